#pragma once
// Data of a cloth in a World with a budget, besides its state.

#include <array>
#include <cstdint>
#include <memory>

#include "cloth/budget/ladder.h"
#include "engine/memory/aligned_buffer.h"
#include "weft/settings.h"
#include "weft/types.h"

namespace weft {

/// A cloth's mean cost on each rung: measured where it was on it, else estimated.
class RungCosts {
  public:
    /// `guess`: cost on the first rung before any step was measured [ns].
    explicit RungCosts(float guess);
    /// Adds the time of a step on a rung [ns]; of a long step, the mean over the World's steps that it
    /// covers.
    void add(std::uint32_t rung, float nanoseconds);
    /// The cloth changed its rung: the new one's samples count from 0.
    void change_rung() noexcept { samples_ = 0; }
    [[nodiscard]] const std::array<float, rung_count>& all() const noexcept { return costs_; }
    /// Returns whether a step on some rung was measured.
    [[nodiscard]] bool are_measured() const noexcept { return known_[0] || known_[1] || known_[2]; }

  private:
    std::array<float, rung_count> costs_;
    std::array<bool, rung_count> known_{};
    std::uint32_t samples_ = 0;  // number since the rung changed
};

/// Ratio of a step's time to the known costs of its cloths.
class Headroom {
  public:
    /// Greatest known cost of all cloths with which nineteen of twenty steps take no longer than `time`.
    [[nodiscard]] float within(float time) const noexcept { return time / quantile_; }
    /// Adds the ratio of a step.
    void add(float ratio) noexcept;

  private:
    float quantile_ = 1.075f;  ///< 19 of 20 ratios are less
};

struct Budgeted {
    explicit Budgeted(const ClothSettings& of, std::uint32_t particles)
        : settings(of), costs(300.0f * static_cast<float>(particles)) {}

    ClothSettings settings;  ///< settings of the present step
    RungCosts costs;
    float spent = 0;          ///< time since the cloth's last step of its own [ns]
    std::uint32_t steps = 0;  ///< steps of the World since then
};

struct BudgetBuffers {
    std::unique_ptr<Budgeted> budgeted;
    AlignedBuffer<Vec4> ahead;
};

}  // namespace weft
