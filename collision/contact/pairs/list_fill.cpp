#include "collision/contact/pairs/list_fill.h"

#include <memory>
#include <span>
#include <utility>

#include "collision/contact/pairs/pair_kernels.h"

namespace weft {

namespace {

constexpr auto relaxed = std::memory_order_relaxed;

/// Stores `count` as a block's own, and adds its increase to the sum of all blocks.
void raise(std::atomic<std::uint64_t>& own, std::atomic<std::uint64_t>& all, std::uint32_t count) {
    all.fetch_add(count - own.load(relaxed), relaxed);
    own.store(count, relaxed);
}

}  // namespace

void ListFill::lay_out(Scratch& scratch, std::size_t blocks) {
    scratch.take(counts_, blocks + 1);
}

void ListFill::begin(std::uint32_t blocks, std::uint32_t capacity, FullList full) {
    for (Counts& counts : counts_.span().first(blocks + 1)) std::construct_at(&counts);
    capacity_ = capacity;
    full_ = full;
}

std::uint64_t ListFill::found() const noexcept {
    return counts_[0].vertex_triangle.load(relaxed) + counts_[0].edge_edge.load(relaxed);
}

// The list has all pairs of vertices and triangles, block by block, before all pairs of edges. Counts that
// other threads still raise are lower bounds.
void ListFill::update(std::uint32_t block, FoundPairs& found) noexcept {
    Counts &all = counts_[0], &own = counts_[block + 1];
    raise(own.vertex_triangle, all.vertex_triangle, found.vertex_triangle.count);
    raise(own.edge_edge, all.edge_edge, found.edge_edge.count);
    if (this->found() <= capacity_) return;
    if (full_ == FullList::is_empty) {
        found.vertex_triangle.enough = found.edge_edge.enough = 0;
        return;
    }
    std::uint64_t vertices = 0, edges = 0;
    for (const Counts& counts : std::as_const(counts_).span().subspan(1, block + 1)) {
        vertices += counts.vertex_triangle.load(relaxed);
        edges += counts.edge_edge.load(relaxed);
    }
    if (vertices > capacity_) found.vertex_triangle.enough = 0;
    if (all.vertex_triangle.load(relaxed) + edges > capacity_) found.edge_edge.enough = 0;
}

}  // namespace weft
