#pragma once
// Long-range attachments (Kim, Chentanez, Mueller 2012): no particle goes further from the nearest pins than
// the way along the cloth, whatever a solver has left unsolved.
//
// Pins that springs join form one hold. A particle has a tether to the nearest pin of each of its four
// nearest holds. A tether to one hold alone would let the cloth stretch between particles that follow
// different holds.

#include <cstdint>
#include <span>
#include <utility>
#include <vector>

#include "cloth/limits/limit.h"
#include "cloth/mesh/cook.h"
#include "cloth/mesh/geodesics.h"
#include "engine/memory/aligned_buffer.h"
#include "engine/threads/parallel_blocks.h"

namespace weft {

class LongRangeAttachments final : public Limit {
  public:
    static constexpr std::uint32_t none = GeodesicReach::none;

    explicit LongRangeAttachments(const ClothModel& model) : geodesics_(model) {}

    /// Finds each particle's pins and their distances, for steps to come.
    void prepare(const ClothModel& model, std::span<const std::uint32_t> pins) override;
    [[nodiscard]] std::unique_ptr<Limit> clone() const override {
        return std::make_unique<LongRangeAttachments>(*this);
    }
    void commit() noexcept override { layers_ = std::move(prepared_); }

    /// Particles beyond `slack` times their distance are put back to it, and lose the velocity at which they
    /// leave their pin. Where tethers contradict each other, the nearest pin's holds.
    void hold(Parallel& parallel, float slack, std::span<Vec4> positions, std::span<Vec4> velocities) const;
    void hold(Parallel& parallel, const ClothSettings& settings, std::span<Vec4> positions,
              std::span<Vec4> velocities) const override {
        hold(parallel, settings.tethers.slack, positions, velocities);
    }

    /// One tether of each particle. All particles take their holds in the same order. If each took its
    /// nearest hold last, say, neighbours would follow different holds and part.
    struct Layer {
        AlignedBuffer<std::uint32_t> pins;  ///< of each particle; none: it has fewer
        AlignedBuffer<float> lengths;       ///< [m]
    };
    [[nodiscard]] std::span<const Layer> layers() const { return layers_; }
    [[nodiscard]] std::size_t bytes() const noexcept override;

  private:
    Geodesics geodesics_;
    std::vector<Layer> layers_, prepared_;
};

}  // namespace weft
