#include "cloth/implicit/implicit_system.h"

#include <functional>
#include <numeric>
#include <vector>

#include "cloth/implicit/time_skew.h"

namespace weft {

Products ImplicitSystem::multiply(Parallel& parallel, std::span<const Vec4> b, std::span<const Vec4> x,
                                  std::span<Vec4> product) {
    return parallel.reduce(
        stencil().nodes, partial_sums_.span(), Products{},
        [&](const BlockRange& range) { return multiply_rows(range, b.data(), x.data(), product.data()); },
        std::plus<>{});
}

void ImplicitSystem::subtract_product(Parallel& parallel, std::span<const Vec4> b, std::span<const Vec4> x,
                                      std::span<Vec4> remainder) const {
    parallel.ranges(stencil().nodes, [&](const BlockRange& range) {
        subtract_product_rows(range, b.data(), x.data(), remainder.data());
    });
}

void ImplicitSystem::relax(Parallel& parallel, std::span<const Vec4> b, std::span<const Vec4> x,
                           Relaxation relaxation, std::span<Vec4> next) const {
    parallel.ranges(stencil().nodes, [&](const BlockRange& range) {
        relax_rows(range, b.data(), x.data(), relaxation, next.data());
    });
}

void ImplicitSystem::relax(Parallel& parallel, std::span<const Vec4> b, std::span<const Relaxation> steps,
                           std::span<Vec4> x, std::span<Vec4> next) const {
    Vec4* const iterates[] = {x.data(), next.data()};
    skewed_sweeps(parallel, stencil().nodes, reach(), static_cast<std::uint32_t>(steps.size()),
                  [&](std::uint32_t k, const BlockRange& range) {
                      relax_rows(range, b.data(), iterates[k % 2], steps[k], iterates[(k + 1) % 2]);
                  });
}

void ImplicitSystem::precondition(Parallel& parallel, std::span<const Vec4> b, float step,
                                  std::span<Vec4> x) const {
    parallel.ranges(stencil().nodes,
                    [&](const BlockRange& range) { precondition_rows(range, b.data(), step, x.data()); });
}

AlignedBuffer<Vec4> ImplicitSystem::all_spring_blocks(Parallel& parallel) {
    std::vector<std::uint32_t> slots(stencil().slots());
    std::iota(slots.begin(), slots.end(), 0u);
    AlignedBuffer<Vec4> blocks(stencil().neighbours.size());
    spring_blocks(parallel, slots, blocks.span());
    return blocks;
}

}  // namespace weft
