#pragma once
// Long-range attachments (Kim, Chentanez, Mueller 2012): no particle goes further from its nearest pin than
// the way along the cloth, whatever a solver has left unsolved.

#include <cstdint>
#include <span>

#include "cloth/cook.h"
#include "cloth/geodesics.h"
#include "engine/aligned_buffer.h"
#include "engine/parallel_blocks.h"

namespace weft {

class LongRangeAttachments {
  public:
    explicit LongRangeAttachments(const CookedCloth& model)
        : geodesics_(model), pins_(model.particle_count), lengths_(model.particle_count) {}

    /// Finds each particle's pin and its distance, for steps to come.
    void attach(const CookedCloth& model, std::span<const std::uint32_t> pins);

    /// Particles beyond `slack` times their distance are put back to it, and lose the velocity at which they
    /// leave their pin.
    void hold(Parallel& parallel, float slack, std::span<Vec4> positions, std::span<Vec4> velocities) const;

    [[nodiscard]] std::span<const std::uint32_t> pins() const {
        return pins_.span();
    }  ///< Geodesics::none: free
    [[nodiscard]] std::span<const float> lengths() const { return lengths_.span(); }  ///< [m]
    [[nodiscard]] std::size_t bytes() const noexcept {
        return geodesics_.bytes() + pins_.bytes() + lengths_.bytes();
    }

  private:
    Geodesics geodesics_;
    AlignedBuffer<std::uint32_t> pins_;
    AlignedBuffer<float> lengths_;
};

}  // namespace weft
