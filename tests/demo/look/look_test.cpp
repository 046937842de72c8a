// Quality by time, where a picture's time goes, rounded meshes, materials, and settings as files.

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <numbers>

#include "demo/headless/report_text.h"
#include "demo/learn/comparison.h"
#include "demo/learn/drape.h"
#include "demo/look/drawn_solid.h"
#include "demo/look/inside.h"
#include "demo/look/look.h"
#include "demo/look/materials.h"
#include "demo/look/quality_choice.h"
#include "demo/look/rounded_mesh.h"
#include "demo/look/settings_file.h"
#include "demo/window/input.h"
#include "tests/demo/small_world.h"

namespace weft::demo {

namespace {

/// A machine that takes so long at best, and by the ladder's costs below.
void draw_pictures(QualityChoice& choice, float at_best, int pictures, int pixels = 1280 * 800) {
    for (int i = 0; i < pictures; ++i) choice.add(at_best * choice.now().cost, pixels);
}

TEST(QualityChoice, GoesDownUntilDrawingLeavesTime) {
    for (const float at_best : {30.0f, 60.0f, 100.0f, 160.0f}) {
        QualityChoice choice;
        draw_pictures(choice, at_best, 300);
        EXPECT_LE(at_best * choice.now().cost, choice.limit()) << at_best;
        const int level = choice.level();
        ASSERT_GT(level, 0);
        EXPECT_GT(at_best * quality_levels()[static_cast<std::size_t>(level - 1)].cost, 0.8f * choice.limit())
            << "no lower than it must";
        for (int i = 0; i < 300; ++i) {
            draw_pictures(choice, at_best, 1);
            ASSERT_EQ(choice.level(), level) << "and it stays";
        }
    }
}

TEST(QualityChoice, AHandsChoiceStays) {
    QualityChoice choice;
    choice.choose(2);
    draw_pictures(choice, 500, 300);
    EXPECT_EQ(choice.level(), 2);
}

TEST(RoundedMesh, IsOnTheCylinderThatTheClothIsBentOver) {
    constexpr float radius = 0.2f, step = 0.4f;  // [m], [rad]
    std::vector<Vec4> positions, normals;
    for (int i = 0; i < 5; ++i)
        for (const float z : {0.0f, 0.1f}) {
            const float angle = step * static_cast<float>(i);
            positions.push_back({radius * std::sin(angle), radius * std::cos(angle), z, 1});
            normals.push_back({std::sin(angle), std::cos(angle), 0, 0});
        }
    std::vector<Triangle> triangles;
    for (std::uint32_t i = 0; i + 3 < 10; i += 2)
        triangles.insert(triangles.end(), {{i, i + 1, i + 2}, {i + 2, i + 1, i + 3}});
    std::vector<std::uint32_t> each(10);
    for (std::uint32_t i = 0; i < 10; ++i) each[i] = i;
    const ClothView view{.positions = positions,
                         .previous_positions = positions,
                         .normals = normals,
                         .vertex_to_particle = each};
    const RoundedMesh rounded(triangles, {}, 10);
    EXPECT_EQ(rounded.triangles().size(), 4 * triangles.size());
    EXPECT_EQ(rounded.size(), 10u + 17u) << "an edge each";
    std::vector<Vec4> p(rounded.size()), before(rounded.size()), n(rounded.size());
    rounded.update(view, {p, before, n});
    const float flat = radius * (1 - std::cos(0.5f * step));
    for (const Vec4& each_vertex : p)
        EXPECT_NEAR(std::hypot(each_vertex.x, each_vertex.y), radius, 0.05f * flat);
    rounded.update(view, {p, before, n}, 0);
    float least = radius;
    for (const Vec4& each_vertex : p) least = std::min(least, std::hypot(each_vertex.x, each_vertex.y));
    EXPECT_NEAR(least, radius - flat, 0.05f * flat) << "on the flat triangles, where nothing may be added";
}

TEST(Materials, AreSevenAndAreTaken) {
    EXPECT_EQ(materials().size(), 7u);
    SmallWorld small;
    for (const Material& each : materials()) {
        ClothSettings settings = *small.world.cloth_settings(small.cloths.front().id);
        settings.fabric = each.fabric;
        EXPECT_TRUE(small.world.set_cloth_settings(small.cloths.front().id, settings).ok()) << each.name;
        EXPECT_GT(std::string(each.note).size(), 20u);
    }
}

class SettingsFile : public testing::Test {
  protected:
    static std::filesystem::path file() {
        return std::filesystem::path(testing::TempDir()) /
               (std::string("weft_") + testing::UnitTest::GetInstance()->current_test_info()->name() +
                ".json");
    }
    ~SettingsFile() override { std::filesystem::remove(file()); }

