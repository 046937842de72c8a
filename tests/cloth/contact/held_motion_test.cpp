// What bounds motion after the last stage of a step: colliders that stand still, and
// WorldSettings::max_speed.

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>
#include <vector>

#include "tests/cloth/fixtures.h"

namespace weft::test {
namespace {

constexpr std::array methods{Method(Multilevel{}),        Method(Jacobi{}), Method(Chebyshev{}),
                             Method(ConjugateGradient{}), Method(Xpbd{}),   Method(Fibres{}),
                             Method(SymplecticEuler{})};

constexpr std::array<SelfCollision, 4> self_collisions{
    SelfCollision{}, SelfCollision{.method = SelfCollisionMethod::avoidance},
    SelfCollision{.method = SelfCollisionMethod::contact},
    SelfCollision{.method = SelfCollisionMethod::impact_zones}};

constexpr std::uint32_t sheet_side = 9;

ClothSettings settings_of(const Method& method, const SelfCollision& self_collision) {
    ClothSettings settings;
    settings.method = method;
    settings.self_collision = self_collision;
    if (std::holds_alternative<SymplecticEuler>(method)) settings.substeps = 40;
    return settings;
}

Mesh sheet_at(float height, float skew) {
    return make_sheet({.rows = sheet_side,
                       .columns = sheet_side,
                       .origin = {-0.2f, height, -0.2f},
                       .u = {0.4f, 0, 0},
                       .v = {skew, 0, 0.4f}})
        .value();
}

std::vector<std::uint32_t> first_row() {
    std::vector<std::uint32_t> row(sheet_side);
    std::iota(row.begin(), row.end(), 0u);
    return row;
}

WorldSettings limited_to(float max_speed) {
    WorldSettings settings;
    settings.max_speed = max_speed;
    settings.threads = 1;
    return settings;
}

float fastest_of(const World& world, ClothId id) {
    float fastest = 0;
    for (const Vec4& v : world.cloth(id)->velocities) fastest = std::max(fastest, xyz(v).norm());
    return fastest;
}

// Cloths that another group's pins throw at each other were cut once more after the limit: 36 m/s for 2.
TEST(MaxSpeed, HoldsByEveryMethodAndEverySelfCollisionWherePinsJump) {
    constexpr float most = 2;
    for (const Method& method : methods)
        for (const SelfCollision& self_collision : self_collisions) {
            World world = World::create(limited_to(most)).value();
            const ClothSettings settings = settings_of(method, self_collision);
            const Mesh mesh = sheet_at(1, 0);
            const ClothId below = world.add_cloth(mesh, settings).value();
            const ClothId above = world.add_cloth(sheet_at(1.05f, 0.1f), settings).value();
            ASSERT_TRUE(world.pin(below, first_row()));
            ASSERT_TRUE(world.add_collider({.shape = Sphere{{0, 0.75f, 0}, 0.15f}}));
            for (int k = 0; k < 20; ++k) {
                for (const std::uint32_t i : first_row()) {
                    const Vec3& x = mesh.positions[i];
                    ASSERT_TRUE(world.move_pin(below, i, {x.x + (k % 7 == 3 ? 1.0f : 0.0f), x.y, x.z}));
                }
                const StepReport& report = world.step(h);
                const float fastest = std::max(fastest_of(world, below), fastest_of(world, above));
                ASSERT_LE(std::max(report.peak_speed, fastest), 1.0001f * most)
                    << method.index() << ", self-collision " << static_cast<int>(self_collision.method)
                    << ", step " << k;
            }
        }
}

// Bodies were limited after they had moved: attached vertices went at 1e6 m/s by Jacobi. Methods that do not
// join bodies place vertices where the body was expected, and the body where it then goes: each of the two is
// within the limit of where the body was, which leaves vertices three times the way.
TEST(MaxSpeed, HoldsForVerticesThatGoWithALightBody) {
    constexpr float most = 2;
    for (const Method& method : methods)
        for (const SelfCollision& self_collision : self_collisions) {
            World world = World::create(limited_to(most)).value();
            const ClothId cloth =
                world.add_cloth(sheet_at(1, 0), settings_of(method, self_collision)).value();
            const BodyId body =
                world.add_body({.mass = 0.05f, .inertia = {1e-4f, 1e-4f, 1e-4f}}, {.position = {0, 1, 0}})
                    .value();
            ASSERT_TRUE(world.attach(body, cloth, first_row()));
            ASSERT_TRUE(world.set_body_state(
                body, {.position = {0, 1, 0}, .velocity = {9000, 0, 0}, .angular_velocity = {0, 9000, 0}}));
            std::vector<Vec4> last(world.cloth(cloth)->positions.begin(),
                                   world.cloth(cloth)->positions.end());
            for (int k = 0; k < 20; ++k) {
                world.step(h);
                ASSERT_LE(fastest_of(world, cloth), 1.0001f * most) << method.index() << ", step " << k;
                const ClothView view = world.cloth(cloth).value();
                for (const std::uint32_t i : first_row()) {
                    if (meets_cloth(self_collision.method)) break;  // what is cut catches up later
                    ASSERT_LE((xyz(view.positions[i]) - xyz(last[i])).norm(), 3.03f * most * h)
                        << method.index() << ", step " << k << ", vertex " << i;
                }
                last.assign(view.positions.begin(), view.positions.end());
            }
        }
}

// Particles that contact cut went on with the motion that all cloth has in common: 11 mm into the ground.
TEST(CutMotion, TakesNothingIntoTheGround) {
    ClothSettings settings;
    settings.fabric = Fabric::named("denim").value();
    settings.self_collision = {.method = SelfCollisionMethod::contact};
    for (const std::uint32_t rows : {12u, 16u})
        for (const float step : {1.0f / 60, 1.0f / 90}) {
            World world = World::create({.threads = 1}).value();
            std::vector<ClothId> cloths;
            for (int k = 0; k < 2; ++k) {
                const float turn = 0.3f + 0.35f * static_cast<float>(k);
                const float c = 0.6f * std::cos(turn), s = 0.6f * std::sin(turn);
                const float height = 0.05f + 0.7f * static_cast<float>(k);
                cloths.push_back(
                    world
                        .add_cloth(make_sheet({.rows = rows,
                                               .columns = rows + 3,
                                               .origin = {-0.5f * (c - s), height, -0.5f * (s + c)},
                                               .u = {c, 0.08f, s},
                                               .v = {-0.25f * s, 0.55f, 0.25f * c}})
                                       .value(),
                                   settings)
                        .value());
            }
            ASSERT_TRUE(world.add_collider({.shape = Plane{{0, 1, 0}, 0}}));
            for (int k = 0; static_cast<float>(k) * step < 2; ++k) {
                world.step(step);
                for (const ClothId id : cloths)
                    for (const Vec4& x : world.cloth(id)->positions)
                        ASSERT_GT(x.y, -0.003f) << rows << " rows, step " << k;
            }
        }
}

}  // namespace
}  // namespace weft::test
