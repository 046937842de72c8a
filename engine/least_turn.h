#pragma once
// The least rotation that takes one direction to another.

#include "engine/vector.h"

namespace weft {

/// Precondition: neither vector is zero. Lengths do not matter. Opposite directions turn about an axis across
/// both. Eigen's FromTwoVectors finds that axis by a singular value decomposition, which alone takes 4 s to
/// compile.
[[nodiscard]] Eigen::Quaternionf least_turn(const Vector3& from, const Vector3& to);

}  // namespace weft
