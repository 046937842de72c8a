#pragma once
// Contact between features in double precision, every pair by itself; and meshes to try it on.

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <deque>
#include <Eigen/Geometry>
#include <limits>
#include <random>
#include <span>
#include <vector>

#include "collision/contact/pairs/pair_finder.h"
#include "weft/types.h"

namespace weft::test {

using Vector3d = Eigen::Vector3d;
using Triangle = ContactMesh::Triangle;

inline constexpr std::size_t room_for_pairs = 1 << 18;  // of a list, unless a test says otherwise

inline Vector3d in_double(const Vec4& v) {
    return {v.x, v.y, v.z};
}

/// From the closest point of B to that of A.
inline Vector3d closest_on_segment(const Vector3d& p, const Vector3d& a, const Vector3d& b) {
    const Vector3d ab = b - a;
    const double length2 = ab.squaredNorm();
    const double t = length2 > 0 ? std::clamp((p - a).dot(ab) / length2, 0.0, 1.0) : 0.0;
    return p - a - t * ab;
}

inline Vector3d gap_of_vertex_and_triangle(const std::array<Vector3d, 4>& x) {
    Vector3d best = closest_on_segment(x[0], x[1], x[2]);
    for (const auto& [a, b] : {std::pair(2, 3), std::pair(3, 1)}) {
        const Vector3d other = closest_on_segment(x[0], x[std::size_t(a)], x[std::size_t(b)]);
        if (other.squaredNorm() < best.squaredNorm()) best = other;
    }
    const Vector3d normal = (x[2] - x[1]).cross(x[3] - x[1]);
    const Vector3d a = x[1] - x[0], b = x[2] - x[0], c = x[3] - x[0];
    const double least = std::min({normal.dot(b.cross(c)), normal.dot(c.cross(a)), normal.dot(a.cross(b))});
    if (least > 0) return -normal.dot(a) / normal.squaredNorm() * normal;
    return best;
}

inline Vector3d gap_of_edges(const std::array<Vector3d, 4>& x) {
    Vector3d best = closest_on_segment(x[0], x[2], x[3]);
    const auto take = [&](const Vector3d& other) {
        if (other.squaredNorm() < best.squaredNorm()) best = other;
    };
    take(closest_on_segment(x[1], x[2], x[3]));
    take(-closest_on_segment(x[2], x[0], x[1]));
    take(-closest_on_segment(x[3], x[0], x[1]));
    const Vector3d p = x[1] - x[0], q = x[3] - x[2], r = x[2] - x[0], across = p.cross(q);
    const double across2 = across.squaredNorm();
    if (across2 > 1e-20 * p.squaredNorm() * q.squaredNorm()) {
        const double s = r.cross(q).dot(across) / across2, t = r.cross(p).dot(across) / across2;
        if (s > 0 && s < 1 && t > 0 && t < 1) return -across.dot(r) / across2 * across;
    }
    return best;
}

/// The pair's distance, and what PairFinder::find lists it by. `box_gap`: between boxes over the motion.
struct ReferencePair {
    double distance, swept_gap, box_gap;
};

/// min over A - max over B of n . x, where the whole motion begins and where it ends.
struct EndGaps {
    double start, end;

