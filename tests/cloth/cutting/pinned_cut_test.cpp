// A cut that ends at a pin, by contact.

#include <gtest/gtest.h>

#include <algorithm>
#include <array>

#include "tests/cloth/meshes.h"
#include "weft/weft.h"

namespace weft::test {
namespace {

// Both copies of the pinned corner are pinned, nearer than contact keeps cloth apart: nothing can mend that.
TEST(Recut, WhatPartsAtAPinIsNotFlungOffByContact) {
    for (const Method& method : {Method(Multilevel{}), Method(Jacobi{})}) {
        World world = must(World::create({}));
        const Mesh mesh = must(make_sheet({.rows = 2, .columns = 2, .u = {0.06f, 0, 0}, .v = {0, 0, 0.06f}}));
        const ClothSettings settings{.method = method,
                                     .self_collision = {.method = SelfCollisionMethod::contact}};
        const ClothId cloth = must(world.add_cloth(mesh, settings));
        std::array<std::uint32_t, 2> diagonal{};
        for (std::uint32_t v = 0, found = 0; v < 4; ++v) {
            const auto has = [&](const Triangle& t) { return std::ranges::find(t, v) != t.end(); };
            if (std::ranges::all_of(mesh.triangles, has)) diagonal[found++] = v;
        }
        ASSERT_TRUE(world.pin(cloth, diagonal[0]));
        for (int k = 0; k < 40; ++k) world.step(1.0f / 60);
        const MeshCut cut = must(cut_mesh(mesh, {{diagonal}}));
        ASSERT_EQ(cut.added_particles, 2u);
        ASSERT_TRUE(world.recut_cloth(cloth, cut.mesh, cut.from));
        for (int k = 0; k < 90; ++k) world.step(1.0f / 60);
        float peak = 0;
        for (int k = 0; k < 30; ++k) peak = std::max(peak, world.step(1.0f / 60).peak_speed);
        EXPECT_LT(peak, 1);  // [m/s]; 100, the most there is, when it was flung
    }
}

}  // namespace
}  // namespace weft::test
