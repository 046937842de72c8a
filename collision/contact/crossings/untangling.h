#pragma once
// Directions in which crossing surfaces separate: those that shorten the contour along which they cross
// ("Resolving surface collisions through intersection contour minimization", Volino & Magnenat-Thalmann
// 2006).

#include <array>
#include <cstdint>
#include <span>

#include "collision/contact/crossings/contours.h"
#include "collision/contact/pairs/crossings.h"
#include "engine/memory/scratch.h"
#include "engine/vector.h"

namespace weft {

/// Asks that the weighted sum of its corners, which is 0, become as long along a direction as its depth.
struct UntanglingRow {
    std::array<std::uint32_t, 5> corners;  ///< the edge's, then the triangle's
    std::array<float, 5> weights;          ///< (1 - s, s, -w0, -w1, -w2)
    Vec4 direction;                        ///< of unit length; w: the depth [m], 0: the row asks for nothing
};

class Untangling {
  public:
    void lay_out(Scratch& scratch, std::size_t crossings);

    /// Makes a row of each crossing. Its direction is half its own and half its contour's mean: crossings
    /// separate when they move together, and their own directions need not agree.
    /// Precondition: the contours are of these crossings.
    void find(std::span<const ContactBody> bodies, std::span<const Vec4> positions,
              std::span<const Crossing> crossings, const Contours& contours);

    void clear() noexcept { size_ = 0; }

    [[nodiscard]] std::span<UntanglingRow> rows() noexcept { return rows_.span().first(size_); }
    [[nodiscard]] std::span<const UntanglingRow> rows() const noexcept { return rows_.span().first(size_); }

  private:
    ScratchArray<UntanglingRow> rows_;
    ScratchArray<Vec4> means_;  // per contour: sum of side 0's directions; w: their number
    std::uint32_t size_ = 0;
};

}  // namespace weft
