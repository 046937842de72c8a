#include "cloth/methods/linear/chebyshev.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>

#include "cloth/equation/sparse/vectors.h"

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
    const auto times = [](float stiffness, std::uint32_t count) {
        return static_cast<double>(stiffness) * count;
    };
    const double stiffness = settings.finite_elements.enabled
                                 ? times(fabric.warp + fabric.weft + fabric.shear, info.particles)
                                 : times(0.5f * (fabric.warp + fabric.weft), info.structural_springs) +
                                       times(fabric.shear, info.shear_springs);
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

void solve_chebyshev(Parallel& parallel, ImplicitSystem& system, int iterations, Spectrum interval,
                     std::span<Vec4> scratch, std::span<Vec4> dv) {
    const std::span<const Vec4> b = system.right_side().span();
    ChebyshevSteps steps(interval);
    std::span<Vec4> present = dv, next = scratch;
    if (iterations % 2 == 1) std::swap(present, next);  // so that the last iterate is in dv
    system.precondition(parallel, b, steps.first(), present);
    clear(parallel, next);
    for (int k = 0; k < iterations; ++k) {
        system.relax(parallel, b, present, steps.next(), next);
        std::swap(present, next);
    }
}

ChebyshevSolver::ChebyshevSolver(const ClothModel& model, const ClothSettings& settings)
    : LinearSolver(model, settings),
      area_(std::reduce(model.rest_area.span().begin(), model.rest_area.span().end(), 0.0)) {}

bool ChebyshevSolver::solve_linear(const SolverStep& step, ImplicitSystem& system, std::span<Vec4> dv) {
    const int iterations = std::get<Chebyshev>(step.settings.method).iterations;
    const double least = least_eigenvalue(step.model.info, step.settings, area_, step.equation.gamma);
    solve_chebyshev(step.parallel, system, iterations, chebyshev_interval(iterations, least), scratch_.span(),
                    dv);
    return true;
}

bool ChebyshevSolver::solves_mean_motion_apart(const ClothSettings& settings) const {
    return std::get<Chebyshev>(settings.method).exact_mean_motion;
}

void ChebyshevSolver::lay_out(Scratch& scratch, std::size_t pairs) {
    LinearSolver::lay_out(scratch, pairs);
    scratch.take(scratch_, particles());
}

}  // namespace weft
