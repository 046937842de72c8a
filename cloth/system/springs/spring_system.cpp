#include "cloth/system/springs/spring_system.h"

#include <algorithm>

#include "cloth/system/sparse/vectors.h"
#include "cloth/system/springs/spring_forces.h"
#include "cloth/system/springs/springs.h"

namespace weft {

SpringSystem::SpringSystem(const CookedCloth& model)
    : ImplicitSystem(model.particle_count),
      model_(model),
      matrix_(model.spring_offsets.span(), model.neighbours.span()),
      kinds_(matrix_.entries()),
      rest_lengths_(matrix_.entries()) {
    windows_ = GridWindows(matrix_.diagonals, 7);
    if (windows_.empty()) positions_ = AlignedBuffer<Vec4>(model.particle_count);
    std::ranges::fill(rest_lengths_.span(), 1.0f);
    for (std::uint32_t i = 0; i < model.particle_count; ++i) {
        for (std::uint32_t e = model.spring_offsets[i]; e < model.spring_offsets[i + 1]; ++e) {
            const std::uint32_t entry = matrix_.entry(i, e, model.neighbours[e]);
            if (entry == SpringMatrix::no_entry) continue;
            rest_lengths_[entry] = model.rest_lengths[e];
            kinds_.of_entries[entry] = static_cast<std::uint8_t>(model.kinds[e]);
        }
    }
    kinds_.sum_up();
}

SpringState SpringSystem::state_at(Parallel& parallel, const StepEquation& equation,
                                   std::span<const Vec4> velocities, LinearisedAbout about) {
    const bool ahead = about == LinearisedAbout::iterate, placed = ahead && windows_.empty();
    if (placed)
        scale_and_add(parallel, equation.gamma, velocities, equation.base_positions, positions_.span());
    return {.equation = equation,
            .matrix = matrix_,
            .rest_lengths = rest_lengths_.span(),
            .kinds = kinds_,
            .stiffness = SpringStiffness(stiffnesses(equation.settings.fabric)),
            .positions = placed ? std::as_const(positions_).span() : equation.base_positions,
            .velocities = velocities,
            .time_ahead = ahead && !placed ? equation.gamma : 0};
}

void SpringSystem::linearise(Parallel& parallel, const StepEquation& equation,
                             std::span<const Vec4> velocities, LinearisedAbout about) {
    stiffness_of_kind_ = stiffnesses(equation.settings.fabric);
    const float stiffest = std::ranges::max(stiffness_of_kind_);
    matrix_.set_unit((equation.gamma + equation.settings.fabric.damping) * equation.gamma * stiffest);
    matrix_.contacts = begin_contacts(equation);
    const SpringState state = state_at(parallel, equation, velocities, about);
    blocks_in_tiles(parallel, model_.particle_count, windows_,
                    [&](const BlockRange& range, GridWindow* window) {
                        linearise_contacts(equation, velocities, range);
                        linearise_block(state, about, range, window, matrix_, right_side_.data());
                    });
}

void SpringSystem::residual(Parallel& parallel, const StepEquation& equation,
                            std::span<const Vec4> velocities, std::span<Vec4> residual) {
    const SpringState state = state_at(parallel, equation, velocities, LinearisedAbout::iterate);
    blocks_in_tiles(parallel, model_.particle_count, windows_,
                    [&](const BlockRange& range, GridWindow* window) {
                        residual_block(state, range, window, residual.data());
                    });
}

Products SpringSystem::multiply_rows(const BlockRange& range, const Vec4* b, const Vec4* x, Vec4* product,
                                     GridWindow* window) const {
    return multiply_block(matrix_, range, b, x, product, window);
}

void SpringSystem::subtract_product_rows(const BlockRange& range, const Vec4* b, const Vec4* x,
                                         Vec4* remainder, GridWindow* window) const {
    subtract_product_block(matrix_, range, b, x, remainder, window);
}

void SpringSystem::precondition_rows(const BlockRange& range, const Vec4* b, float step, Vec4* x) const {
    precondition_block(matrix_, range, b, step, x);
}

void SpringSystem::relax_rows(const BlockRange& range, const Vec4* b, const Vec4* x, Relaxation relaxation,
                              Vec4* next, GridWindow* window) const {
    relax_block(matrix_, range, b, x, relaxation, next, window);
}

void SpringSystem::subtract_first_step(Parallel& parallel, std::span<const Vec4> b, float step,
                                       std::span<Vec4> x, std::span<Vec4> remainder) {
    if (windows_.empty()) return ImplicitSystem::subtract_first_step(parallel, b, step, x, remainder);
    blocks_in_tiles(parallel, model_.particle_count, windows_,
                    [&](const BlockRange& range, GridWindow* window) {
                        subtract_first_step_block(matrix_, range, b.data(), step, remainder.data(), *window);
                    });
}

void SpringSystem::relax_corrected(Parallel& parallel, std::span<const Vec4> b, float step, std::span<Vec4> x,
                                   const Correction& correction, std::span<Vec4> next) {
    if (windows_.empty()) return ImplicitSystem::relax_corrected(parallel, b, step, x, correction, next);
    blocks_in_tiles(
        parallel, model_.particle_count, windows_, [&](const BlockRange& range, GridWindow* window) {
            relax_corrected_block(matrix_, range, b.data(), step, correction, next.data(), *window);
        });
}

// Bend springs lie along structural ones, twice as long: at less than a twentieth of their stiffness they add
// less than a fifth to what those hold in the plane. Across it, coarse motions are too long to feel them.
bool SpringSystem::is_minor(std::uint32_t i, std::uint32_t j) const {
    const auto row = model_.neighbours.span().subspan(
        model_.spring_offsets[i], model_.spring_offsets[i + 1] - model_.spring_offsets[i]);
    const auto e =
        static_cast<std::size_t>(std::ranges::find(row, j) - row.begin()) + model_.spring_offsets[i];
    const auto [stretch, shear, bend] = stiffness_of_kind_;
    return model_.kinds[e] == SpringKind::bend && bend <= 0.05f * stretch;
}

void SpringSystem::spring_blocks(Parallel& parallel, std::span<const std::uint32_t> slots,
                                 std::span<Vec4> blocks) {
    parallel.ranges(static_cast<std::uint32_t>(slots.size()), [&](const BlockRange& range) {
        unpack_block(matrix_, range, slots.data(), blocks.data());
    });
}

std::uint32_t SpringSystem::entry_between(std::uint32_t i, std::uint32_t j) const {
    return matrix_.diagonals.empty() ? ImplicitSystem::entry_between(i, j)
                                     : matrix_.diagonals.entry_between(std::min(i, j), std::max(i, j));
}

std::size_t SpringSystem::bytes() const noexcept {
    return ImplicitSystem::bytes() + matrix_.bytes() + kinds_.bytes() + rest_lengths_.bytes() +
           positions_.bytes();
}

}  // namespace weft
