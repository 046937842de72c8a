#pragma once
// Groups: cloths that are solved together in a substep, because they may touch or share a body, directly or
// through other cloths.

#include <algorithm>
#include <cstdint>
#include <span>
#include <vector>

#include "engine/joined_sets.h"
#include "weft/types.h"

namespace weft {

class GroupFinder {
  public:
    /// Reserves memory, so that searches of up to `cloths` cloths allocate none.
    void reserve(std::size_t cloths);

    /// Finds the connected components of overlapping boxes; an empty box overlaps none. may_touch(i, j),
    /// i < j, is asked of pairs whose boxes overlap, and says whether the pair counts. Sort and sweep along x
    /// (Baraff 1992, "Dynamic simulation of non-penetrating rigid bodies").
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

    /// Replace find() where the pairs are known: begin(), join() for each pair of one group, end().
    void begin(std::size_t cloths) { groups_.begin(cloths); }
    void join(std::uint32_t i, std::uint32_t j) { groups_.join(i, j); }
    void end() { groups_.finish(); }
    /// Merges other groups of the same cloths, as first_of() returns them, with the groups that were found.
    void join(std::span<const std::uint32_t> first_of);

    /// For each cloth, the first cloth of its group.
    [[nodiscard]] std::span<const std::uint32_t> first_of() const { return groups_.firsts(); }

  private:
    static bool overlap_beside_x(const Bounds& a, const Bounds& b) {
        return a.lower.y <= b.upper.y && b.lower.y <= a.upper.y && a.lower.z <= b.upper.z &&
               b.lower.z <= a.upper.z;
    }
    void sort(std::span<const Bounds> boxes);

    std::vector<std::uint32_t> order_;  // boxes by their lower end along x
    JoinedSets groups_;
};

}  // namespace weft
