// weft_profile: its arguments, its table, and the program as people run it.

#include "demo/profile/measurement.h"
#include "tests/demo/program_test.h"

namespace weft::demo {
namespace {

std::vector<StageTime> frame(float solve, float step) {
    return {{.name = "cloths", .depth = 1, .last = solve},
            {.name = "solve", .depth = 2, .last = solve},
            {.name = "step", .depth = 0, .last = step}};
}

TEST(StageTable, KeepsTheLeastOfItsRuns) {
    StageTable table;
    for (const float noise : {3.0f, 0.0f, 5.0f}) {
        for (int k = 1; k <= 100; ++k) table.add(frame(1, static_cast<float>(k) + noise));
        table.end_run();
    }
    EXPECT_NE(table.text(1).find("   50.000    95.000    99.000   100.000"), std::string::npos)
        << table.text(1);
}

TEST(Measurement, CopiesTheFirstClothWithItsPins) {
    ProfileOptions options;
    options.scene = "flag";
    options.scene_options.particles = 300;
    options.cloths = 3;
    auto simulation = build_simulation(options);
    ASSERT_TRUE(simulation.ok()) << simulation.error().message;
    const StepReport& report = simulation->step(1.0f / 60);
    EXPECT_EQ(report.cloths, 3u);
    const auto pinned = [&](std::uint32_t cloth) {
        // Cloths that were added one after the other have ids that follow one another.
        const ClothId first = simulation->content().cloths.front().id;
        const auto view = simulation->world().cloth({first.index + cloth, first.generation});
        return std::ranges::count(view->positions, 0.0f, &Vec4::w);
    };
    EXPECT_GT(pinned(0), 0);
    EXPECT_EQ(pinned(1), pinned(0));
    EXPECT_EQ(pinned(2), pinned(0));
}

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

TEST_F(ProfileProgram, RefusesWhatIsNotThere) {
    expect_refusal(run("--scene atlantis"), "atlantis");
    expect_refusal(run("--scene garment"), "--garment");
    expect_refusal(run("--garment /no/such/shirt.obj"), "/no/such/shirt.obj");
    expect_refusal(run("--cloths 0"), "--cloths");
    expect_refusal(run("--frames many"), "--frames");
}

TEST_F(ProfileProgram, RefusesWhatItCannotWriteBeforeItRuns) {
    // Runs as long as these would not end within the test's time.
    expect_refusal(run("--frames 1000000 --csv /no/such/folder/table.csv"),
                   "--csv /no/such/folder/table.csv");
    expect_refusal(run("--frames 1000000 --trace /no/such/folder/trace.json"),
                   "--trace /no/such/folder/trace.json");
}

TEST_F(ProfileProgram, ExplainsItselfAndListsTheScenes) {
    EXPECT_NE(run("--help").out.find("--cloths"), std::string::npos);
    const Ran list = run("--list");
    EXPECT_EQ(list.status, 0);
    EXPECT_NE(list.out.find("curtain"), std::string::npos);
}

}  // namespace
}  // namespace weft::demo
