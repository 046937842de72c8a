#pragma once
// What a cloth needs in a World with a budget, besides its state.

#include <array>
#include <cstdint>
#include <memory>

#include "cloth/budget/ladder.h"
#include "engine/memory/aligned_buffer.h"
#include "weft/settings.h"
#include "weft/types.h"

namespace weft {

/// What a cloth costs on each rung, as far as it was there.
class RungCosts {
  public:
    /// One that was never stepped is taken to cost this on the first [ns].
    explicit RungCosts(float guess);
    /// What a step took on a rung; of long ones, the mean of the World's steps through which one went [ns].
    void add(std::uint32_t rung, float nanoseconds);
    /// It goes on on another.
    void change_rung() noexcept { samples_ = 0; }
    [[nodiscard]] const std::array<float, rung_count>& all() const noexcept { return costs_; }

  private:
    std::array<float, rung_count> costs_;
    std::array<bool, rung_count> known_{};
    std::uint32_t samples_ = 0;  // since the rung changed
};

/// By how much steps take longer than what is known of their cloths says.
class Headroom {
  public:
    /// What cloths may be known to take, so that nineteen of twenty steps take no longer than this.
    [[nodiscard]] float within(float time) const noexcept { return time / quantile_; }
    /// A step took so many times what was known.
    void add(float ratio) noexcept;

  private:
    float quantile_ = 1.075f;  ///< 19 of 20 ratios are less
};

struct Budgeted {
    explicit Budgeted(const ClothSettings& of, std::uint32_t particles)
        : settings(of), costs(300.0f * static_cast<float>(particles)) {}

    ClothSettings settings;  ///< as the present step takes it
    RungCosts costs;
    float spent = 0;          ///< since it last took a step of its own [ns]
    std::uint32_t steps = 0;  ///< of the World, likewise
};

struct BudgetBuffers {
    std::unique_ptr<Budgeted> budgeted;
    AlignedBuffer<Vec4> ahead;
};

}  // namespace weft
