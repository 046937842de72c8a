// Cloth in moving frames, against closed forms, against a frame at rest, and against cloth that knows of
// none.

#include <gtest/gtest.h>

#include <numbers>

#include "tests/cloth/worn/worn.h"

namespace weft::test::worn {
namespace {

/// A sheet in a shaken frame, with a ball that goes with the frame, or without one.
struct Shaken {
    Shaken(const FrameInertia& inertia, bool in_frame, const ClothSettings& of = {})
        : world(World::create(vacuum(downwards)).value()), framed(in_frame) {
        ClothSettings settings = of;
        settings.frame_inertia = inertia;
        cloth = world.add_cloth(hanging(9, 8), settings).value();
        EXPECT_TRUE(world.pin(cloth, std::vector<std::uint32_t>{0, 7}));
        ball = world.add_collider(ball_at({})).value();
        if (framed) {
            EXPECT_TRUE(world.set_frame(cloth, {}));
        }
    }
    [[nodiscard]] static Collider ball_at(const RigidMotion& place) {
        return {
            .shape = Capsule{place.point(Vec3{-0.2f, 0.3f, 0.1f}), place.point(Vec3{0.2f, 0.3f, 0.1f}), 0.1f},
            .friction = 0.5f};
    }
    /// A run along a bend, jerks and all.
    [[nodiscard]] static Transform pose(int step) {
        const double t = step * static_cast<double>(h);
        return {.translation = {static_cast<float>(3 * t * t), static_cast<float>(0.2 * std::sin(20 * t)),
                                static_cast<float>(std::sin(4 * t))},
                .rotation = turn({0, 1, 0}, 2 * t + std::sin(7 * t))};
    }
    void step(const Transform& to) {
        const RigidMotion place = rigid_motion(to);
        if (framed) {
            EXPECT_TRUE(world.set_frame(cloth, to));
        }
        EXPECT_TRUE(world.move_collider(ball, ball_at(place)));
        for (const std::uint32_t v : {0u, 7u})
            EXPECT_TRUE(world.move_pin(cloth, v, place.point(Vec3{v == 0 ? -0.3f : 0.3f, 0.6f, 0})));
        EXPECT_FALSE(has(world.step(h).flags, StepFlags::state_restored));
    }

