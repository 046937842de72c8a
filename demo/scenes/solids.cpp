#include "demo/scenes/solids.h"

#include <cmath>
#include <numbers>
#include <vector>

#include "demo/scenes/measures.h"
#include "demo/window/annotation.h"
#include "engine/vector.h"

namespace weft::demo {

namespace {

constexpr float full_turn = 2 * std::numbers::pi_v<float>;

}  // namespace

Mesh turned(std::span<const Vec2> profile, std::uint32_t parts, bool closed) {
    Mesh mesh;
    const auto rows = static_cast<std::uint32_t>(profile.size());
    std::vector<std::uint32_t> first(rows);
    std::vector<bool> is_point(rows);
    for (std::uint32_t row = 0; row < rows; ++row) {
        first[row] = static_cast<std::uint32_t>(mesh.positions.size());
        is_point[row] = !closed && (row == 0 || row + 1 == rows);
        const Vec2& at = profile[row];
        if (is_point[row]) {
            mesh.positions.push_back({0, at.y, 0});
            continue;
        }
        for (std::uint32_t part = 0; part < parts; ++part) {
            const float angle = full_turn * static_cast<float>(part) / static_cast<float>(parts);
            mesh.positions.push_back({at.x * std::cos(angle), at.y, at.x * std::sin(angle)});
        }
    }
    const auto vertex = [&](std::uint32_t row, std::uint32_t part) {
        return is_point[row] ? first[row] : first[row] + part % parts;
    };
    for (std::uint32_t row = 0; row + (closed ? 0 : 1) < rows; ++row) {
        const std::uint32_t next = (row + 1) % rows;
        for (std::uint32_t part = 0; part < parts; ++part) {
            const Triangle lower{vertex(row, part), vertex(next, part), vertex(row, part + 1)};
            const Triangle upper{vertex(next, part), vertex(next, part + 1), vertex(row, part + 1)};
            if (!is_point[row]) mesh.triangles.push_back(lower);
            if (!is_point[next]) mesh.triangles.push_back(upper);
        }
    }
    return mesh;
}

Mesh torus(float radius, float tube, std::uint32_t around, std::uint32_t across) {
    std::vector<Vec2> profile;
    for (std::uint32_t k = 0; k < across; ++k) {
        const float angle = full_turn * static_cast<float>(k) / static_cast<float>(across);
        profile.push_back({radius + tube * std::cos(angle), tube * std::sin(angle)});
    }
    return turned(profile, around, true);
}

// An icosahedron: poles, and two rings of five.
Mesh stone(const Vec3& radius) {
    const float up = 1 / std::sqrt(5.0f), out = 2 / std::sqrt(5.0f);
    std::vector<Vector3> corners{{0, -1, 0}};
    for (std::uint32_t k = 0; k < 10; ++k) {
        const float angle = full_turn * (static_cast<float>(k % 5) + (k < 5 ? 0.0f : 0.5f)) / 5;
        corners.emplace_back(out * std::cos(angle), k < 5 ? -up : up, out * std::sin(angle));
    }
    corners.emplace_back(0, 1, 0);
    Mesh mesh;
    const auto add = [&](std::uint32_t a, std::uint32_t b, std::uint32_t c) {
        const auto vertex = static_cast<std::uint32_t>(mesh.positions.size());
        for (const std::uint32_t corner : {a, b, c})
            mesh.positions.push_back(to_vec3(corners[corner].cwiseProduct(to_vector(radius))));
        mesh.triangles.push_back({vertex, vertex + 1, vertex + 2});
    };
    for (std::uint32_t k = 0; k < 5; ++k) {
        const std::uint32_t low = 1 + k, next_low = 1 + (k + 1) % 5, high = 6 + k,
                            next_high = 6 + (k + 1) % 5;
        add(0, low, next_low);
        add(low, high, next_low);
        add(high, next_high, next_low);
        add(high, 11, next_high);
    }
    return mesh;
}

Mesh surface_of(const HeightField& field) {
    Mesh mesh;
    for (std::uint32_t row = 0; row < field.rows; ++row)
        for (std::uint32_t column = 0; column < field.columns; ++column)
            mesh.positions.push_back({static_cast<float>(column) * field.spacing,
                                      field.heights[row * field.columns + column],
                                      static_cast<float>(row) * field.spacing});
    for (std::uint32_t row = 0; row + 1 < field.rows; ++row)
        for (std::uint32_t column = 0; column + 1 < field.columns; ++column) {
            const std::uint32_t here = row * field.columns + column, below = here + field.columns;
            mesh.triangles.push_back({here, below, below + 1});
            mesh.triangles.push_back({here, below + 1, here + 1});
        }
    return mesh;
}

std::vector<Vec4> vertex_normals(const Mesh& mesh) {
    std::vector<Vector3> sums(mesh.positions.size(), Vector3::Zero());
    for (const Triangle& triangle : mesh.triangles) {
        const Vector3 a = to_vector(mesh.positions[triangle[0]]);
        const Vector3 area =
            (to_vector(mesh.positions[triangle[1]]) - a).cross(to_vector(mesh.positions[triangle[2]]) - a);
        for (const std::uint32_t vertex : triangle) sums[vertex] += area;
    }
    std::vector<Vec4> normals;
    for (const Vector3& sum : sums) {
        const Vector3 normal = sum.normalized();
        normals.push_back({normal.x(), normal.y(), normal.z(), 0});
    }
    return normals;
}

namespace {

constexpr Vec3 wood{0.30f, 0.19f, 0.10f}, skin{0.62f, 0.38f, 0.26f}, iron{0.12f, 0.13f, 0.15f};
constexpr float thick = 0.012f;  // radius of rods and posts [m]

}  // namespace

void draw_holder(const ClothView& cloth, std::span<const std::uint32_t> vertices, Holder holder,
                 Annotation& to) {
    if (holder == Holder::rod) {
        if (!is_pinned(cloth, vertices.front())) return;
        const Vector3 a = vertex_position(cloth, vertices.front()),
                      b = vertex_position(cloth, vertices.back());
        const Vector3 beyond = 0.04f * (b - a).normalized();
        to.capsules.push_back({to_vec3(a - beyond), to_vec3(b + beyond), thick, wood});
        return;
    }
    for (const std::uint32_t vertex : vertices) {
        if (!is_pinned(cloth, vertex)) continue;
        const Vec3 at = to_vec3(vertex_position(cloth, vertex));
        if (holder == Holder::hands)
            to.spheres.push_back({at, 1.5f * thick, skin});
        else
            to.capsules.push_back({{at.x, 0, at.z}, {at.x, at.y + 2 * thick, at.z}, thick, wood});
    }
}

void draw_grate(float height, Annotation& to) {
    constexpr float long_half = 0.5f, short_half = 0.4f;
    constexpr int bars = 5;
    const float y = height + thick;
    for (int k = 0; k < bars; ++k) {
        const float part = 2 * static_cast<float>(k) / (bars - 1) - 1;
        const float x = part * long_half, z = part * short_half;
        to.capsules.push_back({{x, y, -short_half}, {x, y, short_half}, thick, iron});
        to.capsules.push_back({{-long_half, y, z}, {long_half, y, z}, thick, iron});
    }
}

}  // namespace weft::demo
