// Colliders met by filtering velocities: what it does, and what it does wrong.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "engine/vector.h"
#include "tests/cloth/fixtures.h"

namespace weft::test {
namespace {

struct Drop {
    float deepest = -1;  ///< in the sphere, of the whole run [m]
    float sunk = 0;      ///< at the end [m]
    float slid = 0;      ///< of the mean, off the axis [m]
    float lowest = 0;    ///< of all particles, at the end [m]
    bool touched = false;
};

/// A sheet of 0.5 m dropped from 10 cm on a sphere of 30 cm, its middle so far off the top.
Drop drop_on_sphere(ColliderResponse response, float aside, float seconds) {
    constexpr float radius = 0.3f;
    World world = World::create(vacuum({0, -9.81f, 0})).value();
    ClothSettings settings;
    settings.collider_response = response;
    const Mesh mesh = make_sheet({.rows = 21,
                                  .columns = 21,
                                  .origin = {aside - 0.25f, radius + 0.1f, -0.25f},
                                  .u = {0.5f, 0, 0},
                                  .v = {0, 0, 0.5f}})
                          .value();
    const ClothId id = world.add_cloth(mesh, settings).value();
    EXPECT_TRUE(world.add_collider({.shape = Sphere{{}, radius}, .friction = 1}));
    Drop drop;
    for (int step = 0; step < static_cast<int>(60 * seconds); ++step) {
        world.step(1.0f / 60);
        drop.touched |= world.report().collider_contacts > 0;
        drop.sunk = -1;
        drop.slid = 0;
        drop.lowest = 1;
        const ClothView view = world.cloth(id).value();
        for (const Vec4& p : view.positions) {
            drop.sunk = std::max(drop.sunk, radius - xyz(p).norm());
            drop.slid += p.x / static_cast<float>(view.positions.size());
            drop.lowest = std::min(drop.lowest, p.y);
            EXPECT_TRUE(std::isfinite(p.x + p.y + p.z));
        }
        drop.deepest = std::max(drop.deepest, drop.sunk);
    }
    return drop;
}

TEST(VelocityFilter, HoldsASheetUpButNotOutside) {
    const Drop filtered = drop_on_sphere(ColliderResponse::velocity_filter, 0, 1);
    const Drop held = drop_on_sphere(ColliderResponse::contact, 0, 1);
    EXPECT_TRUE(filtered.touched);
    // Impact at 1.4 m/s takes it in by up to a step's way, 2.3 cm.
    EXPECT_GT(filtered.deepest, 0.001f);
    EXPECT_LT(filtered.deepest, 0.08f) << "or it has fallen through";
    EXPECT_GT(filtered.sunk, 0) << "nothing pushes it out";
    EXPECT_LT(held.deepest, 0) << "contact keeps it outside";
}

TEST(VelocityFilter, HasNoFriction) {
    const Drop filtered = drop_on_sphere(ColliderResponse::velocity_filter, 0.05f, 1.5f);
    const Drop held = drop_on_sphere(ColliderResponse::contact, 0.05f, 1.5f);
    EXPECT_GT(std::abs(filtered.slid - 0.05f), 3 * std::abs(held.slid - 0.05f))
        << filtered.slid << " and " << held.slid;
}

TEST(VelocityFilter, CanBeSwitchedWhileClothLies) {
    World world = World::create(vacuum({0, -9.81f, 0})).value();
    const Mesh mesh =
        make_sheet(
            {.rows = 9, .columns = 9, .origin = {-0.1f, 0.02f, -0.1f}, .u = {0.2f, 0, 0}, .v = {0, 0, 0.2f}})
            .value();
    const ClothId id = world.add_cloth(mesh, {}).value();
    EXPECT_TRUE(world.add_collider({.shape = Plane{{0, 1, 0}, 0}}));
    const auto height_after = [&](ColliderResponse response) {
        ClothSettings settings = world.cloth_settings(id).value();
        settings.collider_response = response;
        EXPECT_TRUE(world.set_cloth_settings(id, settings));
        for (int step = 0; step < 60; ++step) world.step(1.0f / 60);
        return world.cloth(id).value().positions[0].y;
    };
    EXPECT_NEAR(height_after(ColliderResponse::contact), 0.005, 5e-4);
    const float sunk = height_after(ColliderResponse::velocity_filter);
    EXPECT_LT(sunk, 0) << "filtering begins inside";
    EXPECT_GT(sunk, -0.05f);
    EXPECT_GT(height_after(ColliderResponse::contact), 0.004) << "pushed out";
}

}  // namespace
}  // namespace weft::test