    World world;
    ClothId cloth;
    ColliderId ball;
    bool framed;
};

TEST(MovingFrame, AtFullInertiaIsNone) {
    Shaken framed({}, true), free({}, false);
    for (int k = 1; k <= 30; ++k) {
        framed.step(Shaken::pose(k));
        free.step(Shaken::pose(k));
        const auto a = framed.world.cloth(framed.cloth)->positions,
                   b = free.world.cloth(free.cloth)->positions;
        ASSERT_TRUE(same_bytes({a.begin(), a.end()}, {b.begin(), b.end()})) << "step " << k;
    }
}

void expect_as_at_rest(const ClothSettings& settings, float within) {
    Shaken framed({0, 0, 0}, true, settings), still({}, false, settings);
    std::vector<Vector3> last = places_of(framed.world, framed.cloth);
    // Later what folds shows every rounding.
    for (int k = 1; k <= 18; ++k) {
        framed.step(Shaken::pose(k));
        still.step({});
        EXPECT_EQ(framed.world.report().collider_contacts > 0, still.world.report().collider_contacts > 0);
        ASSERT_LT(farthest(places_of(still.world, still.cloth), rigid_motion(Shaken::pose(k)),
                           places_of(framed.world, framed.cloth)),
                  within)
            << "step " << k;
        const ClothView view = *framed.world.cloth(framed.cloth);
        for (std::size_t i = 0; i < last.size(); ++i)
            ASSERT_LT((xyz(view.previous_positions[i]) - last[i]).norm(), 4e-6f) << "where it was drawn last";
        last = places_of(framed.world, framed.cloth);
    }
    EXPECT_GT(still.world.report().collider_contacts, 0u);
}

TEST(MovingFrame, AtNoInertiaIsOneAtRest) {
    ClothSettings solved, contact, euler, xpbd;
    contact.self_collision = {.method = SelfCollisionMethod::contact};
    euler.time_scheme = TimeScheme::backward_euler;
    euler.substeps = 2;
    xpbd.method = Xpbd{};
    // Solvers hold matrices in half precision, in which a turned one is another: what they solve is the same.
    for (ClothSettings* settings : {&solved, &contact, &euler}) settings->method = Multilevel{.passes = 100};
    for (const ClothSettings& settings : {solved, contact, euler}) expect_as_at_rest(settings, 1e-3f);
    expect_as_at_rest({}, 1e-3f);
    expect_as_at_rest(xpbd, 1e-2f);
}

/// Two masses on strings, side by side across x, in a frame.
struct Pendulum {
    /// Hangs from `from`, tilted by these angles towards x and towards z.
    Pendulum(const FrameInertia& inertia, const Vector3& from, double to_x, double to_z = 0)
        : simulation(vacuum(downwards)), pivot(from) {
        const Vector3 down(static_cast<float>(std::sin(to_x)),
                           static_cast<float>(-std::cos(to_x) * std::cos(to_z)),
                           static_cast<float>(std::sin(to_z)));
        const Mesh mesh = make_sheet({.rows = 2,
                                      .columns = 2,
                                      .origin = to_vec3(Vector3(pivot - across)),
                                      .u = to_vec3(Vector3(2 * across)),
                                      .v = to_vec3(Vector3(length * down.normalized()))})
                              .value();
        ClothSettings settings;
        settings.frame_inertia = inertia;
        settings.air_damping = 0;
        settings.fabric.warp = settings.fabric.weft = 4000;
        settings.fabric.shear = 0;  // each mass for itself
        auto made = std::make_unique<Cloth>(cook(mesh).value(), settings);
        cloth = made.get();
        simulation.prepare(*cloth);
        simulation.add(std::move(made));
        cloth->pin(std::vector<std::uint32_t>{0, 1});
        simulation.set_frame(*cloth, {});
    }
    /// What it would have in its own world: the turn of the frame about y.
    void spin(float omega) {
        for (std::uint32_t i = 0; i < 4; ++i) {
            const Vector3 v = Vector3(0, omega, 0).cross(xyz(cloth->state.positions[i]));
            set_xyz(cloth->state.velocities[i], v);
        }
    }
    void step(const Transform& pose) {
        simulation.set_frame(*cloth, pose);
        const RigidMotion place = rigid_motion(pose);
        for (Pin& pin : cloth->state.pins)
            pin.target = place.point(Vector3(pivot + (pin.particle == 0 ? -1.0f : 1.0f) * across));
        simulation.step(h);
        last = place;
    }
    /// Of the string, in the frame.
    [[nodiscard]] Vector3 direction() const {
        const Vector3 mass = 0.5f * (xyz(cloth->state.positions[2]) + xyz(cloth->state.positions[3])),
                      from = last.point(pivot);
        return last.inverse().vector(Vector3((mass - from).normalized()));
    }
    [[nodiscard]] double to_x() const {
        const Vector3 d = direction();
        return std::atan2(static_cast<double>(d.x()), static_cast<double>(-d.y()));
    }
    [[nodiscard]] double to_z() const {
        const Vector3 d = direction();
        return std::atan2(static_cast<double>(d.z()), static_cast<double>(-d.y()));
    }

