#pragma once
// Shares a time out among cloths: each begins on its last rung, and what takes most error away for its time
// is bought first.

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "cloth/budget/ladder.h"

namespace weft {

/// A cloth to be given time.
struct Claim {
    float importance = 1;                            ///< of its error; 0: it stays on its last rung
    std::array<float, rung_count> costs{};           ///< on each rung, in the unit of the time
    std::uint32_t first = 0, last = rung_count - 1;  ///< rungs that it may be on
    std::uint32_t rung = 0;                          ///< where it is; allot() writes where it is to be
};

class Allotment {
  public:
    /// Up to so many claims are met without allocation.
    void reserve(std::size_t claims);
    [[nodiscard]] std::vector<Claim>& claims() noexcept { return claims_; }
    /// Writes each claim's rung. What a cloth has it keeps as long as all fits, and against what is not much
    /// more worth; what it has not it gets only where some room is left.
    void allot(float time);
    /// By the claims' costs, of what the last allot() gave.
    [[nodiscard]] float spent() const noexcept { return spent_; }

  private:
    /// From a rung to the one before it.
    struct Step {
        float worth;  // error taken away per time
        std::uint32_t claim, to;
    };
    std::vector<Claim> claims_;
    std::vector<Step> steps_;
    std::vector<std::uint32_t> reached_;
    float spent_ = 0;
};

}  // namespace weft
