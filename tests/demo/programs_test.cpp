// The programs, run as people run them.

#include <gtest/gtest.h>
#include <sys/wait.h>

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>

#include "cloth/record/record_format.h"
#include "demo/profile/measurement.h"
#include "demo/scene_simulation.h"
#include "tests/demo/small_world.h"
#include "weft/mesh.h"

namespace weft::demo {

namespace {

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

    /// The folder of the present test. Tests have one each, because CTest runs them at the same time.
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

// The program itself, run as people run it.

class Program : public ProgramTest {
  protected:
    Program() : ProgramTest(WEFT_DEMO_PROGRAM) {}

    Ran run_headless(const std::string& arguments, const std::string& out = "out") const {
        return run("--headless --particles 600 --size 160x100 --out " + (folder() / out).string() + " " +
                   arguments);
    }
};

TEST_F(Program, ListsItsScenes) {
    const Ran ran = run("--list");
    EXPECT_EQ(ran.status, 0);
    for (const char* scene : {"flag", "curtain", "sheet", "ribbon", "garment"}) {
        EXPECT_NE(ran.out.find(scene), std::string::npos) << ran.out;
    }
}

TEST_F(Program, DoesNotCallClothSofterThanItIsForSingleFrames) {
    for (const char* scene : {"trampoline", "crossed", "flag"}) {
        const Ran ran = run_headless("--frames 40 --scene " + std::string(scene));
        EXPECT_EQ(ran.status, 0);
        EXPECT_EQ(ran.out.find("softer"), std::string::npos) << ran.out;
    }
    const Ran torn = run_headless("--frames 30 --scene yank");
    EXPECT_NE(torn.out.find("A pin was stopped"), std::string::npos) << torn.out;
}

TEST_F(Program, TakesSettings) {
    const std::string file = (folder() / "settings.json").string();
    std::ofstream(file) << R"({"scene": "sheet", "substeps": 3})";
    const Ran ran = run_headless("--frames 1 --settings " + file);
    EXPECT_EQ(ran.status, 0) << ran.err;
    EXPECT_NE(ran.out.find("scene sheet"), std::string::npos) << ran.out;
    EXPECT_NE(ran.out.find("3 substeps"), std::string::npos) << ran.out;
    const Ran asked = run_headless("--frames 1 --substeps 5 --settings " + file);
    EXPECT_NE(asked.out.find("5 substeps"), std::string::npos) << "what is asked for expressly wins";
    std::ofstream(file) << R"({"scene": "sheet", "substeps": 0})";
    expect_refusal(run_headless("--frames 1 --settings " + file), "substeps is 0");
    std::ofstream(file) << R"({"scene": "nowhere"})";
    expect_refusal(run_headless("--frames 1 --settings " + file), "nowhere");
}

TEST_F(Program, ExplainsItself) {
    const Ran ran = run("--help");
    EXPECT_EQ(ran.status, 0);
    EXPECT_NE(ran.out.find("--scene"), std::string::npos);
}

TEST_F(Program, RefusesWhatIsNotThere) {
    expect_refusal(run("--headless --scene atlantis"), "atlantis");
    expect_refusal(run("--headless --scene garment"), "--garment");
    expect_refusal(run("--headless --garment /no/such/shirt.obj"), "/no/such/shirt.obj");
    expect_refusal(run("--headless --scene sheet --garment shirt.obj"), "shirt.obj");
    expect_refusal(run("--headless --particles -3"), "--particles");
    expect_refusal(run("--headless --contact sometimes"), "--contact");
    expect_refusal(run("--headless --method symplectic-euler --iterations 4"), "symplectic-euler");
    expect_refusal(run("--headless --frames 1 --out /dev/null/here"), "/dev/null/here");
}

TEST_F(Program, RefusesABrokenGarment) {
    const auto file = folder() / "broken.obj";
    std::ofstream(file) << "v 0 0 0\nv 1 0 0\nv 0 nan 0\nf 1 2 3\n";
    expect_refusal(run("--headless --garment " + file.string()), "broken.obj");
}

TEST_F(Program, LeavesPictureTableMeshAndHash) {
    const Ran ran = run_headless("--frames 5 --trace " + (folder() / "trace.json").string());
    EXPECT_EQ(ran.status, 0) << ran.err;
    hash_of(ran);
    const std::string png = content_of(folder() / "out/final.png");
    EXPECT_EQ(png.substr(0, 8), "\x89PNG\r\n\x1a\n");

    const std::string csv = content_of(folder() / "out/frame_times.csv");
    EXPECT_EQ(std::ranges::count(csv, '\n'), 1 + 5) << "a heading and a row for each frame";
    EXPECT_EQ(csv.substr(0, 6), "frame,");

    const auto mesh = load_obj(folder() / "out/final.obj");
    ASSERT_TRUE(mesh.ok()) << mesh.error().message;
    EXPECT_NEAR(static_cast<double>(mesh->positions.size()), 600, 60);
    EXPECT_GT(std::filesystem::file_size(folder() / "trace.json"), 100u);
}

TEST_F(Program, ComparesTwoMethodsWithoutAnyEffectOnTheFirst) {
    const std::string flag =
        "--headless --scene flag --particles 200 --frames 15 --size 96x60 --out " + folder().string();
    const Ran alone = run(flag), compared = run(flag + " --compare xpbd --check-gl");
    EXPECT_EQ(compared.status, 0) << compared.err;
    EXPECT_EQ(hash_of(compared), hash_of(alone));
    EXPECT_EQ(alone.out.find("compared:"), std::string::npos);
    for (const char* method : {"compared: multilevel", "compared: xpbd"})
        EXPECT_NE(compared.out.find(method), std::string::npos) << compared.out;
    EXPECT_NE(compared.out.find("ms a step, "), std::string::npos) << compared.out;
}

TEST_F(Program, TakesAPictureOfEveryNthFrame) {
    const Ran ran = run_headless("--frames 5 --every 2 --panels");
    EXPECT_EQ(ran.status, 0) << ran.err;
    EXPECT_TRUE(std::filesystem::exists(folder() / "out/frame_000002.png"));
    EXPECT_TRUE(std::filesystem::exists(folder() / "out/frame_000004.png"));
    EXPECT_TRUE(std::filesystem::exists(folder() / "out/final.png"));
}

TEST_F(Program, RefusesWhatItCannotWriteBeforeItRuns) {
    // A run as long as this would not end within the test's time.
    const std::string long_run = "--headless --frames 9000000 --out " + (folder() / "out").string();
    expect_refusal(run(long_run + " --trace /no/such/folder/trace.json"),
                   "--trace /no/such/folder/trace.json");
    expect_refusal(run(long_run + " --trace " + folder().string()), "--trace");
    std::filesystem::create_directories(folder() / "out/final.obj");
    expect_refusal(run(long_run), "final.obj");
}

/// A PC2 file, read by its description.
struct Cache {
    std::int32_t version = 0, points = 0, samples = 0;
    float start = -1, rate = 0;
    std::vector<Vec3> positions;
};
Cache read_cache(const std::filesystem::path& file) {
    std::ifstream stream(file, std::ios::binary);
    char name[12] = {};
    Cache cache;
    const auto get = [&](auto& value) { stream.read(reinterpret_cast<char*>(&value), sizeof value); };
    stream.read(name, sizeof name);
    EXPECT_EQ(std::string(name), "POINTCACHE2");
    get(cache.version), get(cache.points), get(cache.start), get(cache.rate), get(cache.samples);
    cache.positions.resize(static_cast<std::size_t>(cache.points) * static_cast<std::size_t>(cache.samples));
    for (Vec3& p : cache.positions) get(p);
    EXPECT_TRUE(stream.good());
    EXPECT_EQ(stream.peek(), std::ifstream::traits_type::eof());
    return cache;
}

TEST_F(Program, ExportsWhatItDraws) {
    const Ran one = run_headless("--scene character --frames 5 --export pc2", "pc2");
    const Ran many = run_headless("--scene character --frames 5 --export obj", "obj");
    ASSERT_EQ(one.status, 0) << one.err;
    ASSERT_EQ(many.status, 0) << many.err;
    EXPECT_EQ(hash_of(one), hash_of(many));
    const Cache cache = read_cache(folder() / "pc2" / "sequence.pc2");
    EXPECT_EQ(cache.version, 1);
    EXPECT_EQ(cache.start, 0);
    EXPECT_EQ(cache.rate, 1);
    ASSERT_EQ(cache.samples, 6);
    const auto first = load_obj(folder() / "pc2" / "sequence.obj");
    ASSERT_TRUE(first.ok());
    ASSERT_EQ(first->positions.size(), static_cast<std::size_t>(cache.points));
    for (std::size_t frame = 0; frame < 6; ++frame) {
        const auto mesh = load_obj(folder() / "obj" / ("frame_00000" + std::to_string(frame) + ".obj"));
        ASSERT_TRUE(mesh.ok()) << frame;
        ASSERT_EQ(mesh->positions.size(), first->positions.size());
        EXPECT_EQ(mesh->triangles, first->triangles);
        for (std::size_t v = 0; v < mesh->positions.size(); ++v) {
            const Vec3 &a = mesh->positions[v], &b = cache.positions[frame * mesh->positions.size() + v];
            ASSERT_TRUE(a.x == b.x && a.y == b.y && a.z == b.z) << frame << ", " << v;
        }
    }
    EXPECT_FALSE(std::filesystem::exists(folder() / "obj" / "frame_000006.obj"));
    std::filesystem::create_directories(folder() / "blocked" / "sequence.pc2");
    const Ran blocked = run_headless("--scene character --frames 1 --export pc2", "blocked");
    EXPECT_EQ(blocked.status, 2);
    EXPECT_NE(blocked.err.find("sequence.pc2 cannot be written"), std::string::npos) << blocked.err;
}

TEST_F(Program, WritesATraceIntoTheFolderThatItMakes) {
    const Ran ran = run_headless("--frames 2 --trace " + (folder() / "out/trace.json").string());
    EXPECT_EQ(ran.status, 0) << ran.err;
    EXPECT_GT(std::filesystem::file_size(folder() / "out/trace.json"), 100u);
}

TEST_F(Program, GivesTheSameHashWheneverItRunsOnAnyThreads) {
    const std::string once = hash_of(run_headless("--scene ribbon --frames 12 --threads 1"));
    EXPECT_EQ(hash_of(run_headless("--scene ribbon --frames 12 --threads 1")), once);
    EXPECT_EQ(hash_of(run_headless("--scene ribbon --frames 12 --threads 2")), once);
    EXPECT_NE(hash_of(run_headless("--scene ribbon --frames 13 --threads 2")), once);
}

TEST_F(Program, HeedsTheWind) {
    const std::string calm = hash_of(run_headless("--frames 3 --wind 0,0,0"));
    const std::string blown = hash_of(run_headless("--frames 3 --wind -4,0,1"));
    EXPECT_NE(blown, calm);
    const std::string file = (folder() / "settings.json").string();
    std::ofstream(file) << R"({"wind": {"velocity": [0, 0, 0]}})";
    EXPECT_EQ(hash_of(run_headless("--frames 3 --settings " + file)), calm);
    for (const std::string& asked :
         {"--wind -4,0,1 --settings " + file, "--settings " + file + " --wind -4,0,1"})
        EXPECT_EQ(hash_of(run_headless("--frames 3 " + asked)), blown) << "what is asked for expressly wins";
}

// weft_profile: its arguments, its table, and the program as people run it.

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

TEST_F(ProfileProgram, LeavesOutFramesInWhichClothSleeps) {
    const Ran ran = run("--scene folddrop --particles 300 --frames 400 --warm-up 0 --threads 1");
    EXPECT_NE(ran.out.find("\nasleep in "), std::string::npos) << ran.out;
    EXPECT_EQ(ran.out.find(" 0 particles"), std::string::npos) << ran.out;
    EXPECT_EQ(run("--scene flag --particles 300 --frames 2").out.find("asleep"), std::string::npos);
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

// weft_replay, as people run it, on what scenes leave that are run with Overrides::record.

class ReplayProgram : public ProgramTest {
  protected:
    ReplayProgram() : ProgramTest(WEFT_REPLAY_PROGRAM) {}

    static std::filesystem::path recording() { return folder() / "flag.weftrec"; }
    static void write(const std::string& content) { std::ofstream(recording(), std::ios::binary) << content; }
    static void record_flag() {
        Simulation simulation = simulation_of("flag", 300, {.threads = 1, .record = recording()});
        for (int k = 0; k < 12; ++k) simulation.step(1.0f / 60);
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
