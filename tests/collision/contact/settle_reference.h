#pragma once
// What contact is measured against: every pair of features, by brute force and in double.

#include <algorithm>
#include <array>
#include <cmath>
#include <Eigen/Core>
#include <Eigen/Geometry>
#include <random>
#include <set>
#include <vector>

#include "collision/contact/pairs/pairs.h"
#include "engine/vector.h"
#include "tests/collision/contact/contact_reference.h"
#include "tests/collision/contact/cuts.h"
#include "tests/laid_out.h"

namespace weft::test {

using Point = Eigen::Vector3d;
using Points = std::vector<Point>;
using Rows = std::vector<Vec4>;

struct Triangles {
    Rows positions;  // w = inverse mass
    std::vector<std::array<std::uint32_t, 3>> triangles;

    std::uint32_t size() const { return static_cast<std::uint32_t>(positions.size()); }
    std::vector<std::array<std::uint32_t, 2>> edges() const {
        std::set<std::array<std::uint32_t, 2>> all;
        for (const auto& t : triangles) {
            for (std::size_t i = 0; i < 3; ++i) {
                all.insert({std::min(t[i], t[(i + 1) % 3]), std::max(t[i], t[(i + 1) % 3])});
            }
        }
        return {all.begin(), all.end()};
    }
};

inline Point point(const Vec4& v) {
    return xyz(v).cast<double>();
}
inline Points points(const Rows& rows) {
    Points all;
    for (const Vec4& v : rows) all.push_back(point(v));
    return all;
}

/// The least of |sum of w_i p_i| with corner 0's weights fixed: closest point of a triangle to p.
inline Point closest_weights(const Point& p, const Point& a, const Point& b, const Point& c) {
    const auto on_segment = [&](const Point& u, const Point& v) {
        const double square = (v - u).squaredNorm();
        return square > 0 ? std::clamp((p - u).dot(v - u) / square, 0.0, 1.0) : 0.0;
    };
    const double ab = on_segment(a, b), bc = on_segment(b, c), ca = on_segment(c, a);
    Point best(1 - ab, ab, 0);
    const auto distance = [&](const Point& w) { return (p - w[0] * a - w[1] * b - w[2] * c).norm(); };
    for (const Point& w : {Point(0, 1 - bc, bc), Point(ca, 0, 1 - ca)}) {
        if (distance(w) < distance(best)) best = w;
    }
    const Point normal = (b - a).cross(c - a);
    const double square = normal.squaredNorm();
    if (square > 0) {
        const Point inside((b - p).cross(c - p).dot(normal) / square,
                           (c - p).cross(a - p).dot(normal) / square,
                           (a - p).cross(b - p).dot(normal) / square);
        if (inside.minCoeff() >= 0 && distance(inside) < distance(best)) best = inside;
    }
    return best;
}

/// Parameters (s, t) of the closest points a + s (b - a) and c + t (d - c).
inline std::array<double, 2> closest_parameters(const Point& a, const Point& b, const Point& c,
                                                const Point& d) {
    const auto on_segment = [](const Point& p, const Point& u, const Point& v) {
        return std::clamp((p - u).dot(v - u) / (v - u).squaredNorm(), 0.0, 1.0);
    };
    const auto distance = [&](const std::array<double, 2>& st) {
        return (a + st[0] * (b - a) - c - st[1] * (d - c)).norm();
    };
    std::array<double, 2> best{0, on_segment(a, c, d)};
    for (const std::array<double, 2>& st : {std::array<double, 2>{1, on_segment(b, c, d)},
                                            {on_segment(c, a, b), 0},
                                            {on_segment(d, a, b), 1}}) {
        if (distance(st) < distance(best)) best = st;
    }
    const Point u = b - a, v = d - c, w = a - c;
    const double uu = u.dot(u), uv = u.dot(v), vv = v.dot(v), determinant = uu * vv - uv * uv;
    if (determinant > 1e-12 * uu * vv) {
        const double s = (uv * v.dot(w) - vv * u.dot(w)) / determinant;
        const double t = (uu * v.dot(w) - uv * u.dot(w)) / determinant;
        if (s >= 0 && s <= 1 && t >= 0 && t <= 1 && distance({s, t}) < distance(best)) best = {s, t};
    }
    return best;
}

inline void set_shape(const Rows& positions, const FeaturePair& pair, std::uint32_t corners_of_a,
                      const std::array<double, 4>& weights, PairShape& shape) {
    const Point origin = point(positions[pair.corners[0]]);
    Point gap = Point::Zero();
    for (std::size_t i = 0; i < 4; ++i) gap += weights[i] * (point(positions[pair.corners[i]]) - origin);
    const Point normal = gap.norm() > 0 ? gap.normalized() : Point(0, 1, 0);
    double a = 1e30, b = -1e30;
    for (std::uint32_t i = 0; i < 4; ++i) {
        const double value = normal.dot(point(positions[pair.corners[i]]) - origin);
        if (i < corners_of_a) a = std::min(a, value);
        if (i >= corners_of_a) b = std::max(b, value);
    }
    shape.weights = {static_cast<float>(weights[0]), static_cast<float>(weights[1]),
                     static_cast<float>(weights[2]), static_cast<float>(weights[3])};
    shape.normal = to_vec4(normal.cast<float>(), static_cast<float>(a - b));
}

/// All pairs of vertex and triangle, then of edges, that share no vertex, however far.
inline LaidOut<PairList> all_pairs(const Triangles& mesh) {
    std::vector<FeaturePair> found;
    const auto& x = mesh.positions;
    for (std::uint32_t v = 0; v < mesh.size(); ++v) {
        for (const auto& [a, b, c] : mesh.triangles) {
            if (v != a && v != b && v != c) found.push_back({{v, a, b, c}});
        }
    }
    const std::size_t vertex_triangle = found.size();
    const auto edges = mesh.edges();
    for (const auto& [a, b] : edges) {
        for (const auto& [c, d] : edges) {
            if (a < c && b != c && b != d && a != d) found.push_back({{a, b, c, d}});
        }
    }
    LaidOut<PairList> list(found.size());
    list.size = static_cast<std::uint32_t>(found.size());
    list.vertex_triangle = static_cast<std::uint32_t>(vertex_triangle);
    for (std::uint32_t k = 0; k < list.size; ++k) {
        const auto& [a, b, c, d] = found[k].corners;
        std::array<double, 4> weights;
        if (k < vertex_triangle) {
            const Point w = closest_weights(point(x[a]), point(x[b]), point(x[c]), point(x[d]));
            weights = {1, -w[0], -w[1], -w[2]};
        } else {
            const auto [s, t] = closest_parameters(point(x[a]), point(x[b]), point(x[c]), point(x[d]));
            weights = {1 - s, s, t - 1, -t};
        }
        list.pairs[k] = found[k];
        set_shape(x, found[k], list.corners_of_a(k), weights, list.shapes[k]);
    }
    return list;
}

/// Edges through triangles with which they share no vertex.
inline int crossings(const Triangles& mesh, const Points& x) {
    int count = 0;
    for (const auto& [p, q] : mesh.edges()) {
        for (const auto& [a, b, c] : mesh.triangles) {
            if (p == a || p == b || p == c || q == a || q == b || q == c) continue;
            count += cuts(x[p], x[q], x[a], x[b], x[c]) ? 1 : 0;
        }
    }
    return count;
}

inline Rows ends_of(const Rows& positions, const Rows& displacements) {
    Rows ends = positions;
    for (std::size_t i = 0; i < ends.size(); ++i) {
        set_xyz(ends[i], xyz(positions[i]) + xyz(displacements[i]));
    }
    return ends;
}

/// Triangles of about `size` at random places of a cube of side 1, none of which cuts another.
inline Triangles triangle_soup(std::uint32_t triangles, float size, unsigned seed) {
    std::mt19937 random(seed);
    std::uniform_real_distribution<float> uniform(-0.5f, 0.5f);
    Triangles mesh;
    while (mesh.triangles.size() < triangles) {
        Triangles grown = mesh;
        const Vector3 centre(uniform(random), uniform(random), uniform(random));
        for (int i = 0; i < 3; ++i) {
            const Vector3 corner = centre + size * Vector3(uniform(random), uniform(random), uniform(random));
            grown.positions.push_back(to_vec4(corner, 1 + uniform(random)));
        }
        grown.triangles.push_back({mesh.size(), mesh.size() + 1, mesh.size() + 2});
        if (crossings(grown, points(grown.positions)) == 0) mesh = grown;
    }
    return mesh;
}

/// A strip folded to and fro in legs of `leg` cells, layers `apart`, slightly wavy.
inline Triangles folded_packet(std::uint32_t width, std::uint32_t length, std::uint32_t leg, float edge,
                               float apart) {
    Triangles mesh;
    for (std::uint32_t row = 0; row <= length; ++row) {
        const std::uint32_t layer = row / leg, along = layer % 2 == 0 ? row % leg : leg - 1 - row % leg;
        for (std::uint32_t i = 0; i <= width; ++i) {
            const float x = edge * static_cast<float>(i), z = edge * static_cast<float>(along);
            const float wave = 0.1f * apart * std::sin(20 * x + 13 * z);
            mesh.positions.push_back({x, apart * static_cast<float>(layer) + wave, z, 1});
        }
    }
    for (std::uint32_t row = 0; row < length; ++row) {
        for (std::uint32_t i = 0; i < width; ++i) {
            const std::uint32_t a = row * (width + 1) + i, b = a + width + 1;
            mesh.triangles.push_back({a, b, a + 1});
            mesh.triangles.push_back({a + 1, b, b + 1});
        }
    }
    return mesh;
}

}  // namespace weft::test
