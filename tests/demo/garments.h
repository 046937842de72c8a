#pragma once
// The garments of the test data, which live outside the repository.

#include <cstdlib>
#include <filesystem>
#include <string>

namespace weft::demo {

/// The folder named by the environment variable WEFT_DATA; empty where it is not set.
inline std::filesystem::path data_folder() {
    const char* folder = std::getenv("WEFT_DATA");
    return folder == nullptr ? std::filesystem::path{} : std::filesystem::path(folder);
}

}  // namespace weft::demo

/// Skips the test, saying why, where there is no test data.
#define WEFT_NEEDS_DATA() \
    if (weft::demo::data_folder().empty()) GTEST_SKIP() << "WEFT_DATA is not set: no garments to test with"
