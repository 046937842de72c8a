#pragma once
// The bond of a drawn vertex to a triangle of cloth.

#include <array>
#include <cstdint>

#include "engine/vector.h"
#include "weft/drawn_mesh.h"

namespace weft {

/// A drawn vertex's place on the cloth. A bond fills one cache line.
struct alignas(64) DrawnBond {
    std::array<std::uint32_t, 3> particles{};
    float second = 0, third = 0;     // barycentric coordinates of the last two particles
    std::array<float, 3> offset{};   // from the rounded surface, in the triangle's frame [m]
    std::array<float, 3> normal{};   // in that frame, of unit length
    std::array<float, 2> tangent{};  // multiples of the triangle's sides from its first corner
    float handedness = 1;
    float unused = 0;
};
static_assert(sizeof(DrawnBond) == 64);

/// A point on the rounded surface, and axes there: along the triangle's first side, across, and out.
struct SurfacePoint {
    Vector3 position;
    Matrix3 frame;
    Vector3 first_side, second_side;  // of the triangle, from its first corner
};
[[nodiscard]] SurfacePoint surface_point(const ClothView& cloth,
                                         const std::array<std::uint32_t, 3>& particles, float second,
                                         float third, float rounding);

}  // namespace weft
