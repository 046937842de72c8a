// World::save and restore, as a host uses them: going back by some steps, saved games, and saves that are not
// what they should be.

#include <gtest/gtest.h>

#include <cmath>
#include <cstring>
#include <string>
#include <vector>

#include "tests/cloth/fixtures.h"
#include "weft/weft.h"

namespace weft::test::saving {
namespace {

using Bytes = std::vector<std::byte>;

ClothSettings of_method(const Method& method) {
    ClothSettings settings;
    settings.method = method;
    if (std::holds_alternative<SymplecticEuler>(method)) settings.substeps = 64;
    return settings;
}

ClothSettings with_contact() {
    ClothSettings settings;
    settings.self_collision = {.method = SelfCollisionMethod::contact};
    settings.tethers.enabled = true;
    return settings;
}

Bytes saved(const World& world) {
    Bytes bytes(world.save_size());
    EXPECT_TRUE(world.save(bytes));
    return bytes;
}

/// A sheet in gusts that is lowered by two corners onto another, a ball and the ground.
struct Game {
    explicit Game(const ClothSettings& settings, int threads = 1) : world(make_world(threads)) {
        for (const float height : {0.62f, 0.3f}) {
            const Mesh mesh = make_sheet({.rows = 13,
                                          .columns = 12,
                                          .origin = {-0.3f, height, -0.3f},
                                          .u = {0.6f, 0, 0},
                                          .v = {0, 0.02f, 0.6f}})
                                  .value();
            cloths.push_back(world.add_cloth(mesh, settings).value());
        }
        EXPECT_TRUE(world.pin(cloths[0], std::vector<std::uint32_t>{0, 11}));
        ball = world.add_collider({.shape = Sphere{{0, 0.1f, 0}, 0.15f}, .friction = 0.5f}).value();
        ground = world.add_collider({.shape = Plane{}, .friction = 0.6f}).value();
    }
    static World make_world(int threads) {
        WorldSettings settings;
        settings.wind.velocity = {1, 0, 3};
        settings.wind.gust = 0.5f;
        settings.threads = threads;
        return World::create(settings).value();
    }
    /// What the host does depends on the number of the step alone.
    void run(int steps) {
        for (int k = 0; k < steps; ++k) {
            const float time = h * static_cast<float>(step++);
            for (const std::uint32_t v : {0u, 11u})
                static_cast<void>(world.move_pin(
                    cloths[0], v, {v == 0 ? -0.3f : 0.3f, 0.62f - 0.8f * time, -0.3f + 0.2f * time}));
            EXPECT_TRUE(world.move_collider(
                ball, {.shape = Sphere{{0.3f * time, 0.1f, 0}, 0.15f}, .friction = 0.5f}));
            EXPECT_TRUE(!has(world.step(h).flags, StepFlags::state_restored));
        }
    }

