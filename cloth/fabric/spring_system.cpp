#include "cloth/fabric/spring_system.h"

#include <algorithm>
#include <numeric>
#include <utility>

#include "cloth/equation/sparse/vectors.h"
#include "cloth/fabric/spring_forces.h"
#include "engine/memory/list_checks.h"

namespace weft {

namespace {

/// A group gets a place for each spring of its longest ring, and one for openings.
SharedBuffer<std::uint32_t> places_of(const RingOrder& order, std::uint32_t particles) {
    SharedBuffer<std::uint32_t> places(Stencil::whole_groups(particles) / Stencil::lanes + 1);
    for (std::uint32_t i = 0; i < particles; ++i) {
        std::uint32_t& end = places[i / Stencil::lanes + 1];
        end = std::max(end, order.end(i) - order.offsets[i] + 1);
    }
    std::partial_sum(places.begin(), places.end(), places.begin());
    return places;
}

/// Whether these are places of a stencil's groups, each with slots for its springs.
bool are_places(const SharedBuffer<std::uint32_t>& places, const Stencil& stencil) {
    const std::uint32_t groups = stencil.groups();
    if (places.size() != groups + 1 || !are_offsets(places.span(), groups, places[groups])) return false;
    for (std::uint32_t g = 0; g < groups; ++g) {
        const std::uint32_t slots = stencil.group_slots[g + 1] - stencil.group_slots[g];
        if (places[g + 1] == places[g] || places[g + 1] - places[g] > slots + 1) return false;
    }
    return true;
}

}  // namespace

Diagonals diagonals_of(const ClothModel& model) {
    return model.rows > 0 ? Diagonals(model.spring_offsets.span(), model.neighbours.span()) : Diagonals();
}

SpringSystem::SpringSystem(const ClothModel& model, bool stiffens)
    : ImplicitSystem(model.particle_count), model_(&model) {
    if (const Diagonals diagonals = diagonals_of(model); !diagonals.empty()) {
        Stencil no_lists;
        no_lists.nodes = model.particle_count;
        matrix_ = SpringMatrix(std::move(no_lists), {}, diagonals);
        windows_ = GridWindows(diagonals, 7);
        std::uint32_t isotropic = ~0u;
        for_each_entry(model, matrix_, [&](std::uint32_t e, std::uint32_t entry) {
            if (model.kinds[e] != SpringKind::bending)
                isotropic &= ~(1u << entry / Stencil::lanes % diagonals.count);
        });
        matrix_.set_isotropic(isotropic);
        table_ = SpringTable(model, matrix_, stiffens);
    } else {
        const RingOrder order(model);
        matrix_ = SpringMatrix(order.stencil(model), places_of(order, model.particle_count), {});
        rings_ = Rings(model, order, matrix_, stiffens);
    }
    prepare(Fabric());
    lay_out_alone();
}

SpringSystem::SpringSystem(const ClothModel& model, SavedSprings&& saved)
    : ImplicitSystem(model.particle_count),
      model_(&model),
      matrix_(std::move(saved.stencil), std::move(saved.places), saved.diagonals),
      membrane_(saved.membrane),
      table_(std::move(saved.table)),
      rings_(std::move(saved.rings)) {
    windows_ = GridWindows(matrix_.diagonals, 7);
    matrix_.set_isotropic(saved.isotropic);
}

void SpringSystem::lay_out(Scratch& scratch) {
    ImplicitSystem::lay_out(scratch);
    matrix_.lay_out(scratch);
    rings_.lay_out(scratch);
    scratch.take(positions_, rings_.empty() ? 0 : model_->particle_count);
}

std::optional<SavedSprings> SpringSystem::springs() const {
    SavedSprings saved{.stencil = matrix_.stencil,
                       .places = matrix_.group_places,
                       .membrane = membrane_,
                       .table = table_,
                       .rings = rings_,
                       .diagonals = matrix_.diagonals};
    for (std::uint32_t d = 0; d < matrix_.diagonals.count; ++d)
        saved.isotropic |= (matrix_.isotropic[d] ? 1u : 0u) << d;
    return saved;
}

bool SavedSprings::is_sound(const ClothModel& model, bool stiffens) const {
    const float numbers[] = {membrane.warp, membrane.weft, membrane.shear, membrane.stiffening};
    if (!are_from_zero(numbers)) return false;
    if (!diagonals.empty())
        return stencil.nodes == model.particle_count && stencil.neighbours.empty() && rings.empty() &&
               (isotropic & 1) == 0 && table.is_sound(entries(), spring_places(), stiffens);
    return stencil.is_sound(model.particle_count, model.neighbours.size()) && are_places(places, stencil) &&
           table.empty() && rings.is_sound(model, places[stencil.groups()], entries(), stiffens);
}

std::unique_ptr<ImplicitSystem> SpringSystem::clone(const ClothModel& model) const {
    auto made = std::make_unique<SpringSystem>(*this);
    made->model_ = &model;
    made->matrix_.contacts = nullptr;
    made->coupling_ = 0;
    return made;
}

bool SpringSystem::has_membrane_of(const Fabric& fabric) const noexcept {
    return fabric.warp == membrane_.warp && fabric.weft == membrane_.weft &&
           fabric.shear == membrane_.shear && fabric.stiffening == membrane_.stiffening &&
           membrane_.areal_density >= 0;
}

void SpringSystem::make_own(const Fabric& fabric) {
    if (has_membrane_of(fabric)) return;
    rings_.make_own();
    table_.make_own();
}

void SpringSystem::prepare(const Fabric& fabric) noexcept {
    if (has_membrane_of(fabric)) return;
    membrane_ = fabric;
    table_.set(*model_, matrix_, fabric);
    rings_.set(*model_, matrix_, fabric);
}

SpringState SpringSystem::state_at(Parallel& parallel, const StepEquation& equation,
                                   std::span<const Vec4> velocities, LinearisedAbout about) {
    prepare(equation.settings.fabric);
    const float ahead = about == LinearisedAbout::iterate ? equation.gamma : 0;
    SpringState state{.equation = equation,
                      .matrix = matrix_,
                      .table = table_,
                      .rings = rings_,
                      .bending_excess = model_->bending_excess.span(),
                      .positions = equation.base_positions,
                      .velocities = velocities,
                      .time_ahead = ahead};
    if (rings_.empty() || ahead == 0) return state;
    scale_and_add(parallel, ahead, velocities, equation.base_positions, positions_.span());
    state.positions = std::as_const(positions_).span();
    return state;
}

void SpringSystem::linearise(Parallel& parallel, const StepEquation& equation,
                             std::span<const Vec4> velocities, LinearisedAbout about) {
    const Fabric& fabric = equation.settings.fabric;
    const SpringState state = state_at(parallel, equation, velocities, about);
    const float stiffest = rings_.empty() ? table_.stiffest() + equation.rigidity * table_.stiffest_bending()
                                          : rings_.stiffest() + equation.rigidity * rings_.stiffest_bending();
    matrix_.set_unit((equation.gamma + fabric.damping) * equation.gamma * stiffest);
    constant_scale_ = (equation.gamma + fabric.damping) * equation.gamma * equation.rigidity;
    matrix_.contacts = begin_contacts(equation);
    // About the base, b contains W's slope without the coupling, so the matrix must be W alone.
    const bool is_coupled = about == LinearisedAbout::iterate && model_->rows == 0;
    coupling_ = is_coupled ? equation.gamma * equation.gamma : 0;
    blocks_in_tiles(parallel, model_->particle_count, windows_,
                    [&](const BlockRange& range, GridWindow* window) {
                        linearise_contacts(equation, velocities, range);
                        if (window == nullptr)
                            linearise_rings(state, about, range, rings_, matrix_, right_side_.data());
                        else
                            linearise_block(state, about, range, *window, matrix_, right_side_.data());
                    });
}

void SpringSystem::residual(Parallel& parallel, const StepEquation& equation,
                            std::span<const Vec4> velocities, std::span<Vec4> residual) {
    const SpringState state = state_at(parallel, equation, velocities, LinearisedAbout::iterate);
    blocks_in_tiles(parallel, model_->particle_count, windows_,
                    [&](const BlockRange& range, GridWindow* window) {
                        if (window == nullptr)
                            residual_of_rings(state, range, residual.data());
                        else
                            residual_block(state, range, *window, residual.data());
                    });
}

// The coupling of triangles' sides is no part of W. A pass without it would leave its whole residual.
Products SpringSystem::multiply_coupled_rows(const BlockRange& range, const DottedWith& with, const Vec4* x,
                                             Vec4* product, GridWindow* window) const {
    if (coupling_ == 0) return multiply_rows(range, with, x, product, window);
    return multiply_rings(matrix_, rings_, coupling_, range, with, x, product);
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
    return matrix_.bytes() + table_.bytes() + rings_.bytes();
}

}  // namespace weft
