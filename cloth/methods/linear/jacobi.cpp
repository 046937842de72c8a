#include "cloth/methods/linear/jacobi.h"

#include <utility>

namespace weft {

// Kang, eq. 7: dv_i = W_ii^-1 b_i, then dv_i <- W_ii^-1 (b_i + sum_j A_ij dv_j), in the form dv + D^-1 (b - W
// dv). Its eq. 6 drops the brackets.
void solve_jacobi(Parallel& parallel, ImplicitSystem& system, int iterations, std::span<Vec4> scratch,
                  std::span<Vec4> dv) {
    const std::span<const Vec4> b = system.right_side().span();
    std::span<Vec4> present = dv, next = scratch;
    if (iterations % 2 == 1) std::swap(present, next);  // so that the last iterate is in dv
    system.precondition(parallel, b, 1.0f, present);
    for (int k = 0; k < iterations; ++k) {
        system.relax(parallel, b, present, {}, next);
        std::swap(present, next);
    }
}

JacobiSolver::JacobiSolver(const ClothModel& model, const ClothSettings& settings)
    : LinearSolver(model, settings) {}

bool JacobiSolver::solve_linear(const SolverStep& step, ImplicitSystem& system, std::span<Vec4> dv) {
    solve_jacobi(step.parallel, system, std::get<Jacobi>(step.settings.method).iterations, scratch_.span(),
                 dv);
    return true;
}

bool JacobiSolver::solves_mean_motion_apart(const ClothSettings& settings) const {
    return std::get<Jacobi>(settings.method).exact_mean_motion;
}

void JacobiSolver::lay_out(Scratch& scratch, std::size_t pairs) {
    LinearSolver::lay_out(scratch, pairs);
    scratch.take(scratch_, particles());
}

}  // namespace weft
