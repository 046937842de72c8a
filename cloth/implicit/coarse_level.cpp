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

void CoarseLevel::residual(Parallel& parallel, std::span<Vec4> residual) const {
    coarse_ranges(parallel, nodes(), [&](const BlockRange& range) {
        residual_block(matrix_, range, b_.data(), x_.data(), residual.data());
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

namespace {

template <class Row>
void gather(Parallel& parallel, const Interpolation& p, const Row& row, std::span<Vec4> coarse) {
    coarse_ranges(parallel, p.coarse, [&](const BlockRange& range) {
        for (std::uint32_t c = range.begin; c < range.end; ++c) {
            Vector4 sum = Vector4::Zero();
            for (std::uint32_t e = p.offsets[c]; e < p.offsets[c + 1]; ++e)
                sum += p.fine_weights[e] * row(p.fine_nodes[e]);
            store(coarse[c], sum);
        }
    });
}

}  // namespace

void restrict_to(Parallel& parallel, const Interpolation& p, std::span<const Vec4> fine,
                 std::span<Vec4> coarse) {
    gather(
        parallel, p, [&](std::uint32_t i) { return load(fine[i]); }, coarse);
}

void restrict_difference(Parallel& parallel, const Interpolation& p, std::span<const Vec4> a,
                         std::span<const Vec4> b, std::span<Vec4> coarse) {
    gather(
        parallel, p, [&](std::uint32_t i) -> Vector4 { return load(a[i]) - load(b[i]); }, coarse);
}

void prolong_from(Parallel& parallel, const Interpolation& p, std::span<const float> weights,
                  std::span<const Vec4> coarse, std::span<Vec4> fine) {
    parallel.ranges(p.fine, [&](const BlockRange& range) {
        for (std::uint32_t i = range.begin; i < range.end; ++i) {
            Vector4 sum = load(fine[i]);
            for (std::uint32_t e = Interpolation::width * i; e < Interpolation::width * (i + 1); ++e)
                sum += weights[e] * load(coarse[p.nodes[e]]);
            store(fine[i], sum);
        }
    });
}

}  // namespace weft
