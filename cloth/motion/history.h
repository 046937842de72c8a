#pragma once
// BDF2's bases: where a step starts from, by how each particle came here.

#include <limits>
#include <span>

#include "cloth/equation/pair_rows.h"
#include "cloth/state/state.h"
#include "engine/memory/scratch.h"
#include "engine/threads/parallel_blocks.h"
#include "engine/vector.h"

namespace weft {

/// Coefficients of one step: backward Euler (BDF1) or BDF2, see StepEquation.
struct Bdf {
    float gamma;    ///< [s]
    float divisor;  ///< of x_n - x_n-1 in x_base; infinity: backward Euler

    [[nodiscard]] bool is_second_order() const noexcept {
        return divisor < std::numeric_limits<float>::infinity();
    }
};
/// For a step of h seconds after one of `last`; 0: there was none, or the path broke after it. Cloths that
/// are solved together have one gamma. One above BDF2's, up to h, makes the step of first order, and keeps as
/// much of the last step as that leaves room for.
[[nodiscard]] Bdf bdf_after(float last, float h, float least_gamma = 0);

/// Of the last step's velocity changes, forgets what stopped features that touch: the part along the impulse
/// of contact on a particle, but for what those that touch changed by together. Going on with it would make
/// layers bounce off each other. The rows number the cloth's particles from `first` on.
void forget_contact(const PairRows& rows, std::uint32_t first, ClothState& state);

/// Of the last step's velocity changes, keeps what all particles that move have in common: gravity, and what
/// free cloth has as a whole.
void forget_own_changes(ClothState& state);

/// The bases of one step, which are made from the record of the last one.
class History {
  public:
    void lay_out(Scratch& scratch, std::uint32_t particles) {
        scratch.take(base_positions_, particles);
        scratch.take(base_velocities_, particles);
    }

    /// Computes the bases of a step of second order from the present state and its record. A particle that is
    /// not where the last step left it has met something: it is taken to have come in a straight line at its
    /// present velocity. So is one that a collider holds, and what its velocity changed by along the normal
    /// is not gone on with, or cloth that lands would bounce.
    void begin(Parallel& parallel, const ClothState& state, float divisor);
    [[nodiscard]] std::span<const Vec4> base_positions() const { return base_positions_.span(); }
    [[nodiscard]] std::span<const Vec4> base_velocities() const { return base_velocities_.span(); }

  private:
    ScratchArray<Vec4> base_positions_, base_velocities_;
};

}  // namespace weft
