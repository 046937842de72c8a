#pragma once
// Which points are the best there are: nothing else is both cheaper and more accurate.

#include <span>
#include <vector>

namespace weft::study {

struct CostAndError {
    double cost, error;
};

/// Indices of the points of which no other is as good in both and better in one (Pareto 1906), in ascending
/// order of cost. Of equal points the first.
[[nodiscard]] std::vector<std::size_t> front_of(std::span<const CostAndError> points);

}  // namespace weft::study
