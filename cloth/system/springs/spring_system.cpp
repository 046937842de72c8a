#include "cloth/system/springs/spring_system.h"

#include <algorithm>
#include <utility>

#include "cloth/system/sparse/vectors.h"
#include "cloth/system/springs/spring_forces.h"
#include "cloth/system/springs/springs.h"

namespace weft {

SpringSystem::SpringSystem(const ClothModel& model, bool stiffens)
    : ImplicitSystem(model.particle_count),
      model_(&model),
      matrix_(model.spring_offsets.span(), model.neighbours.span()),
      table_(model, matrix_, stiffens) {
    windows_ = GridWindows(matrix_.diagonals, 7);
    if (model.rows == 0) coupling_ = MembraneCoupling(model, matrix_, stiffens);
    if (windows_.empty() || !coupling_.empty()) positions_ = AlignedBuffer<Vec4>(model.particle_count);
    if (const std::uint32_t count = matrix_.diagonals.count; count > 0) {
        matrix_.isotropic.fill(true);
        for_each_entry(model, matrix_, [&](std::uint32_t e, std::uint32_t entry) {
            if (model.kinds[e] != SpringKind::bending)
                matrix_.isotropic[entry / Stencil::lanes % count] = false;
        });
    }
    prepare(Fabric());
}

SpringSystem::SpringSystem(const ClothModel& model, SavedSprings&& saved)
    : ImplicitSystem(model.particle_count, unmade),
      model_(&model),
      matrix_(std::move(saved.stencil), saved.diagonals, unmade),
      table_(std::move(saved.table)),
      coupling_(model.rows == 0 ? std::move(saved.coupling) : MembraneCoupling()) {
    windows_ = GridWindows(matrix_.diagonals, 7);
    if (model.rows == 0) coupling_.complete(model, unmade);
    if (windows_.empty() || !coupling_.empty())
        positions_ = AlignedBuffer<Vec4>(model.particle_count, unmade);
    for (std::uint32_t d = 0; d < matrix_.diagonals.count; ++d)
        matrix_.isotropic[d] = (saved.isotropic >> d & 1) != 0;
}

std::optional<SavedSprings> SpringSystem::springs() const {
    SavedSprings saved;
    saved.stencil = matrix_.stencil;
    saved.table = table_;
    saved.coupling = coupling_;
    saved.diagonals = matrix_.diagonals;
    for (std::uint32_t d = 0; d < matrix_.diagonals.count; ++d)
        saved.isotropic |= (matrix_.isotropic[d] ? 1u : 0u) << d;
    return saved;
}

bool SavedSprings::is_sound(const ClothModel& model, bool stiffens) const {
    const bool has_lists = diagonals.empty()
                               ? stencil.is_sound(model.particle_count, model.neighbours.size())
                               : stencil.nodes == model.particle_count && stencil.neighbours.empty();
    return has_lists && table.is_sound(entries(), stiffens && model.rows > 0) &&
           (model.rows == 0 ? coupling.is_sound(model, entries(), stiffens) : true);
}

std::unique_ptr<ImplicitSystem> SpringSystem::clone(const ClothModel& model) const {
    auto made = std::make_unique<SpringSystem>(*this);
    made->model_ = &model;
    made->matrix_.contacts = nullptr;
    made->linearised_at_ = {};
    return made;
}

void SpringSystem::make_own(const Fabric& fabric) {
    if (table_.has_membrane_of(fabric)) return;
    coupling_.make_own();
    table_.make_own(fabric);
}

void SpringSystem::prepare(const Fabric& fabric) noexcept {
    if (!table_.set(*model_, matrix_, fabric)) return;
    coupling_.set(*model_, matrix_, table_);
}

SpringState SpringSystem::state_at(Parallel& parallel, const StepEquation& equation,
                                   std::span<const Vec4> velocities, LinearisedAbout about) {
    const bool ahead = about == LinearisedAbout::iterate, placed = ahead && positions_.size() > 0;
    if (placed)
        scale_and_add(parallel, equation.gamma, velocities, equation.base_positions, positions_.span());
    const std::span<const Vec4> positions =
        placed ? std::as_const(positions_).span() : equation.base_positions;
    prepare(equation.settings.fabric);
    if (!coupling_.empty()) coupling_.compute(parallel, positions);
    return {.equation = equation,
            .matrix = matrix_,
            .table = table_,
            .coupling = coupling_,
            .bending_excess = model_->bending_excess.span(),
            .positions = positions,
            .velocities = velocities,
            .time_ahead = ahead && !placed ? equation.gamma : 0};
}

void SpringSystem::linearise(Parallel& parallel, const StepEquation& equation,
                             std::span<const Vec4> velocities, LinearisedAbout about) {
    const Fabric& fabric = equation.settings.fabric;
    const SpringState state = state_at(parallel, equation, velocities, about);
    const float stiffest =
        table_.stiffest() + coupling_.stiffest_extra() + equation.rigidity * table_.stiffest_bending();
    matrix_.set_unit((equation.gamma + fabric.damping) * equation.gamma * stiffest);
    constant_scale_ = (equation.gamma + fabric.damping) * equation.gamma * equation.rigidity;
    matrix_.contacts = begin_contacts(equation);
    // About the base the right side has W's slope, and the matrix must, too.
    linearised_at_ = about == LinearisedAbout::iterate ? state.positions : std::span<const Vec4>();
    elastic_ = equation.gamma * equation.gamma;
    blocks_in_tiles(parallel, model_->particle_count, windows_,
                    [&](const BlockRange& range, GridWindow* window) {
                        linearise_contacts(equation, velocities, range);
                        linearise_block(state, about, range, window, matrix_, right_side_.data());
                    });
}

void SpringSystem::residual(Parallel& parallel, const StepEquation& equation,
                            std::span<const Vec4> velocities, std::span<Vec4> residual) {
    const SpringState state = state_at(parallel, equation, velocities, LinearisedAbout::iterate);
    blocks_in_tiles(parallel, model_->particle_count, windows_,
                    [&](const BlockRange& range, GridWindow* window) {
                        residual_block(state, range, window, residual.data());
                    });
}

Products SpringSystem::multiply_rows(const BlockRange& range, const DottedWith& with, const Vec4* x,
                                     Vec4* product, GridWindow* window) const {
    return multiply_block(matrix_, range, with, x, product, window);
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
    blocks_in_tiles(parallel, model_->particle_count, windows_,
                    [&](const BlockRange& range, GridWindow* window) {
                        subtract_first_step_block(matrix_, range, b.data(), step, remainder.data(), *window);
                    });
}

void SpringSystem::relax_corrected(Parallel& parallel, std::span<const Vec4> b, float step, std::span<Vec4> x,
                                   const Correction& correction, std::span<Vec4> next) {
    if (windows_.empty()) return ImplicitSystem::relax_corrected(parallel, b, step, x, correction, next);
    blocks_in_tiles(
        parallel, model_->particle_count, windows_, [&](const BlockRange& range, GridWindow* window) {
            relax_corrected_block(matrix_, range, b.data(), step, correction, next.data(), *window);
        });
}

// What triangles' sides do to one another: without it a pass would leave as much of that as it found.
double SpringSystem::add_coupling(Parallel& parallel, std::span<const Vec4> x, std::span<Vec4> product) {
    if (coupling_.empty() || linearised_at_.empty()) return 0;
    const double sum = coupling_.stiffen(parallel, linearised_at_, x);
    if (!product.empty()) {
        parallel.ranges(model_->particle_count, [&](const BlockRange& range) {
            for (std::uint32_t i = range.begin; i < range.end; ++i)
                if (matrix_.row_sums[i] != 0) coupling_.add_forces(i, elastic_, product[i]);
        });
    }
    return static_cast<double>(elastic_) * sum;
}

float SpringSystem::constant_block(std::uint32_t i, std::uint32_t j) const {
    const std::uint32_t e = half_edge_between(*model_, i, j);
    return model_->kinds[e] == SpringKind::bending ? model_->bending[e] : 0.0f;
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
    return ImplicitSystem::bytes() + matrix_.bytes() + table_.bytes() + coupling_.bytes() +
           positions_.bytes();
}

}  // namespace weft
