// Rigid bodies that cloth moves: balance, momentum, stability, and what a host is told.

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <numbers>
#include <vector>

#include "tests/cloth/colliders/bodies_scene.h"

namespace weft::test {
namespace {

using Held = SheetAndBody::Held;

SheetAndBody::Setup weightless(float mass, float speed) {
    SheetAndBody::Setup setup;
    setup.mass = mass;
    setup.cloth.air_damping = 0;
    setup.world.gravity = {};
    setup.state = {.position = {0.1f, 0.2f, 0.05f}, .velocity = {0, -speed, 0}};
    return setup;
}

/// That each step's impulses on the body have, in a mean over some steps [N].
Vector3 mean_force(World& world, std::size_t number, int steps) {
    Vector3 sum = Vector3::Zero();
    for (int k = 0; k < steps; ++k) {
        world.step(body_step);
        sum += to_vector(world.body_impulses()[number].linear);
    }
    return sum / (static_cast<float>(steps) * body_step);
}

TEST(Bodies, ABallComesToRestInAHammock) {
    SheetAndBody scene(
        {.side = 17, .cloth = {.fabric = {.warp = 2000, .weft = 2000, .shear = 500}, .air_damping = 2}},
        Held::corners);
    scene.steps(900);
    const float height = scene.state().position.y;
    EXPECT_LT(scene.fastest(), 0.05f);
    EXPECT_LT(scene.deepest(), 0);
    EXPECT_LT(height, -0.05f);
    EXPECT_NEAR(mean_force(scene.world, 0, 60).y(), 9.81f, 0.1f);
    EXPECT_NEAR(scene.state().position.y, height, 5e-3f);
    EXPECT_NEAR(scene.state().position.x, 0, 0.05f);
    EXPECT_NEAR(scene.state().position.z, 0, 0.05f);
}

TEST(Bodies, ABoxBouncesOnATrampolineAndSettles) {
    SheetAndBody scene({.side = 17,
                        .cloth = {.fabric = {.warp = 2000, .weft = 2000, .shear = 500}},
                        .mass = 2,
                        .radius = 0.1f,
                        .state = {.position = {0, 0.6f, 0}},
                        .box = true},
                       Held::border);
    float lowest = 1, highest_after = -1;
    for (int k = 0; k < 120; ++k) {
        scene.steps(1);
        const float y = scene.state().position.y;
        if (y < lowest) highest_after = lowest = y;
        highest_after = std::max(highest_after, y);
    }
    EXPECT_GT(highest_after, lowest + 0.1f);
    EXPECT_LT(highest_after, 0.6f);
    scene.steps(1800);
    EXPECT_LT(to_vector(scene.state().velocity).norm(), 0.02f);
    EXPECT_NEAR(mean_force(scene.world, 0, 60).y(), 2 * 9.81f, 0.2f);
    EXPECT_GT(scene.state().position.y, -0.3f);
}

TEST(Bodies, AThrownBallAndAFreeSheetKeepTheirMomentumTogether) {
    for (const bool with_contact : {false, true})
        for (const float mass : {0.02f, 0.2f, 2.0f}) {
            SheetAndBody::Setup setup = weightless(mass, 2);
            setup.cloth.self_collision.method =
                with_contact ? SelfCollisionMethod::contact : SelfCollisionMethod::off;
            SheetAndBody scene(setup, Held::free);
            const SheetAndBody::Momentum before = scene.momentum();
            double most = before.energy;
            for (int k = 0; k < 80; ++k) {
                scene.steps(1);
                const SheetAndBody::Momentum now = scene.momentum();
                const double scale = static_cast<double>(mass) * 2;
                ASSERT_LT((now.linear - before.linear).norm(), 1e-5 * scale)
                    << mass << " kg, step " << k << ", contact " << with_contact;
                ASSERT_LT((now.angular - before.angular).norm(), 1e-4 * scale)
                    << mass << " kg, step " << k << ", contact " << with_contact;
                most = std::max(most, now.energy);
            }
            EXPECT_LE(most, 1.001 * before.energy) << mass;
            EXPECT_GT(to_vector(scene.state().velocity).y(), -1.99f) << "it never touched";
        }
}

// The momentum that the solve loses is given back to the ball and both sheets as one, since each touches
// another.
TEST(Bodies, ABallThrownIntoTwoFreeSheetsKeepsTheirMomentum) {
    for (const bool with_contact : {false, true})
        for (const float mass : {0.02f, 0.2f, 2.0f}) {
            SheetAndBody::Setup setup = weightless(mass, 2);
            setup.cloth.self_collision.method =
                with_contact ? SelfCollisionMethod::contact : SelfCollisionMethod::off;
            SheetAndBody scene(setup, Held::free);
            const Mesh beside = make_sheet({.rows = 13,
                                            .columns = 13,
                                            .origin = {-0.5f, -0.05f, -0.5f},
                                            .u = {0.7f, 0, 0},
                                            .v = {0, 0, 0.9f}})
                                    .value();
            const ClothId other = scene.world.add_cloth(beside, setup.cloth).value();
            const auto momentum = [&] {
                Eigen::Vector3d sum = scene.momentum().linear;
                const ClothView view = scene.world.cloth(other).value();
                for (std::size_t i = 0; i < view.positions.size(); ++i)
                    sum += xyz(view.velocities[i]).cast<double>() / static_cast<double>(view.positions[i].w);
                return sum;
            };
            const Eigen::Vector3d before = momentum();
            for (int k = 0; k < 60; ++k) {
                scene.steps(1);
                ASSERT_LT((momentum() - before).norm(), 1e-5 * static_cast<double>(mass) * 2)
                    << mass << " kg, step " << k << ", contact " << with_contact;
            }
        }
}

TEST(Bodies, OfAnyMassComeToRestOnCloth) {
    const float of_cloth = 0.2f;
    for (const float ratio : {0.01f, 0.1f, 1.0f, 10.0f, 100.0f}) {
        SheetAndBody scene(
            {.side = 17,
             .cloth = {.fabric = {.warp = 4000, .weft = 4000, .shear = 1000}, .air_damping = 1},
             .mass = ratio * of_cloth,
             .state = {.position = {0, 0.2f, 0}}},
            Held::border);
        float fastest = 0;
        for (int k = 0; k < 600; ++k) {
            scene.steps(1);
            fastest = std::max(fastest, scene.fastest());
        }
        // The heaviest stretches cells to twice their length; a particle that slips is drawn back fast.
        EXPECT_LT(fastest, 5) << ratio;
        EXPECT_LT(to_vector(scene.state().velocity).norm(), 0.05f) << ratio;
        const float weight = 9.81f * ratio * of_cloth;
        EXPECT_NEAR(mean_force(scene.world, 0, 60).y(), weight, 0.05f * weight) << ratio;
        EXPECT_LT(scene.deepest(), 0.002f) << ratio;
    }
}

TEST(Bodies, TheFlagPullsItsPole) {
    WorldSettings settings;
    settings.threads = 1;
    settings.wind.air_density = 0;
    World world = World::create(settings).value();
    const ClothId flag =
        world
            .add_cloth(*make_sheet(
                {.rows = 17, .columns = 25, .origin = {0, 1, 0}, .u = {0.6f, 0, 0}, .v = {0, -0.4f, 0}}))
            .value();
    const BodyId pole = world.add_body({.mass = 0}, {.position = {0, 0.8f, 0}}).value();
    std::vector<std::uint32_t> border;
    for (std::uint32_t row = 0; row < 17; ++row) border.push_back(25 * row);
    ASSERT_TRUE(world.attach(pole, flag, border));
    const double mass = static_cast<double>(world.cloth_info(flag)->mass);
    const auto momentum = [&] {
        Eigen::Vector3d sum = Eigen::Vector3d::Zero();
        const ClothView view = world.cloth(flag).value();
        for (std::size_t i = 0; i < view.positions.size(); ++i)
            sum += xyz(view.velocities[i]).cast<double>() / static_cast<double>(view.positions[i].w);
        return sum;
    };
    // The host's engine shakes it.
    const auto shake = [&](int k) {
        const float t = static_cast<float>(k) * body_step, w = 2 * std::numbers::pi_v<float>;
        ASSERT_TRUE(world.set_body_state(pole, {.position = {0.1f * std::sin(w * t), 0.8f, 0},
                                                .velocity = {0.1f * w * std::cos(w * t), 0, 0}}));
    };
    for (int k = 0; k < 120; ++k) {
        shake(k);
        world.step(body_step);
    }
    const Eigen::Vector3d before = momentum();
    Eigen::Vector3d given = Eigen::Vector3d::Zero();
    constexpr int steps = 240;
    for (int k = 120; k < 120 + steps; ++k) {
        shake(k);
        world.step(body_step);
        given += to_vector(world.body_impulses()[0].linear).cast<double>();
    }
    const double weight = mass * 9.81 * steps * static_cast<double>(body_step);
    const Eigen::Vector3d expected = Eigen::Vector3d(0, -weight, 0) - (momentum() - before);
    EXPECT_LT((given - expected).norm(), 0.03 * weight);
}

/// The longest that an edge gets in two seconds, times its length at rest, and the fastest particle.
struct Worst {
    float stretch = 0, speed = 0;
};
Worst worst_of_flight(const BodySettings& settings, const Vec3& where,
                      std::span<const std::uint32_t> attached, const Vec3& wind) {
    constexpr std::uint32_t side = 20;
    World world = World::create({.wind = {.velocity = wind, .gust = 0.3f}, .threads = 1}).value();
    const Mesh mesh = make_sheet({.rows = side, .columns = side}).value();
    const ClothId cloth =
        world.add_cloth(mesh, {.fabric = {.warp = 2000, .weft = 2000, .shear = 500}}).value();
    const BodyId body = world.add_body(settings, {.position = where}).value();
    EXPECT_TRUE(world.attach(body, cloth, attached));
    Worst worst;
    for (int k = 0; k < 120; ++k) {
        world.step(body_step);
        const ClothView view = world.cloth(cloth).value();
        for (const Triangle& t : view.triangles) {
            const float along = (xyz(view.positions[t[0]]) - xyz(view.positions[t[1]])).norm();
            const float rest = (to_vector(mesh.positions[t[0]]) - to_vector(mesh.positions[t[1]])).norm();
            worst.stretch = std::max(worst.stretch, along / rest);
        }
        worst.speed = std::max(worst.speed, world.report().peak_speed);
    }
    return worst;
}

// The row's particles have an inertia of 8e-4 kg m^2 about its middle.
TEST(Bodies, APoleLighterThanWhatIsAttachedToItFliesWithItsFlag) {
    std::vector<std::uint32_t> row(20);
    for (std::uint32_t i = 0; i < 20; ++i) row[i] = i;
    for (const Vec3& inertia : {Vec3{1e-5f, 1e-5f, 1e-5f}, Vec3{1e-3f, 1e-3f, 1e-3f},
                                Vec3{0.02f, 1e-4f, 0.02f}, Vec3{1e-4f, 0.02f, 0.02f}}) {
        std::array<float, 5> speeds{};  // any rounding changes one by a third, hence their median
        for (std::size_t k = 0; k < speeds.size(); ++k) {
            const Worst worst =
                worst_of_flight({.mass = 0.05f, .inertia = inertia, .gravity_scale = 0}, {0, 0, -0.5f}, row,
                                {1, 0, 4 + 1e-4f * static_cast<float>(k)});
            EXPECT_LT(worst.stretch, 1.4f) << inertia.x << " " << inertia.y;
            speeds[k] = worst.speed;
        }
        std::ranges::sort(speeds);
        EXPECT_LT(speeds[2], 12) << inertia.x << " " << inertia.y;
    }
}

TEST(Bodies, AWeightTakesTheClothThatIsAttachedToItAlong) {
    for (const float aside : {0.0f, 0.25f}) {
        const Worst worst =
            worst_of_flight({.mass = 0.8f, .inertia = {1e-3f, 1e-3f, 1e-3f}}, {aside, 0, aside},
                            std::vector<std::uint32_t>{189, 190, 209, 210}, {});
        EXPECT_LT(worst.stretch, 1.4f) << aside;
        EXPECT_LT(worst.speed, 20) << aside;
    }
}

TEST(Bodies, WhatIsAttachedGoesAlong) {
    SheetAndBody scene({.side = 9, .mass = 0, .state = {.position = {0, 0.5f, 0}}}, Held::free);
    const std::vector<std::uint32_t> vertices{0, 8};
    ASSERT_TRUE(scene.world.attach(scene.body, scene.cloth, vertices));
    ASSERT_TRUE(
        scene.world.set_body_state(scene.body, {.position = {0, 0.5f, 0},
                                                .velocity = {0, 1, 0},
                                                .angular_velocity = {0, std::numbers::pi_v<float>, 0}}));
    scene.steps(60);
    const ClothView view = scene.view();
    for (const std::uint32_t vertex : vertices) {  // half a turn, and up by 1 m
        const Vec4& p = view.positions[view.vertex_to_particle[vertex]];
        EXPECT_NEAR(p.x, vertex == 0 ? 0.5f : -0.5f, 2e-3f);
        EXPECT_NEAR(p.y, 1, 2e-3f);
        EXPECT_NEAR(p.z, 0.5f, 2e-3f);
    }
}

// A spring pulls at the place where it is attached: at the centre of mass it has no lever, wherever other
// cloth keeps the particle.
TEST(Bodies, WhatIsAttachedAtItsCentreTurnsNoBody) {
    constexpr std::uint32_t side = 9, corner = side * side - 1;
    for (const bool onto_cloth : {false, true})
        for (const float ratio : {0.01f, 1.0f, 100.0f}) {
            World world = World::create({.threads = 1}).value();
            const ClothSettings settings{.self_collision = {.method = onto_cloth
                                                                          ? SelfCollisionMethod::contact
                                                                          : SelfCollisionMethod::off}};
            const ClothId cloth = world
                                      .add_cloth(*make_sheet({.rows = side,
                                                              .columns = side,
                                                              .origin = {0, 1, 0},
                                                              .u = {0.4f, 0, 0},
                                                              .v = {0, -0.4f, 0}}),
                                                 settings)
                                      .value();
            ASSERT_TRUE(world.pin(cloth, std::array{0u, side - 1}));
            if (onto_cloth) {
                const ClothId below = world
                                          .add_cloth(*make_sheet({.rows = side,
                                                                  .columns = side,
                                                                  .origin = {-0.1f, 0.55f, -0.35f},
                                                                  .u = {0.7f, 0, 0},
                                                                  .v = {0, 0, 0.7f}}),
                                                     settings)
                                          .value();
                for (std::uint32_t i = 0; i <= corner; ++i) ASSERT_TRUE(world.pin(below, i));
            }
            const float mass = ratio * world.cloth_info(cloth)->mass, inertia = 1e-4f * mass;
            const BodyId body = world
                                    .add_body({.mass = mass, .inertia = {inertia, inertia, inertia}},
                                              {.position = {0.4f, 0.6f, 0}})
                                    .value();
            ASSERT_TRUE(world.attach(body, cloth, std::array{corner}));
            float fastest = 0, turn = 0;
            for (int k = 0; k < 240; ++k) {
                fastest = std::max(fastest, world.step(body_step).peak_speed);
                turn = std::max(turn, to_vector(world.body_state(body)->angular_velocity).norm());
            }
            EXPECT_LT(turn, 1e-6f) << ratio << ' ' << onto_cloth;
            if (!onto_cloth) {
                EXPECT_LT(fastest, 2.5f) << ratio;
            }
        }
}

TEST(Bodies, ABallBetweenTwoClothsRestsOnTheLowerOne) {
    SheetAndBody scene({.side = 17, .cloth = {.air_damping = 2}}, Held::border);
    const ClothId upper =
        scene.world.add_cloth(*make_sheet({.rows = 17, .columns = 17, .origin = {-0.5f, 0.6f, -0.5f}}))
            .value();
    scene.steps(900);
    EXPECT_LT(to_vector(scene.state().velocity).norm(), 0.05f);
    const float above = 9.81f * (1 + scene.world.cloth_info(upper)->mass);
    const float force = mean_force(scene.world, 0, 60).y();
    EXPECT_NEAR(force, 9.81f, 0.2f) << "of " << above << " N that come from above";
}

// Hosts have quaternions with rounding, or that they blended.
TEST(Bodies, ARotationCountsByItsDirection) {
    const auto hash = [](float length) {
        World world = World::create({.threads = 1}).value();
        const Rotation tilted{0.36f * length, 0.48f * length, 0, 0.8f * length};
        const ClothId sheet = world.add_cloth(*make_sheet({.rows = 9, .columns = 9})).value();
        const BodyId body = world.add_body({}, {.position = {0.5f, -0.3f, 0.5f}, .rotation = tilted}).value();
        const ColliderId box =
            world.add_collider({.shape = Box{.center = {0.4f, -0.2f, 0.4f}, .rotation = tilted}}).value();
        EXPECT_TRUE(world.attach_collider(body, box));
        EXPECT_TRUE(world.set_frame(sheet, {.rotation = tilted}));
        EXPECT_TRUE(world.move_cloth(sheet, {.rotation = tilted}));
        for (int k = 0; k < 20; ++k) world.step(body_step);
        return world.state_hash();
    };
    for (const float length : {2.0f, 64.0f, 1.0f / 1024}) EXPECT_EQ(hash(length), hash(1)) << length;
}

TEST(Bodies, TakeNoCallThatMakesNoSense) {
    World world = World::create().value();
    EXPECT_NE(world.add_body({.mass = -1}).error().message.find("BodySettings::mass is -1"),
              std::string::npos);
    EXPECT_FALSE(world.add_body({.inertia = {0.1f, NAN, 0.1f}}));
    EXPECT_FALSE(world.add_body({}, {.rotation = {0, 0, 0, 0}}));
    EXPECT_FALSE(world.add_body({}, {.velocity = {2e4f, 0, 0}}));
    const BodyId body = world.add_body({}).value();
    EXPECT_EQ(world.body_impulses().size(), 1u);
    const ColliderId ground = world.add_collider({.shape = Plane{}}).value();
    const ColliderId ball = world.add_collider({.shape = Sphere{{1, 0, 0}, 0.1f}}).value();
    EXPECT_FALSE(world.attach_collider(body, ground));
    ASSERT_TRUE(world.attach_collider(body, ball));
    EXPECT_FALSE(world.move_collider(ball, {.shape = Sphere{}}));
    ASSERT_TRUE(world.set_body_state(body, {.position = {0, 2, 0}}));
    const Sphere carried_there = std::get<Sphere>(world.collider(ball)->shape);
    EXPECT_FLOAT_EQ(carried_there.center.x, 1);
    EXPECT_FLOAT_EQ(carried_there.center.y, 2);
    ASSERT_TRUE(world.remove_body(body));
    EXPECT_EQ(world.remove_body(body).error().code, ErrorCode::stale_id);
    EXPECT_EQ(world.body_state(body).error().code, ErrorCode::stale_id);
    EXPECT_TRUE(world.body_impulses().empty());
    EXPECT_TRUE(world.move_collider(ball, {.shape = Sphere{}})) << "nothing carries it any more";
}

TEST(Bodies, GoOnAfterARestoreAsTheyDid) {
    SheetAndBody scene({.side = 9}, Held::border);
    scene.steps(30);
    std::vector<std::byte> saved(scene.world.save_size());
    ASSERT_TRUE(scene.world.save(saved));
    scene.steps(30);
    const std::uint64_t expected = scene.world.state_hash();
    ASSERT_TRUE(scene.world.restore(saved));
    scene.steps(30);
    EXPECT_EQ(scene.world.state_hash(), expected);
    SheetAndBody other({.side = 9}, Held::border);
    ASSERT_TRUE(other.world.add_body({}));
    EXPECT_FALSE(other.world.restore(saved));
}

TEST(Bodies, WakeTheClothThatTheyFallOnAndLetItNotSleepUnderThem) {
    SheetAndBody scene({.side = 17,
                        .cloth = {.fabric = {.warp = 2000, .weft = 2000, .shear = 500},
                                  .air_damping = 2,
                                  .sleep_speed = 0.05f}},
                       Held::border);
    const BodySettings falling = scene.world.body_settings(scene.body).value();
    ASSERT_TRUE(scene.world.set_body_state(scene.body, {.position = {0, 1, 0}}));
    BodySettings hanging = falling;
    hanging.gravity_scale = 0;
    ASSERT_TRUE(scene.world.set_body_settings(scene.body, hanging));
    scene.steps(300);
    ASSERT_EQ(scene.world.step(body_step).sleeping_cloths, 1u);
    ASSERT_TRUE(scene.world.set_body_settings(scene.body, falling));
    scene.steps(300);
    EXPECT_GT(scene.state().position.y, -0.5f) << "it fell through";
    scene.steps(600);
    EXPECT_EQ(scene.world.step(body_step).sleeping_cloths, 0u);
    EXPECT_NEAR(mean_force(scene.world, 0, 60).y(), 9.81f, 0.2f);
}

TEST(Bodies, FallThroughClothThatTheirCollidersAreNotFor) {
    SheetAndBody scene({.side = 9, .cloth = {.collider_mask = 2}}, Held::border);
    scene.steps(60);
    const float fallen = 0.5f * 9.81f;
    EXPECT_NEAR(scene.state().position.y, 0.3f - fallen, 0.05f * fallen);
    EXPECT_EQ(to_vector(scene.world.body_impulses()[0].linear).norm(), 0);
}

TEST(Bodies, MoveWithTheOrigin) {
    // A ball in the middle of a square is as it is in a mirror, and to which side a fold then goes, the last
    // digit says.
    const SheetAndBody::Setup off_middle{.side = 9, .state = {.position = {0.04f, 0.3f, 0.02f}}};
    SheetAndBody here(off_middle, Held::border), there(off_middle, Held::border);
    here.steps(20);
    there.steps(20);
    ASSERT_TRUE(there.world.shift_origin({4, -8, 2}));
    EXPECT_NEAR(there.state().position.y, here.state().position.y + 8, 1e-5f);
    here.steps(60);
    there.steps(60);
    EXPECT_NEAR(there.state().position.x, here.state().position.x - 4, 1e-3f);
    EXPECT_NEAR(there.state().position.y, here.state().position.y + 8, 1e-3f);
    EXPECT_NEAR(there.state().position.z, here.state().position.z - 2, 1e-3f);
    ASSERT_TRUE(there.world.shift_origin({-4, 8, -2}));
    EXPECT_FALSE(there.world.shift_origin({1e6f, 0, 0}));
}

}  // namespace
}  // namespace weft::test
