#pragma once
// Strips of cloth that hang from one another by seams.

#include <gtest/gtest.h>

#include <algorithm>
#include <numeric>
#include <vector>

#include "tests/cloth/fixtures.h"
#include "weft/weft.h"

namespace weft::test::sewn {

using Vertices = std::vector<std::uint32_t>;
inline constexpr std::uint32_t columns = 6, rows = 9;
inline constexpr float length = 0.4f, width = 0.25f;

inline Vertices row(std::uint32_t number) {
    Vertices vertices(columns);
    std::iota(vertices.begin(), vertices.end(), number * columns);
    return vertices;
}
inline const Vertices top = row(0), bottom = row(rows - 1);

inline Mesh strip(float y, float x = 0) {
    return make_sheet({.rows = rows,
                       .columns = columns,
                       .origin = {x, y, 0},
                       .u = {width, 0, 0},
                       .v = {0, -length, 0}})
        .value();
}

inline ClothSettings of_density(float density) {
    ClothSettings settings;
    settings.fabric.areal_density = density;
    return settings;
}

/// Two strips, the lower one sewn to the upper one's end; the upper one is pinned at its top.
struct Hanging {
    explicit Hanging(const SeamSettings& settings = {}, const ClothSettings& of_a = {},
                     const ClothSettings& of_b = {}, WorldSettings of_world = vacuum(downwards),
                     float gap = 0)
        : world(World::create(of_world).value()),
          a(world.add_cloth(strip(0), of_a).value()),
          b(world.add_cloth(strip(-length - gap), of_b).value()),
          seam(world.stitch(a, bottom, b, top, settings).value()) {
        EXPECT_TRUE(world.pin(a, top));
    }
    void run(int steps) {
        for (int k = 0; k < steps; ++k) world.step(h);
    }
    [[nodiscard]] Vector3 place(ClothId id, std::uint32_t vertex) const {
        const ClothView view = *world.cloth(id);
        return xyz(view.positions[view.vertex_to_particle[vertex]]);
    }
    [[nodiscard]] float gap(std::uint32_t k) const { return (place(a, bottom[k]) - place(b, top[k])).norm(); }
    [[nodiscard]] float weight(ClothId id) const { return 9.81f * world.cloth_info(id)->mass; }

    World world;
    ClothId a, b;
    SeamId seam;
};

/// Strips that are damped enough to hang still after some seconds.
inline ClothSettings damped(float density = 0.2f) {
    ClothSettings settings = of_density(density);
    settings.air_damping = 3;
    return settings;
}

inline ClothSettings in_contact() {
    ClothSettings settings = damped();
    settings.self_collision.method = SelfCollisionMethod::contact;
    return settings;
}

}  // namespace weft::test::sewn