    static constexpr float length = 0.4f;
    const Vector3 across{0, 0, 0.02f};
    Simulation simulation;
    Vector3 pivot;
    Cloth* cloth;
    RigidMotion last;
};

// tan(angle) = linear a / g.
TEST(MovingFrame, APendulumLeansAgainstLinearAcceleration) {
    constexpr double a = 5;
    for (const float linear : {0.0f, 0.3f, 1.0f}) {
        const double expected = -std::atan(static_cast<double>(linear) * a / 9.81);
        Pendulum pendulum({.linear = linear, .angular = 0, .centrifugal = 0}, {0, 0, 0}, expected);
        for (int k = 1; k <= 45; ++k) {
            const double t = k * static_cast<double>(h);
            pendulum.step({.translation = {static_cast<float>(a / 2 * t * t), 0, 0}});
            ASSERT_NEAR(pendulum.to_x(), expected, 0.02) << linear << ", step " << k;
        }
    }
}

double tilt_by_turning(double part, double omega, double radius) {
    double angle = 0;
    for (int k = 0; k < 200; ++k)
        angle = std::atan(part * omega * omega *
                          (radius + static_cast<double>(Pendulum::length) * std::sin(angle)) / 9.81);
    return angle;
}

// tan(angle) = centrifugal w^2 (R + L sin(angle)) / g, whatever part of the turn the cloth itself makes.
TEST(MovingFrame, APendulumLeansOutwardsByItsCentrifugalPart) {
    constexpr float omega = 3, radius = 0.5f;
    for (const float angular : {0.0f, 0.5f, 1.0f}) {
        for (const float centrifugal : {0.0f, 0.4f, 1.0f}) {
            const double expected = tilt_by_turning(static_cast<double>(centrifugal), 3, 0.5);
            Pendulum pendulum({.linear = 1, .angular = angular, .centrifugal = centrifugal}, {radius, 0, 0},
                              expected);
            pendulum.spin(angular * omega);
            for (int k = 1; k <= 45; ++k) {
                pendulum.step({.rotation = turn({0, 1, 0}, 3 * k * static_cast<double>(h))});
                ASSERT_NEAR(pendulum.to_x(), expected, 0.05)
                    << angular << ", " << centrifugal << ", step " << k;
            }
        }
    }
}

// The frame spins up from rest: tan(angle) = angular alpha R / g, against the turn.
TEST(MovingFrame, APendulumLeansAgainstEulersAcceleration) {
    constexpr double alpha = 8, radius = 0.5;
    for (const float angular : {0.0f, 0.5f, 1.0f}) {
        // About +y, x goes towards -z: the string leans towards +z.
        const double expected = std::atan(static_cast<double>(angular) * alpha * radius / 9.81);
        Pendulum pendulum({.linear = 1, .angular = angular, .centrifugal = 0}, {0.5f, 0, 0}, 0, expected);
        for (int k = 1; k <= 20; ++k) {
            const double t = k * static_cast<double>(h);
            pendulum.step({.rotation = turn({0, 1, 0}, alpha / 2 * t * t)});
            ASSERT_NEAR(pendulum.to_z(), expected, 0.07) << angular << ", step " << k;
        }
    }
}

// A frame that drives along a circle and turns with it: its origin's acceleration is linear, w^2 R outwards.
TEST(MovingFrame, TheOriginsAccelerationIsLinearHoweverTheFrameTurns) {
    constexpr double omega = 2, radius = 1.5;
    for (const float linear : {0.0f, 0.5f, 1.0f}) {
        const double expected = std::atan(static_cast<double>(linear) * omega * omega * radius / 9.81);
        Pendulum pendulum({.linear = linear, .angular = 0, .centrifugal = 0}, {0, 0, 0}, expected);
        const auto pose = [&](double t) {
            const double a = omega * t;
            return Transform{.translation = {static_cast<float>(radius * std::cos(a)), 0,
                                             static_cast<float>(-radius * std::sin(a))},
                             .rotation = turn({0, 1, 0}, a)};
        };
        // It is under way.
        pendulum.simulation.move(*pendulum.cloth, rigid_motion(pose(0)));
        const Vec3 speed{0, 0, static_cast<float>(-omega * radius)};
        pendulum.cloth->state.frame->velocity = speed;
        for (Vec4& v : pendulum.cloth->state.velocities.span())
            v = to_vec4(Vector3(linear * to_vector(speed)), 0);
        for (int k = 1; k <= 45; ++k) {
            pendulum.step(pose(k * static_cast<double>(h)));
            ASSERT_NEAR(pendulum.to_x(), expected, 0.03) << linear << ", step " << k;
        }
    }
}

// Cloth of one frame that is carried across cloth of none: nothing is lost track of.
TEST(MovingFrame, AcrossOtherClothIsLetApart) {
    World world = World::create(vacuum()).value();
    ClothSettings settings;
    settings.self_collision = {.method = SelfCollisionMethod::contact};
    settings.frame_inertia = {0, 0, 0};
    const ClothId a = world.add_cloth(sheet(9, 9), settings).value(),
                  b = world.add_cloth(sheet(9, 9), settings).value();
    ASSERT_TRUE(world.move_cloth(b, {.translation = {0, 0.5f, 0}, .rotation = turn({0, 0, 1}, 0.3)}));
    world.step(h);
    world.step(h);
    EXPECT_EQ(world.report().crossings, 0u);
    ASSERT_TRUE(world.set_frame(b, {}));
    ASSERT_TRUE(world.set_frame(b, {.translation = {0, -0.48f, 0}}));
    world.step(h);
    EXPECT_GT(world.report().crossings, 0u);
    static_cast<void>(a);
}

/// The fastest free particle of a sheet in a frame that is shaken along z at up to 9.4 m/s, and turns if it
/// is to, relative to the part of that motion that acts on the sheet [m/s].
float fastest_in_frame(float inertia, float max_speed, bool turns) {
    World world = World::create(vacuum(downwards)).value();
    ClothSettings settings;
    settings.frame_inertia = {inertia, inertia, inertia};
    settings.max_speed_in_frame = max_speed;
    const ClothId cloth = world.add_cloth(hanging(9, 8), settings).value();
    EXPECT_TRUE(world.pin(cloth, std::vector<std::uint32_t>{0, 7}));
    const auto pose = [&](int step) {
        const double t = step * static_cast<double>(h);
        return Transform{.translation = {0, 0, static_cast<float>(0.5 * std::sin(6 * std::numbers::pi * t))},
                         .rotation = turn({0, 1, 0}, turns ? 6 * t : 0)};
    };
    EXPECT_TRUE(world.set_frame(cloth, pose(0)));
    float fastest = 0;
    for (int k = 1; k <= 60; ++k) {
        EXPECT_TRUE(world.set_frame(cloth, pose(k)));
        for (const std::uint32_t v : {0u, 7u})
            EXPECT_TRUE(
                world.move_pin(cloth, v, rigid_motion(pose(k)).point(Vec3{v == 0 ? -0.3f : 0.3f, 0.6f, 0})));
        world.step(h);
        const Vector3 origin = to_vector(pose(k).translation);
        const Vector3 velocity = inertia / h * (origin - to_vector(pose(k - 1).translation));
        const Vector3 spin = (turns ? 6 * inertia : 0) * Vector3::UnitY();
        const ClothView& view = world.cloth(cloth).value();
        for (std::size_t i = 0; i < view.positions.size(); ++i)
            if (view.positions[i].w > 0)
                fastest = std::max(fastest, (xyz(view.velocities[i]) - velocity -
                                             spin.cross(xyz(view.previous_positions[i]) - origin))
                                                .norm());
    }
    return fastest;
}

TEST(MovingFrame, ASpeedLimitIsRelativeToIt) {
    for (const bool turns : {false, true})
        for (const float inertia : {0.0f, 0.5f, 1.0f}) {
            const float free = fastest_in_frame(inertia, 0, turns);
            const float limit = 0.3f * free;
            // In a turning frame places at the start of the step are transported by what does not act.
            EXPECT_LT(fastest_in_frame(inertia, limit, turns),
                      turns && inertia < 1 ? 1.5f * limit : 1.001f * limit)
                << inertia << ", free " << free;
            EXPECT_NEAR(fastest_in_frame(inertia, 2 * free, turns), free, 1e-3f * free);
        }
}

/// Without a frame it is one in the World.
TEST(MovingFrame, ASpeedLimitOfACloth) {
    World world = World::create(vacuum(downwards)).value();
    const ClothId slow = world.add_cloth(hanging(9, 8), {.max_speed_in_frame = 2}).value();
    const ClothId fast = world.add_cloth(hanging(9, 8)).value();
    for (int k = 0; k < 60; ++k) world.step(h);
    for (const Vec4& v : world.cloth(slow)->velocities) EXPECT_NEAR(xyz(v).norm(), 2, 1e-3f);
    for (const Vec4& v : world.cloth(fast)->velocities) EXPECT_GT(xyz(v).norm(), 8);
}

/// Nothing of the frame is left in the limit.
TEST(MovingFrame, ASpeedLimitIsInTheWorldAfterTheFrame) {
    World world = World::create(vacuum()).value();
    const ClothId cloth = world.add_cloth(hanging(9, 8), {.max_speed_in_frame = 2}).value();
    for (int k = 0; k < 5; ++k) {
        ASSERT_TRUE(world.set_frame(cloth, {.translation = {0.5f * static_cast<float>(k), 0, 0}}));
        world.step(h);
    }
    for (const Vec4& v : world.cloth(cloth)->velocities) EXPECT_GT(v.x, 27);
    ASSERT_TRUE(world.leave_frame(cloth));
    world.step(h);
    for (const Vec4& v : world.cloth(cloth)->velocities) EXPECT_LT(xyz(v).norm(), 2.001f);
}

TEST(MovingFrame, RefusesWhatIsNoPose) {
    World world = World::create(vacuum()).value();
    const ClothId cloth = world.add_cloth(sheet(4, 4)).value();
    EXPECT_FALSE(world.set_frame(cloth, {.rotation = {0, 0, 0, 0}}));
    EXPECT_FALSE(world.set_frame(cloth, {.translation = {2e5f, 0, 0}}));
    EXPECT_FALSE(world.set_frame({}, {}));
    EXPECT_FALSE(world.leave_frame({}));
    ClothSettings settings;
    settings.frame_inertia.angular = 1.5f;
    const Result<void> refused = world.set_cloth_settings(cloth, settings);
    ASSERT_FALSE(refused);
    EXPECT_NE(refused.error().message.find("FrameInertia::angular is 1.5"), std::string::npos);
}

// Left, it is as it was before the first set_frame().
TEST(MovingFrame, CanBeLeft) {
    Shaken shaken({0, 0, 0}, true);
    shaken.step(Shaken::pose(1));
    ASSERT_TRUE(shaken.world.leave_frame(shaken.cloth));
    ASSERT_TRUE(shaken.world.set_frame(shaken.cloth, {.translation = {50, 0, 0}}));
    const std::vector<Vector3> before = places_of(shaken.world, shaken.cloth);
    shaken.world.step(h);
    EXPECT_LT(farthest(before, {}, places_of(shaken.world, shaken.cloth)), 0.05f);
}

}  // namespace
}  // namespace weft::test::worn
