#pragma once
// Known answers beside which the bench shows cloth: Cusick's drape test, and the heavy elastica.

#include <cstdint>
#include <vector>

#include "weft/types.h"
#include "weft/weft.h"

namespace weft::demo {

/// A level disc round `middle`, with its pattern round the origin; ring k of `rings` has 6 k particles.
/// Heights are scattered by 0.2 mm, so that no place is preferred for a fold.
[[nodiscard]] Mesh drape_disc(float radius, std::uint32_t rings, const Vec3& middle);

/// Area of the shadow straight below, counted in squares of a millimetre [m^2].
[[nodiscard]] float shadow_area(const Mesh& mesh, const ClothView& view);

/// Share of the ring beyond the table that the shadow covers: 1 for a board, 0 for cloth that hangs straight.
[[nodiscard]] float drape_coefficient(float shadow, float table_radius, float disc_radius);

/// The heavy elastica (Euler 1744): theta'' = -gamma (1 - s) cos theta, theta(0) = 0, theta'(1) = 0, where
/// gamma = areal density * gravity * length^3 / flexural rigidity, 0 to 100. Returns `points` (at least 2)
/// evenly spaced points from clamp to free end, in lengths of the strip: x out, y up.
[[nodiscard]] std::vector<Vec2> elastica_curve(double gamma, int points);

}  // namespace weft::demo
