#pragma once
// The side of a plane on which a point is. The sign is exact for any four points of floats.

#include "weft/types.h"

namespace weft::study {

/// The sign, -1, 0 or 1, of det(a - d, b - d, c - d), six times the signed volume of the four.
[[nodiscard]] int orientation(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d);

/// The same sign without the floating-point filter that decides nearly all cases; for tests.
[[nodiscard]] int exact_orientation(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d);

}  // namespace weft::study
