#include "cloth/implicit/coarse_level.h"

#include <utility>

#include "engine/vector.h"

namespace weft {

CoarseLevel::CoarseLevel(GalerkinLists lists, Interpolation interpolation, const SpringGraph& graph)
    : lists_(std::move(lists)),
      interpolation_(std::move(interpolation)),
      matrix_(graph, lists_.links),
      b_(graph.nodes()),
      x_(graph.nodes()),
      before_(graph.nodes()) {}

void CoarseLevel::sum_links(Parallel& parallel, std::span<const Vec4> springs) {
    parallel.ranges(static_cast<std::uint32_t>(lists_.links.size()), [&](const BlockRange& range) {
        sum_springs_block(lists_, range, springs.data(), matrix_);
    });
}

void CoarseLevel::sum(Parallel& parallel, const CoarseLevel& finer) {
    parallel.ranges(static_cast<std::uint32_t>(lists_.links.size()), [&](const BlockRange& range) {
        sum_links_block(lists_, range, finer.matrix().links.data(), matrix_);
    });
    const Interpolation& p = interpolation_;
    coarse_ranges(parallel, nodes(), [&](const BlockRange& range) {
        for (std::uint32_t c = range.begin; c < range.end; ++c) {
            Symmetric3 ground;
            for (std::uint32_t e = p.offsets[c]; e < p.offsets[c + 1]; ++e)
                ground.add_scaled(p.fine_weights[e], finer.matrix().ground_of(p.fine_nodes[e]));
            matrix_.set_ground(c, ground);
        }
    });
}

void CoarseLevel::finish(Parallel& parallel) {
    coarse_ranges(parallel, nodes(), [&](const BlockRange& range) { finish_block(range, matrix_); });
}

void CoarseLevel::subtract_product(Parallel& parallel, std::span<Vec4> remainder) const {
    coarse_ranges(parallel, nodes(), [&](const BlockRange& range) {
        subtract_product_block(matrix_, range, b_.data(), x_.data(), remainder.data());
    });
}

void CoarseLevel::relax_from_zero(Parallel& parallel, float step) {
    coarse_ranges(parallel, nodes(), [&](const BlockRange& range) {
        precondition_block(matrix_, range, b_.data(), step, x_.data());
        std::fill(before_.data() + range.begin, before_.data() + range.end, Vec4{});
    });
}

void CoarseLevel::relax(Parallel& parallel, Relaxation relaxation) {
    coarse_ranges(parallel, nodes(), [&](const BlockRange& range) {
        relax_block(matrix_, range, b_.data(), x_.data(), relaxation, before_.data());
    });
    std::swap(x_, before_);
}

std::size_t CoarseLevel::bytes() const noexcept {
    return lists_.bytes() + interpolation_.bytes() + matrix_.bytes() + b_.bytes() + x_.bytes() +
           before_.bytes();
}

}  // namespace weft
