#pragma once
// A program of Weft's as people run it, in a folder of the test's own.

#include <gtest/gtest.h>
#include <sys/wait.h>

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>

namespace weft::demo {

struct Ran {
    int status;
    std::string out, err;
};

class ProgramTest : public testing::Test {
  protected:
    explicit ProgramTest(std::string program) : program_(std::move(program)) {
        std::filesystem::remove_all(folder());
        std::filesystem::create_directories(folder());
    }
    ~ProgramTest() override { std::filesystem::remove_all(folder()); }

    /// One for each test: CTest runs them at the same time.
    static std::filesystem::path folder() {
        const testing::TestInfo& test = *testing::UnitTest::GetInstance()->current_test_info();
        return std::filesystem::path(testing::TempDir()) /
               ("weft_" + std::string(test.test_suite_name()) + "_" + test.name());
    }
    static std::string content_of(const std::filesystem::path& file) {
        std::stringstream text;
        text << std::ifstream(file, std::ios::binary).rdbuf();
        return text.str();
    }

    Ran run(const std::string& arguments) const {
        const auto out = folder() / "stdout.txt", err = folder() / "stderr.txt";
        const std::string command = program_ + " " + arguments + " >" + out.string() + " 2>" + err.string();
        const int status = std::system(command.c_str());
        return {WIFEXITED(status) ? WEXITSTATUS(status) : -1, content_of(out), content_of(err)};
    }

    static void expect_refusal(const Ran& ran, const std::string& named) {
        EXPECT_EQ(ran.status, 2);
        EXPECT_EQ(ran.out, "");
        EXPECT_EQ(std::ranges::count(ran.err, '\n'), 1) << ran.err;
        EXPECT_NE(ran.err.find(named), std::string::npos) << ran.err;
    }

    /// The sixteen digits of the line "hash: ...".
    static std::string hash_of(const Ran& ran) {
        const std::string lines = "\n" + ran.out, heading = "\nhash: ";
        const std::size_t found = lines.find(heading);
        const std::string rest = found == std::string::npos ? "" : lines.substr(found + heading.size());
        const std::string digits = rest.substr(0, rest.find_first_not_of("0123456789abcdef"));
        EXPECT_EQ(digits.size(), 16u) << ran.out << ran.err;
        EXPECT_EQ(rest.substr(digits.size(), 1), "\n");
        return digits;
    }

  private:
    std::string program_;
};

}  // namespace weft::demo
