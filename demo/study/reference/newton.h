#pragma once
// Reference A: an implicit step solved to convergence.

#include <memory>
#include <optional>
#include <vector>

#include "cloth/solver/passes/multilevel.h"
#include "cloth/solver/solver.h"
#include "demo/study/reference/exact_solve.h"
#include "demo/study/reference/step_functional.h"

namespace weft::study {

struct NewtonResult {
    Flat velocities;  ///< those of the least residual
    std::vector<double>
        residuals;  ///< norm at the start, nearby if it set out from there, after each iteration
    bool converged = false;
};

/// Newton's method with line search on the functional, until the residual is below a tolerance times the
/// first. The matrix is exact where that makes it positive definite, else projected: near the solution it
/// converges quadratically, and far from it, always downhill.
class Newton {
  public:
    /// What is solved by iteration is preconditioned with the library's multigrid.
    Newton(const SolverStep& step, const StepFunctional& functional,
           std::uint32_t direct_up_to = ExactSolve::usual_limit);
    /// `nearby`: velocities from which to set out, should their residual be less than that of the start.
    [[nodiscard]] NewtonResult minimise(const SolverStep& step, const StepFunctional& functional,
                                        double tolerance, const Flat& nearby = {});

  private:
    [[nodiscard]] Flat direction(const StepFunctional& functional, const Flat& v, const Flat& residual,
                                 double left);
    void precondition_at(const SolverStep& step, const Flat& v);

    BlockMatrix matrix_;
    ExactSolve exact_solve_;
    // Only where systems are solved by iteration.
    std::unique_ptr<ImplicitSystem> system_;
    std::optional<MultigridCycle> cycle_;
    AlignedBuffer<Vec4> velocities_;
};

/// Reference A as a method of the frame, so that it meets the same wind, pins and time scheme as all others.
/// Large cloths are brought near the solution in single precision, by the library's multilevel method with
/// many passes: far from it, double precision is lost time. The largest are left there: a sheet of 64 x 64
/// is then less than a millimetre from A after 0.5 s, and after 1 s within what buckling leaves open.
class ConvergedSolver final : public Solver {
  public:
    static constexpr double converged = 1e-8;                    ///< of the first residual
    static constexpr std::uint32_t largest_for_newton = 20'000;  ///< particles

    ConvergedSolver(const ClothModel& model, const ClothSettings& settings, double tolerance = converged);
    SolveResult solve(const SolverStep& step) override;
    void inverse_mass_changed(std::uint32_t particle, std::span<const Vec4> positions) noexcept override;
    void inverse_masses_changed(std::span<const Vec4> positions) noexcept override;
    [[nodiscard]] std::size_t bytes() const noexcept override { return 0; }

  private:
    /// Velocities near the solution; none for small cloths, and where there are none.
    [[nodiscard]] Flat approach(const SolverStep& step);

    double tolerance_;
    std::unique_ptr<Newton> newton_;
    ClothSettings approach_settings_;
    std::unique_ptr<MultilevelSolver> approach_;
};

}  // namespace weft::study
