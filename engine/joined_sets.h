#pragma once
// Sets of the numbers 0, 1, .., joined two at a time (union-find with path halving, Tarjan and van Leeuwen
// 1984).

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <numeric>
#include <span>
#include <vector>

namespace weft {

/// Invariant: parents[i] <= i, so that the first, lowest number of a set is its root.
class JoinedSets {
  public:
    JoinedSets() = default;
    explicit JoinedSets(std::size_t count) { begin(count); }

    void reserve(std::size_t count) { parents_.reserve(count); }
    /// Begins with a set for each number below `count`; allocates nothing within what was reserved.
    void begin(std::size_t count) {
        parents_.resize(count);
        std::iota(parents_.begin(), parents_.end(), 0u);
    }
    void join(std::uint32_t i, std::uint32_t j) {
        const std::uint32_t a = first_of(i), b = first_of(j);
        parents_[std::max(a, b)] = std::min(a, b);
    }
    /// The first number of the set that i is in.
    [[nodiscard]] std::uint32_t first_of(std::uint32_t i) {
        while (parents_[i] != i) i = parents_[i] = parents_[parents_[i]];
        return i;
    }
    /// Makes firsts() hold for all numbers, until sets are joined again.
    void finish() {
        for (std::uint32_t i = 0; i < parents_.size(); ++i) parents_[i] = first_of(i);
    }
    /// The first number of each number's set.
    [[nodiscard]] std::span<const std::uint32_t> firsts() const { return parents_; }
    /// The number of each one's set, from 0 in the order of first numbers.
    [[nodiscard]] std::vector<std::uint32_t> numbers() {
        finish();
        std::vector<std::uint32_t> numbers(parents_.size());
        std::uint32_t next = 0;
        for (std::uint32_t i = 0; i < numbers.size(); ++i)
            numbers[i] = parents_[i] == i ? next++ : numbers[parents_[i]];
        return numbers;
    }

  private:
    std::vector<std::uint32_t> parents_;
};

}  // namespace weft
