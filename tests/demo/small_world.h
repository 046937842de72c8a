#pragma once
// Scenes for tests, and a sheet in the xy plane, seen from +Z, for tests of the pointer.

#include <gtest/gtest.h>

#include "demo/scene_simulation.h"

namespace weft::demo {

/// A scene of about so many particles.
inline Simulation simulation_of(const char* scene, std::uint32_t particles,
                                const Overrides& overrides = {.threads = 1}) {
    auto made = Simulation::create(*find_scene(scene), {.particles = particles}, overrides);
    EXPECT_TRUE(made.ok()) << (made ? "" : made.error().message);
    return std::move(*made);
}

/// 11 by 11 particles, 0.1 m apart; vertex (row, column) at x = 0.1 column, y = 1 - 0.1 row, z = 0.
struct SmallWorld {
    SmallWorld() : world(*World::create(one_thread())) {
        Mesh mesh =
            *make_sheet({.rows = 11, .columns = 11, .origin = {0, 1, 0}, .u = {1, 0, 0}, .v = {0, -1, 0}});
        cloths.push_back({*world.add_cloth(mesh), mesh, {}});
    }

    static WorldSettings one_thread() {
        WorldSettings settings;
        settings.threads = 1;
        return settings;
    }
    static std::uint32_t vertex(std::uint32_t row, std::uint32_t column) { return 11 * row + column; }

    [[nodiscard]] Vec4 position(std::uint32_t of_vertex) const {
        const auto view = world.cloth(cloths.front().id);
        return view->positions[view->vertex_to_particle[of_vertex]];
    }
    [[nodiscard]] static render::Ray straight_at(float x, float y) { return {{x, y, 2}, {0, 0, -1}}; }

    World world;
    std::vector<SceneCloth> cloths;
};

}  // namespace weft::demo
