// Cloth that a step finds inside a collider, into which it did not bring it: it comes out, and is not thrown.

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <vector>

#include "collision/colliders/nearest_surface.h"
#include "engine/vector.h"
#include "tests/cloth/fixtures.h"
#include "tests/collision/colliders/solids.h"
#include "weft/weft.h"

namespace weft::test {
namespace {

constexpr Vec3 weight{0, -9.81f, 0};

Mesh lying_sheet(float height, std::uint32_t side = 9) {
    return make_sheet({.rows = side,
                       .columns = side,
                       .origin = {-0.2f, height, -0.2f},
                       .u = {0.4f, 0, 0},
                       .v = {0, 0, 0.4f}})
        .value();
}

struct Rise {
    float speed = 0;       ///< greatest of any particle [m/s]
    float over = -1;       ///< greatest height over where it is to lie [m]
    float under_then = 0;  ///< least after the stated time [m]
};

/// What the cloth does over the time in which it is to have come out, and twice that again.
Rise watch(World& world, ClothId id, float lies_at, float seconds = 1, float step = 1.0f / 60) {
    Rise rise;
    const int steps = static_cast<int>(seconds / step);
    for (int k = 0; k < 3 * steps; ++k) {
        world.step(step);
        const ClothView view = world.cloth(id).value();
        for (const Vec4& v : view.velocities) rise.speed = std::max(rise.speed, xyz(v).norm());
        for (const Vec4& p : view.positions) {
            rise.over = std::max(rise.over, p.y - lies_at);
            if (k >= steps) rise.under_then = std::min(rise.under_then, p.y - lies_at);
        }
    }
    return rise;
}

void expect_calm(const Rise& rise, const std::string& of) {
    EXPECT_LT(rise.speed, 0.3f) << of;
    EXPECT_LT(rise.over, 0.005f) << of;
    EXPECT_GT(rise.under_then, -5e-4f) << of;
}

std::vector<Method> methods_to_rise() {
    return {Multilevel{}, Multilevel{.passes = 3}, ConjugateGradient{}, Xpbd{}};
}

// A step's spring that took out all of it would throw the cloth up at 0.95 to 1.3 m/s.
TEST(FoundDepth, FilteredClothComesOutOfTheGroundWithoutSpeed) {
    for (const Method& method : methods_to_rise())
        for (const float step : {1.0f / 60, 1.0f / 240}) {
            World world = World::create(vacuum(weight)).value();
            ClothSettings settings;
            settings.method = method;
            settings.collider_response = ColliderResponse::velocity_filter;
            const ClothId id = world.add_cloth(lying_sheet(0.02f), settings).value();
            ASSERT_TRUE(world.add_collider({.shape = Plane{}}));
            for (int k = 0; k < 120; ++k) world.step(step);
            ASSERT_LT(world.cloth(id)->positions[0].y, 0) << "it lies in the ground";
            settings.collider_response = ColliderResponse::contact;
            ASSERT_TRUE(world.set_cloth_settings(id, settings));
            expect_calm(watch(world, id, 0.005f, 1, step), std::to_string(method.index()));
        }
}

TEST(FoundDepth, PlacedGroundLiftsClothWithoutSpeed) {
    for (const Method& method : methods_to_rise())
        for (const float depth : {0.002f, 0.01f, 0.1f}) {
            World world = World::create(vacuum(weight)).value();
            ClothSettings settings;
            settings.method = method;
            const ClothId id = world.add_cloth(lying_sheet(0.006f), settings).value();
            const ColliderId ground = world.add_collider({.shape = Plane{}}).value();
            for (int k = 0; k < 60; ++k) world.step(h);
            ASSERT_TRUE(world.place_collider(ground, {.shape = Plane{{0, 1, 0}, depth}}));
            expect_calm(watch(world, id, 0.005f + depth),
                        std::to_string(method.index()) + ", " + std::to_string(depth));
        }
}

TEST(FoundDepth, ClothAddedInsideABoxComesOut) {
    World world = World::create(vacuum(weight)).value();
    ASSERT_TRUE(world.add_collider({.shape = Box{{0, -0.5f, 0}, {}, {1, 0.5f, 1}}}));
    const ClothId id = world.add_cloth(lying_sheet(-0.05f)).value();
    expect_calm(watch(world, id, 0.005f), "box");
}

// It has no velocity, but it does not fall asleep before it is out.
TEST(FoundDepth, ClothDoesNotSleepBeforeItIsOut) {
    World world = World::create(vacuum(weight)).value();
    ClothSettings settings;
    settings.sleep_speed = 0.01f;
    const ClothId id = world.add_cloth(lying_sheet(0.006f), settings).value();
    const ColliderId ground = world.add_collider({.shape = Plane{}}).value();
    for (int k = 0; k < 90; ++k) world.step(h);
    ASSERT_EQ(world.report().sleeping_cloths, 1u);
    ASSERT_TRUE(world.place_collider(ground, {.shape = Plane{{0, 1, 0}, 0.2f}}));
    for (int k = 0; k < 150; ++k) world.step(h);
    EXPECT_EQ(world.report().sleeping_cloths, 1u);
    for (const Vec4& p : world.cloth(id)->positions) ASSERT_GT(p.y, 0.2045f);
}

// What a step brings is no found depth: bodies that sweep push all of it, whatever they do on the way.
TEST(FoundDepth, WhatAStepBringsIsPushedAtOnce) {
    const auto turned = [](float angle) { return Rotation{0, 0, std::sin(angle / 2), std::cos(angle / 2)}; };
    const auto bar = [](float angle) {
        return Capsule{{-0.4f * std::cos(angle), 0.3f - 0.4f * std::sin(angle), -0.1f},
                       {0.4f * std::cos(angle), 0.3f + 0.4f * std::sin(angle), 0.1f},
                       0.03f};
    };
    for (int shape = 0; shape < 4; ++shape) {
        const auto at = [&](float t) {  // from 0 to 1
            switch (shape) {
                case 0:
                    return Collider{.shape = Plane{{0.2f * t, 1, 0}, 0.4f * t}};
                case 1:
                    return Collider{.shape = Box{{0, 0.4f * t, 0}, turned(t), {0.3f, 0.05f, 0.3f}}};
                case 2:
                    return Collider{.shape = bar(3 * t)};
                default:
                    return Collider{.shape = Sphere{{0, -0.2f + 0.3f * t, 0}, 0.1f + 0.3f * t}};
            }
        };
        World world = World::create(vacuum(weight)).value();
        const ClothId id = world.add_cloth(lying_sheet(0.41f - 0.35f * (shape != 2), 17)).value();
        const ColliderId collider = world.add_collider(at(0)).value();
        float deepest = 0;
        for (int k = 1; k <= 30; ++k) {
            const Collider now = at(static_cast<float>(k) / 30);
            ASSERT_TRUE(world.move_collider(collider, now));
            world.step(h);
            const ClothView view = world.cloth(id).value();
            for (const Vec4& p : view.positions)
                deepest = std::max(deepest, 0.005f - nearest_surface(now, xyz(p)).distance);
        }
        EXPECT_LT(deepest, 2e-4f) << shape;
    }
}

// A mesh that deforms brings its depth, too.
TEST(FoundDepth, WhatADeformingMeshBringsIsPushedAtOnce) {
    World world = World::create(vacuum(weight)).value();
    const auto corners = [](float top) {
        std::vector<Vec3> made;
        for (const float z : {-0.3f, 0.3f})
            for (const float y : {-0.1f, top})
                for (const float x : {-0.3f, 0.3f}) made.push_back({x, y, z});
        return made;
    };
    const std::vector<std::array<std::uint32_t, 3>> triangles{{0, 3, 1}, {0, 2, 3}, {4, 5, 7}, {4, 7, 6},
                                                              {0, 1, 5}, {0, 5, 4}, {2, 7, 3}, {2, 6, 7},
                                                              {0, 4, 6}, {0, 6, 2}, {1, 3, 7}, {1, 7, 5}};
    const std::vector<Vec3> flat = corners(0);
    const ShapeId shape = world.add_shape(TriangleMesh{flat, triangles}).value();
    const ClothId id = world.add_cloth(lying_sheet(0.006f, 17)).value();
    ASSERT_TRUE(world.add_collider({.shape = PlacedShape{shape}}));
    for (int k = 1; k <= 20; ++k) {
        const float top = 0.01f * static_cast<float>(k);
        ASSERT_TRUE(world.deform_shape(shape, corners(top)));
        world.step(h);
        for (const Vec4& p : world.cloth(id)->positions) ASSERT_GT(p.y - top, 0.0048f) << k;
    }
}

// A ball that is set down inside a hung sheet: the sheet comes off it, and does not fly.
TEST(FoundDepth, BallPlacedInAHungSheetDoesNotThrowIt) {
    for (const Method& method : {Method(Multilevel{}), Method(Xpbd{})}) {
        World world = World::create(vacuum(weight)).value();
        ClothSettings settings;
        settings.method = method;
        settings.substeps = std::holds_alternative<Xpbd>(method) ? 4 : 1;
        settings.air_damping = 2;
        const Mesh mesh =
            make_sheet({.rows = 33, .columns = 33, .origin = {-0.5f, 1, 0}, .u = {1, 0, 0}, .v = {0, -1, 0}})
                .value();
        const ClothId id = world.add_cloth(mesh, settings).value();
        std::vector<std::uint32_t> top;
        for (std::uint32_t v = 0; v < 33; ++v) top.push_back(v);
        ASSERT_TRUE(world.pin(id, top));
        const ColliderId ball = world.add_collider({.shape = Sphere{{0, 0, 9}, 0.1f}}).value();
        for (int k = 0; k < 240; ++k) world.step(h);
        const ClothView view = world.cloth(id).value();
        const Vec4 middle = view.positions[33 * 16 + 16];
        const Vec3 place{middle.x, middle.y, middle.z - 0.06f};
        ASSERT_TRUE(world.place_collider(ball, {.shape = Sphere{place, 0.1f}}));
        float speed = 0, near_it = 0, gap = 0;
        for (int k = 0; k < 60; ++k) {
            world.step(h);
            gap = 1;
            const ClothView now = world.cloth(id).value();
            for (std::size_t i = 0; i < now.positions.size(); ++i) {
                const float moves = xyz(now.velocities[i]).norm();
                const float apart = (xyz(now.positions[i]) - to_vector(place)).norm() - 0.1f;
                speed = std::max(speed, moves);
                gap = std::min(gap, apart);
                if (apart < 0.01f) near_it = std::max(near_it, moves);
            }
        }
        EXPECT_LT(near_it, 0.3f) << method.index();
        EXPECT_LT(speed, 0.7f) << "its hem swings: " << method.index();
        EXPECT_GT(gap, 0.004f) << method.index();
    }
}

// A body of two balls: between their middles no way is free along the nearest normals, and there is no cloth
// that they squeeze either.
TEST(FoundDepth, BodyOfTwoBallsPlacedInASheetIsLeft) {
    World world = World::create(vacuum({})).value();
    const ClothId id = world.add_cloth(lying_sheet(0.02f, 33)).value();
    const std::array<Vec3, 2> places{Vec3{-0.04f, 0, 0}, Vec3{0.04f, 0, 0}};
    for (const Vec3& place : places) {
        const ColliderId ball = world.add_collider({.shape = Sphere{{place.x, 9, 0}, 0.08f}}).value();
        ASSERT_TRUE(world.place_collider(ball, {.shape = Sphere{place, 0.08f}}));
    }
    for (int k = 0; k < 120; ++k) world.step(h);
    const ClothView view = world.cloth(id).value();
    for (const Vec4& p : view.positions)
        for (const Vec3& place : places)
            ASSERT_GT((xyz(p) - to_vector(place)).norm(), 0.08f + 0.0045f) << p.x << ", " << p.z;
}

/// A box of 40 x 30 x 50 cm about the origin.
Collider body_of_kind(World& world, int kind) {
    const Solid solid = box_mesh({0.2f, 0.15f, 0.25f});
    if (kind == 0) return {.shape = Box{.half_extents = {0.2f, 0.15f, 0.25f}}};
    if (kind == 1) return {.shape = PlacedShape{world.add_shape(ConvexHull{solid.vertices}).value()}};
    return {.shape = PlacedShape{world.add_shape(solid.mesh()).value()}};
}

/// The same in another place.
Collider moved_to(Collider collider, const Vec3& place) {
    if (auto* const box = std::get_if<Box>(&collider.shape)) box->center = place;
    if (auto* const placed = std::get_if<PlacedShape>(&collider.shape)) placed->position = place;
    return collider;
}

Mesh upright_sheet(float size, float z) {
    return make_sheet({.rows = 17,
                       .columns = 17,
                       .origin = {-0.5f * size, 0.5f * size, z},
                       .u = {size, 0, 0},
                       .v = {0, -size, 0}})
        .value();
}

// The nearest ways out lead to all sides: they tore the sheet to eighteen times its size, and it snapped at
// 3 to 27 m/s.
TEST(FoundDepth, ClothInTheMiddleOfABodyLeavesItAsAWhole) {
    for (const int kind : {0, 1, 2})
        for (const float size : {0.28f, 1.0f})
            for (const float z : {0.001f, 0.1f})
                for (const auto method : {SelfCollisionMethod::off, SelfCollisionMethod::contact}) {
                    World world = World::create(vacuum()).value();
                    const Collider body = body_of_kind(world, kind);
                    ASSERT_TRUE(world.add_collider(body));
                    const ClothSettings settings{.self_collision = {.method = method}};
                    const ClothId id = world.add_cloth(upright_sheet(size, z), settings).value();
                    float speed = 0;
                    for (int k = 0; k < 210; ++k) speed = std::max(speed, world.step(h).peak_speed);
                    EXPECT_LT(speed, 1.2f) << kind << ", " << size << " m at " << z;
                    const Collider box{.shape = Box{.half_extents = {0.2f, 0.15f, 0.25f}}};
                    for (const Vec4& p : world.cloth(id)->positions)
                        ASSERT_GT(nearest_surface(box, xyz(p)).distance, 0.0045f) << kind << ", " << size;
                }
}

// Cloth in the middle moves along with the body until it is out.
TEST(FoundDepth, ABodyCarriesTheClothInItsMiddle) {
    for (const int kind : {0, 1, 2}) {
        World world = World::create(vacuum()).value();
        const Collider body = body_of_kind(world, kind);
        const ColliderId collider = world.add_collider(body).value();
        const ClothId id = world.add_cloth(upright_sheet(0.2f, 0.001f)).value();
        for (int k = 1; k <= 60; ++k) {
            ASSERT_TRUE(world.move_collider(collider, moved_to(body, {0, h * static_cast<float>(k), 0})));
            EXPECT_LT(world.step(h).peak_speed, 1.1f) << kind;
        }
        for (const Vec4& p : world.cloth(id)->positions) {
            ASSERT_NEAR(p.y, 1, 0.11f) << kind;
            ASSERT_NEAR(p.z, 0.1f, 0.01f) << kind << ": .1 m/s out of it";
        }
    }
}

}  // namespace
}  // namespace weft::test
