#include "cloth/solvers/multigrid/multilevel.h"

#include "cloth/solvers/make_system.h"

#include <algorithm>
#include <cmath>
#include <tuple>
#include <utility>

#include "cloth/system/sparse/vectors.h"

namespace weft {

// Levels depend on the mesh and on how stiff its springs are against each other, which a step at rest tells.
MultilevelSolver::MultilevelSolver(const CookedCloth& model, const ClothSettings& settings,
                                   std::span<const Vec4> positions)
    : fabric_(settings.fabric),
      elements_(settings.finite_elements),
      system_(make_system(model, settings)),
      vectors_(model.particle_count),
      partials_(block_count(model.particle_count)) {
    Parallel serial(1);
    const AlignedBuffer<Vec4> at_rest(model.particle_count);
    AlignedBuffer<Vec4> free(model.particle_count);
    for (std::uint32_t i = 0; i < model.particle_count; ++i) {
        const float mass = settings.fabric.areal_density * model.rest_area[i];
        free[i] = to_vec4(xyz(model.positions[i]), mass > 0 ? 1.0f / mass : 0.0f);
    }
    const StepEquation equation{.settings = settings,
                                .h = 1.0f / 60,
                                .gamma = 1.0f / 60,
                                .positions = free.span(),
                                .velocities = at_rest.span(),
                                .base_positions = free.span(),
                                .base_velocities = at_rest.span(),
                                .external = {}};
    system_->linearise(serial, equation, at_rest.span(), LinearisedAbout::base);
    multigrid_ = std::make_unique<Multigrid>(serial, *system_, free.span());
    multigrid_->set_pins(positions);
}

bool MultilevelSolver::serves(const ClothSettings& settings) const {
    const auto levels_of = [](const Fabric& fabric, const FiniteElements& elements) {
        return elements.enabled
                   ? std::tuple(elements.warp, elements.weft, elements.shear, elements.poisson,
                                elements.bending, fabric.damping)
                   : std::tuple(fabric.stretch, fabric.shear, fabric.bend, 0.0f, 0.0f, fabric.damping);
    };
    ClothSettings own = settings;
    own.finite_elements = elements_;
    return std::holds_alternative<Multilevel>(settings.method) && SystemKind(settings) == SystemKind(own) &&
           levels_of(settings.fabric, settings.finite_elements) == levels_of(fabric_, elements_);
}

void MultilevelSolver::inverse_mass_changed(std::uint32_t /*particle*/,
                                            std::span<const Vec4> positions) noexcept {
    multigrid_->set_pins(positions);
}

void MultilevelSolver::inverse_masses_changed(std::span<const Vec4> positions) noexcept {
    multigrid_->set_pins(positions);
}

SolveResult MultilevelSolver::solve(const SolverStep& step) {
    const auto& method = std::get<Multilevel>(step.settings.method);
    copy(step.parallel, step.equation.velocities, step.velocities);
    return method.use == Multilevel::Use::passes ? solve_in_passes(step, method)
                                                 : solve_nonlinear(step, method.iterations);
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

// Nonlinear conjugate gradients (Polak and Ribiere 1969) on the equation itself; W and its levels, made once,
// serve the preconditioner and the length of the step alone.
SolveResult MultilevelSolver::solve_nonlinear(const SolverStep& step, int iterations) {
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
        scale_and_add(parallel, static_cast<float>(length), direction.span(), 1.0f, step.velocities);
        system_->residual(parallel, step.equation, step.velocities, residual.span());
    };

    system_->residual(parallel, step.equation, step.velocities, residual.span());
    double first = 0, rho = 0;
    for (int k = 0; k < iterations; ++k) {
        cycle(step, residual.span(), preconditioned.span());
        const double new_rho = dot_of(preconditioned, residual);
        if (!std::isfinite(new_rho)) return {.ok = false};
        if (!(new_rho > 0)) break;
        if (k == 0) first = new_rho;
        // `product` holds the residual before this one.
        const double beta = k == 0 ? 0.0 : std::max(0.0, (new_rho - dot_of(preconditioned, product)) / rho);
        rho = new_rho;
        scale_and_add(parallel, 1.0f, preconditioned.span(), static_cast<float>(beta), direction.span());
        const Products along = system_->multiply(parallel, residual.span(), direction.span(), product.span());
        if (!(along.x_wx > 0)) break;
        const double slope = along.b_x, length = slope / along.x_wx;
        std::swap(residual, product);
        move(length);
        // Where the equation is stiffer along the direction than W said: back to where the secant crosses
        // zero.
        const double new_slope = dot_of(residual, direction);
        if (new_slope < -0.5 * slope) move(length * new_slope / (slope - new_slope));
    }
    return {.residual = first > 0 ? static_cast<float>(std::sqrt(rho / first)) : 0.0f};
}

// Newton's method as far as the passes go. The coarse operators are those of the first pass: the springs'
// directions, which change most, are the finest level's. All passes but the last need only be on the way, so
// one iteration each serves them.
SolveResult MultilevelSolver::solve_in_passes(const SolverStep& step, const Multilevel& method) {
    Parallel& parallel = step.parallel;
    SolveResult result;
    for (int pass = 0; pass < method.passes; ++pass) {
        {
            const auto timer = step.timed(Stage::assemble);
            linearise(step);
            if (pass == 0) build_levels(step);
        }
        const auto timer = step.timed(Stage::solve);
        result = conjugate_gradients(
            parallel, *system_, pass + 1 < method.passes ? 1 : method.iterations,
            [&](std::span<const Vec4> r, std::span<Vec4> z) { cycle(step, r, z); }, vectors_,
            step.velocities);
    }
    return result;
}

std::size_t MultilevelSolver::bytes() const noexcept {
    return system_->bytes() + (multigrid_ ? multigrid_->bytes() : 0) + vectors_.bytes() + partials_.bytes();
}

}  // namespace weft
