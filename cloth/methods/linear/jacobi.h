#pragma once
// Kang's approximate implicit integration: a fixed number of block Jacobi iterations on W dv = b.

#include <span>

#include "cloth/methods/linear/linear_solver.h"

namespace weft {

/// Leaves in dv the iterate after `iterations` steps from the first one, D^-1 b.
void solve_jacobi(Parallel& parallel, ImplicitSystem& system, int iterations, std::span<Vec4> scratch,
                  std::span<Vec4> dv);

class JacobiSolver final : public LinearSolver {
  public:
    JacobiSolver(const ClothModel& model, const ClothSettings& settings);
    JacobiSolver(const JacobiSolver& other, const ClothModel& model) : LinearSolver(other, model) {}
    [[nodiscard]] std::unique_ptr<Solver> clone(const ClothModel& model) const override {
        return std::make_unique<JacobiSolver>(*this, model);
    }
    [[nodiscard]] bool serves(const ClothSettings& settings) const override {
        return std::holds_alternative<Jacobi>(settings.method) && serves_system(settings);
    }
    void lay_out(Scratch& scratch, std::size_t pairs) override;

  protected:
    bool solve_linear(const SolverStep& step, ImplicitSystem& system, std::span<Vec4> dv) override;
    [[nodiscard]] bool solves_mean_motion_apart(const ClothSettings& settings) const override;

  private:
    ScratchArray<Vec4> scratch_;
};

}  // namespace weft