    static Simulation flag() { return simulation_of("flag", 100); }
    static std::string refusal(const std::string& text, Simulation& of) {
        std::ofstream(file()) << text;
        const auto loaded = load_settings(file(), of);
        return loaded ? "" : loaded.error().message;
    }
};

TEST_F(SettingsFile, ReadsBackWhatItWrote) {
    Simulation first = flag(), second = flag();
    WorldSettings world = first.world().settings();
    world.wind.velocity = {1, 2.25f, -3.1f};
    world.wind.gust = 0.3f;
    world.substeps = 7;
    world.budget = 1.5f;
    ASSERT_TRUE(first.world().set_settings(world).ok());
    const ClothId id = first.content().cloths.front().id;
    ClothSettings cloth = *first.world().cloth_settings(id);
    cloth.fabric = materials()[3].fabric;
    cloth.method = Multilevel{.passes = 4};
    cloth.substeps = 2;
    cloth.friction = 0.25f;
    ASSERT_TRUE(first.world().set_cloth_settings(id, cloth).ok());
    ASSERT_TRUE(save_settings(file(), first).ok());
    EXPECT_EQ(*scene_of_settings(file()), "flag");
    const auto loaded = load_settings(file(), second);
    ASSERT_TRUE(loaded.ok()) << loaded.error().message;
    const ClothSettings& same = *second.world().cloth_settings(second.content().cloths.front().id);
    EXPECT_EQ(same.fabric, cloth.fabric);
    EXPECT_EQ(same.method, cloth.method);
    EXPECT_EQ(same.substeps, 2);
    EXPECT_EQ(same.friction, 0.25f);
    const WorldSettings& again = second.world().settings();
    EXPECT_EQ(again.wind.velocity.y, 2.25f);
    EXPECT_EQ(again.wind.velocity.z, -3.1f);
    EXPECT_EQ(again.wind.gust, 0.3f);
    EXPECT_EQ(again.substeps, 7);
    EXPECT_EQ(again.budget, 1.5f);
}

TEST_F(SettingsFile, NamesWhatIsWrongAndChangesNothing) {
    Simulation each = flag();
    const auto before = each.world().describe(DescriptionFormat::json);
    const std::pair<const char*, const char*> wrong[] = {
        {"[1]", "no JSON object"},
        {"{\"sbsteps\": 3}", "sbsteps"},
        {"{\"substeps\": 0}", "1 to 256"},
        {"{\"substeps\": 3, \"wind\": {\"velocity\": [1, 2]}}", "three numbers"},
        {"{\"wind\": {\"gust\": 1}}", "gust"},
        {"{\"wind\": 3}", "wind"},
        {"{\"material\": {\"warp\": -1}}", "warp is -1"},
        {"{\"substeps\": 9, \"method\": \"magic\"}", "multilevel, jacobi"},
        {"{\"method\": \"xpbd\", \"passes\": 3}", "no \"passes\""},
        {"{\"self_collision\": 2}", "avoidance"},
        {"{\"substeps\": 9, \"method\": \"xpbd\", \"material\": {\"stiffening\": 3}}", "stiffening"}};
    for (const auto& [text, named] : wrong)
        EXPECT_NE(refusal(text, each).find(named), std::string::npos) << text << ": " << refusal(text, each);
    EXPECT_EQ(*each.world().describe(DescriptionFormat::json), *before);
    EXPECT_NE(load_settings("/nonexistent/a.json", each).error().message.find("/nonexistent"),
              std::string::npos);
    EXPECT_FALSE(save_settings("/proc/nowhere/a.json", each).ok());
}

TEST(Simulation, RestoresItsDefaults) {
    Simulation simulation = simulation_of("flag", 100);
    const ClothId id = simulation.content().cloths.front().id;
    const Fabric first = simulation.world().cloth_settings(id)->fabric;
    ClothSettings settings = *simulation.world().cloth_settings(id);
    settings.fabric.warp = 77;
    ASSERT_TRUE(simulation.world().set_cloth_settings(id, settings).ok());
    ASSERT_TRUE(simulation.restart().ok());
    EXPECT_EQ(simulation.world().cloth_settings(simulation.content().cloths.front().id)->fabric.warp, 77);
    ASSERT_TRUE(simulation.restore_defaults().ok());
    EXPECT_EQ(simulation.world().cloth_settings(simulation.content().cloths.front().id)->fabric, first);
}

TEST(Recorder, LeavesPicturesByNumber) {
    const auto folder = std::filesystem::path(testing::TempDir()) / "weft_recorder";
    std::filesystem::remove_all(folder);
    std::filesystem::create_directories(folder);
    Recorder recorder(folder);
    const render::Image image{16, 8, std::vector<std::uint8_t>(3 * 16 * 8, 99)};
    EXPECT_EQ(*recorder.save(image), folder / "weft-0001.png");
    EXPECT_EQ(*recorder.save(image), folder / "weft-0002.png");
    ASSERT_TRUE(recorder.start().ok());
    EXPECT_TRUE(recorder.recording());
    for (int i = 0; i < 3; ++i) ASSERT_TRUE(recorder.add(image).ok());
    const auto told = recorder.stop();
    ASSERT_TRUE(told.ok()) << told.error().message;
    EXPECT_NE(told->find("3 pictures"), std::string::npos) << *told;
    EXPECT_FALSE(recorder.recording());
    EXPECT_TRUE(std::filesystem::exists(folder / "weft-film-0001" / "picture_000003.png"));
    EXPECT_EQ(std::filesystem::exists(folder / "weft-film-0001.mp4"), program_is_there("ffmpeg"));
    for (int i = 3; i < 10'000; ++i) {
        std::array<char, 16> name{};
        std::snprintf(name.data(), name.size(), "weft-%04d.png", i);
        std::ofstream(folder / name.data());
    }
    EXPECT_EQ(*recorder.save(image), folder / "weft-10000.png") << "no picture is overwritten";
    EXPECT_FALSE(Recorder("/proc/nowhere").start().ok());
    EXPECT_FALSE(Recorder("/proc/nowhere").save(image).ok());
    std::filesystem::remove_all(folder);
}

/// A program in $PATH, as long as it lives.
class StandIn {
  public:
    StandIn(std::filesystem::path folder, const char* name, const std::string& script)
        : folder_(std::move(folder)), path_(std::getenv("PATH")) {
        std::filesystem::create_directories(folder_);
        std::ofstream(folder_ / name) << "#!/bin/sh\n" << script;
        std::filesystem::permissions(folder_ / name, std::filesystem::perms::owner_all);
        setenv("PATH", (folder_.string() + ":" + path_).c_str(), 1);
    }
    ~StandIn() {
        setenv("PATH", path_.c_str(), 1);
        std::filesystem::remove_all(folder_);
    }
    StandIn(const StandIn&) = delete;
    StandIn& operator=(const StandIn&) = delete;

