#pragma once
// The early end of a search: compares the pairs found so far with the room in the list.

#include <atomic>
#include <cstddef>
#include <cstdint>

#include "engine/memory/scratch.h"

namespace weft {

struct FoundPairs;

/// Content of the list if a search finds more pairs than there is room for.
enum class FullList : std::uint8_t {
    has_the_first,  ///< as many pairs as there is room for
    is_empty,       ///< no pair: the search ends when the overflow is known
};

/// A crowd of n particles has n^2 pairs. A search for more pairs than there is room for counts at most as
/// many of each kind as there is room for: a block continues only while the list has room behind the pairs
/// found so far that precede its own. The moment when a block learns that the list is full depends on
/// threads. The list does not: a block ends only where every further pair of its own is certain to be left
/// out.
class ListFill {
  public:
    void lay_out(Scratch& scratch, std::size_t blocks);
    void begin(std::uint32_t blocks, std::uint32_t capacity, FullList full);

    /// Stores the numbers of pairs that `block` has found, and ends its search of those kinds whose further
    /// pairs have no room in the list. Each block is updated by one thread.
    void update(std::uint32_t block, FoundPairs& found) noexcept;

    /// Number of pairs that all blocks have found.
    [[nodiscard]] std::uint64_t found() const noexcept;

  private:
    struct Counts {
        std::atomic<std::uint64_t> vertex_triangle = 0, edge_edge = 0;
    };

    ScratchArray<Counts> counts_;  // first of all blocks together, then by block
    std::uint64_t capacity_ = 0;
    FullList full_ = FullList::has_the_first;
};

}  // namespace weft
