#include "cloth/solvers/linear/jacobi.h"

#include <utility>

#include "cloth/system/sparse/vectors.h"

namespace weft {

// Kang, eq. 7: dv_i = W_ii^-1 b_i, then dv_i <- W_ii^-1 (b_i + sum_j A_ij dv_j), in the form dv + D^-1 (b - W
// dv). Its eq. 6 drops the brackets.
float solve_jacobi(Parallel& parallel, ImplicitSystem& system, int iterations, AlignedBuffer<Vec4>& scratch,
                   std::span<double> partials, std::span<Vec4> dv) {
    const std::span<const Vec4> b = system.right_side().span();
    std::span<Vec4> present = dv, next = scratch.span();
    if (iterations % 2 == 1) std::swap(present, next);  // the last iterate comes to lie in dv
    system.precondition(parallel, b, 1.0f, present);
    if (iterations == 0) return 1;

    const double start = norm(parallel, present, partials);
    for (int k = 0; k < iterations; ++k) {
        system.relax(parallel, b, present, {}, next);
        std::swap(present, next);
    }
    // One iteration changes the iterate by its preconditioned residual.
    const double change = distance(parallel, present, next, partials);
    return start > 0 ? static_cast<float>(change / start) : 0.0f;
}

JacobiSolver::JacobiSolver(const CookedCloth& model, const ClothSettings& settings)
    : LinearSolver(model, settings),
      scratch_(model.particle_count),
      partials_(block_count(model.particle_count)) {}

SolveResult JacobiSolver::solve_linear(const SolverStep& step, ImplicitSystem& system, std::span<Vec4> dv) {
    const int iterations = std::get<Jacobi>(step.settings.method).iterations;
    return {.residual = solve_jacobi(step.parallel, system, iterations, scratch_, partials_.span(), dv)};
}

bool JacobiSolver::solves_mean_motion_apart(const ClothSettings& settings) const {
    return std::get<Jacobi>(settings.method).exact_mean_motion;
}

std::size_t JacobiSolver::bytes() const noexcept {
    return LinearSolver::bytes() + scratch_.bytes() + partials_.bytes();
}

}  // namespace weft
