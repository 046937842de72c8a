#pragma once
// A bounding volume hierarchy over the triangles of a soup, which finds pairs of triangles that are near.

#include <algorithm>
#include <array>
#include <cstdint>
#include <span>
#include <utility>
#include <vector>

#include "demo/study/crossings/triangle_soup.h"

namespace weft::study {

struct Box {
    std::array<float, 3> low, high;
};

class BoxTree {
  public:
    explicit BoxTree(const TriangleSoup& soup);

    /// Calls `visit(first, second)` once for each pair of different triangles for which `near(box, box)` is
    /// true of their boxes and of all nodes' boxes around them. Precondition: if `near` is true of two boxes,
    /// it is true of boxes that contain them.
    template <class Near, class Visit>
    void pairs(const Near& near, const Visit& visit) const;

  private:
    static constexpr std::uint32_t leaf_size = 4;
    /// A node over order_[first, last). Its children are the nodes `child` and `child` + 1; 0: it is a leaf.
    struct Node {
        Box box;
        std::uint32_t first, last, child;
    };
    void split(std::uint32_t node, std::vector<Box>& boxes);
    template <class Near, class Visit>
    void leaves(const Node& a, const Node& b, const Near& near, const Visit& visit) const;

    std::vector<Node> nodes_;
    std::vector<std::uint32_t> order_;  // triangles
    std::vector<Box> boxes_;            // of each triangle of order_
};

template <class Near, class Visit>
void BoxTree::pairs(const Near& near, const Visit& visit) const {
    std::vector<std::pair<std::uint32_t, std::uint32_t>> open;
    if (!nodes_.empty()) open.emplace_back(0u, 0u);
    while (!open.empty()) {
        const auto [i, j] = open.back();
        open.pop_back();
        const Node &a = nodes_[i], &b = nodes_[j];
        if (i != j && !near(a.box, b.box)) continue;
        if (a.child == 0 && b.child == 0) {
            leaves(a, b, near, visit);
        } else if (i == j) {
            open.insert(open.end(), {{a.child, a.child}, {a.child, a.child + 1}, {a.child + 1, a.child + 1}});
        } else if (b.child == 0 || (a.child != 0 && a.last - a.first > b.last - b.first)) {
            open.insert(open.end(), {{a.child, j}, {a.child + 1, j}});
        } else {
            open.insert(open.end(), {{i, b.child}, {i, b.child + 1}});
        }
    }
}

template <class Near, class Visit>
void BoxTree::leaves(const Node& a, const Node& b, const Near& near, const Visit& visit) const {
    for (std::uint32_t p = a.first; p < a.last; ++p) {
        for (std::uint32_t q = &a == &b ? p + 1 : b.first; q < b.last; ++q) {
            if (near(boxes_[p], boxes_[q]))
                visit(std::min(order_[p], order_[q]), std::max(order_[p], order_[q]));
        }
    }
}

}  // namespace weft::study