  private:
    std::filesystem::path folder_;
    std::string path_;
};

TEST(Recorder, HasFfmpegMakeAFilmOfThePictures) {
    const auto folder = std::filesystem::path(testing::TempDir()) / "weft_film";
    std::filesystem::remove_all(folder);
    // Notes its arguments, and copies the second picture that its pattern names to the last of them.
    const StandIn ffmpeg(folder / "bin", "ffmpeg",
                         "echo \"$@\" > " + (folder / "arguments").string() +
                             "\nwhile [ $# -gt 1 ]; do [ \"$1\" = -i ] && pattern=$2; shift; done\n"
                             "cp \"$(printf \"$pattern\" 2)\" \"$1\"\n");
    const render::Image image{15, 9, std::vector<std::uint8_t>(3 * 15 * 9, 50)};
    Recorder recorder(folder);
    ASSERT_TRUE(recorder.start().ok());
    for (int i = 0; i < 2; ++i) ASSERT_TRUE(recorder.add(image).ok());
    const auto told = recorder.stop();
    ASSERT_TRUE(told.ok()) << told.error().message;
    EXPECT_NE(told->find("weft-film-0001.mp4, of 2 pictures"), std::string::npos) << *told;
    EXPECT_EQ(std::filesystem::file_size(folder / "weft-film-0001.mp4"),
              std::filesystem::file_size(folder / "weft-film-0001" / "picture_000002.png"));
    std::string arguments;
    std::getline(std::ifstream(folder / "arguments"), arguments);
    for (const char* needed : {"-y ", "-framerate 30 ", "-pix_fmt yuv420p ", "pad=ceil(iw/2)*2:ceil(ih/2)*2"})
        EXPECT_NE(arguments.find(needed), std::string::npos) << arguments;
    std::filesystem::remove_all(folder);
}

TEST(Recorder, SaysThatFfmpegMadeNone) {
    const auto folder = std::filesystem::path(testing::TempDir()) / "weft_no_film";
    std::filesystem::remove_all(folder);
    const StandIn ffmpeg(folder / "bin", "ffmpeg", "exit 1\n");
    Recorder recorder(folder);
    ASSERT_TRUE(recorder.start().ok());
    ASSERT_TRUE(recorder.add({16, 8, std::vector<std::uint8_t>(3 * 16 * 8, 50)}).ok());
    const auto told = recorder.stop();
    ASSERT_FALSE(told.ok());
    EXPECT_NE(told.error().message.find("ffmpeg made no film of the 1 pictures in"), std::string::npos)
        << told.error().message;
    std::filesystem::remove_all(folder);
}

// The bench's closed forms, and two methods beside each other.

TEST(Elastica, HangsLikeABeamWhereItIsStiff) {
    const std::vector<Vec2> curve = elastica_curve(0.01, 11);
    ASSERT_EQ(curve.size(), 11u);
    EXPECT_NEAR(curve.back().y, -0.01 / 8, 1e-6) << "w l^4 / 8 E I";
    EXPECT_NEAR(curve.back().x, 1, 1e-5);
    EXPECT_EQ(curve.front().x, 0);
}

TEST(Elastica, HasPeircesAngle) {
    const std::vector<Vec2> curve = elastica_curve(8.0042, 101);
    const double chord =
        std::atan2(-static_cast<double>(curve.back().y), static_cast<double>(curve.back().x));
    EXPECT_NEAR(chord * 180 / std::numbers::pi, 41.5, 0.02)
        << "at which his bending length is half of the strip's";
    float length = 0;
    for (std::size_t i = 1; i < curve.size(); ++i)
        length += std::hypot(curve[i].x - curve[i - 1].x, curve[i].y - curve[i - 1].y);
    EXPECT_NEAR(length, 1, 1e-3);
}

TEST(Comparison, TheFinerOneIsNearerToTheExact) {
    Simulation shown = simulation_of("flag", 200);
    auto comparison = Comparison::start(shown, Jacobi{.iterations = 1}, Fairness::same_steps);
    ASSERT_TRUE(comparison.ok()) << comparison.error().message;
    for (int i = 0; i < 30; ++i) {
        shown.step(1.0f / 60);
        comparison->step(shown, 1.0f / 60);
    }
    EXPECT_GT(comparison->shown().usual, 0);
    EXPECT_LT(comparison->shown().usual, 0.7f * comparison->other().usual);
    EXPECT_GE(comparison->other().farthest, comparison->other().usual);
    EXPECT_EQ(comparison->other().substeps, 1);
    EXPECT_GT(comparison->shown().milliseconds, 0);
}

TEST(Comparison, GivesTheFasterOneSubstepsUntilBothTakeTheSameTime) {
    const auto cost = [](BothSubsteps substeps, float shown, float other) {
        return static_cast<float>(substeps.shown) * shown / (static_cast<float>(substeps.other) * other);
    };
    EXPECT_EQ(balanced_substeps(1, 10, 2.5f), (BothSubsteps{1, 4}));
    EXPECT_EQ(balanced_substeps(2, 3, 3), (BothSubsteps{2, 2}));
    for (const auto& [shown, other] :
         {std::pair(37.0f, 142.0f), {142.0f, 37.0f}, {1.0f, 1.5f}, {1.5f, 1.0f}, {2.0f, 31.0f}})
        EXPECT_NEAR(cost(balanced_substeps(1, shown, other), shown, other), 1, 0.11f)
            << shown << " " << other;
}

/// A method that is several times as slow as the shown one.
TEST(Comparison, SlowerMethodsAreAnsweredByMoreSubstepsOfTheShownOne) {
    Simulation shown = simulation_of("flag", 200);
    auto comparison = Comparison::start(shown, Multilevel{.passes = 20}, Fairness::same_time);
    ASSERT_TRUE(comparison.ok()) << comparison.error().message;
    for (int i = 0; i < 240; ++i) {
        shown.step(1.0f / 60);
        comparison->step(shown, 1.0f / 60);
    }
    const ClothId flag = shown.content().cloths.front().id;
    EXPECT_GT(comparison->shown().substeps, 1);
    EXPECT_EQ(shown.world().cloth_settings(flag)->substeps, comparison->shown().substeps);
    EXPECT_NEAR(comparison->shown().milliseconds / comparison->other().milliseconds, 1, 0.5f);
    comparison->end(shown);
    EXPECT_EQ(shown.world().cloth_settings(flag)->substeps, 1);
}

TEST(Comparison, AllHaveTheShownOnesWind) {
    Simulation shown = simulation_of("flag", 200);
    auto comparison = Comparison::start(shown, Multilevel{}, Fairness::same_steps);
    ASSERT_TRUE(comparison.ok());
    WorldSettings settings = shown.world().settings();
    settings.wind.velocity = {0, 0, 9};
    ASSERT_TRUE(shown.world().set_settings(settings).ok());
    for (int i = 0; i < 30; ++i) {
        shown.step(1.0f / 60);
        comparison->step(shown, 1.0f / 60);
    }
    EXPECT_GT(comparison->shown().farthest, 0);
    EXPECT_EQ(comparison->other().farthest, comparison->shown().farthest) << "the same method, the same wind";
    EXPECT_FLOAT_EQ(comparison->truth().world().settings().wind.velocity.z, 9);
}

// Colliders between two steps: drawn as late as the cloth that lies on them.

class MovedBall : public testing::Test {
  protected:
    static constexpr float dt = 1.0f / 60, metres_a_step = 0.02f;

