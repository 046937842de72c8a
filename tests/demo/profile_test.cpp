// weft_profile: its arguments, its table, and the program as people run it.

#include "demo/profile/measurement.h"
#include "tests/demo/program_test.h"

namespace weft::demo {
namespace {

class ProfileProgram : public ProgramTest {
  protected:
    ProfileProgram() : ProgramTest(WEFT_PROFILE_PROGRAM) {}
};

TEST_F(ProfileProgram, LeavesTableFileAndTrace) {
    const auto csv = folder() / "table.csv", trace = folder() / "trace.json";
    const Ran ran =
        run("--scene flag --particles 300 --cloths 4 --threads 2 --frames 5 --warm-up 2 "
            "--repeat 2 --csv " +
            csv.string() + " --trace " + trace.string());
    EXPECT_EQ(ran.status, 0) << ran.err;
    for (const char* shown : {"4 cloths", "2 threads", "bytes per particle", "\n    solve", "\n      cycles"})
        EXPECT_NE(ran.out.find(shown), std::string::npos) << shown << " in " << ran.out;
    const std::string rows = content_of(csv);
    EXPECT_EQ(rows.substr(0, 6), "scene,");
    EXPECT_NE(rows.find("\nflag,multilevel,4,"), std::string::npos) << rows;
    const std::string events = content_of(trace);
    EXPECT_NE(events.find("\"coarse operators\""), std::string::npos);
}

TEST_F(ProfileProgram, RunsTheSameStepsOnAnyThreadsAndAgain) {
    const std::string once = hash_of(run("--particles 400 --cloths 3 --frames 4 --threads 1"));
    EXPECT_EQ(hash_of(run("--particles 400 --cloths 3 --frames 4 --threads 2 --repeat 2")), once);
    EXPECT_NE(hash_of(run("--particles 400 --cloths 3 --frames 5 --threads 2")), once);
}

TEST_F(ProfileProgram, CountsCrossings) {
    const std::string scene = "--scene crossed --particles 300 --frames 2 --warm-up 0 ";
    const std::string sentence = " pairs of triangles cross at the worst\n";
    EXPECT_EQ(run(scene).out.find(sentence), std::string::npos) << "it was not asked to";
    const std::string crossed = run(scene + "--contact off --crossings").out;
    ASSERT_NE(crossed.find(sentence), std::string::npos) << crossed;
    EXPECT_EQ(crossed.find("\n0" + sentence), std::string::npos) << "the sheets start through each other";
    const std::string flag = run("--scene flag --particles 300 --frames 2 --crossings").out;
    EXPECT_NE(flag.find("\n0" + sentence), std::string::npos) << flag;
}

TEST_F(ProfileProgram, RefusesWhatIsNotThere) {
    expect_refusal(run("--scene atlantis"), "atlantis");
    expect_refusal(run("--scene garment"), "--garment");
    expect_refusal(run("--garment /no/such/shirt.obj"), "/no/such/shirt.obj");
    expect_refusal(run("--cloths 0"), "--cloths");
    expect_refusal(run("--frames many"), "--frames");
}

TEST_F(ProfileProgram, ExplainsItselfAndListsTheScenes) {
    EXPECT_NE(run("--help").out.find("--cloths"), std::string::npos);
    const Ran list = run("--list");
    EXPECT_EQ(list.status, 0);
    EXPECT_NE(list.out.find("curtain"), std::string::npos);
}

}  // namespace
}  // namespace weft::demo
