#pragma once
// The share of a push that each corner of a triangle gets.

#include <algorithm>
#include <array>
#include <cstddef>

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

}  // namespace weft
