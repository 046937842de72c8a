#pragma once
// The triangles of all cloths of a World together, as what judges contact sees them.

#include <cstdint>
#include <vector>

#include "weft/mesh.h"
#include "weft/world.h"

namespace weft::study {

struct TriangleSoup {
    std::vector<Vec3> points;           ///< [m]
    std::vector<Triangle> triangles;    ///< of points; those that share one of these share a vertex
    std::vector<std::uint32_t> bodies;  ///< of each triangle, the cloth that it is of, from 0 on

    /// Appends a cloth's particles and triangles, as one body more.
    void add(const ClothView& cloth);
    void add_body(const std::vector<Vec3>& points, const std::vector<Triangle>& triangles);
    [[nodiscard]] bool share_a_vertex(std::uint32_t first, std::uint32_t second) const;
    [[nodiscard]] bool finite() const;
};

}  // namespace weft::study
