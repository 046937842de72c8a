#pragma once
// The share of a push that each corner of a triangle gets.

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <span>

#include "weft/types.h"

namespace weft {

/// A push moves corner k by weights[k] inverse_mass(k) / yielding(). In this sum a corner counts as at most
/// three times as heavy as the lightest: without that limit, a free corner beside a pinned or very heavy one
/// would move by an unbounded lever. No corner moves farther than twice the push, and the heavy corners'
/// share of it is not made up for. 0: no corner that has a weight is free.
template <class InverseMass>
[[nodiscard]] float yielding(const std::array<float, 3>& weights, const InverseMass& inverse_mass) {
    constexpr float least_part = 1.0f / 3;
    float lightest = 0, yields = 0;
    for (std::size_t k = 0; k < 3; ++k)
        if (weights[k] != 0) lightest = std::max(lightest, inverse_mass(k));
    for (std::size_t k = 0; k < 3; ++k)
        yields += weights[k] * weights[k] * std::max(inverse_mass(k), least_part * lightest);
    return lightest > 0 ? yields : 0;
}

/// Calls move(corner, share) for each corner of a triangle that a push moves, with its share of the push.
/// Returns false if it moves none.
template <class Move>
bool share_push(const std::array<std::uint32_t, 3>& corners, const std::array<float, 3>& weights,
                std::span<const Vec4> positions, const Move& move) {
    const float yields = yielding(weights, [&](std::size_t k) { return positions[corners[k]].w; });
    if (!(yields > 0)) return false;
    for (std::size_t k = 0; k < 3; ++k)
        if (const float share = weights[k] * positions[corners[k]].w / yields; share != 0)
            move(corners[k], share);
    return true;
}

}  // namespace weft
