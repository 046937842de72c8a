#pragma once
// The Pareto front: the points that no other point beats in both cost and error.

#include <span>
#include <vector>

namespace weft::study {

struct CostAndError {
    double cost, error;
};

/// Indices of the points of which no other is as good in both and better in one (Pareto 1906), in ascending
/// order of cost. Equal points are represented by the first.
[[nodiscard]] std::vector<std::size_t> front_of(std::span<const CostAndError> points);

}  // namespace weft::study