    EndGaps(const Vector3d& n, const std::array<std::uint32_t, 4>& corners, std::size_t of_a,
            std::span<const Vec4> positions, std::span<const Vec4> motions) {
        const auto gap = [&](double part) {
            constexpr double infinity = std::numeric_limits<double>::infinity();
            double least_a = infinity, most_b = -infinity;
            for (std::size_t k = 0; k < 4; ++k) {
                const double along =
                    n.dot(in_double(positions[corners[k]]) + part * in_double(motions[corners[k]]));
                if (k < of_a)
                    least_a = std::min(least_a, along);
                else
                    most_b = std::max(most_b, along);
            }
            return least_a - most_b;
        };
        start = gap(0);
        end = gap(1);
    }
    [[nodiscard]] double least() const { return std::min(start, end); }
};

inline ReferencePair reference_pair(const std::array<std::uint32_t, 4>& corners, std::size_t of_a,
                                    std::span<const Vec4> positions, std::span<const Vec4> motions) {
    std::array<Vector3d, 4> x, m;
    for (std::size_t k = 0; k < 4; ++k) {
        x[k] = in_double(positions[corners[k]]);
        m[k] = in_double(motions[corners[k]]);
    }
    const Vector3d gap = of_a == 1 ? gap_of_vertex_and_triangle(x) : gap_of_edges(x);
    const Vector3d n = gap.norm() > 0 ? Vector3d(gap.normalized()) : Vector3d(0, 0, 0);
    constexpr double infinity = std::numeric_limits<double>::infinity();
    double least_a = infinity, most_b = -infinity;
    Eigen::Array3d lower[2], upper[2];
    for (std::size_t side = 0; side < 2; ++side) {
        lower[side].setConstant(infinity);
        upper[side].setConstant(-infinity);
    }
    for (std::size_t k = 0; k < 4; ++k) {
        const std::size_t side = k < of_a ? 0 : 1;
        for (const Vector3d& p : {x[k], Vector3d(x[k] + m[k])}) {
            lower[side] = lower[side].min(p.array());
            upper[side] = upper[side].max(p.array());
            const double along = n.dot(p - x[0]);
            if (side == 0)
                least_a = std::min(least_a, along);
            else
                most_b = std::max(most_b, along);
        }
    }
    const double box_gap = std::max((lower[0] - upper[1]).maxCoeff(), (lower[1] - upper[0]).maxCoeff());
    return {gap.norm(), least_a - most_b, box_gap};
}

/// rows x columns vertices, each cell cut along either diagonal in turn.
inline std::vector<Triangle> grid_triangles(std::uint32_t rows, std::uint32_t columns,
                                            std::uint32_t first = 0) {
    std::vector<Triangle> triangles;
    for (std::uint32_t r = 0; r + 1 < rows; ++r) {
        for (std::uint32_t c = 0; c + 1 < columns; ++c) {
            const std::uint32_t a = first + r * columns + c, b = a + 1, d = a + columns, e = d + 1;
            if ((r + c) % 2 == 0) {
                triangles.push_back({a, d, b});
                triangles.push_back({b, d, e});
            } else {
                triangles.push_back({a, d, e});
                triangles.push_back({a, e, b});
            }
        }
    }
    return triangles;
}

/// shape(u, v) for the vertices of a grid, u and v in edges.
template <class Shape>
std::vector<Vec4> grid_positions(std::uint32_t rows, std::uint32_t columns, const Shape& shape) {
    std::vector<Vec4> positions;
    for (std::uint32_t r = 0; r < rows; ++r)
        for (std::uint32_t c = 0; c < columns; ++c)
            positions.push_back(shape(static_cast<float>(c), static_cast<float>(r)));
    return positions;
}

inline std::vector<Vec4> random_vectors(std::size_t count, float size, std::uint32_t seed) {
    std::mt19937 random(seed);
    std::uniform_real_distribution<float> uniform(-size, size);
    std::vector<Vec4> vectors(count);
    for (Vec4& v : vectors) v = {uniform(random), uniform(random), uniform(random), 0};
    return vectors;
}

/// Meshes, their bodies, and where all is.
struct ContactScene {
    std::deque<ContactMesh> meshes;  // bodies point into it
    std::vector<ContactBody> bodies;
    std::vector<Vec4> positions, motions;

    ContactBody& add(const std::vector<Vec4>& rest, const std::vector<Vec4>& now,
                     const std::vector<Triangle>& triangles, float reach) {
        meshes.emplace_back(rest, triangles);
        bodies.push_back({.mesh = &meshes.back(), .first = std::uint32_t(positions.size()), .reach = reach});
        positions.insert(positions.end(), now.begin(), now.end());
        motions.resize(positions.size());
        return bodies.back();
    }
    void add_motions(const std::vector<Vec4>& more) {
        for (std::size_t i = 0; i < motions.size(); ++i) {
            motions[i].x += more[i].x;
            motions[i].y += more[i].y;
            motions[i].z += more[i].z;
        }
    }
    void jitter(float size, std::uint32_t seed = 1) {
        const std::vector<Vec4> by = random_vectors(positions.size(), size, seed);
        for (std::size_t i = 0; i < by.size(); ++i) {
            positions[i].x += by[i].x;
            positions[i].y += by[i].y;
            positions[i].z += by[i].z;
        }
    }
};

inline bool meet(const ContactBody& a, const ContactBody& b) {
    return &a == &b ? a.meets_itself : (a.mask & b.layer) != 0 && (b.mask & a.layer) != 0;
}

/// A sheet laid to and fro along u: legs of so many edges, layers `gap` apart, half circles between.
inline Vec4 zigzag(float u, float v, float leg, float gap) {
    const float bend = 1.57079633f * gap;
    const float period = leg + bend;
    const float index = std::floor(u / period);
    const float along = u - index * period;
    float x = along, y = gap * index;
    if (along > leg) {
        const float angle = (along - leg) / bend * 3.14159265f;
        x = leg + 0.5f * gap * std::sin(angle);
        y += 0.5f * gap * (1 - std::cos(angle));
    }
    if (static_cast<int>(index) % 2 != 0) x = leg - x;
    return {x, y, v, 0};
}

}  // namespace weft::test
