#pragma once
// The triangles of all cloths of a World together, for the search for crossings.

#include <cstdint>
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

}  // namespace weft::study
