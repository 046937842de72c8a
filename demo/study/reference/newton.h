#pragma once
// The converged step: an implicit step solved to convergence.

#include <memory>
#include <optional>
#include <vector>

#include "cloth/solver/passes/multilevel.h"
#include "cloth/solver/solver.h"
#include "demo/study/reference/exact_solve.h"
#include "demo/study/reference/step_functional.h"

namespace weft::study {

struct NewtonResult {
    Flat velocities;                ///< velocities of the least residual
    std::vector<double> residuals;  ///< norms: at the start, at `nearby` if used, after each iteration
    bool converged = false;
};

/// Newton's method with line search on the functional, until the residual is below a tolerance times the
/// first. The Hessian is exact where that is positive definite, otherwise projected. So convergence is
/// quadratic near the solution, and steps far from it go downhill.
class Newton {
  public:
    /// Systems of more than `direct_up_to` particles are preconditioned with the library's multigrid.
    Newton(const SolverStep& step, const StepFunctional& functional,
           std::uint32_t direct_up_to = ExactSolve::usual_limit);
    /// `nearby`: velocities to start from, if their residual is less than that of the step's start.
    [[nodiscard]] NewtonResult minimise(const SolverStep& step, const StepFunctional& functional,
                                        double tolerance, const Flat& nearby = {});

  private:
    [[nodiscard]] Flat direction(const StepFunctional& functional, const Flat& v, const Flat& residual,
                                 double left);
    void precondition_at(const SolverStep& step, const Flat& v);

    BlockMatrix matrix_;
    ExactSolve exact_solve_;
    // The preconditioner, only where systems are solved by iteration.
    std::unique_ptr<ImplicitSystem> system_;
    std::optional<MultigridCycle> cycle_;
    AlignedBuffer<Vec4> velocities_;
};

/// The converged step as a solver of the library's step, with the same wind, pins and time scheme as all
/// others. Large cloths approach the solution in single precision first, by the library's multilevel method
/// with many passes: far from it, double precision is lost time. The largest stop there: a sheet of 64 x 64
/// is then less than a millimetre from convergence after 0.5 s, and after 1 s within what buckling leaves
/// open.
class ConvergedSolver final : public Solver {
  public:
    static constexpr double converged = 1e-8;                    ///< residual over the first residual
    static constexpr double air_tolerance = 1e-6;                ///< change of velocities over themselves
    static constexpr std::uint32_t largest_for_newton = 20'000;  ///< particles

    ConvergedSolver(const ClothModel& model, const ClothSettings& settings);
    SolveResult solve(const SolverStep& step) override;
    void inverse_mass_changed(std::uint32_t particle, std::span<const Vec4> positions) noexcept override;
    void inverse_masses_changed(std::span<const Vec4> positions) noexcept override;
    [[nodiscard]] std::size_t bytes() const noexcept override { return 0; }

  private:
    /// Velocities near the solution; none for small cloths, and none if the multilevel method fails.
    [[nodiscard]] Flat approach(const SolverStep& step);

    std::unique_ptr<Newton> newton_;
    ClothSettings approach_settings_;
    std::unique_ptr<MultilevelSolver> approach_;
};

}  // namespace weft::study
