#pragma once
// BDF2's bases: the start of a step, extrapolated from each particle's last step.

#include <limits>
#include <span>

#include "cloth/equation/pairs/pair_rows.h"
#include "cloth/state/state.h"
#include "engine/memory/scratch.h"
#include "engine/threads/parallel_blocks.h"
#include "engine/vector.h"

namespace weft {

/// Coefficients of one step: backward Euler (BDF1) or BDF2, see StepEquation.
struct Bdf {
    float gamma;    ///< [s]
    float divisor;  ///< x_base = x_n + (x_n - x_n-1) / divisor; infinity: backward Euler

    [[nodiscard]] bool is_second_order() const noexcept {
        return divisor < std::numeric_limits<float>::infinity();
    }
};
/// Coefficients of a step of h seconds after one of `last` seconds; last = 0: no step precedes, or the path
/// broke after it. Cloths that are solved together share one gamma. A least_gamma above BDF2's, up to h,
/// makes the step first order; its divisor keeps straight motion exact.
[[nodiscard]] Bdf bdf_after(float last, float h, float least_gamma = 0);

/// Removes contact's part from the recorded velocity changes: the component along a particle's contact
/// impulse, relative to the mean change of all touching particles. Extrapolating that part would make layers
/// bounce off each other. The rows number the cloth's particles from `first` on.
void forget_contact(const PairRows& rows, std::uint32_t first, ClothState& state);

/// The bases of one step, made from the record of the last step.
class History {
  public:
    void lay_out(Scratch& scratch, std::uint32_t particles) {
        scratch.take(base_positions_, particles);
        scratch.take(base_velocities_, particles);
    }

    /// Computes the bases of a second-order step from the present state and its record. A particle that is
    /// not where the last step left it was moved by contact or a limit: its displacement is taken to be its
    /// present velocity times the last step's length. The same holds for a particle on a collider, whose
    /// velocity change along the normal is not extrapolated either: cloth that lands would bounce.
    void begin(Parallel& parallel, const ClothState& state, float divisor);
    [[nodiscard]] std::span<const Vec4> base_positions() const { return base_positions_.span(); }
    [[nodiscard]] std::span<const Vec4> base_velocities() const { return base_velocities_.span(); }

  private:
    ScratchArray<Vec4> base_positions_, base_velocities_;
};

}  // namespace weft
