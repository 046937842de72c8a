#pragma once
// Sheets in which features are near, and the search for them.

#include <cmath>

#include "tests/collision/contact/contact_reference.h"
#include "tests/laid_out.h"

namespace weft::test {

inline LaidOut<PairList> pairs_of(const ContactScene& scene, int threads = 1,
                                  std::size_t capacity = room_for_pairs, float of_borders = 1) {
    LaidOut<PairFinder> finder;
    finder.reserve(scene.bodies, capacity);
    Parallel parallel(threads);
    LaidOut<PairList> list(capacity);
    finder.find(parallel, scene.bodies, scene.positions, scene.motions, list, of_borders);
    return list;
}

inline constexpr float edge = 0.01f;

inline std::vector<Vec4> flat(std::uint32_t rows, std::uint32_t columns) {
    return grid_positions(rows, columns, [](float u, float v) { return Vec4{edge * u, 0, edge * v, 0}; });
}

inline ContactScene sheet(std::uint32_t side, float reach, const std::vector<Vec4>& now) {
    ContactScene scene;
    scene.add(flat(side, side), now, grid_triangles(side, side), reach);
    return scene;
}

inline ContactScene waving(std::uint32_t side, float height) {
    return sheet(side, 0.3f * edge, grid_positions(side, side, [&](float u, float v) {
                     return Vec4{edge * u, edge * height * std::sin(0.3f * u + 0.2f * v), edge * v, 0};
                 }));
}

inline ContactScene folded(std::uint32_t side, float gap) {
    ContactScene scene = sheet(side, 0.3f * edge, grid_positions(side, side, [&](float u, float v) {
                                   const Vec4 p = zigzag(u, v, 6, gap);
                                   return Vec4{edge * p.x, edge * p.y, edge * p.z, 0};
                               }));
    scene.jitter(0.02f * edge);
    return scene;
}

/// A sheet that a smooth map lays down, the harder the larger `strength`.
inline Vec4 smoothly(const Vec4& p, float strength, std::uint32_t seed) {
    std::mt19937 random(seed);
    std::uniform_real_distribution<float> uniform(-1, 1);
    const float u = p.x / edge, v = p.z / edge;
    float x[3] = {u * (1 + 0.4f * strength * uniform(random)), 0, v * (1 - 0.3f * strength)};
    for (float& coordinate : x)
        for (int wave = 0; wave < 3; ++wave) {
            const float fu = 0.5f * uniform(random), fv = 0.5f * uniform(random);
            coordinate += strength * 2 * uniform(random) * std::sin(fu * u + fv * v + 3 * uniform(random));
        }
    return {edge * x[0], edge * x[1], edge * x[2], 0};
}

inline std::vector<Vec4> smoothly(std::vector<Vec4> points, float strength, std::uint32_t seed) {
    for (Vec4& p : points) p = smoothly(p, strength, seed);
    return points;
}

}  // namespace weft::test
