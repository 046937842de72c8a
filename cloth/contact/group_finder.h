#pragma once
// Groups: the cloths that are solved together in a substep, since they may touch or share a body, directly
// or by way of others.

#include <algorithm>
#include <cstdint>
#include <span>
#include <vector>

#include "weft/types.h"

namespace weft {

class GroupFinder {
  public:
    /// Up to so many cloths are looked at without allocation.
    void reserve(std::size_t cloths);

    /// Finds the groups of boxes; an empty box touches none. may_touch(i, j), i < j, says whether a pair
    /// counts, and is asked of pairs whose boxes overlap. Sort and sweep along x (Baraff 1992, "Dynamic
    /// simulation of non-penetrating rigid bodies").
    template <class MayTouch>
    void find(std::span<const Bounds> boxes, const MayTouch& may_touch) {
        begin(boxes.size());
        sort(boxes);
        for (std::size_t k = 0; k < order_.size(); ++k) {
            const std::uint32_t i = order_[k];
            for (std::size_t next = k + 1; next < order_.size(); ++next) {
                const std::uint32_t j = order_[next];
                if (boxes[j].lower.x > boxes[i].upper.x) break;
                if (overlap_beside_x(boxes[i], boxes[j]) && may_touch(std::min(i, j), std::max(i, j)))
                    join(i, j);
            }
        }
        end();
    }

    /// In place of find(): begin, pairs of cloths that are in one group, end.
    void begin(std::size_t cloths);
    void join(std::uint32_t i, std::uint32_t j);
    void end();
    /// Joins the groups that `first_of` has of the same cloths to those that were found.
    void join(std::span<const std::uint32_t> first_of);

    /// Of each cloth, the first cloth of its group.
    [[nodiscard]] std::span<const std::uint32_t> first_of() const { return parents_; }

  private:
    static bool overlap_beside_x(const Bounds& a, const Bounds& b) {
        return a.lower.y <= b.upper.y && b.lower.y <= a.upper.y && a.lower.z <= b.upper.z &&
               b.lower.z <= a.upper.z;
    }
    void sort(std::span<const Bounds> boxes);
    std::uint32_t root(std::uint32_t cloth);

    std::vector<std::uint32_t> order_;    // by where boxes begin along x
    std::vector<std::uint32_t> parents_;  // a forest; a parent comes before its children
};

}  // namespace weft
