#pragma once
// Chebyshev semi-iteration of block Jacobi on W dv = b.

#include <span>

#include "cloth/methods/linear/linear_solver.h"

namespace weft {

/// The interval in which eigenvalues of D^-1 W are assumed to lie.
struct Spectrum {
    double least, largest;
};

/// The largest eigenvalue of D^-1 W is below 2, whatever stiffness and step, since 2 D - W is positive
/// definite, and near 2 on most meshes: any smaller end diverges sooner or later.
inline constexpr double largest_eigenvalue = 2;

/// The interval [low, 2] for a count of iterations. `low` is `least`, an estimate of the least eigenvalue,
/// unless that is too low for the count: each error within the interval must shrink at least fourfold.
///
/// Why fourfold: the iteration may turn the sign of what it leaves of an error, and time steps feed a stiff
/// mode of which too much is left with the other sign. With a part p of the error left, backward Euler's step
/// of a stiff mode is x += h v, v += (1 - p)(-v - x / h). Its eigenvalues are p +- sqrt(p (p - 1)), which
/// leave the unit circle at p = -1/3. Modes below the interval are solved less, as by Jacobi's iteration.
[[nodiscard]] Spectrum chebyshev_interval(int iterations, double least);

/// Estimate of the least eigenvalue of D^-1 W: the Rayleigh quotient of a translation within the cloth's
/// plane, 1 / (1 + stiffness gamma^2 / mass), from the totals of the cloth. Precondition: area > 0 [m^2].
[[nodiscard]] double least_eigenvalue(const ClothInfo& info, const ClothSettings& settings, double area,
                                      float gamma);

/// The steps of the iteration, one after another (Golub and Varga 1961).
class ChebyshevSteps {
  public:
    explicit ChebyshevSteps(Spectrum interval)
        : centre_((interval.largest + interval.least) / 2),
          half_width_((interval.largest - interval.least) / 2) {}

    /// The first iterate is this times D^-1 b.
    [[nodiscard]] float first();
    [[nodiscard]] Relaxation next();

  private:
    double centre_, half_width_;
    double ratio_ = 0;  // T_k-1 / T_k at centre / half_width, after k steps
};

/// Leaves in dv the iterate after `iterations` steps from the first one. In an eigenvector of eigenvalue
/// lambda, this part of the error of dv = 0 is left: T_n((c - lambda) / w) / T_n(c / w), n = iterations + 1,
/// where c and w are the interval's centre and half width. Precondition: iterations >= 1.
void solve_chebyshev(Parallel& parallel, ImplicitSystem& system, int iterations, Spectrum interval,
                     std::span<Vec4> scratch, std::span<Vec4> dv);

class ChebyshevSolver final : public LinearSolver {
  public:
    ChebyshevSolver(const ClothModel& model, const ClothSettings& settings);
    ChebyshevSolver(const ChebyshevSolver& other, const ClothModel& model)
        : LinearSolver(other, model), area_(other.area_) {}
    [[nodiscard]] std::unique_ptr<Solver> clone(const ClothModel& model) const override {
        return std::make_unique<ChebyshevSolver>(*this, model);
    }
    [[nodiscard]] bool serves(const ClothSettings& settings) const override {
        return std::holds_alternative<Chebyshev>(settings.method) && serves_system(settings);
    }
    void lay_out(Scratch& scratch, std::size_t pairs) override;

  protected:
    bool solve_linear(const SolverStep& step, ImplicitSystem& system, std::span<Vec4> dv) override;
    [[nodiscard]] bool solves_mean_motion_apart(const ClothSettings& settings) const override;

  private:
    ScratchArray<Vec4> scratch_;
    double area_ = 0;  // of the cloth at rest [m^2]
};

}  // namespace weft
