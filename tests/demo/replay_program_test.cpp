// weft_replay, as people run it, on what scenes leave that are run with Overrides::record.

#include "cloth/record/record_format.h"
#include "demo/scene_simulation.h"
#include "tests/demo/program_test.h"

namespace weft::demo {
namespace {

class ReplayProgram : public ProgramTest {
  protected:
    ReplayProgram() : ProgramTest(WEFT_REPLAY_PROGRAM) {}

    static std::filesystem::path recording() { return folder() / "flag.weftrec"; }
    static void write(const std::string& content) { std::ofstream(recording(), std::ios::binary) << content; }
    static void record_flag() {
        Overrides overrides;
        overrides.threads = 1;
        overrides.record = recording();
        SceneOptions options;
        options.particles = 300;
        auto simulation = Simulation::create(*find_scene("flag"), options, overrides);
        ASSERT_TRUE(simulation) << simulation.error().message;
        for (int k = 0; k < 12; ++k) simulation->step(1.0f / 60);
    }
};

TEST_F(ReplayProgram, SaysThatAllIsTheSame) {
    record_flag();
    for (const char* threads : {"", " --threads 1", " --threads 2"}) {
        const Ran ran = run(recording().string() + threads);
        EXPECT_EQ(ran.status, 0) << ran.out << ran.err;
        EXPECT_NE(ran.out.find("12 steps"), std::string::npos) << ran.out;
        EXPECT_NE(ran.out.find("the same bytes"), std::string::npos) << ran.out;
    }
}

TEST_F(ReplayProgram, NamesTheFirstStepAndClothThatDiffer) {
    record_flag();
    std::string bytes = content_of(recording());
    // The hash that was recorded of the cloth after its seventh step.
    int steps = 0;
    for (std::size_t at = sizeof(RecordingHead); at < bytes.size();) {
        RecordHead head;
        std::memcpy(&head, bytes.data() + at, sizeof head);
        const std::size_t end = at + sizeof head + head.bytes;
        if (static_cast<Call>(head.call) == Call::step && ++steps == 7) {
            bytes[end - 1] ^= 1;
            StateHash hasher;
            hasher.add(std::as_bytes(std::span(bytes)).subspan(at + sizeof head, head.bytes));
            head.hash = hasher.value();
            head.own_hash = head.hash_of_head(hasher);
            std::memcpy(bytes.data() + at, &head, sizeof head);
        }
        at = end;
    }
    write(bytes);
    const Ran ran = run(recording().string());
    EXPECT_EQ(ran.status, 1);
    EXPECT_NE(ran.out.find("step 7 is the first that differs: cloth 0"), std::string::npos) << ran.out;
}

TEST_F(ReplayProgram, RefusesWhatIsNoRecording) {
    record_flag();
    std::string bytes = content_of(recording());
    bytes[bytes.size() / 2] ^= 1;
    write(bytes);
    const Ran damaged = run(recording().string());
    EXPECT_EQ(damaged.status, 2);
    EXPECT_NE(damaged.err.find("is damaged"), std::string::npos) << damaged.err;
    EXPECT_EQ(run("/no/such/file").status, 2);
    EXPECT_NE(run("/no/such/file").err.find("/no/such/file"), std::string::npos);
    EXPECT_EQ(run("").status, 2);
    EXPECT_EQ(run("--help").status, 0);
}

TEST_F(ReplayProgram, GoesAsFarAsABrokenRecordingDoes) {
    record_flag();
    const std::string bytes = content_of(recording());
    write(bytes.substr(0, bytes.size() - 100));
    const Ran ran = run(recording().string());
    EXPECT_EQ(ran.status, 0) << ran.err;
    EXPECT_NE(ran.out.find("breaks off"), std::string::npos) << ran.out;
}

}  // namespace
}  // namespace weft::demo
