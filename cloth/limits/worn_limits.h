#pragma once
// Limits of cloth that is worn: a leash round each particle's place on the skin, and a backstop behind it.
// Both hold at the end of a substep, whatever the solver leaves. Both are also surfaces in the equation that
// particles press on: otherwise the cloth that hangs from a held particle would draw it into the limit.
//
// With place p and normal n at the substep's end, a particle x is kept where
//     |x - p| <= leash   and   |x - c| >= r,   c = p - (offset + r) n;   r infinite: n . (x - p) >= -offset.
// The set is never empty: since offset >= -leash, it has p, or the point of the leash in front of p.

#include <cstdint>
#include <span>

#include "cloth/equation/contacts.h"
#include "cloth/state/skin_state.h"
#include "engine/memory/aligned_buffer.h"
#include "engine/threads/parallel_blocks.h"
#include "engine/vector.h"
#include "weft/types.h"

namespace weft {

/// Particles beyond their limits at the end of a step, and their greatest distance from these.
struct LimitLag {
    std::uint32_t particles = 0;
    float most = 0;  ///< [m]
};

/// The limits of one cloth.
class WornLimits final : public OwnSurfaces {
  public:
    // Values of the maps, one a particle [m]; an empty buffer: the map is not set.
    AlignedBuffer<float> leash, backstop, backstop_radius;

    [[nodiscard]] bool has_limits() const noexcept { return leash.size() > 0 || backstop.size() > 0; }
    /// Allocates what the limits need besides maps; frees it where there are no limits. May throw.
    void reserve(std::uint32_t particles);

    /// Begins a substep, or a part of one, that ends after the fraction `end` of a step of dt seconds.
    void begin(const SkinState& skin, float end, float dt) noexcept;
    /// Whether there are limits, and the host has said where the skin is.
    [[nodiscard]] bool is_holding() const noexcept { return has_limits() && is_known_; }

    bool adjust(const BlockRange& range, float reach, bool found, NearSurfaces& near) noexcept override;
    [[nodiscard]] bool holds(std::uint32_t particle) const noexcept override {
        return by_limit_.size() > 0 && by_limit_[particle] != 0;
    }
    /// Ends the substep: moves particles beyond limits back, and removes their velocity out of these.
    void hold(Parallel& parallel, std::span<Vec4> positions, std::span<Vec4> velocities) const;
    /// The lag at the end of the step.
    [[nodiscard]] LimitLag lag(Parallel& parallel, std::span<const Vec4> positions) noexcept;

    [[nodiscard]] std::size_t bytes() const noexcept {
        return leash.bytes() + backstop.bytes() + backstop_radius.bytes() + by_limit_.bytes() +
               partials_.bytes();
    }

  private:
    struct Bounds;
    [[nodiscard]] Bounds bounds_of(std::uint32_t particle) const noexcept;

    AlignedBuffer<std::uint8_t> by_limit_;  // whether the particle's nearest surface is a limit
    AlignedBuffer<LimitLag> partials_;      // by block
    std::span<const Vec4> places_, targets_, normals_, target_normals_;
    float end_ = 1, per_second_ = 0;
    bool is_known_ = false;
};

}  // namespace weft
