#pragma once
// Distributes a step's time among cloths. Each begins on its last rung; the rungs that remove the most error
// for their time are bought first.

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "cloth/budget/ladder.h"

namespace weft {

/// A cloth's cost on a rung, in the unit of the time, and its error there. A garment with levels has the
/// rungs of its coarser ones behind those of the finest.
struct Offer {
    float cost = 0, error = 0;
};

/// A cloth that competes for time.
struct Claim {
    float importance = 1;  ///< weight of its error; 0: it stays on its last rung
    std::array<Offer, std::size_t{most_garment_levels} * rung_count> offers{};  ///< from the best
    std::uint32_t first = 0, last = 0;                                          ///< rungs that it may be on
    std::uint32_t rung = 0;  ///< the present rung; allot() writes the next one
};

class Allotment {
  public:
    /// Allocates for up to so many claims.
    void reserve(std::size_t claims);
    [[nodiscard]] std::vector<Claim>& claims() noexcept { return claims_; }
    /// Writes each claim's rung. A cloth keeps its rung as long as all fits, unless another one is worth much
    /// more. It gets a rung that it does not have only if some time is left then.
    void allot(float time);
    /// Total cost of the rungs that the last allot() gave.
    [[nodiscard]] float spent() const noexcept { return spent_; }

  private:
    /// A purchase: from a rung to the one before it.
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
