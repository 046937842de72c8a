#pragma once
// A search's early end: how many pairs its blocks have found so far, against the room in the list.

#include <atomic>
#include <cstddef>
#include <cstdint>

#include "engine/memory/scratch.h"

namespace weft {

struct FoundPairs;

/// The list of a search that finds more pairs than there is room for.
enum class FullList : std::uint8_t {
    has_the_first,  ///< as many pairs as there is room for
    is_empty,       ///< no pair: the search ends as soon as it knows
};

/// A crowd of n particles has n^2 pairs. A search for more pairs than there is room for counts at most as
/// many of each kind as there is room for: each block looks on only while the list has room behind the pairs
/// that were found so far and go before its own. When a block learns that the list is full depends on
/// threads. The list does not: a block ends only where every further pair of its own is certain to be left
/// out.
class ListFill {
  public:
    void lay_out(Scratch& scratch, std::size_t blocks);
    void begin(std::uint32_t blocks, std::uint32_t capacity, FullList full);

    /// Stores what `block` has found, and ends the search of it for those kinds whose further pairs the list
    /// has no room for. Each block is updated by one thread.
    void update(std::uint32_t block, FoundPairs& found) noexcept;

    /// Pairs that all blocks have found.
    [[nodiscard]] std::uint64_t found() const noexcept;

  private:
    struct Counts {
        std::atomic<std::uint64_t> vertex_triangle = 0, edge_edge = 0;
    };

    ScratchArray<Counts> counts_;  // of all blocks together; then by block
    std::uint64_t capacity_ = 0;
    FullList full_ = FullList::has_the_first;
};

}  // namespace weft
