#pragma once
// The orientation predicate of four points.

#include "weft/types.h"

namespace weft {

/// Sign of the signed volume of tetrahedron (a, b, c, d), det(b - a, c - a, d - a): 1, -1, or 0 where the
/// four lie in one plane. Exact for every finite input, so that all triangles beside an edge agree about a
/// line that passes it. x, y and z are read; w is ignored.
[[nodiscard]] int volume_sign(const Vec4& a, const Vec4& b, const Vec4& c, const Vec4& d) noexcept;

}  // namespace weft
