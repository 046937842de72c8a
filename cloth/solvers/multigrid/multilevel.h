#pragma once
// The multilevel method: a multigrid cycle as preconditioner, of a nonlinear conjugate gradient or of linear
// passes.

#include <memory>

#include "cloth/solvers/linear/conjugate_gradient.h"
#include "cloth/solvers/multigrid/levels.h"
#include "cloth/solvers/multigrid/multigrid.h"
#include "cloth/solvers/solver.h"
#include "cloth/system/implicit_system.h"

namespace weft {

class MultilevelSolver final : public Solver {
  public:
    MultilevelSolver(const CookedCloth& model, const ClothSettings& settings);
    float solve(const SolverStep& step) override;
    void prepare(const CookedCloth& model, const ClothSettings& settings,
                 std::span<const Vec4> positions) override;
    [[nodiscard]] std::size_t bytes() const noexcept override;

  private:
    float solve_nonlinear(const SolverStep& step, int iterations);
    float solve_in_passes(const SolverStep& step, const Multilevel& method);
    void linearise(const SolverStep& step);
    void build_levels(const SolverStep& step);
    void cycle(const SolverStep& step, std::span<const Vec4> right_side, std::span<Vec4> x);

    std::unique_ptr<ImplicitSystem> system_;
    LevelsKey levels_key_;
    std::unique_ptr<Multigrid> multigrid_;  // made by the first prepare
    AlignedBuffer<Vec4> velocities_;        // the iterate
    CgVectors vectors_;
    AlignedBuffer<double> partials_;
};

}  // namespace weft
