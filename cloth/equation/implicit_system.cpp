#include "cloth/equation/implicit_system.h"

#include <algorithm>
#include <numeric>
#include <utility>
#include <vector>

namespace weft {

void ImplicitSystem::lay_out(Scratch& scratch) {
    own_scratch_.free();
    scratch.take(right_side_, particles_);
    scratch.take(partial_sums_, block_count(particles_));
    windows_.lay_out(scratch);
}

Products ImplicitSystem::multiply_by(MultiplyRows rows, Parallel& parallel, const DottedWith& with,
                                     std::span<const Vec4> x, std::span<Vec4> product) {
    const std::uint32_t nodes = stencil().nodes;
    blocks_in_tiles(parallel, nodes, windows_, [&](const BlockRange& range, GridWindow* window) {
        partial_sums_[range.block] = (this->*rows)(range, with, x.data(), product.data(), window);
    });
    const std::span<const Products> partials = std::as_const(partial_sums_).span().first(block_count(nodes));
    return std::accumulate(partials.begin(), partials.end(), Products{});
}

Products ImplicitSystem::multiply(Parallel& parallel, const DottedWith& with, std::span<const Vec4> x,
                                  std::span<Vec4> product) {
    return multiply_by(&ImplicitSystem::multiply_rows, parallel, with, x, product);
}

Products ImplicitSystem::multiply_coupled(Parallel& parallel, const DottedWith& with, std::span<const Vec4> x,
                                          std::span<Vec4> product) {
    return multiply_by(&ImplicitSystem::multiply_coupled_rows, parallel, with, x, product);
}

void ImplicitSystem::relax(Parallel& parallel, std::span<const Vec4> b, std::span<const Vec4> x,
                           Relaxation relaxation, std::span<Vec4> next) {
    blocks_in_tiles(parallel, stencil().nodes, windows_, [&](const BlockRange& range, GridWindow* window) {
        relax_rows(range, b.data(), x.data(), relaxation, next.data(), window);
    });
}

void ImplicitSystem::precondition(Parallel& parallel, std::span<const Vec4> b, float step,
                                  std::span<Vec4> x) const {
    parallel.ranges(stencil().nodes,
                    [&](const BlockRange& range) { precondition_rows(range, b.data(), step, x.data()); });
}

void ImplicitSystem::precondition_group(std::uint32_t i, std::span<const Vec4> b, float step,
                                        std::span<Vec4> x) const {
    const std::uint32_t begin = i - i % Stencil::lanes;
    const std::uint32_t end = std::min(begin + Stencil::lanes, stencil().nodes);
    precondition_rows({.begin = begin, .end = end, .block = 0}, b.data(), step, x.data());
}

void ImplicitSystem::subtract_first_step(Parallel& parallel, std::span<const Vec4> b, float step,
                                         std::span<Vec4> x, std::span<Vec4> remainder) {
    precondition(parallel, b, step, x);
    blocks_in_tiles(parallel, stencil().nodes, windows_, [&](const BlockRange& range, GridWindow* window) {
        subtract_product_rows(range, b.data(), x.data(), remainder.data(), window);
    });
}

void ImplicitSystem::relax_corrected(Parallel& parallel, std::span<const Vec4> b, float step,
                                     std::span<Vec4> x, const Correction& correction, std::span<Vec4> next) {
    prolong_from(parallel, correction, x);
    relax(parallel, b, x, {.step = step}, next);
}

ImplicitSystem::Neighbours ImplicitSystem::neighbours_of(std::uint32_t i) const noexcept {
    const Stencil& graph = stencil();
    const std::uint32_t group = i / Stencil::lanes, slot = graph.group_slots[group];
    return {graph.neighbours.data() + std::size_t{slot} * Stencil::lanes + i % Stencil::lanes,
            graph.group_slots[group + 1] - slot, Stencil::lanes};
}

std::uint32_t ImplicitSystem::entry_between(std::uint32_t i, std::uint32_t j) const {
    const Stencil& graph = stencil();
    std::uint32_t entry = graph.group_slots[i / Stencil::lanes] * Stencil::lanes + i % Stencil::lanes;
    // The entry exists, except in a malicious file: the bound keeps the search within the row.
    const std::uint32_t last = graph.group_slots[i / Stencil::lanes + 1] * Stencil::lanes;
    while (entry + Stencil::lanes < last && graph.neighbours[entry] != j) entry += Stencil::lanes;
    return entry;
}

AlignedBuffer<Vec4> ImplicitSystem::all_spring_blocks(Parallel& parallel) {
    std::vector<std::uint32_t> slots(entries() / Stencil::lanes);
    std::iota(slots.begin(), slots.end(), 0u);
    AlignedBuffer<Vec4> blocks(entries());
    spring_blocks(parallel, slots, blocks.span());
    return blocks;
}

}  // namespace weft
