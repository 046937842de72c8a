#pragma once
// Orientation predicates: exact signs of volumes and areas.

#include "weft/types.h"

namespace weft {

/// Sign of the signed volume of tetrahedron (a, b, c, d), det(b - a, c - a, d - a): 1, -1, or 0 where the
/// four lie in one plane. Exact for every finite input, so that all triangles beside an edge agree about a
/// line that passes it. x, y and z are read; w is ignored.
[[nodiscard]] int volume_sign(const Vec4& a, const Vec4& b, const Vec4& c, const Vec4& d) noexcept;

/// Sign of the signed area of triangle (a, b, c) as seen along `normal`, det(normal, b - a, c - a): 1 where
/// it is counter-clockwise, -1 where clockwise, 0 where the three project onto one line. Exact for every
/// finite input. `normal` need not have length 1.
[[nodiscard]] int area_sign(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& normal) noexcept;

}  // namespace weft
