#pragma once
// One implicit step as a minimisation, in double precision: the discrete model of the library, to the letter.
//
//     M (v - v_base) = gamma f(x_base + gamma v, v)
//
// is the stationary point of
//     E(v) = 1/2 |v - v_base|^2_M + U(x_base + gamma v) - gamma (gravity, air) . v + D(v)
// (Martin et al. 2011, "Example-based elastic materials", for the form). The springs' damping force c s n,
// with s = dl/dt along the direction n, has no potential. D has its force at one state, and near that state
// its slope without the part of n's rotation with s, which is not symmetric:
//     D(v) = c s0 l(v) + 1/2 gamma c (n0 . (v_j - v_i) - s0)^2
// E has the equation's residual as its gradient where s0 and n0 are those of v itself.

#include <Eigen/Dense>
#include <memory>
#include <optional>
#include <vector>

#include "cloth/equation/step_equation.h"
#include "cloth/mesh/cook.h"
#include "cloth/solver/passes/multilevel.h"
#include "cloth/solver/solver.h"
#include "demo/study/reference/exact_solve.h"

namespace weft::study {

/// A spring between two particles, the smaller index first, and the bending between them.
struct Spring {
    std::uint32_t i, j;
    double stiffness;    ///< [N/m]
    double rest_length;  ///< [m]
    double bending;      ///< weight of bending between the two [N/m]
};
[[nodiscard]] std::vector<Spring> springs_of(const ClothModel& model, const Fabric& fabric);
[[nodiscard]] std::vector<ParticlePair> pairs_of(std::span<const Spring> springs);

/// Flat vectors hold x, y, z of particle after particle.
using Flat = Eigen::VectorXd;
[[nodiscard]] Flat flat(std::span<const Vec4> values);

/// The state at which a spring's damping is evaluated.
struct DampedState {
    Eigen::Vector3d direction;  ///< n0
    double stretching;          ///< s0 [m/s]
};

/// The Hessian's stiffness of a compressed spring across its direction.
enum class Curvature {
    exact,      ///< negative: Newton's matrix, which can be indefinite
    projected,  ///< zero: Kang's safe derivative, positive definite
};

class StepFunctional {
  public:
    StepFunctional(const ClothModel& model, const StepEquation& equation);

    [[nodiscard]] std::uint32_t particles() const { return static_cast<std::uint32_t>(masses_.size()); }
    [[nodiscard]] const std::vector<Spring>& springs() const { return springs_; }
    /// Velocities at the start, from which solvers set out.
    [[nodiscard]] const Flat& start() const { return start_; }

    /// The damping states of all springs at `v`.
    [[nodiscard]] std::vector<DampedState> damped_states(const Flat& v) const;
    /// E with damping evaluated at these states.
    [[nodiscard]] double value(const Flat& v, std::span<const DampedState> damped) const;
    /// gamma f - M (v - v_base) = -dE/dv, 0 for pinned particles.
    [[nodiscard]] Flat residual(const Flat& v) const;
    /// d2E/dv2 at v; rows and columns of pinned particles are those of the identity.
    void hessian(const Flat& v, Curvature curvature, BlockMatrix& matrix) const;

  private:
    [[nodiscard]] Eigen::Vector3d separation(const Spring& spring, const Flat& v) const;

    double gamma_, damping_, air_damping_;
    Eigen::Vector3d gravity_;
    std::vector<Spring> springs_;
    std::vector<double> masses_;        // 0: pinned
    std::vector<Eigen::Vector3d> air_;  // force at the start [N]; empty: no air
    std::vector<double> air_slopes_;    // [N s/m]
    Flat start_, base_positions_, base_velocities_;
};

/// The converged step: an implicit step solved to convergence.
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
