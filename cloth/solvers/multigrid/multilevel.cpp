#include "cloth/solvers/multigrid/multilevel.h"

#include "cloth/solvers/make_system.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "cloth/system/sparse/vectors.h"

namespace weft {

MultilevelSolver::MultilevelSolver(const CookedCloth& model, const ClothSettings& settings)
    : system_(make_system(model, settings)),
      velocities_(model.particle_count),
      vectors_(model.particle_count),
      partials_(block_count(model.particle_count)) {}

void MultilevelSolver::prepare(const CookedCloth& model, const ClothSettings& settings,
                               std::span<const Vec4> positions) {
    const LevelsKey key = levels_key(settings);
    if (!multigrid_ || levels_key_ != key) multigrid_ = make_levels(model, key, *system_);
    levels_key_ = key;
    multigrid_->set_pins(positions);
}

float MultilevelSolver::solve(const SolverStep& step) {
    const auto& method = std::get<Multilevel>(step.settings.method);
    copy(step.parallel, step.equation.velocities, velocities_.span());
    const float residual = method.use == Multilevel::Use::passes ? solve_in_passes(step, method)
                                                                 : solve_nonlinear(step, method.iterations);
    scale_and_add(step.parallel, -1.0f, step.equation.velocities, velocities_.span(), step.velocity_change);
    return residual;
}

// About where inertia leads, x + gamma v: springs have turned there as far as they will in the step, which at
// the present positions they have not. One linearisation there is three times as accurate as Kang's on a
// hanging sheet.
void MultilevelSolver::linearise(const SolverStep& step) {
    system_->linearise(step.parallel, step.equation, velocities_.span(), LinearisedAbout::iterate);
}

void MultilevelSolver::build_levels(const SolverStep& step) {
    const auto timer = step.timed(Stage::coarse_operators);
    multigrid_->build(step.parallel, *system_);
}

void MultilevelSolver::cycle(const SolverStep& step, std::span<const Vec4> right_side, std::span<Vec4> x) {
    const auto timer = step.timed(Stage::cycles);
    multigrid_->cycle(step.parallel, *system_, right_side, x);
}

// Nonlinear conjugate gradients (Polak and Ribiere 1969) on the equation itself; W and its levels, made once,
// serve the preconditioner and the length of the step alone.
float MultilevelSolver::solve_nonlinear(const SolverStep& step, int iterations) {
    Parallel& parallel = step.parallel;
    {
        const auto timer = step.timed(Stage::assemble);
        linearise(step);
        build_levels(step);
    }
    const auto timer = step.timed(Stage::solve);
    auto& residual = vectors_.residual;
    auto& preconditioned = vectors_.preconditioned;
    auto& direction = vectors_.direction;
    auto& product = vectors_.product;
    const auto dot_of = [&](const AlignedBuffer<Vec4>& a, const AlignedBuffer<Vec4>& b) {
        return dot(parallel, a.span(), b.span(), partials_.span());
    };
    const auto move = [&](double length) {
        scale_and_add(parallel, static_cast<float>(length), direction.span(), 1.0f, velocities_.span());
        system_->residual(parallel, step.equation, velocities_.span(), residual.span());
    };

    system_->residual(parallel, step.equation, velocities_.span(), residual.span());
    double first = 0, rho = 0;
    for (int k = 0; k < iterations; ++k) {
        cycle(step, residual.span(), preconditioned.span());
        const double new_rho = dot_of(preconditioned, residual);
        if (!std::isfinite(new_rho)) return std::numeric_limits<float>::quiet_NaN();
        if (!(new_rho > 0)) break;
        if (k == 0) first = new_rho;
        // `product` holds the residual before this one.
        const double beta = k == 0 ? 0.0 : std::max(0.0, (new_rho - dot_of(preconditioned, product)) / rho);
        rho = new_rho;
        scale_and_add(parallel, 1.0f, preconditioned.span(), static_cast<float>(beta), direction.span());
        const Products along = system_->multiply(parallel, residual.span(), direction.span(), product.span());
        if (!(along.x_wx > 0 && along.b_x > 0)) break;  // solved to rounding
        const double slope = along.b_x, length = slope / along.x_wx;
        std::swap(residual, product);
        move(length);
        // Where the equation is stiffer along the direction than W said: back to where the secant crosses
        // zero.
        const double new_slope = dot_of(residual, direction);
        if (new_slope < -0.5 * slope) move(length * new_slope / (slope - new_slope));
    }
    return first > 0 ? static_cast<float>(std::sqrt(rho / first)) : 0.0f;
}

// Newton's method as far as the passes go. The coarse operators are those of the first pass: the springs'
// directions, which change most, are the finest level's. All passes but the last need only be on the way, so
// one iteration each serves them.
float MultilevelSolver::solve_in_passes(const SolverStep& step, const Multilevel& method) {
    Parallel& parallel = step.parallel;
    float residual = 0;
    for (int pass = 0; pass < method.passes; ++pass) {
        {
            const auto timer = step.timed(Stage::assemble);
            linearise(step);
            if (pass == 0) build_levels(step);
        }
        const auto timer = step.timed(Stage::solve);
        residual = conjugate_gradients(
            parallel, *system_, pass + 1 < method.passes ? 1 : method.iterations,
            [&](std::span<const Vec4> r, std::span<Vec4> z) { cycle(step, r, z); }, vectors_,
            velocities_.span());
    }
    return residual;
}

std::size_t MultilevelSolver::bytes() const noexcept {
    return system_->bytes() + (multigrid_ ? multigrid_->bytes() : 0) + velocities_.bytes() +
           vectors_.bytes() + partials_.bytes();
}

}  // namespace weft
