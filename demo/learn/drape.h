#pragma once
// Cusick's drape test (1965): a disc of cloth over a smaller round table.

#include <cstdint>

#include "weft/weft.h"

namespace weft::demo {

/// A level disc round `middle`, with its pattern round the origin; ring k of `rings` has 6 k particles.
/// Heights are scattered by 0.2 mm, so that no place is preferred for a fold.
[[nodiscard]] Mesh drape_disc(float radius, std::uint32_t rings, const Vec3& middle);

/// Area of the shadow straight below, counted in squares of a millimetre [m^2].
[[nodiscard]] float shadow_area(const Mesh& mesh, const ClothView& view);

/// Share of the ring beyond the table that the shadow covers: 1 for a board, 0 for cloth that hangs straight.
[[nodiscard]] float drape_coefficient(float shadow, float table_radius, float disc_radius);

}  // namespace weft::demo
