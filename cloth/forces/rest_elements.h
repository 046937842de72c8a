#pragma once
// The rest shape as finite elements see it: triangles in the pattern's axes, and pairs of them that share an
// edge.

#include <array>
#include <cstdint>
#include <vector>

#include "cloth/cook.h"
#include "engine/vector.h"

namespace weft {

/// Sides of a triangle from its corner 0 to corners 1 and 2, in the pattern's axes [m].
struct RestSides {
    Eigen::Vector2f to1, to2;
};

/// In the panel's own axes for a mesh with a pattern. Else the mesh is the rest shape, and warp runs along
/// the rows of a grid, or upwards in a general mesh, where triangles that lie flat take +X for it.
[[nodiscard]] RestSides rest_sides(const CookedCloth& model, std::uint32_t triangle);

/// Two triangles about their shared edge: (0, 1, 2) and (1, 0, 3), in the order in which the first is wound.
struct Hinge {
    std::array<std::uint32_t, 4> particles;
    /// Bergou et al. 2006: |sum_k q_k x_k| is the edge's length times its angle, while that is small. From
    /// each triangle's own panel, so sum_k q_k is 0.
    std::array<float, 4> q;
    float area;    ///< of both triangles [m^2]
    float length;  ///< of the edge, mean of both panels' [m]
    float angle;   ///< at rest; 0 on a flat pattern
};

/// In ascending order of their edges.
[[nodiscard]] std::vector<Hinge> hinges(const CookedCloth& model);

}  // namespace weft
