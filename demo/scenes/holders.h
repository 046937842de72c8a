#pragma once
// What holds cloth, as it is drawn: it takes no part in the simulation.

#include <cstdint>
#include <span>

#include "weft/world.h"

namespace weft::demo {

struct Annotation;

enum class Holder {
    rod,    ///< through the first and the last vertex, a bit longer
    hands,  ///< at each vertex
    posts   ///< from the ground to each vertex
};

/// Draws a holder of these vertices, those of them that are pinned.
void draw_holder(const ClothView& cloth, std::span<const std::uint32_t> vertices, Holder holder,
                 Annotation& to);

/// Draws a level grate of 1 m by 0.8 m, whose lower side is at that height [m].
void draw_grate(float height, Annotation& to);

}  // namespace weft::demo
