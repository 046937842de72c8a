#include "cloth/solvers/multigrid/multilevel.h"

#include "cloth/system/sparse/vectors.h"

namespace weft {

namespace {

double rest_area(const CookedCloth& model) {
    double area = 0;
    for (const float a : model.rest_area.span()) area += static_cast<double>(a);
    return area;
}

}  // namespace

MultilevelSolver::MultilevelSolver(const CookedCloth& model, const ClothSettings& settings,
                                   std::span<const Vec4> positions)
    : kind_(settings),
      system_(make_system(model, settings)),
      multigrid_(make_levels(model, *system_)),
      vectors_(model.particle_count),
      sums_(block_count(model.particle_count)),
      rest_area_(rest_area(model)),
      residual_(model, settings) {
    multigrid_->set_pins(positions);
}

bool MultilevelSolver::serves(const ClothSettings& settings) const {
    return std::holds_alternative<Multilevel>(settings.method) && SystemKind(settings) == kind_;
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
    SolveResult result = solve_in_passes(step, std::get<Multilevel>(step.settings.method));
    result.residual = residual_(step, system_.get());
    return result;
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
//
// A direction's first product b . P b is the square of Newton's decrement (Deuflhard 2004, "Newton methods
// for nonlinear problems"): what energy is left, in a metric in which a stiff spring counts no more than a
// soft one. It is known for nothing. Where it grows from pass to pass, the last step went too far; where it
// is high after the usual passes, more follow.
SolveResult MultilevelSolver::solve_in_passes(const SolverStep& step, const Multilevel& method) {
    const double mass = rest_area_ * static_cast<double>(step.settings.fabric.areal_density);
    Effort effort(method, mass, static_cast<double>(step.equation.gamma));
    do {
        {
            const auto timer = step.timed(Stage::assemble);
            linearise(step);
            if (effort.is_at_start()) build_levels(step);
        }
        const auto timer = step.timed(Stage::solve);
        const CgResult pass = take_pass(step, method, effort);
        if (!pass.ok) return {.ok = false};
        effort.add(pass);
    } while (effort.wants_another_pass());
    if (effort.is_hard()) check_last_step(step, effort);
    return {.unsolved = effort.is_unsolved()};
}

CgResult MultilevelSolver::take_pass(const SolverStep& step, const Multilevel& method, Effort& effort) {
    const auto precondition = [&](std::span<const Vec4> r, std::span<Vec4> z) { cycle(step, r, z); };
    const auto iterations_for = [&](double decrement) {
        const bool went_too_far =
            effort.has_grown(decrement) && shorten_last_step(step, effort, system_->right_side().span(),
                                                             vectors_.preconditioned.span(), true);
        return went_too_far ? 0 : effort.iterations_for(decrement);
    };
    return conjugate_gradients(step.parallel, *system_, method.iterations, precondition, iterations_for,
                               vectors_, step.velocities);
}

// A line search along the last direction, by the equation's residual where the last step ended.
bool MultilevelSolver::shorten_last_step(const SolverStep& step, Effort& effort,
                                         std::span<const Vec4> residual, std::span<const Vec4> direction,
                                         bool a_pass_follows) {
    const double slope = dot(step.parallel, residual, direction, sums_.span());
    const float back = effort.step_back(slope, a_pass_follows);
    if (back == 0) return false;
    scale_and_add(step.parallel, -back, direction, 1.0f, step.velocities);
    return true;
}

// No pass follows that would see where the last one went.
void MultilevelSolver::check_last_step(const SolverStep& step, Effort& effort) {
    constexpr int most = 3;
    const auto timer = step.timed(Stage::solve);
    for (int k = 0; k < most; ++k) {
        system_->residual(step.parallel, step.equation, step.velocities, vectors_.residual.span());
        if (!shorten_last_step(step, effort, vectors_.residual.span(), vectors_.direction.span(), false))
            return;
    }
}

std::size_t MultilevelSolver::bytes() const noexcept {
    return system_->bytes() + multigrid_->bytes() + vectors_.bytes() + sums_.bytes() + residual_.bytes();
}

}  // namespace weft
