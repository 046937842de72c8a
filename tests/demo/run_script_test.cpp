// demo/run in a folder of its own, with stand-ins for the build and the program: which runs it starts, and
// what it installs.

#include <gtest/gtest.h>
#include <sys/wait.h>

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>

namespace weft::demo {
namespace {

namespace fs = std::filesystem;

class RunScript : public testing::Test {
  protected:
    RunScript() {
        const std::string name = testing::UnitTest::GetInstance()->current_test_info()->name();
        root_ = fs::path(testing::TempDir()) / ("weft_run_" + name);
        fs::remove_all(root_);
        for (const char* folder : {"demo", "bin", "build/release/bin"})
            fs::create_directories(root_ / folder);
        fs::copy_file(WEFT_RUN_SCRIPT, root_ / "demo/run");
        script("demo/packages", "echo \"packages $*\" >> \"$WEFT_TEST_LOG\"");
        script("bin/cmake", "exit 0");
        script("bin/xvfb-run", "echo xvfb-run >> \"$WEFT_TEST_LOG\"; shift; CAN_DRAW=1 \"$@\"");
        // Draws where CAN_DRAW is set; --trace bad is a failure for another reason, --scene none is refused.
        script("build/release/bin/weft_demo",
               "echo \"weft_demo $*\" >> \"$WEFT_TEST_LOG\"\n"
               "case \"$*\" in *none*) exit 2;; *bad*) exit 1;; esac\n"
               "[ -n \"$CAN_DRAW\" ]");
    }
    ~RunScript() override { fs::remove_all(root_); }

    /// Its exit status; what was called is in log().
    [[nodiscard]] int run(const std::string& surroundings, const std::string& arguments) const {
        const std::string command =
            "cd " + root_.string() +
            " && env -u DISPLAY -u WAYLAND_DISPLAY -u CAN_DRAW PATH=" + (root_ / "bin").string() +
            ":\"$PATH\" WEFT_TEST_LOG=" + (root_ / "log").string() + " " + surroundings + " demo/run " +
            arguments + " > stdout.txt 2> stderr.txt";
        const int status = std::system(command.c_str());
        return WIFEXITED(status) ? WEXITSTATUS(status) : -1;
    }
    [[nodiscard]] std::string log() const {
        std::stringstream text;
        text << std::ifstream(root_ / "log").rdbuf();
        return text.str();
    }
    [[nodiscard]] bool logged(const char* what) const { return log().find(what) != std::string::npos; }

  private:
    void script(const char* name, const std::string& body) const {
        std::ofstream(root_ / name) << "#!/bin/sh\n" << body << '\n';
        fs::permissions(root_ / name, fs::perms::owner_all);
    }

    fs::path root_;
};

TEST_F(RunScript, PassesSuccessAndRefusalOn) {
    EXPECT_EQ(run("CAN_DRAW=1", "--headless --out out"), 0) << log();
    EXPECT_EQ(run("CAN_DRAW=1", "--headless --scene none"), 2) << log();
    EXPECT_EQ(run("", "--headless --scene none"), 2) << log();
    EXPECT_FALSE(logged("xvfb")) << log();
}

TEST_F(RunScript, TakesAVirtualDisplayWhereNothingCanBeDrawn) {
    EXPECT_EQ(run("", "--headless --out out"), 0) << log();
    EXPECT_TRUE(logged("packages xvfb")) << log();
    EXPECT_TRUE(logged("xvfb-run")) << log();
}

TEST_F(RunScript, InstallsNothingWhereTheProgramFailsForAnotherReason) {
    EXPECT_EQ(run("CAN_DRAW=1", "--headless --trace bad"), 1) << log();
    EXPECT_FALSE(logged("xvfb")) << log();
}

TEST_F(RunScript, DoesNotRunAgainWithoutItsWindowWhereThatWasNotToBlame) {
    EXPECT_EQ(run("CAN_DRAW=1 DISPLAY=:99", "--trace bad"), 1) << log();
    EXPECT_FALSE(logged("--trace bad --headless")) << log();
    EXPECT_FALSE(logged("xvfb")) << log();
}

TEST_F(RunScript, RunsHeadlessWithoutADisplay) {
    EXPECT_EQ(run("CAN_DRAW=1", "--out out --scene sheet"), 0) << log();
    EXPECT_TRUE(logged("weft_demo --out out --scene sheet --headless")) << log();
}

}  // namespace
}  // namespace weft::demo
