#pragma once
// Cusick's drape test (1965): a disc of cloth over a smaller round table.

#include <cstdint>

#include "weft/weft.h"

namespace weft::demo {

/// A disc about the pattern's origin, of `rings` rings of which ring k has 6 k particles, at `height`, flat
/// but for a fifth of a millimetre, so that it has no reason to fold at one place rather than at another.
[[nodiscard]] Mesh drape_disc(float radius, std::uint32_t rings, const Vec3& middle);

/// Of the shadow straight below, by squares of a millimetre [m^2].
[[nodiscard]] float shadow_area(const Mesh& mesh, const ClothView& view);

/// The part of the ring beyond the table that still shades the floor: 1 a board, 0 a cloth that hangs
/// straight.
[[nodiscard]] float drape_coefficient(float shadow, float table_radius, float disc_radius);

}  // namespace weft::demo
