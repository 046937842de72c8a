#include "cloth/solvers/linear/chebyshev.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>

#include "cloth/system/sparse/vectors.h"

namespace weft {

// T_n(c / w) = 4 at c / w = cosh(acosh(4) / n), and the interval's lower end is 2 (c - w) / (c + w).
Spectrum chebyshev_interval(int iterations, double least) {
    constexpr double reduction = 4;
    const double half_angle = std::acosh(reduction) / (2.0 * (iterations + 1));
    const double useful = largest_eigenvalue * std::pow(std::tanh(half_angle), 2);
    return {std::max(least, useful), largest_eigenvalue};
}

// Each spring adds to the diagonal at both its ends, half of that along any one direction in the plane.
double least_eigenvalue(const ClothInfo& info, const ClothSettings& settings, double area, float gamma) {
    const Fabric& fabric = settings.fabric;
    const FiniteElements& elements = settings.finite_elements;
    const auto times = [](float stiffness, std::uint32_t count) {
        return static_cast<double>(stiffness) * count;
    };
    const double stiffness = elements.enabled
                                 ? times(elements.warp + elements.weft + elements.shear, info.particles)
                                 : times(fabric.stretch, info.structural_springs) +
                                       times(fabric.shear, info.shear_springs) +
                                       times(fabric.bend, info.bend_springs);
    const double mass = static_cast<double>(fabric.areal_density) * area;
    return 1 / (1 + static_cast<double>(gamma * (gamma + fabric.damping)) * stiffness / mass);
}

float ChebyshevSteps::first() {
    ratio_ = half_width_ / centre_;
    return static_cast<float>(1 / centre_);
}

Relaxation ChebyshevSteps::next() {
    const double before = ratio_;
    ratio_ = 1 / (2 * centre_ / half_width_ - before);
    return {.step = static_cast<float>(2 * ratio_ / half_width_),
            .momentum = static_cast<float>(ratio_ * before)};
}

float solve_chebyshev(Parallel& parallel, ImplicitSystem& system, int iterations, Spectrum interval,
                      ChebyshevVectors& vectors, std::span<Vec4> dv) {
    const std::span<const Vec4> b = system.right_side().span();
    ChebyshevSteps steps(interval);
    const float first = steps.first();
    std::span<Vec4> present = dv, next = vectors.next.span();
    if (iterations % 2 == 1) std::swap(present, next);  // the last iterate comes to lie in dv
    system.precondition(parallel, b, first, present);
    const double start = norm(parallel, present, vectors.partials.span()) / static_cast<double>(first);

    clear(parallel, next);
    for (int k = 1; k < iterations; ++k) {
        system.relax(parallel, b, present, steps.next(), next);
        std::swap(present, next);
    }
    const Relaxation relaxation = steps.next();
    copy(parallel, next, vectors.before.span());
    system.relax(parallel, b, present, relaxation, next);
    std::swap(present, next);
    // Of what the last step did, all but the momentum is the preconditioned residual.
    const auto n = static_cast<std::uint32_t>(dv.size());
    const double squared = sum_over_particles(parallel, n, vectors.partials.span(), [&](std::uint32_t i) {
        const Vector4 momentum = relaxation.momentum * (load(next[i]) - load(vectors.before[i]));
        return static_cast<double>((load(present[i]) - load(next[i]) - momentum).squaredNorm());
    });
    const double residual = std::sqrt(squared) / static_cast<double>(relaxation.step);
    return start > 0 ? static_cast<float>(residual / start) : 0.0f;
}

ChebyshevSolver::ChebyshevSolver(const CookedCloth& model, const ClothSettings& settings)
    : LinearSolver(model, settings),
      vectors_(model.particle_count),
      area_(std::reduce(model.rest_area.span().begin(), model.rest_area.span().end(), 0.0)) {}

SolveResult ChebyshevSolver::solve_linear(const SolverStep& step, ImplicitSystem& system,
                                          std::span<Vec4> dv) {
    const int iterations = std::get<Chebyshev>(step.settings.method).iterations;
    const double least = least_eigenvalue(step.model.info, step.settings, area_, step.equation.gamma);
    return {.residual = solve_chebyshev(step.parallel, system, iterations,
                                        chebyshev_interval(iterations, least), vectors_, dv)};
}

bool ChebyshevSolver::solves_mean_motion_apart(const ClothSettings& settings) const {
    return std::get<Chebyshev>(settings.method).exact_mean_motion;
}

std::size_t ChebyshevSolver::bytes() const noexcept {
    return LinearSolver::bytes() + vectors_.bytes();
}

}  // namespace weft
