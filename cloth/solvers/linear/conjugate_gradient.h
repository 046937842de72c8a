#pragma once
// Preconditioned conjugate gradients on W dv = b.

#include <algorithm>
#include <cmath>
#include <span>
#include <utility>

#include "cloth/solvers/linear/linear_solver.h"
#include "engine/vector.h"

namespace weft {

/// The memory of one solve.
struct CgVectors {
    explicit CgVectors(std::uint32_t particles)
        : residual(particles),
          preconditioned(particles),
          direction(particles),
          product(particles),
          partials(block_count(particles)) {}
    [[nodiscard]] std::size_t bytes() const noexcept;

    AlignedBuffer<Vec4> residual, preconditioned, direction, product;  ///< r, z, p and W p
    AlignedBuffer<Products> partials;
};

// The passes over whole vectors that an iteration is made of.
/// r . z and z . z.
[[nodiscard]] Products products(Parallel& parallel, std::span<const Vec4> residual, CgVectors& vectors);
/// p = z + beta p.
void turn_direction(Parallel& parallel, float beta, CgVectors& vectors);
/// dv += alpha p.
void advance_along(Parallel& parallel, float alpha, const CgVectors& vectors, std::span<Vec4> dv);
/// r = residual - alpha W p.
void update_residual(Parallel& parallel, float alpha, std::span<const Vec4> residual, CgVectors& vectors);

struct CgResult {
    float left = 0;  ///< |P (b - W dv)| / |P b| of the last iterate that was preconditioned; 0 for b = 0
    bool ok = true;  ///< false: something was not finite
    /// b . P b: twice the energy that W says is left to lose, as far as P is W's inverse [J].
    double decrement = 0;
    double slope = 0;    ///< of the energy down the last direction, where the last step along it began
    float length = 0;    ///< of that step: dv grew by length * vectors.direction; 0: there was none
    int iterations = 0;  ///< that were begun
};

/// Conjugate gradients (Hestenes and Stiefel 1952) from 0: the solution is added to dv. precondition(r, z)
/// writes z = P r from r, of which w may be anything, P symmetric and positive definite on the free particles
/// and 0 on the pinned ones, of which nothing more is needed: a direction that is 0 there stays so (the
/// filter of Baraff and Witkin 1998). Each iteration multiplies once and preconditions once. It ends early
/// where single precision has nothing left to find; at what is not finite it gives up.
/// Unless it ended early, the last iterate that was preconditioned is the last but one.
///
/// iterations_for(decrement) says how many are wanted, up to `most`, once the first direction is known and
/// before anything is done: the direction of the call before still stands in vectors.preconditioned. If it
/// says 0, that goes back to vectors.direction, and no iteration is begun.
template <class Precondition, class IterationsFor>
CgResult conjugate_gradients(Parallel& parallel, ImplicitSystem& system, int most,
                             const Precondition& precondition, const IterationsFor& iterations_for,
                             CgVectors& vectors, std::span<Vec4> dv) {
    constexpr CgResult failed{.ok = false};
    constexpr double rounding = 1e-14;  // of r . z, relative to its first value: 1e-7 in dv
    std::span<const Vec4> residual = system.right_side().span();
    Products first, now;
    float length = 0;
    int begun = 0;
    for (int k = 0, iterations = most; k < iterations; ++k) {
        const auto multiply_direction = [&] {
            return system.multiply_coupled(parallel, residual, std::as_const(vectors.direction).span(),
                                           k + 1 == iterations ? std::span<Vec4>() : vectors.product.span());
        };
        precondition(residual, vectors.preconditioned.span());
        if (k == 0) {  // z is the direction
            std::swap(vectors.direction, vectors.preconditioned);
            first = now = multiply_direction();
            if (std::isfinite(now.b_x)) iterations = std::min(iterations_for(now.b_x), most);
            if (iterations <= 0) {
                std::swap(vectors.direction, vectors.preconditioned);
                return {};
            }
        } else {
            const double before = now.b_x;
            now = products(parallel, residual, vectors);
            turn_direction(parallel, static_cast<float>(now.b_x / before), vectors);
            length = 0;
            now.x_wx = multiply_direction().x_wx;
        }
        begun = k + 1;
        if (!std::isfinite(now.b_x)) return failed;
        if (!(now.b_x > rounding * first.b_x)) break;
        const double alpha = now.b_x / now.x_wx;
        if (std::isnan(now.x_wx)) return failed;
        if (!(now.x_wx > 0) || !std::isfinite(alpha)) break;
        length = static_cast<float>(alpha);
        advance_along(parallel, length, vectors, dv);
        if (k + 1 == iterations) break;
        update_residual(parallel, length, residual, vectors);
        residual = vectors.residual.span();
    }
    return {.left = first.x_x > 0 ? static_cast<float>(std::sqrt(now.x_x / first.x_x)) : 0.0f,
            .decrement = first.b_x,
            .slope = now.b_x,
            .length = length,
            .iterations = begun};
}
template <class Precondition>
CgResult conjugate_gradients(Parallel& parallel, ImplicitSystem& system, int iterations,
                             const Precondition& precondition, CgVectors& vectors, std::span<Vec4> dv) {
    const auto all = [=](double /*decrement*/) { return iterations; };
    return conjugate_gradients(parallel, system, iterations, precondition, all, vectors, dv);
}

/// Conjugate gradients with the block diagonal as preconditioner (Baraff and Witkin 1998).
class ConjugateGradientSolver final : public LinearSolver {
  public:
    ConjugateGradientSolver(const CookedCloth& model, const ClothSettings& settings);
    [[nodiscard]] bool serves(const ClothSettings& settings) const override {
        return std::holds_alternative<ConjugateGradient>(settings.method) && serves_system(settings);
    }
    [[nodiscard]] std::size_t bytes() const noexcept override;

  protected:
    bool solve_linear(const SolverStep& step, ImplicitSystem& system, std::span<Vec4> dv) override;

  private:
    CgVectors vectors_;
};

}  // namespace weft
