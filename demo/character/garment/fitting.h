#pragma once
// How a garment comes to be round a body: the body takes the stance that suits it, and grows into it.

#include "demo/character/garment/garment.h"

namespace weft::demo {

/// What fit() found.
struct Fit {
    float arms = 45;  ///< how far the stance lowers them from the horizontal [degrees]
    /// Of the body's radii, 0.8 to 1: who wears a garment is as slender as it is made for.
    float girth = 1;
    /// Where the garment's fixed vertices are to be when the body has grown, in the stance, in the order of
    /// Garment::fixed: where they are, or put out of the body, or drawn up to it.
    std::vector<Vec3> held;
    std::uint32_t inside = 0;  ///< vertices that begin inside the grown body
    float deepest = 0;         ///< the deepest of these [m]
};

/// Moves the garment so that as little of it as can be is inside the body, and its highest opening is next to
/// the body; one that stands ready stays where it is. Error: it does not fit, with by how much.
[[nodiscard]] Result<Fit> fit(const Skeleton& skeleton, const Body& body, Garment& garment);

/// What part of their grown size the radii have at `time`, of `duration` [s]: 1 from then on.
[[nodiscard]] float growth_at(double time, double duration);

}  // namespace weft::demo
