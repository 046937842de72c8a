#pragma once
// Sheets over which fine meshes are drawn, and the fine meshes.

#include <cmath>
#include <cstdint>
#include <vector>

#include "engine/vector.h"
#include "weft/drawn_mesh.h"
#include "weft/world.h"

namespace weft::test {

/// A view of a sheet whose particles are put by a function of the place on it, with the surface's own
/// normals.
struct Cage {
    std::vector<Vec4> positions, normals;
    std::vector<Triangle> triangles;
    ClothView view;

    template <class F>
    Cage(std::uint32_t cells, const F& place) {
        for (std::uint32_t r = 0; r <= cells; ++r) {
            for (std::uint32_t c = 0; c <= cells; ++c) {
                const float u = static_cast<float>(c) / static_cast<float>(cells),
                            v = static_cast<float>(r) / static_cast<float>(cells);
                const auto [p, n] = place(u, v);
                positions.push_back(to_vec4(p, 1));
                normals.push_back(to_vec4(n, 0));
                const std::uint32_t a = r * (cells + 1) + c;
                if (r == cells || c == cells) continue;
                triangles.push_back({a, a + 1, a + cells + 2});
                triangles.push_back({a, a + cells + 2, a + cells + 1});
            }
        }
        view = {.positions = positions, .normals = normals, .triangles = triangles};
    }
};

struct PointAndNormal {
    Vector3 p, n;
};
inline PointAndNormal flat_place(float u, float v) {
    return {{u, v, 0}, {0, 0, 1}};
}
/// On a cylinder of radius 0.4 about the y axis.
inline PointAndNormal bent(float u, float v) {
    const float angle = u / 0.4f;
    return {{0.4f * std::sin(angle), v, 0.4f * std::cos(angle)}, {std::sin(angle), 0, std::cos(angle)}};
}

/// A grid of drawn vertices over the flat sheet, `height` above it.
struct Fine {
    std::vector<Vec3> vertices;
    std::vector<Vec2> texcoords;
    std::vector<Triangle> triangles;
    explicit Fine(std::uint32_t cells, float height = 0, bool mirrored = false) {
        for (std::uint32_t r = 0; r <= cells; ++r) {
            for (std::uint32_t c = 0; c <= cells; ++c) {
                const float u = static_cast<float>(c) / static_cast<float>(cells),
                            v = static_cast<float>(r) / static_cast<float>(cells);
                vertices.push_back({u, v, height});
                texcoords.push_back({mirrored ? -u : u, v});
                const std::uint32_t a = r * (cells + 1) + c;
                if (r == cells || c == cells) continue;
                triangles.push_back({a, a + 1, a + cells + 2});
                triangles.push_back({a, a + cells + 2, a + cells + 1});
            }
        }
    }
    [[nodiscard]] DrawnSurface surface() const {
        return {.vertices = vertices, .triangles = triangles, .texcoords = texcoords};
    }
};

struct Drawn {
    std::vector<Vec4> positions, normals, tangents;
    explicit Drawn(std::size_t size) : positions(size), normals(size), tangents(size) {}
    [[nodiscard]] DrawnVertices spans() { return {positions, normals, tangents}; }
};

}  // namespace weft::test
