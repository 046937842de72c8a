#include "demo/study/charts/front.h"

#include <algorithm>
#include <limits>
#include <numeric>
#include <tuple>

namespace weft::study {

std::vector<std::size_t> front_of(std::span<const CostAndError> points) {
    std::vector<std::size_t> order(points.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::ranges::stable_sort(order, {},
                             [&](std::size_t i) { return std::tuple(points[i].cost, points[i].error); });
    std::vector<std::size_t> front;
    double least = std::numeric_limits<double>::infinity();
    for (const std::size_t i : order) {
        if (points[i].error >= least) continue;
        least = points[i].error;
        front.push_back(i);
    }
    return front;
}

}  // namespace weft::study
