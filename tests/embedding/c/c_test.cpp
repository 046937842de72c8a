// A host in C that calls all of the interface. same_calls_test.cpp holds its calls against those of C++.

#include <gtest/gtest.h>
#include <unistd.h>

#include <filesystem>
#include <string>

#include "host.h"

namespace weft::test {
namespace {

#ifndef __wasi__  // which has no files to load meshes from
TEST(HostInC, CallsAllThatThereIs) {
    const auto folder = std::filesystem::temp_directory_path() / ("weft_c_" + std::to_string(::getpid()));
    std::filesystem::create_directories(folder);
    const std::uint64_t hash = hash_of_host_in_c(folder.c_str());
    EXPECT_EQ(hash_of_host_in_c(folder.c_str()), hash);
    std::filesystem::remove_all(folder);
}
#endif

}  // namespace
}  // namespace weft::test
