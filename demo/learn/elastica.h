#pragma once
// The exact shape of a strip that is clamped level and hangs by its weight.

#include <vector>

#include "weft/types.h"

namespace weft::demo {

/// The heavy elastica (Euler 1744): theta'' = -gamma (1 - s) cos theta, theta(0) = 0, theta'(1) = 0, where
/// gamma = areal density * gravity * length^3 / flexural rigidity, 0 to 100. Returns `points` (at least 2)
/// evenly spaced points from clamp to free end, in lengths of the strip: x out, y up.
[[nodiscard]] std::vector<Vec2> elastica_curve(double gamma, int points);

}  // namespace weft::demo
