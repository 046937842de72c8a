#pragma once
// One sweep of extended position based dynamics over springs that share no particles, by as many lanes as the
// machine has.

#include <cstdint>

#include "cloth/methods/positional/colouring.h"
#include "engine/threads/parallel_blocks.h"
#include "weft/types.h"

namespace weft {

/// Per spring, in the order of its colours. Springs that only fill up a group have response and weights 0.
struct XpbdSprings {
    AlignedBuffer<float> rest_lengths;  ///< [m]
    AlignedBuffer<float> responses;     ///< multiplier per violation, see sweep_springs [kg]
    AlignedBuffer<float> releases;      ///< the part of the multiplier that compliance takes back
    AlignedBuffer<float> first_weights, second_weights;  ///< inverse masses [1/kg]
    AlignedBuffer<float> multipliers;                    ///< h^2 times the spring's tension, negative [kg m]

    XpbdSprings() = default;
    explicit XpbdSprings(std::uint32_t springs)
        : rest_lengths(springs),
          responses(springs),
          releases(springs),
          first_weights(springs),
          second_weights(springs),
          multipliers(springs) {}
    [[nodiscard]] std::size_t bytes() const noexcept { return 6 * responses.bytes(); }
};

/// Whether a sweep is the first or the last of a step. The first starts with multipliers of 0; the last does
/// not write them, because nobody reads them.
struct SweepOrder {
    bool first, last;
};

/// Projects all springs, colour by colour, with the damping gamma of eq. 26.
void sweep_springs(Parallel& parallel, const SpringColours& colours, float gamma, SweepOrder order,
                   XpbdSprings& springs, const Vec4* start, Vec4* moved);

}  // namespace weft
