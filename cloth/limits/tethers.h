#pragma once
// Long-range attachments (Kim, Chentanez, Mueller 2012): no particle is further from the nearest pins than
// the way along the cloth, whatever residual a solver leaves.
//
// Pins that springs join form one hold. A particle has a tether to the nearest pin of each of its four
// nearest holds. A tether to one hold alone would let the cloth stretch between particles that follow
// different holds.

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "cloth/limits/limit.h"
#include "cloth/mesh/cook.h"
#include "cloth/mesh/cooking/geodesics.h"
#include "engine/memory/aligned_buffer.h"
#include "engine/threads/parallel_blocks.h"

namespace weft {

class LongRangeAttachments final : public Limit {
  public:
    static constexpr std::uint32_t none = GeodesicReach::none;

    explicit LongRangeAttachments(const ClothModel& model) : geodesics_(model) {}

    /// The first change of pins after a step is computed here, so that the step need not compute it. Further
    /// changes before the next step only allocate what update() needs.
    void prepare(const ClothModel& model, std::span<const std::uint32_t> pins) override;
    [[nodiscard]] std::unique_ptr<Limit> clone() const override;
    void commit() noexcept override;
    void update(const ClothModel& model) noexcept override;

    /// Moves particles beyond `slack` times their tether's length back to that distance, and removes the
    /// velocity at which they leave their pin. Where tethers contradict each other, the last layer's holds.
    void hold(Parallel& parallel, float slack, std::span<Vec4> positions, std::span<Vec4> velocities) const;
    void hold(Parallel& parallel, const ClothSettings& settings, std::span<Vec4> positions,
              std::span<Vec4> velocities) const override {
        hold(parallel, settings.tethers.slack, positions, velocities);
    }

    /// One tether of each particle. All particles list their holds in the same order. With its nearest hold
    /// last, say, each particle would follow another hold than its neighbours, and separate from them.
    struct Layer {
        AlignedBuffer<std::uint32_t> pins;  ///< of each particle; none: it has fewer tethers
        AlignedBuffer<float> lengths;       ///< [m]
    };
    /// Precondition: update() has been called since the last commit().
    [[nodiscard]] std::span<const Layer> layers() const { return std::span(layers_).first(layer_count_); }
    [[nodiscard]] std::size_t bytes() const noexcept override;

  private:
    using Layers = std::array<Layer, Geodesics::most_reached>;
    struct Prepared {
        std::vector<GeodesicSource> sources;
        std::size_t layer_count = 0;
        Layers layers{};  // a layer without memory: the present one stays
        bool is_outdated = false;
    };

    void measure(const ClothModel& model, std::span<const GeodesicSource> sources, std::span<Layer> layers);

    Geodesics geodesics_;
    Layers layers_;
    std::size_t layer_count_ = 0;
    std::vector<GeodesicSource> sources_;
    bool is_outdated_ = false;  // the layers are not those of the sources
    bool has_changed_ = false;  // pins have changed since the last update()
    Prepared prepared_;
};

}  // namespace weft
