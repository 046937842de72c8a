// Cloth that goes another way than it was going when groups were found crosses nothing of another group.

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <memory>
#include <numeric>
#include <random>
#include <set>

#include "cloth/contact/own_space.h"
#include "cloth/stages/contact_step.h"
#include "cloth/step/sleep.h"
#include "crossing_count.h"
#include "engine/bounds.h"
#include "tests/cloth/fixtures.h"
#include "tests/cloth/meshes.h"

namespace weft::test {
namespace {

bool contains(const Bounds& outer, const Bounds& inner) {
    return (to_vector(outer.lower).array() <= to_vector(inner.lower).array()).all() &&
           (to_vector(outer.upper).array() >= to_vector(inner.upper).array()).all();
}

/// The widest gap between two boxes, along any axis.
float gap_between(const Bounds& a, const Bounds& b) {
    return std::max((to_vector(a.lower) - to_vector(b.upper)).maxCoeff(),
                    (to_vector(b.lower) - to_vector(a.upper)).maxCoeff());
}

// Boxes of a lattice: many have the same gap along two axes, or on both sides.
TEST(OwnSpace, OfTwoBoxesAreApartAndHaveTheirBoxes) {
    constexpr float radius = 0.01f, floor = 0.001f;
    std::mt19937 random(11);
    std::uniform_int_distribution<int> place(-3, 3), size(0, 2);
    int pairs = 0;
    for (int k = 0; k < 2000; ++k) {
        std::array<Bounds, 2> boxes{};
        for (Bounds& box : boxes)
            for (float Vec3::*axis : {&Vec3::x, &Vec3::y, &Vec3::z}) {
                box.lower.*axis = 0.1f * static_cast<float>(place(random));
                box.upper.*axis = box.lower.*axis + 0.1f * static_cast<float>(size(random));
            }
        const std::array<Bounds, 2> grown_boxes{grown(boxes[0], radius), grown(boxes[1], radius)};
        if (overlap(grown_boxes[0], grown_boxes[1])) continue;
        ++pairs;
        OwnSpace first(grown_boxes[0], floor), second(grown_boxes[1], floor);
        first.keep_from(grown_boxes[1]);
        second.keep_from(grown_boxes[0]);
        EXPECT_GT(gap_between(first.bounds(), second.bounds()), 1.999f * floor);
        EXPECT_TRUE(contains(first.bounds(), boxes[0]));
        EXPECT_TRUE(contains(second.bounds(), boxes[1]));
    }
    EXPECT_GT(pairs, 500);
}

constexpr float width = 0.3f;

/// An upright square across x.
Mesh upright(float x) {
    return must(
        make_sheet({.rows = 12, .columns = 12, .origin = {x, 0, 0}, .u = {0, width, 0}, .v = {0, 0, width}}));
}

/// Sheets at random places that fly in random directions.
struct Flight {
    Simulation simulation{vacuum()};

    Flight(std::uint32_t seed, float speed) {
        std::mt19937 random(seed);
        std::uniform_real_distribution<float> place(0, 5), direction(-speed, speed);
        ClothSettings settings;
        settings.self_collision = {.method = SelfCollisionMethod::contact};
        for (int k = 0; k < 40; ++k) {
            Mesh mesh = upright(place(random));
            const Vec3 at{0, place(random), place(random)};
            for (Vec3& p : mesh.positions) p = {p.x, p.y + at.y, p.z + at.z};
            auto cloth = std::make_unique<Cloth>(must(cook(mesh)), settings);
            const Vector3 velocity(direction(random), direction(random), direction(random));
            for (Vec4& v : cloth->state.velocities.span()) v = to_vec4(velocity, 0);
            simulation.add(std::move(cloth));
        }
        choose_present(simulation, h);
        for (Cloth* cloth : simulation.present) expect(simulation, *cloth, h);
        meet(simulation);
    }
};

// What meets may pass its speed on, to what is then to be expected farther away, and so on.
TEST(OwnSpace, ClothsOfTwoGroupsAreExpectedApartHoweverSpeedIsPassedOn) {
    int some_meet = 0;
    for (std::uint32_t seed = 0; seed < 20; ++seed) {
        const Flight flight(seed, 0.5f + static_cast<float>(seed));
        const std::vector<Cloth*>& cloths = flight.simulation.present;
        std::set<std::uint32_t> groups;
        for (const Cloth* a : cloths) {
            groups.insert(a->group);
            float longest = 0;  // of those that it meets
            for (const Cloth* b : cloths) {
                if (a != b && a->group == b->group) longest = std::max(longest, b->expected.length);
                EXPECT_FALSE(a->group != b->group && overlap(a->expected.box, b->expected.box)) << seed;
            }
            EXPECT_GE(a->expected.grown_by, 0.999f * longest) << seed;
        }
        some_meet += groups.size() > 1 && groups.size() < cloths.size();
    }
    EXPECT_GE(some_meet, 10);
}

/// A light sheet at rest beside a heavy one, and a wind from now on that blows one at the
/// other.
struct Gust {
    World world;
    std::vector<ClothId> cloths;

