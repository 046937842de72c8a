#include "cloth/methods/fibres/fibres.h"

#include <algorithm>

#include "cloth/fabric/springs/membrane.h"

namespace weft {

namespace {

Fibres::SetSolver solver_of(const Fibres& method, FibreKind kind) {
    switch (kind) {
        case FibreKind::vertical:
            return method.vertical;
        case FibreKind::horizontal:
            return method.horizontal;
        case FibreKind::shear:
            break;
    }
    return method.shear;
}

}  // namespace

FibresSolver::FibresSolver(const ClothModel& model, const ClothSettings& settings,
                           std::span<const Vec4> positions)
    : model_(model),
      method_(std::get<Fibres>(settings.method)),
      sets_(make_fibre_sets(model)),
      occurrences_(sets_.particles.span(), model.particle_count),
      stiffness_(model.neighbours.size()),
      compliances_(sets_.rest_lengths.size()),
      displacements_(model, sets_.stand_ins),
      weights_(sets_.particles.size()),
      multipliers_(sets_.rest_lengths.size()),
      residual_(model, {}) {
    std::size_t rows = 0;
    for (const FibreSet& set : sets_.sets) {
        if (solver_of(method_, set.kind) == Fibres::SetSolver::ldlt)
            rows = std::max<std::size_t>(rows, sets_.rows[set.groups_end] - sets_.rows[set.groups_begin]);
    }
    scratch_ = AlignedBuffer<float>(rows * FibreGroup::scratch_rows * FibreSets::lanes);
    inverse_masses_changed(positions);
}

bool FibresSolver::serves(const ClothSettings& settings) const {
    const auto* const method = std::get_if<Fibres>(&settings.method);
    return method != nullptr && method->vertical == method_.vertical &&
           method->horizontal == method_.horizontal && method->shear == method_.shear;
}

void FibresSolver::inverse_mass_changed(std::uint32_t particle, std::span<const Vec4> positions) noexcept {
    for (const std::uint32_t at : occurrences_.of(particle)) weights_[at] = positions[particle].w;
}

void FibresSolver::inverse_masses_changed(std::span<const Vec4> positions) noexcept {
    for (std::uint32_t i = 0; i < positions.size(); ++i) inverse_mass_changed(i, positions);
}

void FibresSolver::find_compliances(const Fabric& fabric, float h) noexcept {
    if (fabric == fabric_ && h == h_) return;
    fabric_ = fabric;
    h_ = h;
    spring_stiffness(model_, fabric, stiffness_.span());
    constexpr float softest = 1e-20f;  // [kg]; for springs of stiffness 0
    for (std::size_t at = 0; at < compliances_.size(); ++at)
        compliances_[at] = 1 / std::max(stiffness_[sets_.half_edges[at]] * h * h, softest);
}

void FibresSolver::solve_set(const SolverStep& step, const FibreSet& set) {
    const float h = step.equation.h;
    const bool factorised =
        solver_of(std::get<Fibres>(step.settings.method), set.kind) == Fibres::SetSolver::ldlt;
    const auto blocks = static_cast<std::uint32_t>(set.blocks.size()) - 1;
    step.parallel.blocks(blocks, [&](std::uint32_t block) {
        for (std::uint32_t g = set.blocks[block]; g < set.blocks[block + 1]; ++g) {
            constexpr std::size_t lanes = FibreSets::lanes;
            const std::size_t row = sets_.rows[g], row_in_set = row - sets_.rows[set.groups_begin];
            const FibreGroup group{.rows = sets_.rows_of(g),
                                   .particles = &sets_.particles[sets_.particle_row(g) * lanes],
                                   .weights = &weights_[sets_.particle_row(g) * lanes],
                                   .rest_lengths = &sets_.rest_lengths[row * lanes],
                                   .compliances = &compliances_[row * lanes],
                                   .multipliers = &multipliers_[row * lanes],
                                   .scratch = scratch_.data() + row_in_set * FibreGroup::scratch_rows * lanes,
                                   .gamma = step.settings.fabric.damping / h,
                                   .start = displacements_.start().data(),
                                   .moved = displacements_.moved().data()};
            factorised ? solve_by_ldlt(group) : solve_by_gauss_seidel(group);
        }
    });
}

SolveResult FibresSolver::solve(const SolverStep& step) {
    const auto timer = step.timed(Stage::solve);
    find_compliances(step.settings.fabric, step.equation.h);
    displacements_.predict(step);
    std::ranges::fill(multipliers_.span(), 0.0f);
    const int iterations = std::get<Fibres>(step.settings.method).iterations;
    for (int k = 0; k < iterations; ++k)
        for (const FibreSet& set : sets_.sets) solve_set(step, set);
    displacements_.find_velocities(step);
    return {.residual = residual_(step)};
}

std::size_t FibresSolver::bytes() const noexcept {
    return sets_.bytes() + occurrences_.bytes() + displacements_.bytes() + weights_.bytes() +
           multipliers_.bytes() + scratch_.bytes() + stiffness_.bytes() + compliances_.bytes();
}

}  // namespace weft
