#pragma once
// What BDF2 remembers: how each particle came here.

#include <span>

#include "cloth/frame/state.h"
#include "engine/aligned_buffer.h"
#include "engine/parallel_blocks.h"
#include "engine/vector.h"

namespace weft {

/// From one particle on.
struct HistoryRows {
    Vec4 *displacements, *velocity_changes;  ///< of the last step
    Vec4* arrivals;                          ///< where it ended
    Vec4 *base_positions, *base_velocities;  ///< of the next one
};

class History {
  public:
    explicit History(std::uint32_t particles)
        : displacements_(particles),
          velocity_changes_(particles),
          arrivals_(particles),
          base_positions_(particles),
          base_velocities_(particles) {}

    /// Whether there was a step of length h; the first one is of backward Euler.
    [[nodiscard]] bool holds(float h) const { return h == h_; }
    void forget() { h_ = 0; }

    /// Computes the bases of the next step from the present state. A particle that is not where the last step
    /// left it has met something: it is taken to have come in a straight line at its present velocity.
    /// Contact impulses are no part of the velocity changes that are remembered, so none is extrapolated.
    void begin(Parallel& parallel, const ClothState& state);
    [[nodiscard]] std::span<const Vec4> base_positions() const { return base_positions_.span(); }
    [[nodiscard]] std::span<const Vec4> base_velocities() const { return base_velocities_.span(); }
    [[nodiscard]] static float gamma(float h) { return h * (2.0f / 3.0f); }

    /// A step of length h is about to be recorded ...
    void set_step(float h) { h_ = h; }
    /// ... here.
    [[nodiscard]] HistoryRows rows(std::uint32_t first = 0) {
        return {displacements_.data() + first, velocity_changes_.data() + first, arrivals_.data() + first,
                base_positions_.data() + first, base_velocities_.data() + first};
    }

    [[nodiscard]] std::size_t bytes() const noexcept;

  private:
    float h_ = 0;  // of the last step; 0: none
    AlignedBuffer<Vec4> displacements_, velocity_changes_, arrivals_, base_positions_, base_velocities_;
};

}  // namespace weft