    void SetUp() override { ball_ = world_.add_collider({.shape = Sphere{{}, 0.1f}}).value(); }
    void steps(int count) {
        for (int k = 0; k < count; ++k) {
            ++taken_;
            (void)world_.move_collider(
                ball_, {.shape = Sphere{{metres_a_step * static_cast<float>(taken_), 0, 0}, 0.1f}});
            world_.step(dt);
        }
    }
    /// The ball's place along X, as a picture at this share of the way shows it.
    float drawn_at(float share) {
        motion_.note(ball_, *world_.collider(ball_), world_.report().step);
        return std::get<Sphere>(motion_.at(ball_, share).shape).center.x;
    }

    World world_ = World::create({.threads = 1}).value();
    ColliderId ball_;
    ColliderMotion motion_;
    int taken_ = 0;
};

TEST_F(MovedBall, IsDrawnBetweenTheLastTwoSteps) {
    EXPECT_EQ(drawn_at(0.5f), 0) << "it has not moved yet";
    steps(1);
    EXPECT_NEAR(drawn_at(0), 0, 1e-6f);
    EXPECT_NEAR(drawn_at(0.25f), 0.25f * metres_a_step, 1e-6f);
    EXPECT_NEAR(drawn_at(1), metres_a_step, 1e-6f);
    steps(3);  // a slow picture
    EXPECT_NEAR(drawn_at(0), 3 * metres_a_step, 1e-6f);
    EXPECT_NEAR(drawn_at(0.5f), 3.5f * metres_a_step, 1e-6f);
}

TEST_F(MovedBall, IsWhereItHasJumped) {
    steps(1);
    (void)drawn_at(1);
    (void)world_.place_collider(ball_, {.shape = Sphere{{50, 0, 0}, 0.1f}});
    world_.step(dt);
    EXPECT_EQ(drawn_at(0.5f), 50);
}

}  // namespace

}  // namespace weft::demo
