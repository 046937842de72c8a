#pragma once
// Corners of a flat outline, searched by triangle.

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include <Eigen/Core>

namespace weft {

/// A k-d tree (Bentley 1975) whose corners can be removed. A search for a triangle takes time in proportion
/// to the corners in it, plus the square root of all of them for its border.
class CornerTree {
  public:
    /// Corner i lies at points[i]; the tree keeps `corners` of them. `slack`: absolute error of a coordinate
    /// that a search allows for.
    CornerTree(std::span<const Eigen::Vector2d> points, std::vector<std::uint32_t> corners, double slack);

    /// Precondition: the tree has the corner.
    void remove(std::uint32_t corner);

    /// Calls visit(corner) for all corners in the counter-clockwise triangle or within the slack of it, and
    /// for some others, until it returns true. Returns the number of nodes and corners visited.
    template <class Visit>
    std::size_t search(const std::array<Eigen::Vector2d, 3>& triangle, const Visit& visit) const {
        std::size_t looked_at = 0;
        search(triangle, visit, whole(), looked_at);
        return looked_at;
    }

  private:
    static constexpr std::size_t most_in_leaf = 8;

    struct Node {
        Eigen::Vector2d low, high;
        std::uint32_t left;  // corners of it that have not been removed
    };
    /// Node `index` holds order_[begin, end). Its children are 2 index and 2 index + 1, and share it evenly.
    struct Range {
        std::size_t index, begin, end;
        [[nodiscard]] bool is_leaf() const { return end - begin <= most_in_leaf; }
        [[nodiscard]] std::size_t middle() const { return (begin + end) / 2; }
        [[nodiscard]] Range lower() const { return {2 * index, begin, middle()}; }
        [[nodiscard]] Range upper() const { return {2 * index + 1, middle(), end}; }
    };

    [[nodiscard]] Range whole() const { return {1, 0, order_.size()}; }
    void build(const Range& range);
    [[nodiscard]] bool misses(const Node& node, const std::array<Eigen::Vector2d, 3>& triangle) const;

    template <class Visit>
    bool search(const std::array<Eigen::Vector2d, 3>& triangle, const Visit& visit, const Range& range,
                std::size_t& looked_at) const {
        ++looked_at;
        const Node& node = nodes_[range.index];
        if (node.left == 0 || misses(node, triangle)) return false;
        if (!range.is_leaf())
            return search(triangle, visit, range.lower(), looked_at) ||
                   search(triangle, visit, range.upper(), looked_at);
        looked_at += range.end - range.begin;
        for (std::size_t k = range.begin; k < range.end; ++k)
            if (place_[order_[k]] == k && visit(order_[k])) return true;
        return false;
    }

    std::span<const Eigen::Vector2d> points_;
    std::vector<std::uint32_t> order_, place_;  // place_[order_[k]] == k, but for removed corners
    std::vector<Node> nodes_;
    double slack_;
};

}  // namespace weft
