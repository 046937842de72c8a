// Saves of one cloth, and the cloths of a World's save after others have come and gone.

#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "tests/cloth/fixtures.h"
#include "weft/weft.h"

namespace weft::test::saves_by_cloth {
namespace {

using Bytes = std::vector<std::byte>;

Bytes saved(const World& world, ClothId cloth) {
    Bytes bytes(world.cloth_save_size(cloth));
    EXPECT_TRUE(world.save_cloth(cloth, bytes));
    return bytes;
}
Bytes saved(const World& world) {
    Bytes bytes(world.save_size());
    EXPECT_TRUE(world.save(bytes));
    return bytes;
}

Mesh small_sheet(float x, std::uint32_t rows = 13) {
    return make_sheet({.rows = rows,
                       .columns = 12,
                       .origin = {x - 0.3f, 0.4f, -0.3f},
                       .u = {0.6f, 0, 0},
                       .v = {0, 0.02f, 0.6f}})
        .value();
}

/// Sheets 5 m apart, by two corners each over a ball that rolls under the first.
struct Stage {
    static constexpr float apart = 5;

    explicit Stage(const ClothSettings& settings, int sheets = 2, int threads = 1)
        : world(World::create({.threads = threads}).value()), settings(settings) {
        ball = world.add_collider(ball_at(0)).value();
        for (int k = 0; k < sheets; ++k) add(k);
    }
    void add(int place) {
        settings.key = static_cast<std::uint64_t>(place) + 1;
        const float x = apart * static_cast<float>(place);
        cloths.push_back(world.add_cloth(small_sheet(x), settings).value());
        EXPECT_TRUE(world.pin(cloths.back(), std::vector<std::uint32_t>{0, 11}));
    }
    static Collider ball_at(int step) {
        const float x = 0.3f * h * static_cast<float>(step);
        return {.shape = Sphere{{x, 0.1f, 0}, 0.25f}, .friction = 0.5f};
    }
    void run(int steps) {
        for (int k = 0; k < steps; ++k) {
            ++step;
            EXPECT_TRUE(world.move_collider(ball, ball_at(step)));
            for (const std::uint32_t v : {0u, 11u}) {
                const float x = v == 0 ? -0.3f : 0.3f, y = 0.4f - 0.3f * h * static_cast<float>(step);
                static_cast<void>(world.move_pin(cloths[0], v, {x, y, -0.3f}));
            }
            EXPECT_FALSE(has(world.step(h).flags, StepFlags::state_restored));
        }
    }
    void go_back_to(int earlier) {
        step = earlier;
        EXPECT_TRUE(world.place_collider(ball, ball_at(step)));
    }
    World world;
    ClothSettings settings;
    ColliderId ball;
    std::vector<ClothId> cloths;
    int step = 0;
};

struct SaveClothCase {
    const char* name;
    ClothSettings settings;
};
ClothSettings of_method(const Method& method) {
    ClothSettings settings;
    settings.method = method;
    if (std::holds_alternative<SymplecticEuler>(method)) settings.substeps = 64;
    return settings;
}
std::vector<SaveClothCase> cases() {
    std::vector<SaveClothCase> all{{"Multilevel", of_method(Multilevel{})},
                                   {"Contact", {}},
                                   {"Euler", {}},
                                   {"Sleeper", {}},
                                   {"Xpbd", of_method(Xpbd{})},
                                   {"SymplecticEuler", of_method(SymplecticEuler{})}};
    all[1].settings.self_collision = {.method = SelfCollisionMethod::contact};
    all[2].settings.time_scheme = TimeScheme::backward_euler;
    all[3].settings.sleep_speed = 0.05f;
    return all;
}
class SaveCloth : public testing::TestWithParam<SaveClothCase> {};
INSTANTIATE_TEST_SUITE_P(, SaveCloth, testing::ValuesIn(cases()),
                         [](const auto& info) { return std::string(info.param.name); });

TEST_P(SaveCloth, GoesBackAloneAndOnWithTheSameBytes) {
    Stage stage(GetParam().settings);
    stage.run(30);
    const ClothId cloth = stage.cloths[0];
    const Bytes then = saved(stage.world, cloth);
    stage.run(8);
    const Bytes expected = saved(stage.world, cloth), other = saved(stage.world, stage.cloths[1]);
    ASSERT_TRUE(stage.world.pin(cloth, std::vector<std::uint32_t>{5, 40}));
    ASSERT_TRUE(stage.world.move_cloth(cloth, {.translation = {0, 0.3f, 0}}));
    stage.go_back_to(30);
    ASSERT_TRUE(stage.world.restore_cloth(cloth, then));
    EXPECT_TRUE(saved(stage.world, cloth) == then);
    EXPECT_TRUE(saved(stage.world, stage.cloths[1]) == other);
    stage.run(8);
    EXPECT_TRUE(saved(stage.world, cloth) == expected);
}

TEST_P(SaveCloth, GoesOnInAnotherWorldUnderAnotherIdAndOnMoreThreads) {
    Stage stage(GetParam().settings), other(GetParam().settings, 0, 3);
    stage.run(30);
    const Bytes then = saved(stage.world, stage.cloths[0]);
    stage.run(8);
    other.add(3);
    other.add(0);
    std::swap(other.cloths[0], other.cloths[1]);
    other.run(7);
    other.go_back_to(30);
    ASSERT_TRUE(other.world.restore_cloth(other.cloths[0], then));
    other.run(8);
    EXPECT_TRUE(saved(other.world, other.cloths[0]) == saved(stage.world, stage.cloths[0]));
}

// Cloths are found by their keys, though one has gone, one has come, and their order is another.
TEST_P(SaveCloth, ThoseThatAreInBothGoBackByTheirKeys) {
    Stage stage(GetParam().settings, 3);
    stage.run(30);
    const Bytes then = saved(stage.world);
    stage.run(8);
    const Bytes first = saved(stage.world, stage.cloths[0]), third = saved(stage.world, stage.cloths[2]);
    ASSERT_TRUE(stage.world.remove_cloth(stage.cloths[1]));
    ASSERT_TRUE(stage.world.remove_cloth(stage.cloths[2]));
    stage.add(5);
    stage.add(2);
    stage.run(3);
    const Bytes come = saved(stage.world, stage.cloths[3]);
    const auto refused = stage.world.restore(then);
    ASSERT_FALSE(refused);
    EXPECT_NE(refused.error().message.find("cloth 1 has the key 2, the one here 3"), std::string::npos)
        << refused.error().message;
    const auto restored = stage.world.restore_cloths(then);
    ASSERT_TRUE(restored) << restored.error().message;
    EXPECT_EQ(*restored, 2u);
    EXPECT_TRUE(saved(stage.world, stage.cloths[3]) == come);
    stage.go_back_to(30);
    stage.run(8);
    EXPECT_TRUE(saved(stage.world, stage.cloths[0]) == first);
    EXPECT_TRUE(saved(stage.world, stage.cloths[4]) == third);
}

std::string refusal(World& world, const Result<void>& result, std::uint64_t before) {
    EXPECT_EQ(world.state_hash(), before) << "something has changed";
    return result ? "nothing" : result.error().message;
}

TEST(SaveOfACloth, ThatDoesNotFitIsNamed) {
    World world = World::create({.threads = 1}).value();
    const ClothId cloth = world.add_cloth(small_sheet(0)).value();
    world.step(h);
    const Bytes good = saved(world, cloth), whole = saved(world);
    const auto why = [&](ClothId id, const Bytes& bytes) {
        const std::uint64_t before = world.state_hash();
        return refusal(world, world.restore_cloth(id, bytes), before);
    };
    const auto adding = [&](const Mesh& mesh, const ClothSettings& settings) {
        return world.add_cloth(mesh, settings).value();
    };
    const auto says = [](const std::string& message, const std::string& what) {
        EXPECT_NE(message.find(what), std::string::npos) << message;
    };
    says(why(adding(small_sheet(1, 14), {}), good), "156 particles, the one here 168");
    Mesh turned = small_sheet(2);
    turned.rows = turned.columns = 0;
    says(why(adding(turned, {}), good), "other triangles");
    ClothSettings euler, meets;
    euler.time_scheme = TimeScheme::backward_euler;
    meets.self_collision = {.method = SelfCollisionMethod::contact};
    says(why(adding(small_sheet(3), euler), good), "set the time scheme");
    says(why(adding(small_sheet(4), meets), good), "set the self-collision");
    ASSERT_TRUE(world.add_collider({.shape = Plane{}}));
    says(why(cloth, good), "add colliders before where it had some");
    says(why(cloth, whole), "is of a World");
    says(why(cloth, {}), "0 bytes");
    Bytes damaged = good;
    damaged[damaged.size() / 2] ^= std::byte{1};
    says(why(cloth, damaged), "is damaged");
    says(why({}, good), "ClothId");
    const std::uint64_t before = world.state_hash();
    says(refusal(world, world.restore(good), before), "is of one cloth");
    EXPECT_FALSE(world.save_cloth(cloth, std::span(damaged).first(10)));
    EXPECT_EQ(world.cloth_save_size({}), 0u);
}

TEST(SaveOfCloths, NamesTheKeyOfAClothThatWasCut) {
    Stage stage({}, 2);
    stage.run(5);
    const Bytes then = saved(stage.world);
    const MeshCut cut = cut_mesh(small_sheet(0), std::vector<MeshEdge>{{30, 31}, {31, 32}, {32, 33}}).value();
    ASSERT_TRUE(stage.world.recut_cloth(stage.cloths[0], cut.mesh, cut.from));
    const auto why = [&] {
        const std::uint64_t before = stage.world.state_hash();
        const auto restored = stage.world.restore_cloths(then);
        EXPECT_EQ(stage.world.state_hash(), before);
        return restored ? "nothing" : restored.error().message;
    };
    EXPECT_NE(why().find("its cloth of the key 1 has"), std::string::npos) << why();
    ClothSettings keyless = stage.world.cloth_settings(stage.cloths[0]).value();
    keyless.key = 0;
    ASSERT_TRUE(stage.world.set_cloth_settings(stage.cloths[0], keyless));
    EXPECT_EQ(stage.world.restore_cloths(then).value(), 1u);
    keyless.key = 2;
    ASSERT_TRUE(stage.world.set_cloth_settings(stage.cloths[0], keyless));
    EXPECT_NE(why().find("two cloths have ClothSettings::key 2"), std::string::npos) << why();
}

// A cloth goes back to where another has come to be meanwhile: they part, and it does not hang in the other.
TEST(SaveOfACloth, PartsFromClothThatIsThereNow) {
    World world = World::create({.gravity = {}, .threads = 1}).value();
    ClothSettings meets;
    meets.self_collision = {.method = SelfCollisionMethod::contact};
    const ClothId cloth = world.add_cloth(small_sheet(0), meets).value();
    const Mesh slope = make_sheet({.rows = 13,
                                   .columns = 12,
                                   .origin = {5.2f, 0.395f, -0.25f},
                                   .u = {0.6f, 0.15f, 0},
                                   .v = {0, 0.02f, 0.6f}})
                           .value();
    const ClothId other = world.add_cloth(slope, meets).value();
    for (int k = 0; k < 3; ++k) world.step(h);
    const Bytes then = saved(world, cloth);
    ASSERT_TRUE(world.move_cloth(cloth, {.translation = {0, 2, 0}}));
    ASSERT_TRUE(world.move_cloth(other, {.translation = {-5, 0, 0}}));
    world.step(h);
    ASSERT_TRUE(world.restore_cloth(cloth, then));
    world.step(h);
    EXPECT_GT(world.report().crossings, 0u);
    for (int k = 0; k < 180; ++k) world.step(h);
    EXPECT_EQ(world.report().crossings, 0u);
}

TEST(SaveOfACloth, WakesWhatLayOnIt) {
    World world = World::create({.threads = 1}).value();
    ClothSettings meets;
    meets.self_collision = {.method = SelfCollisionMethod::contact};
    meets.sleep_speed = 0.05f;
    ASSERT_TRUE(world.add_collider({.shape = Plane{}}));
    const ClothId below = world.add_cloth(small_sheet(0), meets).value();
    const ClothId above = world.add_cloth(small_sheet(0.05f), meets).value();
    ASSERT_TRUE(world.move_cloth(above, {.translation = {0, 0.01f, 0}}));
    const Bytes start = saved(world, below);
    for (int k = 0; k < 600 && world.report().sleeping_cloths < 2; ++k) world.step(h);
    ASSERT_EQ(world.report().sleeping_cloths, 2u);
    const auto height = [&] {
        float sum = 0;
        const ClothView view = world.cloth(above).value();
        for (const Vec4& x : view.positions) sum += x.y;
        return sum / static_cast<float>(view.positions.size());
    };
    const float lay = height();
    ASSERT_TRUE(world.move_cloth(below, {.translation = {3, 0, 0}}));
    for (int k = 0; k < 600 && world.report().sleeping_cloths < 2; ++k) world.step(h);
    const Bytes beside = saved(world, below);
    ASSERT_TRUE(world.restore_cloth(below, start));
    world.step(h);
    EXPECT_LT(height(), lay);
    EXPECT_LT(world.report().sleeping_cloths, 2u);
    ASSERT_TRUE(world.restore_cloth(below, beside));
    EXPECT_TRUE(saved(world, below) == beside);
}

}  // namespace
}  // namespace weft::test::saves_by_cloth
