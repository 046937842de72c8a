#pragma once
// Decides which groups of cloths run side by side, each on one thread, and which run one after the other,
// each on all threads. The schedule never affects results.

#include <cstdint>
#include <span>
#include <vector>

#include "cloth/instance/cloth.h"

namespace weft {

class Schedule {
  public:
    /// Reserves memory, so that plans of up to `cloths` cloths allocate none.
    void reserve(std::size_t cloths);

    /// Plans each cloth as a group of its own.
    void plan(std::span<Cloth* const> cloths, int threads);
    /// Plans groups; first_of: for each cloth, the first cloth of its group, as GroupFinder finds it.
    void plan(std::span<Cloth* const> cloths, std::span<const std::uint32_t> first_of, int threads);

    /// Cloths that are computed together; mostly one.
    struct Group {
        std::span<Cloth* const> cloths;
        std::uint64_t work;  // particles times substeps
        std::uint32_t blocks;
        std::size_t scratch_bytes;  // of the World's scratch that it takes
        std::size_t scratch;        // of the k-th group for one thread: offset of the k-th thread's scratch
        bool is_whole;              // for one thread
    };
    [[nodiscard]] std::span<const Group> groups() const { return groups_; }
    /// Groups for one thread each, those with most scratch first: so the last to end are small, and each
    /// group of a thread fits into the memory of that thread's first.
    [[nodiscard]] std::span<const Group> side_by_side() const { return std::span(groups_).first(whole_); }
    /// Groups for all threads together.
    [[nodiscard]] std::span<const Group> in_turn() const { return std::span(groups_).subspan(whole_); }

  private:
    void share_out(int threads);

    std::vector<Cloth*> members_;            // group by group
    std::vector<std::uint32_t> own_places_;  // 0, 1, 2, ...: each cloth is the first of its group
    std::vector<std::uint32_t> next_;
    std::vector<Group> groups_;
    std::size_t whole_ = 0;
};

}  // namespace weft
