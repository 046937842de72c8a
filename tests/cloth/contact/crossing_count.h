#pragma once
// How many edges of cloths go through triangles that they share no vertex with, of one cloth or of two: every
// edge against every triangle, by signs of volumes in double precision.

#include <array>
#include <Eigen/Core>
#include <Eigen/Geometry>
#include <set>
#include <span>
#include <vector>

#include "tests/collision/contact/cuts.h"
#include "weft/weft.h"

namespace weft::test {

/// All cloths of a World as one soup.
class Soup {
  public:
    void add(const ClothView& cloth) {
        const auto first = static_cast<std::uint32_t>(points_.size());
        for (const Vec4& x : cloth.positions) points_.emplace_back(x.x, x.y, x.z);
        std::set<std::array<std::uint32_t, 2>> edges;
        for (const Triangle& t : cloth.triangles) {
            triangles_.push_back({first + t[0], first + t[1], first + t[2]});
            for (std::size_t k = 0; k < 3; ++k)
                edges.insert(
                    {first + std::min(t[k], t[(k + 1) % 3]), first + std::max(t[k], t[(k + 1) % 3])});
        }
        edges_.insert(edges_.end(), edges.begin(), edges.end());
    }
    [[nodiscard]] int crossings() const {
        int count = 0;
        for (const auto& edge : edges_)
            for (const auto& triangle : triangles_) count += crosses(edge, triangle) ? 1 : 0;
        return count;
    }

  private:
    using Corners = std::array<std::uint32_t, 3>;
    using Ends = std::array<std::uint32_t, 2>;

    [[nodiscard]] bool boxes_overlap(const Ends& e, const Corners& t) const {
        const Eigen::Vector3d lower = points_[e[0]].cwiseMin(points_[e[1]]),
                              upper = points_[e[0]].cwiseMax(points_[e[1]]);
        const Eigen::Vector3d low = points_[t[0]].cwiseMin(points_[t[1]]).cwiseMin(points_[t[2]]),
                              high = points_[t[0]].cwiseMax(points_[t[1]]).cwiseMax(points_[t[2]]);
        return (lower.array() <= high.array()).all() && (low.array() <= upper.array()).all();
    }
    [[nodiscard]] bool crosses(const Ends& e, const Corners& t) const {
        for (const std::uint32_t i : e)
            for (const std::uint32_t j : t)
                if (i == j) return false;
        if (!boxes_overlap(e, t)) return false;
        return cuts(points_[e[0]], points_[e[1]], points_[t[0]], points_[t[1]], points_[t[2]]);
    }

    std::vector<Eigen::Vector3d> points_;
    std::vector<Corners> triangles_;
    std::vector<Ends> edges_;
};

inline int crossings(const World& world, std::span<const ClothId> cloths) {
    Soup soup;
    for (const ClothId id : cloths) soup.add(world.cloth(id).value());
    return soup.crossings();
}

}  // namespace weft::test