    Gust(float speed, float gap, bool light_first) : world(must(World::create(wind_of(speed)))) {
        for (const bool first : {true, false}) {
            const bool is_light = first == light_first;
            ClothSettings settings;
            settings.self_collision = {.method = SelfCollisionMethod::contact};
            settings.fabric.areal_density = is_light ? 0.05f : 50.0f;
            cloths.push_back(must(world.add_cloth(upright(is_light ? 0 : gap), settings)));
        }
    }
    static WorldSettings wind_of(float speed) {
        WorldSettings settings;
        settings.gravity = {};
        settings.wind.velocity = {speed, 0, 0};
        return settings;
    }
};

// From rest the light sheet reaches its neighbour within a step: nothing told that the two would meet.
TEST(OwnSpace, ClothThatIsBlownAtAnotherCrossesNothing) {
    for (const float speed : {30.0f, 100.0f, 300.0f})
        for (const float gap : {0.03f, 0.1f, 0.3f})
            for (const bool light_first : {true, false}) {
                Gust scene(speed, gap, light_first);
                for (int k = 0; k < 8; ++k) {
                    scene.world.step(h);
                    ASSERT_EQ(crossings(scene.world, scene.cloths), 0)
                        << speed << " m/s, " << gap << " m apart, step " << k;
                }
                const Bounds light = must(scene.world.cloth(scene.cloths[light_first ? 0 : 1])).bounds;
                const Bounds heavy = must(scene.world.cloth(scene.cloths[light_first ? 1 : 0])).bounds;
                EXPECT_LT(light.lower.x, heavy.upper.x) << "it was to be stopped";
                EXPECT_GT(heavy.lower.x, gap) << "it was to be pushed";
                EXPECT_EQ(scene.world.report().restored_cloths, 0u);
            }
}

/// Level squares above each other.
struct Sheets {
    World world;
    std::vector<ClothId> cloths;

    Sheets(const WorldSettings& settings, std::span<const float> heights)
        : world(must(World::create(settings))) {
        ClothSettings of;
        of.self_collision = {.method = SelfCollisionMethod::contact};
        for (const float y : heights)
            cloths.push_back(must(world.add_cloth(must(make_sheet({.rows = 12,
                                                                   .columns = 12,
                                                                   .origin = {0, y, 0},
                                                                   .u = {width, 0, 0},
                                                                   .v = {0, 0, width}})),
                                                  of)));
    }
    [[nodiscard]] Bounds bounds(std::size_t k) { return must(world.cloth(cloths[k])).bounds; }
};

// The lowest sheet is pushed into the next, and that into the third: all of them go along.
TEST(OwnSpace, ClothsThatAColliderSweepsUpTogetherAreExpectedToMeet) {
    WorldSettings settings = vacuum();
    settings.gravity = {};
    Sheets sheets(settings, std::array{0.0f, 0.06f, 0.12f});
    const auto box = [](float y) {
        return Collider{.shape = Box{.center = {0.15f, y, 0.15f}, .half_extents = {0.3f, 0.05f, 0.3f}}};
    };
    const ColliderId below = must(sheets.world.add_collider(box(-0.06f)));
    sheets.world.step(h);
    ASSERT_TRUE(sheets.world.move_collider(below, box(0.1f)));
    sheets.world.step(h);
    EXPECT_GT(sheets.bounds(0).lower.y, 0.14f) << "the box's top is at 0.15";
    EXPECT_GT(sheets.bounds(1).lower.y, 0.14f);
    EXPECT_GT(sheets.bounds(2).lower.y, 0.14f);
    EXPECT_EQ(crossings(sheets.world, sheets.cloths), 0);
}

// What is pushed is expected to pass that on, too.
TEST(OwnSpace, WhatAColliderPushesIsExpectedToPushAsFar) {
    Simulation simulation(vacuum());
    ClothSettings settings;
    settings.self_collision = {.method = SelfCollisionMethod::contact};
    simulation.add(std::make_unique<Cloth>(must(cook(upright(0))), settings));
    const auto ball = [](float x) {
        return Collider{.shape = Sphere{.center = {x, 0.15f, 0.15f}, .radius = 0.05f}};
    };
    simulation.expect_colliders(1);
    simulation.state.colliders.insert({.current = ball(-0.1f), .target = ball(0.3f)});
    choose_present(simulation, h);
    Cloth& cloth = *simulation.present.front();
    expect(simulation, cloth, h);
    EXPECT_NEAR(cloth.expected.length, 0.4f, 0.01f);
    EXPECT_GT(cloth.expected.box.upper.x, 0.4f);
}

// Two light layers that a gust blows at a third: what is cut between them goes with the motion that they have
// in common, and may not go on to the third.
TEST(OwnSpace, LayersThatAreBlownAtAnotherClothCrossNothing) {
    for (const float speed : {20.0f, 60.0f, 150.0f})
        for (const float gap : {0.03f, 0.1f}) {
            World world = must(World::create(Gust::wind_of(speed)));
            std::vector<ClothId> cloths;
            for (const float x : {0.0f, 0.004f, 0.008f, 0.008f + gap}) {
                ClothSettings settings;
                settings.self_collision = {.method = SelfCollisionMethod::contact};
                settings.fabric.areal_density = x > 0.01f ? 50.0f : 0.03f + 20 * x;
                cloths.push_back(must(world.add_cloth(upright(x), settings)));
            }
            for (int k = 0; k < 8; ++k) {
                world.step(h);
                ASSERT_EQ(crossings(world, cloths), 0) << speed << " m/s, " << gap << " m apart, step " << k;
            }
            if (speed > 100) continue;  // it may slide off around a border
            EXPECT_LT(must(world.cloth(cloths[0])).bounds.lower.x,
                      must(world.cloth(cloths[3])).bounds.upper.x);
        }
}

}  // namespace
}  // namespace weft::test
