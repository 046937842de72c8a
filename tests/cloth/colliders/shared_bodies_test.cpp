// Bodies that several cloths share, and bodies on cloth that cannot give way.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "engine/vector.h"
#include "weft/weft.h"

namespace weft::test::shared_bodies {
namespace {

constexpr float h = 1.0f / 60;
constexpr std::uint32_t wall_side = 16;

World make_world(int threads = 1) {
    WorldSettings settings;
    settings.threads = threads;
    return World::create(settings).value();
}

std::vector<std::uint32_t> row(std::uint32_t r) {
    std::vector<std::uint32_t> vertices;
    for (std::uint32_t i = 0; i < wall_side; ++i) vertices.push_back(r * wall_side + i);
    return vertices;
}

/// Cloths one below the other from pins, with a bar between any two that is attached to both.
struct Chain {
    Chain(float mass, std::uint32_t count, const std::vector<ClothSettings>& settings, int threads = 1)
        : world(make_world(threads)) {
        for (std::uint32_t k = 0; k < count; ++k) {
            const float top = 1 - 0.3f * static_cast<float>(k);
            const Mesh mesh = make_sheet({.rows = wall_side,
                                          .columns = wall_side,
                                          .origin = {0, top, 0},
                                          .u = {0.3f, 0, 0},
                                          .v = {0, -0.3f, 0}})
                                  .value();
            cloths.push_back(world.add_cloth(mesh, settings[k % settings.size()]).value());
            if (k == 0) {
                EXPECT_TRUE(world.pin(cloths[0], row(0)));
                continue;
            }
            const float i = mass * 0.09f / 12;
            bars.push_back(
                world.add_body({.mass = mass, .inertia = {mass * 1e-4f, i, i}}, {.position = {0.15f, top, 0}})
                    .value());
            EXPECT_TRUE(world.attach(bars.back(), cloths[k - 1], row(wall_side - 1)));
            EXPECT_TRUE(world.attach(bars.back(), cloths[k], row(0)));
        }
    }
    /// Returns the greatest speed.
    float run(int steps) {
        float fastest = 0;
        for (int i = 0; i < steps; ++i) {
            fastest = std::max(fastest, world.step(h).peak_speed);
            restored += world.report().restored_cloths;
        }
        return fastest;
    }
    void expect_hangs(int steps = 240) {
        EXPECT_LT(run(steps), 2);
        EXPECT_EQ(restored, 0u);
        for (std::size_t k = 0; k < bars.size(); ++k)
            EXPECT_NEAR(world.body_state(bars[k])->position.y, 0.7f - 0.3f * static_cast<float>(k), 0.03f);
    }
    World world;
    std::vector<ClothId> cloths;
    std::vector<BodyId> bars;
    std::uint32_t restored = 0;
};

ClothSettings with_contact() {
    ClothSettings settings;
    settings.self_collision = {.method = SelfCollisionMethod::contact};
    return settings;
}

TEST(SharedBodies, TwoClothsOnOneBarHang) {
    for (const float mass : {0.5f, 0.05f, 0.005f, 0.0005f}) {
        SCOPED_TRACE(mass);
        Chain(mass, 2, {{}}).expect_hangs();
    }
}

TEST(SharedBodies, ClothsWithContactHang) {
    Chain(0.005f, 2, {with_contact()}).expect_hangs();
}

TEST(SharedBodies, ClothsThatTakeTheirOwnSubstepsHang) {
    ClothSettings settings;
    settings.substeps = 2;
    Chain(0.005f, 2, {settings}).expect_hangs();
}

TEST(SharedBodies, AChainOfClothsHangs) {
    Chain(0.002f, 4, {{}}).expect_hangs();
}

TEST(SharedBodies, TheLoadOnTheBarsIsWhatHangsBelow) {
    Chain chain(0.02f, 3, {{}});
    chain.run(600);
    const float cloth = chain.world.cloth_info(chain.cloths[0])->mass;
    // At rest a bar gets its own weight from all that is attached to it.
    Vec3 sum{};
    for (int i = 0; i < 60; ++i) {
        chain.world.step(h);
        sum.y += chain.world.body_impulses()[0].linear.y;
    }
    EXPECT_NEAR(sum.y, 0.02f * 9.81f, 0.02f * cloth * 9.81f + 0.02f);
}

TEST(SharedBodies, AClothThatComesLaterIsStepped) {
    // Steps of another length than the last are of first order: such cloth takes one step, not two.
    World world = make_world();
    const auto add = [&](float x) {
        const Mesh mesh = make_sheet({.rows = wall_side,
                                      .columns = wall_side,
                                      .origin = {x, 1, 0},
                                      .u = {0.3f, 0, 0},
                                      .v = {0, 0, 0.3f}})
                              .value();
        ClothSettings settings = with_contact();
        settings.air_damping = 0;
        return world.add_cloth(mesh, settings).value();
    };
    add(0);
    for (int i = 0; i < 5; ++i) world.step(h);
    ASSERT_TRUE(world.move_cloth(add(0), {.translation = {0, -0.13f, 0}}));
    const ClothId late = add(0.001f);
    world.step(h);
    EXPECT_NEAR(world.cloth(late)->velocities[0].y, -9.81f * h, 0.02f);
}

/// A ball above a level sheet on something.
struct BallOnSheet {
    BallOnSheet(float mass, const ClothSettings& settings, std::uint32_t count = 33, float y = 0.2f,
                float radius = 0.1f)
        : world(make_world()) {
        const Mesh mesh =
            make_sheet({.rows = count, .columns = count, .origin = {-0.5f, 0.005f, -0.5f}}).value();
        cloth = world.add_cloth(mesh, settings).value();
        const float inertia = 0.4f * mass * radius * radius;
        ball = world.add_body({.mass = mass, .inertia = {inertia, inertia, inertia}}, {.position = {0, y, 0}})
                   .value();
        const ColliderId collider =
            world.add_collider({.shape = Sphere{.center = {0, y, 0}, .radius = radius}}).value();
        EXPECT_TRUE(world.attach_collider(ball, collider));
    }
    void run(int steps) {
        for (int i = 0; i < steps; ++i) world.step(h);
    }
    [[nodiscard]] BodyState state() const { return world.body_state(ball).value(); }
    World world;
    ClothId cloth;
    BodyId ball;
};

TEST(BodyStops, ABallRestsOnClothThatLiesOnTheGround) {
    for (const bool contact : {false, true}) {
        for (const float mass : {0.01f, 0.1f, 1.0f, 10.0f}) {
            SCOPED_TRACE(std::to_string(mass) + " kg" + (contact ? ", contact" : ""));
            BallOnSheet scene(mass, contact ? with_contact() : ClothSettings());
            EXPECT_TRUE(scene.world.add_collider({.shape = Plane{}}));
            scene.run(240);
            EXPECT_NEAR(scene.state().position.y, 0.11f, 0.006f);
            EXPECT_LT(std::hypot(scene.state().position.x, scene.state().position.z), 0.05f);
            EXPECT_LT(to_vector(scene.state().velocity).norm(), 0.05f);
            Vec3 got{};
            for (int i = 0; i < 60; ++i) {
                scene.world.step(h);
                got.y += scene.world.body_impulses()[0].linear.y;
            }
            EXPECT_NEAR(got.y, 9.81f * mass, 0.03f * 9.81f * mass);
        }
    }
}

TEST(BodyStops, ABallRestsOnPinnedCloth) {
    for (const float mass : {0.05f, 5.0f}) {
        BallOnSheet scene(mass, {});
        std::vector<std::uint32_t> all(33 * 33);
        for (std::uint32_t i = 0; i < all.size(); ++i) all[i] = i;
        ASSERT_TRUE(scene.world.pin(scene.cloth, all));
        scene.run(240);
        EXPECT_NEAR(scene.state().position.y, 0.11f, 0.006f);
        EXPECT_LT(to_vector(scene.state().velocity).norm(), 0.05f);
    }
}

TEST(BodyStops, PinsThatMoveLiftABall) {
    BallOnSheet scene(1, {}, 25);
    std::vector<std::uint32_t> all(25 * 25);
    for (std::uint32_t i = 0; i < all.size(); ++i) all[i] = i;
    ASSERT_TRUE(scene.world.pin(scene.cloth, all));
    scene.run(120);
    for (int k = 1; k <= 60; ++k) {
        std::vector<Vec3> targets;
        for (const std::uint32_t i : all)
            targets.push_back({-0.5f + static_cast<float>(i % 25) / 24,
                               0.005f + 0.01f * static_cast<float>(k),
                               -0.5f + static_cast<float>(i / 25) / 24});
        ASSERT_TRUE(scene.world.move_pins(scene.cloth, all, targets));
        scene.world.step(h);
    }
    EXPECT_NEAR(scene.state().position.y, 0.71f, 0.03f);
}

TEST(BodyStops, ABallOnClothGoesWithThePlatformBelow) {
    BallOnSheet scene(1, {});
    const auto box = [](float y) {
        return Collider{.shape = Box{.center = {0, y - 0.1f, 0}, .half_extents = {0.6f, 0.1f, 0.6f}}};
    };
    const ColliderId platform = scene.world.add_collider(box(0)).value();
    scene.run(120);
    for (int k = 1; k <= 60; ++k) {
        ASSERT_TRUE(scene.world.move_collider(platform, box(0.01f * static_cast<float>(k))));
        scene.world.step(h);
    }
    EXPECT_NEAR(scene.state().position.y, 0.71f, 0.03f);
}

TEST(BodyStops, AFastHeavyBallIsStopped) {
    BallOnSheet scene(5, {}, 49, 1);
    ASSERT_TRUE(scene.world.add_collider({.shape = Plane{}}));
    ASSERT_TRUE(scene.world.set_body_state(scene.ball, {.position = {0, 1, 0}, .velocity = {0, -8, 0}}));
    float lowest = 1, highest = 0;
    for (int i = 0; i < 120; ++i) {
        scene.world.step(h);
        lowest = std::min(lowest, scene.state().position.y);
        if (i > 20) highest = std::max(highest, scene.state().position.y);
    }
    EXPECT_GT(lowest, 0.08f);
    EXPECT_LT(highest, 0.2f);  // it gains nothing
}

TEST(BodyStops, ARollingBallSlowsByFriction) {
    BallOnSheet scene(1, {}, 49, 0.11f);
    ASSERT_TRUE(scene.world.add_collider({.shape = Plane{}}));
    ASSERT_TRUE(
        scene.world.set_body_state(scene.ball, {.position = {-0.3f, 0.11f, 0}, .velocity = {0.5f, 0, 0}}));
    scene.run(30);
    const BodyState state = scene.state();
    EXPECT_GT(state.velocity.x, 0.1f);
    EXPECT_LT(state.velocity.x, 0.5f);
    EXPECT_NEAR(-state.angular_velocity.z * 0.1f, state.velocity.x, 0.1f);
    EXPECT_NEAR(state.position.y, 0.11f, 0.008f);
}

TEST(BodyStops, LooseVerticesStopNothing) {
    World world = make_world();
    const std::vector<Vec3> vertices{{2, 0, 0}, {3, 0, 0}, {2, 0, 1}, {0, 0, 0}};
    const std::vector<Triangle> triangles{{0, 2, 1}};
    ASSERT_TRUE(world.add_cloth(Mesh{.positions = vertices, .triangles = triangles}));
    const BodyId ball = world.add_body({.mass = 1, .inertia = {1, 1, 1}}, {.position = {0, 0.5f, 0}}).value();
    const ColliderId collider = world.add_collider({.shape = Sphere{{0, 0.5f, 0}, 0.1f}}).value();
    ASSERT_TRUE(world.attach_collider(ball, collider));
    for (int i = 0; i < 60; ++i) world.step(h);
    EXPECT_LT(world.body_state(ball)->position.y, -3);
}

}  // namespace
}  // namespace weft::test::shared_bodies
