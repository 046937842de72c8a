#pragma once
// Kang's approximate implicit integration: a fixed number of block Jacobi iterations on W dv = b.

#include <span>

#include "cloth/solvers/linear/linear_solver.h"

namespace weft {

/// Leaves the iterate in dv. Returns |D^-1 (b - W dv)| / |D^-1 b| of the last iterate but one, which is what
/// the last iteration measures in passing; 1 for no iterations, 0 for b = 0. Precondition: partials.size() >=
/// block_count(n).
float solve_jacobi(Parallel& parallel, ImplicitSystem& system, int iterations, AlignedBuffer<Vec4>& scratch,
                   std::span<double> partials, std::span<Vec4> dv);

class JacobiSolver final : public LinearSolver {
  public:
    JacobiSolver(const CookedCloth& model, const ClothSettings& settings);
    [[nodiscard]] bool serves(const ClothSettings& settings) const override {
        return std::holds_alternative<Jacobi>(settings.method) && serves_system(settings);
    }
    [[nodiscard]] std::size_t bytes() const noexcept override;

  protected:
    SolveResult solve_linear(const SolverStep& step, ImplicitSystem& system, std::span<Vec4> dv) override;
    [[nodiscard]] bool solves_mean_motion_apart(const ClothSettings& settings) const override;

  private:
    AlignedBuffer<Vec4> scratch_;
    AlignedBuffer<double> partials_;
};

}  // namespace weft
