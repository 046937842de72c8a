#include "cloth/solvers/multigrid/multilevel.h"

#include "cloth/system/sparse/vectors.h"

namespace weft {

MultilevelSolver::MultilevelSolver(const CookedCloth& model, const ClothSettings& settings,
                                   std::span<const Vec4> positions)
    : kind_(settings),
      levels_key_(levels_key(settings)),
      system_(make_system(model, settings)),
      multigrid_(make_levels(model, levels_key_, *system_)),
      vectors_(model.particle_count),
      residual_(model, settings) {
    multigrid_->set_pins(positions);
}

bool MultilevelSolver::serves(const ClothSettings& settings) const {
    return std::holds_alternative<Multilevel>(settings.method) && SystemKind(settings) == kind_ &&
           levels_key(settings) == levels_key_;
}

void MultilevelSolver::reserve_pins(std::size_t count) {
    multigrid_->reserve_pins(count);
}

void MultilevelSolver::inverse_mass_changed(std::uint32_t particle,
                                            std::span<const Vec4> positions) noexcept {
    if (positions[particle].w == 0)
        multigrid_->pin(particle);
    else
        multigrid_->unpin(particle);
}

void MultilevelSolver::inverse_masses_changed(std::span<const Vec4> positions) noexcept {
    multigrid_->set_pins(positions);
}

SolveResult MultilevelSolver::solve(const SolverStep& step) {
    copy(step.parallel, step.equation.velocities, step.velocities);
    const bool ok = solve_in_passes(step, std::get<Multilevel>(step.settings.method));
    return {.residual = residual_(step, system_.get()), .ok = ok};
}

// About where inertia leads, x + gamma v: springs have turned there as far as they will in the step, which at
// the present positions they have not. One linearisation there is three times as accurate as Kang's on a
// hanging sheet.
void MultilevelSolver::linearise(const SolverStep& step) {
    system_->linearise(step.parallel, step.equation, step.velocities, LinearisedAbout::iterate);
}

void MultilevelSolver::build_levels(const SolverStep& step) {
    const auto timer = step.timed(Stage::coarse_operators);
    multigrid_->build(step.parallel, *system_);
}

void MultilevelSolver::cycle(const SolverStep& step, std::span<const Vec4> right_side, std::span<Vec4> x) {
    const auto timer = step.timed(Stage::cycles);
    multigrid_->cycle(step.parallel, *system_, right_side, x);
}

// Newton's method as far as the passes go. The coarse operators are those of the first pass: the springs'
// directions, which change most, are the finest level's. All passes but the last need only be on the way, so
// one iteration each serves them.
bool MultilevelSolver::solve_in_passes(const SolverStep& step, const Multilevel& method) {
    Parallel& parallel = step.parallel;
    bool ok = true;
    for (int pass = 0; ok && pass < method.passes; ++pass) {
        {
            const auto timer = step.timed(Stage::assemble);
            linearise(step);
            if (pass == 0) build_levels(step);
        }
        const auto timer = step.timed(Stage::solve);
        ok = conjugate_gradients(
                 parallel, *system_, pass + 1 < method.passes ? 1 : method.iterations,
                 [&](std::span<const Vec4> r, std::span<Vec4> z) { cycle(step, r, z); }, vectors_,
                 step.velocities)
                 .ok;
    }
    return ok;
}

std::size_t MultilevelSolver::bytes() const noexcept {
    return system_->bytes() + multigrid_->bytes() + vectors_.bytes() + residual_.bytes();
}

}  // namespace weft
