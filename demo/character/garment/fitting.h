#pragma once
// Puts a garment round a body: the body takes the stance that suits the garment, and grows into it.

#include "demo/character/garment/garment.h"

namespace weft::demo {

/// The result of fit().
struct Fit {
    float arms = 45;  ///< angle of the arms below the horizontal, in the stance [degrees]
    /// Factor on the body's radii, 0.8 to 1: the body is as slender as the garment is made for.
    float girth = 1;
    /// Targets of the garment's fixed vertices on the grown body in its stance, by Garment::fixed [m]. Of a
    /// garment that stands ready only vertices inside the body move; others are drawn up to the body.
    std::vector<Vec3> held;
    std::uint32_t inside = 0;  ///< vertices that begin inside the grown body
    float deepest = 0;         ///< greatest depth of these [m]
};

/// Moves the garment to where little of it is inside the body and its highest opening is next to the body. A
/// garment that stands ready is not moved. Error: the garment does not fit; the message says by how much.
[[nodiscard]] Result<Fit> fit(const Skeleton& skeleton, const Body& body, Garment& garment);

/// Radii at `time` over their final size, for a growth of `duration` [s]; 1 from `duration` on.
[[nodiscard]] float growth_at(double time, double duration);

}  // namespace weft::demo
