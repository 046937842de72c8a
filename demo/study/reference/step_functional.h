#pragma once
// One implicit step as a minimisation, in double precision: the discrete model of the library, to the letter.
//
//     M (v - v_base) = gamma f(x_base + gamma v, v)
//
// is the stationary point of
//     E(v) = 1/2 |v - v_base|^2_M + U(x_base + gamma v) - gamma (gravity, air) . v + 1/2 gamma (dampings)
// (Martin et al. 2011, "Example-based elastic materials", for the form). The dampings of springs act along
// directions that depend on v; E takes them as given, and E with the directions at v itself has the
// equation's residual as its gradient.

#include <Eigen/Dense>
#include <vector>

#include "cloth/cook.h"
#include "cloth/implicit/step_equation.h"
#include "demo/study/reference/block_matrix.h"

namespace weft::study {

/// A spring between two particles, the smaller first.
struct Spring {
    std::uint32_t i, j;
    double stiffness;    ///< [N/m]
    double rest_length;  ///< [m]
};
[[nodiscard]] std::vector<Spring> springs_of(const CookedCloth& model, const Fabric& fabric);
[[nodiscard]] std::vector<ParticlePair> pairs_of(std::span<const Spring> springs);

/// Flat vectors hold x, y, z of particle after particle.
using Flat = Eigen::VectorXd;
[[nodiscard]] Flat flat(std::span<const Vec4> values);

/// What the matrix takes for the stiffness of a compressed spring across its direction.
enum class Curvature {
    exact,      ///< negative: Newton's matrix, which can be indefinite
    projected,  ///< zero: Kang's safe derivative, positive definite
};

class StepFunctional {
  public:
    StepFunctional(const CookedCloth& model, const StepEquation& equation);

    [[nodiscard]] std::uint32_t particles() const { return static_cast<std::uint32_t>(masses_.size()); }
    [[nodiscard]] const std::vector<Spring>& springs() const { return springs_; }
    /// Velocities at the start, from which solvers set out.
    [[nodiscard]] const Flat& start() const { return start_; }

    /// Directions of the springs where the velocities `v` lead.
    [[nodiscard]] std::vector<Eigen::Vector3d> directions(const Flat& v) const;
    [[nodiscard]] double value(const Flat& v, std::span<const Eigen::Vector3d> damped_along) const;
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

}  // namespace weft::study
