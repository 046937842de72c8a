// The front against brute force.

#include "demo/study/charts/front.h"

#include <gtest/gtest.h>
#include <algorithm>
#include <random>

namespace weft::study {
namespace {

bool beats(const CostAndError& a, const CostAndError& b) {
    return a.cost <= b.cost && a.error <= b.error && (a.cost < b.cost || a.error < b.error);
}

TEST(Front, HoldsExactlyThePointsThatNoneBeats) {
    std::mt19937 random(3);
    for (int trial = 0; trial < 200; ++trial) {
        std::vector<CostAndError> points(1 + random() % 30);
        for (CostAndError& point : points)  // few values, so that ties are common
            point = {static_cast<double>(random() % 12), static_cast<double>(random() % 12)};
        const std::vector<std::size_t> front = front_of(points);
        const auto is_on_front = [&](const CostAndError& point) {
            return std::ranges::any_of(front, [&](std::size_t i) {
                return points[i].cost == point.cost && points[i].error == point.error;
            });
        };
        for (const CostAndError& point : points) {
            const bool is_beaten =
                std::ranges::any_of(points, [&](const CostAndError& other) { return beats(other, point); });
            EXPECT_EQ(is_on_front(point), !is_beaten);
        }
        for (std::size_t k = 1; k < front.size(); ++k) {
            EXPECT_LT(points[front[k - 1]].cost, points[front[k]].cost);
            EXPECT_GT(points[front[k - 1]].error, points[front[k]].error);
        }
    }
}

TEST(Front, OfNothingIsEmpty) {
    EXPECT_TRUE(front_of({}).empty());
}

}  // namespace
}  // namespace weft::study
