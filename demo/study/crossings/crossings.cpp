#include "demo/study/crossings/crossings.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <numeric>
#include <span>
#include <utility>
#include <vector>

#include "demo/study/crossings/triangle_geometry.h"

namespace weft::study {

namespace {

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

}  // namespace

void TriangleSoup::add(const ClothView& cloth) {
    std::vector<Vec3> places;
    places.reserve(cloth.positions.size());
    for (const Vec4& p : cloth.positions) places.push_back({p.x, p.y, p.z});
    add_body(places, {cloth.triangles.begin(), cloth.triangles.end()});
}

void TriangleSoup::add_body(const std::vector<Vec3>& more, const std::vector<Triangle>& their_triangles) {
    const auto first = static_cast<std::uint32_t>(points.size());
    const std::uint32_t body = bodies.empty() ? 0 : bodies.back() + 1;
    points.insert(points.end(), more.begin(), more.end());
    for (const auto& [a, b, c] : their_triangles) {
        triangles.push_back({first + a, first + b, first + c});
        bodies.push_back(body);
    }
}

bool TriangleSoup::share_a_vertex(std::uint32_t first, std::uint32_t second) const {
    const auto& [a, b, c] = triangles[first];
    const auto is_shared = [&](std::uint32_t p) { return p == a || p == b || p == c; };
    return std::ranges::any_of(triangles[second], is_shared);
}

bool TriangleSoup::finite() const {
    return std::ranges::all_of(
        points, [](const Vec3& p) { return std::isfinite(p.x) && std::isfinite(p.y) && std::isfinite(p.z); });
}

namespace {

using Corners = std::array<Vec3, 3>;
using Sides = std::array<int, 3>;

Corners corners_of(const TriangleSoup& soup, std::uint32_t triangle) {
    const auto& [a, b, c] = soup.triangles[triangle];
    return {soup.points[a], soup.points[b], soup.points[c]};
}

/// For each of `other`'s corners, its side of the triangle's plane.
Sides sides_of(const Corners& triangle, const Corners& other) {
    Sides sides;
    for (std::size_t k = 0; k < 3; ++k)
        sides[k] = orientation(triangle[0], triangle[1], triangle[2], other[k]);
    return sides;
}

bool on_both_sides(const Sides& sides) {
    const auto [least, most] = std::ranges::minmax(sides);
    return least < 0 && most > 0;
}

/// Rotates the corners so that the first one is alone on its side of the other triangle's plane. The other
/// triangle is flipped if that is not its positive side. Where sides are -1, 0 and 1, either end counts as
/// alone.
void put_lone_corner_first(Corners& corners, const Sides& sides, Corners& other) {
    const auto is_alone = [&](std::size_t k) {
        return sides[k] != 0 && sides[(k + 1) % 3] != sides[k] && sides[(k + 2) % 3] != sides[k];
    };
    std::size_t lone = 0;
    while (!is_alone(lone)) ++lone;
    std::ranges::rotate(corners, corners.begin() + static_cast<std::ptrdiff_t>(lone));
    if (sides[lone] < 0) std::swap(other[1], other[2]);
}

// Each triangle cuts an interval out of the planes' common line, at the two edges of its lone corner. The
// ends' order along the line is the sign of a volume (Guigue and Devillers, "Fast and Robust
// Triangle-Triangle Overlap Test", 2003). With < for their <=, intervals that only touch do not overlap.
bool cross(Corners a, Corners b) {
    const Sides of_b = sides_of(a, b);
    if (!on_both_sides(of_b)) return false;
    const Sides of_a = sides_of(b, a);
    if (!on_both_sides(of_a)) return false;
    put_lone_corner_first(a, of_a, b);
    // The swap above may have moved b's corners.
    put_lone_corner_first(b, sides_of(a, b), a);
    return orientation(a[0], a[1], b[0], b[1]) < 0 && orientation(a[0], a[2], b[2], b[0]) < 0;
}

/// True if the boxes' interiors overlap: boxes that only touch hold no triangles that cross.
bool overlap(const Box& a, const Box& b) {
    for (std::size_t k = 0; k < 3; ++k)
        if (a.high[k] <= b.low[k] || b.high[k] <= a.low[k]) return false;
    return true;
}

template <class Visit>
void for_crossings(const TriangleSoup& soup, const Visit& visit) {
    BoxTree(soup).pairs(overlap, [&](std::uint32_t first, std::uint32_t second) {
        if (triangles_cross(soup, first, second)) visit(first, second);
    });
}

}  // namespace

bool triangles_cross(const TriangleSoup& soup, std::uint32_t first, std::uint32_t second) {
    return !soup.share_a_vertex(first, second) && cross(corners_of(soup, first), corners_of(soup, second));
}

std::vector<std::pair<std::uint32_t, std::uint32_t>> crossing_pairs(const TriangleSoup& soup) {
    std::vector<std::pair<std::uint32_t, std::uint32_t>> pairs;
    for_crossings(soup,
                  [&](std::uint32_t first, std::uint32_t second) { pairs.emplace_back(first, second); });
    std::ranges::sort(pairs);
    return pairs;
}

CrossingCount count_crossings(const TriangleSoup& soup) {
    CrossingCount count;
    for_crossings(soup, [&](std::uint32_t first, std::uint32_t second) {
        ++count.all;
        if (soup.bodies[first] != soup.bodies[second]) ++count.between_bodies;
    });
    return count;
}

namespace {

Corners3 exact_corners(const TriangleSoup& soup, std::uint32_t triangle) {
    Corners3 corners;
    for (std::size_t k = 0; k < 3; ++k) {
        const Vec3& p = soup.points[soup.triangles[triangle][k]];
        corners[k] = Eigen::Vector3f(p.x, p.y, p.z).cast<double>();
    }
    return corners;
}

double squared_distance(const Box& a, const Box& b) {
    double sum = 0;
    for (std::size_t k = 0; k < 3; ++k) {
        const double apart = std::max({0.0, static_cast<double>(a.low[k]) - static_cast<double>(b.high[k]),
                                       static_cast<double>(b.low[k]) - static_cast<double>(a.high[k])});
        sum += apart * apart;
    }
    return sum;
}

}  // namespace

// The tree skips boxes that are farther apart than the closest pair so far.
double least_gap(const TriangleSoup& soup, double bound) {
    double least = bound * bound;
    const auto near = [&](const Box& a, const Box& b) { return squared_distance(a, b) < least; };
    BoxTree(soup).pairs(near, [&](std::uint32_t first, std::uint32_t second) {
        if (soup.share_a_vertex(first, second)) return;
        const bool cross = triangles_cross(soup, first, second);
        const double apart =
            cross ? 0 : squared_distance(exact_corners(soup, first), exact_corners(soup, second));
        least = std::min(least, apart);
    });
    return std::sqrt(least);
}

}  // namespace weft::study
