// What a step promises, whatever the host does between steps: speeds, bounds, colliders, pins.

#include <gtest/gtest.h>

#include <array>
#include <random>

#include "tests/cloth/fixtures.h"

namespace weft::test {
namespace {

constexpr float dt = 1.0f / 60;

float fastest(const World& world, ClothId id) {
    const ClothView view = world.cloth(id).value();
    float peak = 0;
    for (const Vec4& v : view.velocities) peak = std::max(peak, xyz(v).norm());
    return peak;
}

/// A sheet of 1 m that hangs by two corners, at rest, in a World without air.
struct HungByCorners {
    explicit HungByCorners(const ClothSettings& settings = {},
                           WorldSettings of_world = vacuum({0, -9.81f, 0}))
        : world(World::create(of_world).value()),
          cloth(world
                    .add_cloth(make_sheet({.rows = 24,
                                           .columns = 24,
                                           .origin = {-0.5f, 0.5f, 0},
                                           .u = {1, 0, 0},
                                           .v = {0, -1, 0}})
                                   .value(),
                               settings)
                    .value()) {
        EXPECT_TRUE(world.pin(cloth, std::array{0u, 23u}));
    }
    void step(int count = 1) {
        for (int k = 0; k < count; ++k) world.step(dt);
    }
    World world;
    ClothId cloth;
};

std::vector<Method> plain_methods() {
    return {Multilevel{}, Jacobi{}, Chebyshev{}, ConjugateGradient{}, Xpbd{}, Fibres{}, SymplecticEuler{}};
}

ClothSettings with(const Method& method) {
    ClothSettings settings;
    settings.method = method;
    if (std::holds_alternative<SymplecticEuler>(method)) settings.substeps = 64;
    return settings;
}

TEST(MaxSpeed, HoldsWhenAColliderJumpsIntoTheCloth) {
    for (const Method& method : plain_methods()) {
        for (const float jump : {10.0f, 100.0f, 1000.0f}) {
            ClothSettings settings = with(method);
            settings.self_collision.method = SelfCollisionMethod::contact;
            HungByCorners hung(settings);
            const ColliderId ball = hung.world.add_collider({.shape = Sphere{{0, 0, jump}, 0.3f}}).value();
            hung.step(20);
            ASSERT_TRUE(hung.world.move_collider(ball, {.shape = Sphere{{0, 0, 0.1f}, 0.3f}}));
            hung.step();
            EXPECT_LE(fastest(hung.world, hung.cloth), 1.0001f * hung.world.settings().max_speed)
                << method.index() << ", " << jump << " m";
            hung.step(5);
            EXPECT_LE(fastest(hung.world, hung.cloth), 1.0001f * hung.world.settings().max_speed);
            EXPECT_FALSE(has(hung.world.report().flags, StepFlags::state_restored));
        }
    }
}

TEST(PlaceCollider, PutsClothOutsideAndThrowsNothing) {
    for (const float jump : {10.0f, 1000.0f}) {
        HungByCorners hung;
        const ColliderId ball = hung.world.add_collider({.shape = Sphere{{0, 0, jump}, 0.3f}}).value();
        hung.step(60);
        ASSERT_TRUE(hung.world.place_collider(ball, {.shape = Sphere{{0, 0, 0.1f}, 0.3f}}));
        float speed = 0;
        for (int k = 0; k < 120; ++k) {
            hung.step();
            speed = std::max(speed, fastest(hung.world, hung.cloth));
        }
        const ClothView view = hung.world.cloth(hung.cloth).value();
        for (const Vec4& x : view.positions)
            EXPECT_GT((xyz(x) - Vector3(0, 0, 0.1f)).norm(), 0.3f) << "no particle is left inside";
        EXPECT_LT(speed, 2) << "as fast as cloth that hangs and is stretched by a hand";
    }
}

TEST(PlaceCollider, RefusesWhatMoveColliderRefuses) {
    HungByCorners hung;
    const ColliderId ball = hung.world.add_collider({.shape = Sphere{{0, 0, 9}, 0.3f}}).value();
    EXPECT_EQ(hung.world.place_collider(ball, {.shape = Plane{}}).error().code, ErrorCode::invalid_argument);
    EXPECT_EQ(hung.world.place_collider(ball, {.shape = Sphere{{0, NAN, 0}, 1}}).error().code,
              ErrorCode::invalid_argument);
    EXPECT_EQ(hung.world.place_collider({}, {.shape = Sphere{}}).error().code, ErrorCode::stale_id);
    EXPECT_EQ(std::get<Sphere>(hung.world.collider(ball)->shape).center.z, 9);
}

TEST(Bounds, HoldPinsThatHaveMoved) {
    HungByCorners hung;
    ASSERT_TRUE(hung.world.move_pin(hung.cloth, 0, {9.5f, 0.5f, -3}));
    hung.step();
    const ClothView view = hung.world.cloth(hung.cloth).value();
    EXPECT_EQ(view.positions[0].x, 9.5f);
    EXPECT_EQ(view.bounds.upper.x, 9.5f);
    EXPECT_EQ(view.bounds.lower.z, -3);
}

TEST(Settle, LeavesNoParticleInsideAColliderWithSelfCollisionOn) {
    // A sheet dropped on a small ball folds over it and is pushed by its own layers.
    ClothSettings settings;
    settings.self_collision = {.method = SelfCollisionMethod::avoidance, .distance = 0.04f};
    settings.thickness = 0.005f;
    for (const Method& method : {Method(Multilevel{}), Method(Xpbd{})}) {
        settings.method = method;
        World world = World::create(vacuum({0, -9.81f, 0})).value();
        const Mesh mesh = make_sheet({.rows = 40, .columns = 40, .origin = {-0.5f, 0.25f, -0.5f}}).value();
        const ClothId cloth = world.add_cloth(mesh, settings).value();
        ASSERT_TRUE(world.add_collider({.shape = Sphere{{0, 0, 0}, 0.15f}}));
        std::uint32_t contacts = 0;
        for (int k = 0; k < 120; ++k) {
            world.step(dt);
            contacts += world.report().self_contacts;
            const ClothView view = world.cloth(cloth).value();
            float deepest = 0;
            for (const Vec4& x : view.positions) deepest = std::max(deepest, 0.155f - xyz(x).norm());
            ASSERT_LT(deepest, 1e-5f) << "frame " << k;
        }
        EXPECT_GT(contacts, 0u);
    }
}

TEST(Pins, ManyAtOnceAreThoseOneByOneInAnyOrder) {
    for (const Method& method : plain_methods()) {
        ClothSettings settings = with(method);
        settings.tethers.enabled = true;
        HungByCorners at_once(settings), one_by_one(settings);
        std::vector<std::uint32_t> vertices;
        for (std::uint32_t v = 7; v < 576; v += 61) vertices.push_back(v);
        ASSERT_TRUE(at_once.world.pin(at_once.cloth, vertices));
        std::ranges::shuffle(vertices, std::mt19937(5));
        for (const std::uint32_t v : vertices) ASSERT_TRUE(one_by_one.world.pin(one_by_one.cloth, v));
        for (const std::uint32_t v : {100u, 200u}) ASSERT_TRUE(one_by_one.world.pin(one_by_one.cloth, v));
        ASSERT_TRUE(one_by_one.world.unpin(one_by_one.cloth, std::array{200u, 100u}));
        at_once.step(5);
        one_by_one.step(5);
        EXPECT_EQ(at_once.world.state_hash(), one_by_one.world.state_hash()) << method.index();
    }
}

TEST(Pins, AVertexThatDoesNotExistLeavesTheOthersFree) {
    HungByCorners hung;
    const std::uint64_t before = hung.world.state_hash();
    const Result<void> result = hung.world.pin(hung.cloth, std::array{5u, 576u});
    ASSERT_FALSE(result);
    EXPECT_NE(result.error().message.find("576"), std::string::npos);
    EXPECT_EQ(hung.world.state_hash(), before);
}

}  // namespace
}  // namespace weft::test
