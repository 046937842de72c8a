#include "cloth/mesh/obj/corner_tree.h"

#include <algorithm>
#include <bit>
#include <utility>

namespace weft {

namespace {

constexpr std::uint32_t removed = ~0u;

}  // namespace

CornerTree::CornerTree(std::span<const Eigen::Vector2d> points, std::vector<std::uint32_t> corners,
                       double slack)
    : points_(points), order_(std::move(corners)), place_(points.size(), removed), slack_(slack) {
    // The deepest leaves hold more than most_in_leaf / 2 corners, so that indices stay below this.
    nodes_.resize(2 * std::bit_ceil(2 * order_.size() / most_in_leaf + 1));
    build(whole());
    for (std::uint32_t k = 0; k < order_.size(); ++k) place_[order_[k]] = k;
}

void CornerTree::build(const Range& range) {
    Node& node = nodes_[range.index];
    node.left = static_cast<std::uint32_t>(range.end - range.begin);
    if (node.left == 0) return;
    node.low = node.high = points_[order_[range.begin]];
    for (std::size_t k = range.begin; k < range.end; ++k) {
        node.low = node.low.cwiseMin(points_[order_[k]]);
        node.high = node.high.cwiseMax(points_[order_[k]]);
    }
    if (range.is_leaf()) return;
    const Eigen::Vector2d size = node.high - node.low;
    const Eigen::Index axis = size.x() >= size.y() ? 0 : 1;
    const auto at = [&](std::size_t k) { return order_.begin() + static_cast<std::ptrdiff_t>(k); };
    std::nth_element(at(range.begin), at(range.middle()), at(range.end),
                     [&](std::uint32_t a, std::uint32_t b) {
                         return std::pair(points_[a][axis], a) < std::pair(points_[b][axis], b);
                     });
    build(range.lower());
    build(range.upper());
}

void CornerTree::remove(std::uint32_t corner) {
    const std::size_t k = std::exchange(place_[corner], removed);
    Range range = whole();
    for (;; range = k < range.middle() ? range.lower() : range.upper()) {
        --nodes_[range.index].left;
        if (range.is_leaf()) return;
    }
}

bool CornerTree::misses(const Node& node, const std::array<Eigen::Vector2d, 3>& triangle) const {
    for (std::size_t i = 0; i < 3; ++i) {
        const Eigen::Vector2d &from = triangle[i], along = triangle[(i + 1) % 3] - from;
        // The box's corner that lies farthest to the left of the edge.
        const Eigen::Vector2d farthest{along.y() > 0 ? node.low.x() : node.high.x(),
                                       along.x() > 0 ? node.high.y() : node.low.y()};
        const Eigen::Vector2d way = farthest - from;
        const double left = along.x() * way.y() - along.y() * way.x();
        if (left < -slack_ * (along.cwiseAbs().sum() + way.cwiseAbs().sum())) return true;
    }
    const Eigen::Vector2d low = triangle[0].cwiseMin(triangle[1]).cwiseMin(triangle[2]),
                          high = triangle[0].cwiseMax(triangle[1]).cwiseMax(triangle[2]);
    return ((node.low - high).array() > slack_).any() || ((low - node.high).array() > slack_).any();
}

}  // namespace weft
