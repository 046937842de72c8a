#pragma once
// Closed meshes of known shape, and how far points are from triangles, in double precision.

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <numbers>
#include <vector>

#include <Eigen/Geometry>

#include "engine/vector.h"
#include "weft/shapes.h"

namespace weft::test {

struct Solid {
    std::vector<Vec3> vertices;
    std::vector<std::array<std::uint32_t, 3>> triangles;
    [[nodiscard]] TriangleMesh mesh(bool closed = true) const { return {vertices, triangles, closed}; }
};

/// About y.
inline Solid torus(float radius, float tube, std::uint32_t around, std::uint32_t across) {
    Solid made;
    const auto angle = [](std::uint32_t k, std::uint32_t n) {
        return 2 * std::numbers::pi_v<float> * static_cast<float>(k) / static_cast<float>(n);
    };
    for (std::uint32_t i = 0; i < around; ++i)
        for (std::uint32_t j = 0; j < across; ++j) {
            const float u = angle(i, around), v = angle(j, across), r = radius + tube * std::cos(v);
            made.vertices.push_back({r * std::cos(u), tube * std::sin(v), r * std::sin(u)});
            const auto at = [&](std::uint32_t a, std::uint32_t b) {
                return (a % around) * across + b % across;
            };
            made.triangles.push_back({at(i, j), at(i, j + 1), at(i + 1, j)});
            made.triangles.push_back({at(i + 1, j), at(i, j + 1), at(i + 1, j + 1)});
        }
    return made;
}

inline Solid box_mesh(const Vec3& half) {
    Solid made;
    for (int k = 0; k < 8; ++k)
        made.vertices.push_back({(k & 1) != 0 ? half.x : -half.x, (k & 2) != 0 ? half.y : -half.y,
                                 (k & 4) != 0 ? half.z : -half.z});
    made.triangles = {{0, 4, 6}, {0, 6, 2}, {1, 3, 7}, {1, 7, 5}, {0, 1, 5}, {0, 5, 4},
                      {2, 6, 7}, {2, 7, 3}, {0, 2, 3}, {0, 3, 1}, {4, 5, 7}, {4, 7, 6}};
    return made;
}

/// Ericson 2004, 5.1.5.
inline double distance_to_triangle(const Eigen::Vector3d& p, const Eigen::Vector3d& a,
                                   const Eigen::Vector3d& b, const Eigen::Vector3d& c) {
    using V = Eigen::Vector3d;
    const auto to_edge = [&](const V& u, const V& v) {
        const double t = std::clamp((p - u).dot(v - u) / (v - u).squaredNorm(), 0.0, 1.0);
        return (p - u - t * (v - u)).norm();
    };
    const V n = (b - a).cross(c - a);
    const bool is_over = n.dot((b - a).cross(p - a)) >= 0 && n.dot((c - b).cross(p - b)) >= 0 &&
                         n.dot((a - c).cross(p - c)) >= 0;
    if (is_over) return std::abs(n.normalized().dot(p - a));
    return std::min({to_edge(a, b), to_edge(b, c), to_edge(c, a)});
}

/// Below 0 inside, which is where triangles fill the whole sphere of directions (van Oosterom, Strackee
/// 1983).
inline double distance_to(const Solid& solid, const Vector3& point) {
    using V = Eigen::Vector3d;
    const V p = point.cast<double>();
    double least = std::numeric_limits<double>::infinity(), solid_angle = 0;
    for (const auto& t : solid.triangles) {
        const V a = to_vector(solid.vertices[t[0]]).cast<double>(),
                b = to_vector(solid.vertices[t[1]]).cast<double>(),
                c = to_vector(solid.vertices[t[2]]).cast<double>();
        least = std::min(least, distance_to_triangle(p, a, b, c));
        const V u = a - p, v = b - p, w = c - p;
        solid_angle +=
            2 * std::atan2(u.dot(v.cross(w)), u.norm() * v.norm() * w.norm() + u.dot(v) * w.norm() +
                                                  v.dot(w) * u.norm() + w.dot(u) * v.norm());
    }
    return std::abs(solid_angle) > 2 * std::numbers::pi ? -least : least;
}

}  // namespace weft::test