    World world;
    std::vector<ClothId> cloths;
    ColliderId ball, ground;
    int step = 0;  // of the game, which goes back with it
};

struct SaveCase {
    const char* name;
    ClothSettings settings;
};
class Save : public testing::TestWithParam<SaveCase> {};
INSTANTIATE_TEST_SUITE_P(
    , Save,
    testing::Values(SaveCase{"Multilevel", of_method(Multilevel{})}, SaveCase{"Contact", with_contact()},
                    SaveCase{"Jacobi", of_method(Jacobi{})}, SaveCase{"Chebyshev", of_method(Chebyshev{})},
                    SaveCase{"ConjugateGradient", of_method(ConjugateGradient{})},
                    SaveCase{"Xpbd", of_method(Xpbd{})}, SaveCase{"Fibres", of_method(Fibres{})},
                    SaveCase{"SymplecticEuler", of_method(SymplecticEuler{})}),
    [](const auto& info) { return std::string(info.param.name); });

TEST_P(Save, GoesBackBySomeStepsAndOnWithTheSameBytes) {
    Game game(GetParam().settings);
    game.run(30);
    const Bytes then = saved(game.world);
    game.run(8);
    const Bytes expected = saved(game.world);

    ASSERT_TRUE(game.world.unpin(game.cloths[0], 0));
    ASSERT_TRUE(game.world.pin(game.cloths[1], std::vector<std::uint32_t>{5, 40, 41}));
    ASSERT_TRUE(game.world.place_collider(game.ground, {.shape = Plane{{0, 1, 0}, 0.2f}, .friction = 0}));
    ClothSettings other = GetParam().settings;
    other.fabric.warp *= 3;
    ASSERT_TRUE(game.world.set_cloth_settings(game.cloths[0], other));
    for (int k = 0; k < 5; ++k) game.world.step(h);
    ASSERT_TRUE(game.world.set_cloth_settings(game.cloths[0], GetParam().settings));
    ASSERT_TRUE(game.world.restore(then));
    EXPECT_TRUE(saved(game.world) == then);
    game.step = 30;
    game.run(8);
    EXPECT_TRUE(saved(game.world) == expected);
}

TEST_P(Save, GoesOnInAWorldMadeLaterOnMoreThreads) {
    Bytes then, expected;
    {
        Game game(GetParam().settings);
        game.run(30);
        then = saved(game.world);
        game.run(6);
        expected = saved(game.world);
    }
    Game later(GetParam().settings, 3);
    later.run(3);
    ASSERT_TRUE(later.world.restore(then));
    const Bounds bounds = later.world.cloth(later.cloths[0])->bounds;
    for (const Vec4& x : later.world.cloth(later.cloths[0])->positions) {
        EXPECT_LE(bounds.lower.y, x.y);
        EXPECT_GE(bounds.upper.y, x.y);
    }
    later.step = 30;
    later.run(6);
    EXPECT_TRUE(saved(later.world) == expected);
}

void expect_refused(World& world, std::span<const std::byte> bytes, const std::string& says) {
    const std::uint64_t before = world.state_hash();
    const Result<void> result = world.restore(bytes);
    ASSERT_FALSE(result);
    EXPECT_NE(result.error().message.find(says), std::string::npos) << result.error().message;
    EXPECT_EQ(world.state_hash(), before);
}

World small_world() {
    World world = World::create().value();
    EXPECT_TRUE(world.add_cloth(make_sheet({.rows = 3, .columns = 3}).value()));
    EXPECT_TRUE(world.add_collider({.shape = Plane{}}));
    world.step(h);
    return world;
}

/// A sheet in a frame that turns, on leashes and a backstop, with a step's plans made.
struct WornGame {
    explicit WornGame(bool in_frame = true) : world(World::create({.threads = 1}).value()) {
        ClothSettings settings;
        settings.frame_inertia = {0.5f, 0, 0.5f};
        cloth = world.add_cloth(mesh, settings).value();
        EXPECT_TRUE(world.set_map(cloth, Map::leash, std::vector<float>(mesh.positions.size(), 0.05f)));
        EXPECT_TRUE(world.set_map(cloth, Map::backstop, std::vector<float>(mesh.positions.size(), 0.01f)));
        EXPECT_TRUE(world.add_collider({.shape = Sphere{{0.1f, -0.1f, 0}, 0.15f}}));
        if (in_frame) {
            EXPECT_TRUE(world.set_frame(cloth, {}));
        }
    }
    void plan() {
        const float t = h * static_cast<float>(++step);
        std::vector<Vec3> places = mesh.positions, normals(places.size(), Vec3{t, 1, 0});
        for (Vec3& p : places) p.x += t;
        EXPECT_TRUE(world.set_skin(cloth, places, normals));
        EXPECT_TRUE(
            world.set_frame(cloth, {.translation = {t, 0, 0}, .rotation = {0, std::sin(t), 0, std::cos(t)}}));
    }
    void run(int steps) {
        for (int k = 0; k < steps; ++k) {
            plan();
            EXPECT_FALSE(has(world.step(h).flags, StepFlags::state_restored));
        }
    }
    Mesh mesh = make_sheet({.rows = 9, .columns = 8}).value();
    World world;
    ClothId cloth;
    int step = 0;
};

TEST(SaveOfWornCloth, GoesOnInAnotherWorldInTheMiddleOfItsPlans) {
    WornGame game, later(false);
    game.run(20);
    game.plan();
    const Bytes then = saved(game.world);
    game.world.step(h);
    game.run(5);
    ASSERT_TRUE(later.world.restore(then));
    EXPECT_TRUE(saved(later.world) == then);
    later.step = 21;
    later.world.step(h);
    later.run(5);
    EXPECT_TRUE(saved(later.world) == saved(game.world));

    ASSERT_TRUE(later.world.set_map(later.cloth, Map::backstop, {}));
    expect_refused(later.world, then, "set the maps of leashes and backstops");
}

TEST(SaveOfWornCloth, TakesAClothOutOfItsFrame) {
    WornGame free(false), framed;
    const Bytes then = saved(free.world);
    framed.run(3);
    ASSERT_TRUE(framed.world.restore(then));
    EXPECT_TRUE(saved(framed.world) == then);
    EXPECT_EQ(framed.world.state_hash(), free.world.state_hash());
    for (WornGame* game : {&free, &framed}) game->world.step(h);
    EXPECT_EQ(framed.world.state_hash(), free.world.state_hash());
}

// What touched what, and what bodies got, was of a step that has not been taken any more.
TEST(SaveOfContacts, IsWithoutWhatTheLastStepReported) {
    World world = World::create({.contact_reports = 100, .threads = 1}).value();
    const ClothId cloth = world.add_cloth(make_sheet({.rows = 5, .columns = 5}).value()).value();
    ASSERT_TRUE(world.add_collider({.shape = Plane{.offset = -0.02f}}));
    const BodyId body = world.add_body({.mass = 0.1f}, {.position = {0.5f, 0, 0.5f}}).value();
    ASSERT_TRUE(world.attach(body, cloth, std::vector<std::uint32_t>{12}));
    const Bytes start = saved(world);
    const auto has_got_something = [&] {
        return std::ranges::any_of(world.body_impulses(), [](const BodyImpulse& got) {
            return got.linear.x != 0 || got.linear.y != 0 || got.linear.z != 0;
        });
    };
    for (int k = 0; k < 12; ++k) world.step(h);
    ASSERT_FALSE(world.contacts().empty());
    ASSERT_TRUE(has_got_something());
    ASSERT_TRUE(world.restore(start));
    EXPECT_TRUE(world.contacts().empty());
    ASSERT_EQ(world.body_impulses().size(), 1u);
    EXPECT_EQ(world.body_impulses()[0].body, body);
    EXPECT_FALSE(has_got_something());

    for (int k = 0; k < 12; ++k) world.step(h);
    ASSERT_TRUE(has_got_something());
    const BodyId other = world.add_body({}, {.position = {9, 9, 9}}).value();
    ASSERT_EQ(world.body_impulses().size(), 2u);
    EXPECT_EQ(world.body_impulses()[1].body, other);
    EXPECT_FALSE(has_got_something());
    for (int k = 0; k < 3; ++k) world.step(h);
    ASSERT_TRUE(has_got_something());
    ASSERT_TRUE(world.remove_body(other));
    ASSERT_EQ(world.body_impulses().size(), 1u);
    EXPECT_EQ(world.body_impulses()[0].body, body);
    EXPECT_FALSE(has_got_something());
}

TEST(SaveRefuses, EveryFlippedByteAndEveryShorterOne) {
    World world = small_world();
    const Bytes good = saved(world);
    world.step(h);
    for (std::size_t k = 0; k < good.size(); ++k) {
        Bytes bad = good;
        bad[k] ^= std::byte{static_cast<unsigned char>(1u << (k % 8))};
        expect_refused(world, bad, "the save");
        expect_refused(world, std::span(good).first(k), "the save has");
    }
    Bytes longer = good;
    longer.push_back({});
    expect_refused(world, longer, std::to_string(longer.size()) + " were given");
}

TEST(SaveRefuses, ByName) {
    World world = small_world();
    Bytes foreign = saved(world), newer = foreign, damaged = foreign;
    foreign[0] = std::byte{'X'};
    expect_refused(world, foreign, "does not begin with WEFTSAVE");
    newer[8] = std::byte{200};
    expect_refused(world, newer, "version 200; this library reads version");
    damaged.back() ^= std::byte{1};
    expect_refused(world, damaged, "is damaged");
    Bytes short_one(world.save_size() - 1);
    const Result<void> result = world.save(short_one);
    ASSERT_FALSE(result);
    EXPECT_NE(result.error().message.find(std::to_string(world.save_size())), std::string::npos);
}

TEST(SaveRefuses, AWorldOfOtherThings) {
    const Bytes good = saved(small_world());
    World world = small_world();
    EXPECT_TRUE(world.add_cloth(make_sheet({.rows = 3, .columns = 3}).value()));
    expect_refused(world, good, "it has 1 cloths, this one has 2");

    World colliders = small_world();
    EXPECT_TRUE(colliders.add_collider({.shape = Sphere{}}));
    expect_refused(colliders, good, "it has 1 colliders, this one has 2");
    World kinds = World::create().value();
    EXPECT_TRUE(kinds.add_cloth(make_sheet({.rows = 3, .columns = 3}).value()));
    EXPECT_TRUE(kinds.add_collider({.shape = Sphere{}}));
    expect_refused(kinds, good, "colliders are of other kinds");

    const auto with_two = [](const decltype(Collider::shape)& first,
                             const decltype(Collider::shape)& second) {
        World two = World::create().value();
        EXPECT_TRUE(two.add_collider({.shape = first}));
        EXPECT_TRUE(two.add_collider({.shape = second}));
        return two;
    };
    World in_turn = with_two(Plane{}, Sphere{});
    expect_refused(in_turn, saved(with_two(Sphere{}, Plane{})), "or in another order");

    World finer = World::create().value();
    EXPECT_TRUE(finer.add_collider({.shape = Plane{}}));
    EXPECT_TRUE(finer.add_cloth(make_sheet({.rows = 4, .columns = 3}).value()));
    expect_refused(finer, good, "cloth 0 has 9 particles, the one here 12");

    // As many particles, joined otherwise.
    World other = World::create().value();
    EXPECT_TRUE(other.add_collider({.shape = Plane{}}));
    Mesh mesh = make_sheet({.rows = 3, .columns = 3}).value();
    mesh.rows = mesh.columns = 0;
    mesh.triangles = {{0, 1, 3}, {1, 4, 3}, {1, 2, 4}, {2, 5, 4}, {3, 4, 6}, {4, 7, 6}, {4, 5, 8}, {4, 8, 7}};
    EXPECT_TRUE(other.add_cloth(mesh));
    expect_refused(other, good, "cloth 0 has other triangles");
}

TEST(SaveRefuses, SettingsByWhichAClothHasAnotherState) {
    World world = World::create().value();
    const ClothId cloth = world.add_cloth(make_sheet({.rows = 3, .columns = 3}).value()).value();
    EXPECT_TRUE(world.add_collider({.shape = Plane{}}));
    const Bytes good = saved(world);
    const auto with = [&](const auto& change) {
        ClothSettings settings;
        change(settings);
        EXPECT_TRUE(world.set_cloth_settings(cloth, settings));
    };
    with([](ClothSettings& s) { s.time_scheme = TimeScheme::backward_euler; });
    expect_refused(world, good, "BDF2");
    with([](ClothSettings& s) { s.self_collision = {.method = SelfCollisionMethod::contact}; });
    expect_refused(world, good, "contact");
    with([](ClothSettings& s) {
        s.method = ConjugateGradient{};
        s.time_scheme = TimeScheme::bdf2;
        s.collider_response = ColliderResponse::velocity_filter;
    });
    expect_refused(world, good, "held by colliders");
    with([](ClothSettings&) {});
    EXPECT_TRUE(world.restore(good));
}

}  // namespace
}  // namespace weft::test::saving
