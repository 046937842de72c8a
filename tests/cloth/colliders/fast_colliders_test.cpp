// What is thin or fast does not pass a sheet between two steps.

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cstdio>
#include <cstdlib>
#include <vector>

#include "struck_sheet.h"

namespace weft::test {
namespace {

constexpr int strikes = 20;  // in as many phases of the step

float phase_of(int strike) {
    return static_cast<float>(strike) / static_cast<float>(strikes);
}

TEST(FastColliders, ABallOfTwentyCentimetresIsCarriedAtAnySpeed) {
    for (const float speed : {10.0f, 50.0f})
        for (int k = 0; k < strikes; k += 7) {
            const Struck struck = strike(Striker{Striker::Kind::ball, speed, 0.1f}, 32, phase_of(k));
            EXPECT_EQ(struck.carried, 1) << speed << " m/s, phase " << phase_of(k);
            EXPECT_TRUE(struck.sound);
            EXPECT_LT(struck.fastest, 1.5f * speed);
        }
}

TEST(FastColliders, ABallOfTenCentimetresIsCarriedByAFineSheet) {
    for (const int k : {0, 7, 13})
        EXPECT_EQ(strike(Striker{Striker::Kind::ball, 50, 0.05f}, 128, phase_of(k)).carried, 1)
            << phase_of(k);
}

// Cloth flew on over the edges of a plate that had just stopped, since these counted only while it moved.
TEST(FastColliders, APlateDoesNotCutTheSheetWhenItStops) {
    for (const auto kind : {Plate::Kind::box, Plate::Kind::hull, Plate::Kind::mesh})
        for (const float speed : {2.0f, 5.0f, 10.0f})
            for (const int k : {0, 5, 11}) {
                const float radius = kind == Plate::Kind::box ? 0.1f : 0.025f;
                const Struck struck = strike(Plate{kind, speed, radius, 0.01f}, 32, phase_of(k));
                EXPECT_EQ(struck.carried, 1)
                    << static_cast<int>(kind) << " at " << speed << " m/s, phase " << phase_of(k);
            }
}

// Each part but the first begins elsewhere than the step did.
TEST(FastColliders, PartsOfAStepMeetCollidersOnTheirWay) {
    for (const int substeps : {2, 3})
        for (const int k : {0, 5})
            EXPECT_EQ(strike(Striker{Striker::Kind::ball, 50, 0.1f}, 32, phase_of(k), substeps).carried, 1);
}

/// How far a hung sheet's particles go at most within three steps, in the first of which something jumps
/// through it, or not [m].
float moved_by_jump(const Collider& from, const Collider& to, int world_substeps, int cloth_substeps) {
    World world = World::create({.substeps = world_substeps, .threads = 1}).value();
    const Mesh mesh = make_sheet({.rows = 17, .columns = 17}).value();
    const ClothId cloth = world.add_cloth(mesh, {.substeps = cloth_substeps}).value();
    for (const std::uint32_t corner : {0u, 16u}) EXPECT_TRUE(world.pin(cloth, corner));
    const ColliderId collider = world.add_collider(from).value();
    world.step(1.0f / 60);
    const auto positions = world.cloth(cloth).value().positions;
    const std::vector<Vec4> were(positions.begin(), positions.end());
    EXPECT_TRUE(world.move_collider(collider, to));
    for (int k = 0; k < 3; ++k) world.step(1.0f / 60);
    float way = 0;
    for (std::size_t i = 0; i < were.size(); ++i)
        way = std::max(way, (xyz(world.cloth(cloth).value().positions[i]) - xyz(were[i])).norm());
    return way;
}

// Half way, where a step in two halves would have it, it would be in the cloth.
TEST(FastColliders, WhatJumpsMeetsNothingOnTheWayInAnyNumberOfParts) {
    const auto at = [](float x) {
        return std::array<Collider, 3>{
            Collider{.shape = Sphere{{x, 0, 0}, 0.3f}},
            Collider{.shape = Capsule{{x, 0, -1}, {x, 0, 1}, 0.2f}},
            Collider{.shape = Box{.center = {x, 0, 0}, .half_extents = {.3f, .3f, .3f}}}};
    };
    for (std::size_t kind = 0; kind < 3; ++kind)
        for (const int world_substeps : {1, 2, 4})
            for (const int cloth_substeps : {1, 2}) {
                const Collider far = at(-400)[kind], beyond = at(400)[kind];
                EXPECT_EQ(moved_by_jump(far, beyond, world_substeps, cloth_substeps),
                          moved_by_jump(far, far, world_substeps, cloth_substeps))
                    << kind << ", " << world_substeps << " x " << cloth_substeps;
            }
}

// WEFT_STRIKE_TABLE=1: how often, of 20 phases of the step, the sheet is carried; for MEASUREMENTS.md.
TEST(FastColliders, Table) {
    if (std::getenv("WEFT_STRIKE_TABLE") == nullptr) GTEST_SKIP() << "a table for people";
    struct Row {
        const char* name;
        Striker::Kind kind;
        float radius;
        std::vector<float> speeds;
    };
    const Row rows[] = {{"bar", Striker::Kind::bar, 0.005f, {1, 5, 10, 20, 30}},
                        {"ball", Striker::Kind::ball, 0.05f, {5, 10, 20, 50}},
                        {"ball20", Striker::Kind::ball, 0.1f, {10, 20, 50}},
                        {"sword", Striker::Kind::sword, 0.005f, {5, 10, 30}}};
    for (const Row& row : rows)
        for (const std::uint32_t side : {32u, 128u})
            for (const float speed : row.speeds) {
                int whole = 0;
                float mean = 0, fastest = 0;
                for (int phase = 0; phase < strikes; ++phase) {
                    const Struck struck = strike(Striker{row.kind, speed, row.radius}, side,
                                                 static_cast<float>(phase) / static_cast<float>(strikes));
                    EXPECT_TRUE(struck.sound);
                    whole += struck.carried == 1 ? 1 : 0;
                    mean += struck.carried / strikes;
                    fastest = std::max(fastest, struck.fastest);
                }
                std::printf("%-6s %6u particles %5.0f m/s: whole in %2d of 20, mean %.3f, fastest %.0f m/s\n",
                            row.name, side * side, static_cast<double>(speed), whole,
                            static_cast<double>(mean), static_cast<double>(fastest));
                std::fflush(stdout);
            }
}

}  // namespace
}  // namespace weft::test
