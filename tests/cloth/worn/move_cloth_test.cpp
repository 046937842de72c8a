// A cloth that is teleported moves on as it would have: in another place, another way round.

#include <gtest/gtest.h>

#include <limits>
#include <numbers>
#include <string>

#include "tests/cloth/worn/worn.h"

namespace weft::test::worn {
namespace {

struct TeleportCase {
    std::string name;
    ClothSettings settings;
};
void PrintTo(const TeleportCase& of, std::ostream* out) {
    *out << of.name;
}

std::vector<TeleportCase> teleport_cases() {
    std::vector<TeleportCase> result;
    const auto add = [&](const char* name, const auto& change) {
        change(result.emplace_back(TeleportCase{name, {}}).settings);
    };
    add("Default", [](ClothSettings&) {});
    add("BackwardEuler", [](ClothSettings& s) { s.time_scheme = TimeScheme::backward_euler; });
    add("Tethers", [](ClothSettings& s) { s.tethers.enabled = true; });
    add("Contact", [](ClothSettings& s) { s.self_collision = {.method = SelfCollisionMethod::contact}; });
    add("Xpbd", [](ClothSettings& s) { s.method = Xpbd{}; });
    add("Elements", [](ClothSettings& s) {
        s.finite_elements.enabled = true;
        s.method = Multilevel{.passes = 100};
    });
    return result;
}

/// A sheet that swings from two corners against a ball off the middle, in a World that may be turned.
struct Swing {
    explicit Swing(const ClothSettings& settings) : world(World::create(vacuum(downwards)).value()) {
        cloth = world.add_cloth(hanging(13, 12), settings).value();
        EXPECT_TRUE(world.pin(cloth, std::vector<std::uint32_t>{0, 11}));
        ball = world.add_collider(at({})).value();
    }
    [[nodiscard]] static Collider at(const RigidMotion& place) {
        return {.shape = Sphere{place.point(Vec3{0.04f, 0.25f, 0.1f}), 0.15f}, .friction = 0.5f};
    }
    void run(int steps, const RigidMotion& place = {}) {
        for (int k = 0; k < steps; ++k) {
            const float way = 0.1f * std::sin(5 * h * static_cast<float>(++step));
            for (const std::uint32_t v : {0u, 11u})
                EXPECT_TRUE(world.move_pin(cloth, v, place.point(Vec3{v == 0 ? -0.3f : 0.3f, 0.6f, way})));
            EXPECT_FALSE(has(world.step(h).flags, StepFlags::state_restored));
        }
    }
    /// All of it.
    void teleport(const Transform& by) {
        const RigidMotion place = rigid_motion(by);
        WorldSettings turned = world.settings();
        turned.gravity = to_vec3(place.vector(to_vector(downwards)));
        ASSERT_TRUE(world.set_settings(turned));
        ASSERT_TRUE(world.place_collider(ball, at(place)));
        ASSERT_TRUE(world.move_cloth(cloth, by));
    }

