#pragma once
// Which cloths are stepped side by side, each by one thread, and which one after the other, each by all
// threads. It decides when a cloth is stepped, never what comes out.

#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "cloth/frame/cloth.h"
#include "engine/slot_map.h"
#include "weft/world.h"

namespace weft {

class Schedule {
  public:
    /// Up to so many cloths are planned without allocation.
    void reserve(std::size_t cloths) { entries_.reserve(cloths); }

    void plan(SlotMap<ClothId, std::unique_ptr<Cloth>>& cloths, int threads);

    /// The work of a cloth that is planned.
    struct Entry {
        Cloth* cloth;
        std::uint64_t work;  // particles moved in a step
        bool is_whole;
    };
    /// Cloths for one thread each; the largest first, so that the last to end are small.
    [[nodiscard]] std::span<const Entry> side_by_side() const { return std::span(entries_).first(whole_); }
    /// Cloths for all threads together.
    [[nodiscard]] std::span<const Entry> in_turn() const { return std::span(entries_).subspan(whole_); }

  private:
    std::vector<Entry> entries_;
    std::size_t whole_ = 0;
};

}  // namespace weft
