#pragma once
// Limits of the size of a mesh.

#include <cstddef>

namespace weft {

/// Half-edge lists are indexed by 32 bits; at up to twelve half-edges a triangle these bounds keep within
/// them.
inline constexpr std::size_t most_vertices = std::size_t{1} << 26;
inline constexpr std::size_t most_triangles = std::size_t{1} << 27;

/// The most triangles at one particle: the data that a solver prepares grows with the square of their number.
inline constexpr std::size_t most_triangles_at_particle = 1024;

/// The least rest area of a triangle [m^2], the square of a tenth of a micrometre. With the least density its
/// particles weigh 1e-19 kg, whose inverse a float holds with room for its square.
inline constexpr double least_area = 1e-14;

/// Least height of a triangle over its longest edge. The area of a lower one may be rounding of coordinates.
inline constexpr double least_relative_height = 1e-6;

}  // namespace weft