    World world;
    ClothId cloth;
    ColliderId ball;
    int step = 0;
};

class Teleport : public testing::TestWithParam<TeleportCase> {};
INSTANTIATE_TEST_SUITE_P(, Teleport, testing::ValuesIn(teleport_cases()),
                         [](const auto& info) { return info.param.name; });

// In the middle of a swing that touches the ball: what BDF2 remembers, and how hard the cloth presses, go
// along, or the next steps would show it.
TEST_P(Teleport, GoesOnAsItWouldHave) {
    for (const Transform& by :
         {Transform{.translation = {40, 0, 0}}, Transform{.rotation = turn({0, 1, 0}, std::numbers::pi)},
          Transform{.translation = {3, -8, 2}, .rotation = turn({1, 2, -1}, 2.2)}}) {
        Swing still(GetParam().settings), moved(GetParam().settings);
        still.run(40);
        moved.run(40);
        const std::vector<Vector3> before = places_of(moved.world, moved.cloth);
        const RigidMotion place = rigid_motion(by);
        moved.teleport(by);
        EXPECT_LT(farthest(places_of(still.world, still.cloth), place, places_of(moved.world, moved.cloth)),
                  4e-6f);
        EXPECT_LT(largest_strain(*moved.world.cloth(moved.cloth), before), 1e-3f);
        for (int k = 0; k < 12; ++k) {
            still.run(1);
            moved.run(1, place);
            EXPECT_EQ(moved.world.report().collider_contacts > 0, still.world.report().collider_contacts > 0);
            // Solvers hold matrices in half precision, in which a turned one is another.
            EXPECT_LT(
                farthest(places_of(still.world, still.cloth), place, places_of(moved.world, moved.cloth)),
                6e-3f)
                << "after " << k + 1 << " steps";
            EXPECT_NEAR(largest_strain(*moved.world.cloth(moved.cloth), before),
                        largest_strain(*still.world.cloth(still.cloth), before), 0.02f);
        }
    }
}

TEST(MoveCloth, ShowsNoWayAndNoVelocity) {
    Swing swing({});
    swing.run(20);
    const ClothView before = *swing.world.cloth(swing.cloth);
    const std::vector<Vec4> velocities(before.velocities.begin(), before.velocities.end()),
        normals(before.normals.begin(), before.normals.end()),
        previous(before.previous_positions.begin(), before.previous_positions.end());
    const Transform by{.translation = {40, 5, 0}, .rotation = turn({0, 0, 1}, 1)};
    ASSERT_TRUE(swing.world.move_cloth(swing.cloth, by));
    const RigidMotion place = rigid_motion(by);
    const ClothView after = *swing.world.cloth(swing.cloth);
    for (std::size_t i = 0; i < velocities.size(); ++i) {
        EXPECT_LT((place.vector(xyz(velocities[i])) - xyz(after.velocities[i])).norm(), 1e-6f);
        EXPECT_LT((place.vector(xyz(normals[i])) - xyz(after.normals[i])).norm(), 1e-4f);
        EXPECT_LT((place.point(xyz(previous[i])) - xyz(after.previous_positions[i])).norm(), 4e-6f);
        EXPECT_LE(after.bounds.lower.x, after.positions[i].x);
        EXPECT_GE(after.bounds.upper.x, after.positions[i].x);
    }
}

// A pin that was told where to go, and the frame, go along.
TEST(MoveCloth, TakesTargetsAlong) {
    World world = World::create(vacuum()).value();
    const ClothId cloth = world.add_cloth(sheet(4, 4)).value();
    ASSERT_TRUE(world.pin(cloth, 0));
    ASSERT_TRUE(world.move_pin(cloth, 0, {-0.5f, 0.01f, -0.5f}));
    ASSERT_TRUE(
        world.move_cloth(cloth, {.translation = {0, 3, 0}, .rotation = turn({0, 0, 1}, std::numbers::pi)}));
    world.step(h);
    const Vec4& pin = world.cloth(cloth)->positions[0];
    EXPECT_NEAR(pin.x, 0.5f, 1e-6f);
    EXPECT_NEAR(pin.y, 2.99f, 1e-6f);
}

// Cloth that is put across another comes apart again, as cloth does that began so.
TEST(MoveCloth, AcrossAnotherIsLetApart) {
    World world = World::create(vacuum()).value();
    ClothSettings settings;
    settings.self_collision = {.method = SelfCollisionMethod::contact};
    const ClothId a = world.add_cloth(sheet(9, 9), settings).value(),
                  b = world.add_cloth(sheet(9, 9), settings).value();
    ASSERT_TRUE(world.move_cloth(b, {.translation = {3, 0, 0}}));
    for (int k = 0; k < 3; ++k) world.step(h);
    EXPECT_EQ(world.report().crossings, 0u);
    ASSERT_TRUE(world.move_cloth(b, {.translation = {-2.8f, -0.88f, 0}, .rotation = turn({0, 0, 1}, 0.3)}));
    world.step(h);
    EXPECT_GT(world.report().crossings, 0u);
    static_cast<void>(a);
}

TEST(MoveCloth, RefusesWhatIsNoMotion) {
    World world = World::create(vacuum()).value();
    const ClothId cloth = world.add_cloth(sheet(4, 4)).value();
    const std::uint64_t before = world.state_hash();
    const auto refusal = [&](const Transform& by) {
        const Result<void> result = world.move_cloth(cloth, by);
        EXPECT_FALSE(result);
        EXPECT_EQ(world.state_hash(), before);
        return result ? std::string() : result.error().message;
    };
    constexpr float nan = std::numeric_limits<float>::quiet_NaN();
    EXPECT_NE(refusal({.rotation = {0, 0, 0, 0}}).find("by.rotation is 0"), std::string::npos);
    EXPECT_NE(refusal({.rotation = {0, nan, 0, 1}}).find("by.rotation is nan"), std::string::npos);
    EXPECT_NE(refusal({.translation = {0, nan, 0}}).find("by.translation"), std::string::npos);
    EXPECT_NE(refusal({.translation = {99999.8f, 0, 0}}).find("vertex 3 once moved"), std::string::npos);
    EXPECT_FALSE(world.move_cloth({}, {}));
}

}  // namespace
}  // namespace weft::test::worn
