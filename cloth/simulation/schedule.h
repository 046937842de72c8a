#pragma once
// Which cloths are taken side by side, each by one thread, and which one after the other, each by all
// threads. It decides when a cloth is worked on, never what comes out.

#include <cstdint>
#include <span>
#include <vector>

#include "cloth/instance/cloth.h"

namespace weft {

class Schedule {
  public:
    /// Up to so many cloths are planned without allocation.
    void reserve(std::size_t cloths);

    /// Each cloth for itself.
    void plan(std::span<Cloth* const> cloths, int threads);
    /// Groups: the first cloth of each cloth's group, as GroupFinder finds them.
    void plan(std::span<Cloth* const> cloths, std::span<const std::uint32_t> first_of, int threads);

    /// Cloths that are taken together; mostly one.
    struct Group {
        std::span<Cloth* const> cloths;
        std::uint64_t work;  // particles moved in a step
        std::uint32_t blocks;
        std::size_t scratch_bytes;  // that it takes of the World's
        std::size_t scratch;        // of the k-th for one thread: where the part of the k-th thread begins
        bool is_whole;
    };
    [[nodiscard]] std::span<const Group> groups() const { return groups_; }
    /// For one thread each; the largest first, so that the last to end are small, and what a thread takes
    /// lies in the memory of its first.
    [[nodiscard]] std::span<const Group> side_by_side() const { return std::span(groups_).first(whole_); }
    /// For all threads together.
    [[nodiscard]] std::span<const Group> in_turn() const { return std::span(groups_).subspan(whole_); }

  private:
    void share_out(int threads);

    std::vector<Cloth*> members_;            // group by group
    std::vector<std::uint32_t> own_places_;  // each cloth's, which is the first of its own group
    std::vector<std::uint32_t> next_;
    std::vector<Group> groups_;
    std::size_t whole_ = 0;
};

}  // namespace weft
