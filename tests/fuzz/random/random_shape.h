#pragma once
// Shapes that a World is to hold: meshes, open and closed, hulls, ground, distance fields, and broken ones.

#include <array>
#include <vector>

#include "tests/fuzz/random/random.h"

namespace weft::fuzz {

/// A shape that owns what its spans show.
struct OwnedShape {
    enum class Kind { mesh, hull, ground, distances };
    Kind kind = Kind::mesh;
    std::vector<Vec3> vertices;
    std::vector<std::array<std::uint32_t, 3>> triangles;
    bool closed = true;
    std::uint32_t rows = 0, columns = 0;
    std::vector<float> heights;
    float size = 0.1f;  ///< of ground's and of distances' cells [m]

    [[nodiscard]] Shape shape() const;
};

/// At most some 300 triangles, within a metre.
[[nodiscard]] Drawn<OwnedShape> random_shape(Random& random);
/// Of as many vertices, somewhat elsewhere: or not as many, or nowhere.
[[nodiscard]] Drawn<std::vector<Vec3>> random_deformation(Random& random, const OwnedShape& shape);

}  // namespace weft::fuzz
