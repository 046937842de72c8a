#include "cloth/solver/levels/coarse_level.h"

#include <algorithm>
#include <utility>

#include "engine/vector.h"

namespace weft {

CoarseLevel::CoarseLevel(CoarseLinks& links, Interpolation interpolation, const SpringGraph& graph,
                         const Components& components)
    : interpolation_(std::move(interpolation)),
      matrix_(graph, links),
      small_components_(SmallComponents(components, links)) {
    lists_ = std::move(links.lists);
}

CoarseLevel::CoarseLevel(Constants constants)
    : lists_(std::move(constants.lists)),
      interpolation_(std::move(constants.interpolation)),
      matrix_(std::move(constants.stencil), std::move(constants.link_rows)),
      small_components_(std::move(constants.small_components)) {}

void CoarseLevel::lay_out_cycle(Scratch& scratch) {
    matrix_.lay_out_matrix(scratch);
    small_components_.lay_out(scratch);
    for (auto* vector : {&b_, &x_, &before_}) scratch.take(*vector, nodes());
    scratch.take(corrected_, pairs_.room() > 0 ? nodes() : 0);
}

CoarseLevel::Constants CoarseLevel::constant_part() const {
    return {lists_, interpolation_, matrix_.stencil, matrix_.link_rows, small_components_.components()};
}

void CoarseLevel::sum_links(Parallel& parallel, std::span<const Vec4> springs,
                            std::span<const double> constants, float constant_scale) {
    parallel.ranges(lists_.groups() * Stencil::lanes, [&](const BlockRange& range) {
        sum_springs_block(lists_, range, springs.data(), constants.data(), constant_scale, matrix_.links);
    });
}

void CoarseLevel::sum_ground(Parallel& parallel, std::span<const Vec4> diagonal,
                             std::span<const Vec4> off_diagonal) {
    SymmetricRows& rows = matrix_.ground_rows;
    rows.diagonal.clear_padding();
    rows.off_diagonal.clear_padding();
    matrix_.links.set(lists_.groups() * Stencil::lanes, {});
    restrict_to(parallel, interpolation_, diagonal, rows.diagonal.span());
    if (off_diagonal.empty())
        std::ranges::fill(rows.off_diagonal.span(), Vec4{});
    else
        restrict_to(parallel, interpolation_, off_diagonal, rows.off_diagonal.span());
}

void CoarseLevel::sum(Parallel& parallel, const CoarseLevel& finer) {
    parallel.ranges(lists_.groups() * Stencil::lanes, [&](const BlockRange& range) {
        sum_links_block(lists_, range, finer.matrix().links, matrix_.links);
    });
    const SymmetricRows& ground = finer.matrix().ground_rows;
    sum_ground(parallel, ground.diagonal.span(), ground.off_diagonal.span());
}

void CoarseLevel::add_bound_of_pairs() {
    SymmetricRows& ground = matrix_.ground_rows;
    pairs_.for_each_bound([&](std::uint32_t node, float factor, const Symmetric3& stiffness) {
        Symmetric3 sum = ground[node];
        sum.add(factor * stiffness);
        ground.set(node, sum);
    });
}

std::span<const Vec4> CoarseLevel::corrected_b() const {
    if (pairs_.rows().empty()) return b_.span();
    pairs_.correct(b_.span(), x_.span(), corrected_.span());
    return corrected_.span();
}

void CoarseLevel::finish(Parallel& parallel) {
    for (auto* vector : {&b_, &x_, &before_, &corrected_}) vector->clear_padding();
    coarse_ranges(parallel, nodes(), [&](const BlockRange& range) { finish_block(range, matrix_); });
    small_components_.factorise(parallel, matrix_, pairs_);
}

void CoarseLevel::solve_small_components(Parallel& parallel) {
    small_components_.solve(parallel, b_.span(), x_.span());
}

void CoarseLevel::subtract_product(Parallel& parallel, std::span<Vec4> remainder) const {
    const std::span<const Vec4> b = corrected_b();
    coarse_ranges(parallel, nodes(), [&](const BlockRange& range) {
        subtract_product_block(matrix_, range, b.data(), x_.data(), remainder.data());
    });
}

void CoarseLevel::relax_from_zero(Parallel& parallel, float step) {
    coarse_ranges(parallel, nodes(), [&](const BlockRange& range) {
        precondition_block(matrix_, range, b_.data(), step, x_.data());
        std::fill(before_.data() + range.begin, before_.data() + range.end, Vec4{});
    });
}

void CoarseLevel::relax(Parallel& parallel, Relaxation relaxation) {
    const std::span<const Vec4> b = corrected_b();
    coarse_ranges(parallel, nodes(), [&](const BlockRange& range) {
        relax_block(matrix_, range, b.data(), x_.data(), relaxation, before_.data());
    });
    std::swap(x_, before_);
}

std::size_t CoarseLevel::bytes() const noexcept {
    return lists_.bytes() + interpolation_.bytes() + matrix_.bytes() + small_components_.bytes();
}

}  // namespace weft
