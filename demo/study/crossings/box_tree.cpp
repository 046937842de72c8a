#include "demo/study/crossings/box_tree.h"

#include <limits>
#include <numeric>

namespace weft::study {

namespace {

constexpr float huge = std::numeric_limits<float>::infinity();
constexpr Box nothing{{huge, huge, huge}, {-huge, -huge, -huge}};

void include(Box& box, const Box& more) {
    for (std::size_t k = 0; k < 3; ++k) {
        box.low[k] = std::min(box.low[k], more.low[k]);
        box.high[k] = std::max(box.high[k], more.high[k]);
    }
}

Box box_of(const TriangleSoup& soup, const Triangle& triangle) {
    Box box = nothing;
    for (const std::uint32_t corner : triangle) {
        const Vec3& p = soup.points[corner];
        include(box, {{p.x, p.y, p.z}, {p.x, p.y, p.z}});
    }
    return box;
}

float middle(const Box& box, std::size_t axis) {
    return box.low[axis] + box.high[axis];
}

/// The axis along which the boxes' middles spread most.
std::size_t widest_axis(std::span<const std::uint32_t> triangles, const std::vector<Box>& boxes) {
    Box middles = nothing;
    for (const std::uint32_t t : triangles) {
        const std::array<float, 3> m{middle(boxes[t], 0), middle(boxes[t], 1), middle(boxes[t], 2)};
        include(middles, {m, m});
    }
    std::size_t widest = 0;
    for (std::size_t k = 1; k < 3; ++k)
        if (middles.high[k] - middles.low[k] > middles.high[widest] - middles.low[widest]) widest = k;
    return widest;
}

}  // namespace

BoxTree::BoxTree(const TriangleSoup& soup) : order_(soup.triangles.size()) {
    if (order_.empty()) return;
    std::vector<Box> boxes;
    for (const Triangle& triangle : soup.triangles) boxes.push_back(box_of(soup, triangle));
    std::iota(order_.begin(), order_.end(), 0u);
    nodes_.push_back({nothing, 0, static_cast<std::uint32_t>(order_.size()), 0});
    for (std::uint32_t node = 0; node < nodes_.size(); ++node) split(node, boxes);
    for (const std::uint32_t t : order_) boxes_.push_back(boxes[t]);
}

/// Halves a node at the median of its widest axis, where it has too many for a leaf.
void BoxTree::split(std::uint32_t node, std::vector<Box>& boxes) {
    const std::uint32_t first = nodes_[node].first, last = nodes_[node].last;
    const std::span<std::uint32_t> own = std::span(order_).subspan(first, last - first);
    for (const std::uint32_t t : own) include(nodes_[node].box, boxes[t]);
    if (last - first <= leaf_size) return;
    const std::size_t axis = widest_axis(own, boxes);
    const std::uint32_t half = (last - first) / 2;
    std::nth_element(own.begin(), own.begin() + half, own.end(), [&](std::uint32_t a, std::uint32_t b) {
        return std::pair(middle(boxes[a], axis), a) < std::pair(middle(boxes[b], axis), b);
    });
    nodes_[node].child = static_cast<std::uint32_t>(nodes_.size());
    nodes_.push_back({nothing, first, first + half, 0});
    nodes_.push_back({nothing, first + half, last, 0});
}

}  // namespace weft::study
