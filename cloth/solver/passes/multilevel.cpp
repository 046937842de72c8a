#include "cloth/solver/passes/multilevel.h"

#include <utility>

#include "cloth/equation/sparse/vectors.h"
#include "cloth/mesh/model_totals.h"

namespace weft {

MultilevelSolver::MultilevelSolver(const ClothModel& model, const ClothSettings& settings,
                                   std::span<const Vec4> positions, SavedLevels* saved)
    : kind_(settings),
      system_(saved != nullptr && saved->springs
                  ? std::make_unique<SpringSystem>(model, std::move(*saved->springs))
                  : make_system(model, settings)),
      multigrid_(make_levels(model, *system_, saved)),
      pieces_(model),
      rest_area_(rest_area(model)),
      residual_(model, settings) {
    multigrid_->set_pins(positions);
}

MultilevelSolver::MultilevelSolver(const MultilevelSolver& other, const ClothModel& model)
    : kind_(other.kind_),
      system_(other.system_->clone(model)),
      multigrid_(std::make_unique<Multigrid>(*other.multigrid_, *system_)),
      pieces_(model),
      rest_area_(other.rest_area_),
      residual_(other.residual_, model) {}

void MultilevelSolver::lay_out(Scratch& scratch, std::size_t pairs) {
    Solver::lay_out(scratch, pairs);
    system_->lay_out(scratch);
    vectors_.lay_out(scratch, pieces_.particles());
    multigrid_->lay_out(scratch, pairs, [&] { vectors_.lay_out_later(scratch, pieces_.particles()); });
    residual_.lay_out(scratch);
}

bool MultilevelSolver::serves(const ClothSettings& settings) const {
    return std::holds_alternative<Multilevel>(settings.method) && SystemKind(settings) == kind_;
}

void MultilevelSolver::inverse_mass_changed(std::uint32_t particle,
                                            std::span<const Vec4> positions) noexcept {
    if (positions[particle].w == 0)
        multigrid_->pin(particle);
    else
        multigrid_->unpin(particle);
}

void MultilevelSolver::reserve_pairs(std::size_t count) {
    pieces_.reserve_pairs(count);
}

PassMember MultilevelSolver::member(const SolverStep& step, const CommonLevels& sewn) noexcept {
    return {.step = step,
            .system = *system_,
            .levels = sewn.levels ? *sewn.levels : *multigrid_,
            .part = sewn.part,
            .vectors = vectors_,
            .pieces = pieces_,
            .residual = residual_,
            .mass = rest_area_ * static_cast<double>(step.settings.fabric.areal_density)};
}

SolveResult MultilevelSolver::solve(const SolverStep& step) {
    const PassMember alone = member(step, {});
    float residual = 0;
    return solve_by_passes(std::span(&alone, 1), std::span(&residual, 1));
}

std::span<const Vec4> MultilevelSolver::left_to_contact(const SolverStep& step) {
    StepEquation without = step.equation;
    without.contacts = nullptr;
    without.pairs = nullptr;
    system_->residual(step.parallel, without, step.velocities, vectors_.correction.span());
    return std::as_const(vectors_.correction).span();
}

std::size_t MultilevelSolver::bytes() const noexcept {
    return system_->bytes() + multigrid_->bytes() + pieces_.bytes();
}

}  // namespace weft
