#pragma once
// The triangles of all cloths of a World, and the search for those that cross.

#include <cstdint>
#include <utility>
#include <vector>

#include "weft/mesh.h"
#include "weft/world.h"

namespace weft::study {

struct TriangleSoup {
    std::vector<Vec3> points;           ///< [m]
    std::vector<Triangle> triangles;    ///< indices of points; triangles with a common index share a vertex
    std::vector<std::uint32_t> bodies;  ///< cloth of each triangle, from 0 on

    /// Appends a cloth's particles and triangles as one more body.
    void add(const ClothView& cloth);
    void add_body(const std::vector<Vec3>& points, const std::vector<Triangle>& triangles);
    [[nodiscard]] bool share_a_vertex(std::uint32_t first, std::uint32_t second) const;
    [[nodiscard]] bool finite() const;
};

/// The test of two triangles. It judges contact, and so shares nothing with it.
///
/// Two triangles that share no vertex cross if each has corners strictly on both sides of the other's plane,
/// and their interiors, without edges and corners, have a point in common. So touching is no crossing: a
/// corner in a plane, an edge on an edge, triangles in one plane, faces that coincide. All decisions are
/// signs of volumes, which are exact for floats, degenerate cases included.
[[nodiscard]] bool triangles_cross(const TriangleSoup& soup, std::uint32_t first, std::uint32_t second);

/// The pairs that cross, the smaller index first, in ascending order. Positions have to be finite.
[[nodiscard]] std::vector<std::pair<std::uint32_t, std::uint32_t>> crossing_pairs(const TriangleSoup& soup);

struct CrossingCount {
    std::uint64_t all = 0;
    std::uint64_t between_bodies = 0;  ///< of these, those whose triangles are of different bodies
};
[[nodiscard]] CrossingCount count_crossings(const TriangleSoup& soup);

/// Distance of the closest two triangles that share no vertex [m], or `bound` if none are closer: in double
/// precision. In flat cloth of square cells that is 0.7 of an edge. 0 for triangles that cross.
[[nodiscard]] double least_gap(const TriangleSoup& soup, double bound);

}  // namespace weft::study
