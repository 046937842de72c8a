#pragma once
// Preconditioned conjugate gradients on W dv = b.

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

/// Conjugate gradients (Hestenes and Stiefel 1952) from 0: the solution is added to dv. precondition(r, z)
/// writes z = P r from r, of which w may be anything, P symmetric and positive definite on the free particles
/// and 0 on the pinned ones, of which nothing more is needed: a direction that is 0 there stays so (the
/// filter of Baraff and Witkin 1998). Each iteration multiplies once and preconditions once. It ends early
/// where single precision has nothing left to find; at what is not finite it gives up, and the result is not
/// ok. Its residual is |P (b - W dv)| / |P b| of the last iterate that was preconditioned: the last but one,
/// unless it ended early; 0 for b = 0.
template <class Precondition>
SolveResult conjugate_gradients(Parallel& parallel, ImplicitSystem& system, int iterations,
                                const Precondition& precondition, CgVectors& vectors, std::span<Vec4> dv) {
    constexpr SolveResult failed{.ok = false};
    constexpr double rounding = 1e-14;  // of r . z, relative to its first value: 1e-7 in dv
    std::span<const Vec4> residual = system.right_side().span();
    Products first, now;
    for (int k = 0; k < iterations; ++k) {
        const bool is_last = k + 1 == iterations;
        const auto multiply_direction = [&] {
            return system.multiply(parallel, residual, std::as_const(vectors.direction).span(),
                                   is_last ? std::span<Vec4>() : vectors.product.span());
        };
        precondition(residual, vectors.preconditioned.span());
        if (k == 0) {  // z is the direction
            std::swap(vectors.direction, vectors.preconditioned);
            first = now = multiply_direction();
        } else {
            const double before = now.b_x;
            now = products(parallel, residual, vectors);
            turn_direction(parallel, static_cast<float>(now.b_x / before), vectors);
            now.x_wx = multiply_direction().x_wx;
        }
        if (!std::isfinite(now.b_x)) return failed;
        if (!(now.b_x > rounding * first.b_x)) break;
        const double alpha = now.b_x / now.x_wx;
        if (std::isnan(now.x_wx)) return failed;
        if (!(now.x_wx > 0) || !std::isfinite(alpha)) break;
        advance_along(parallel, static_cast<float>(alpha), vectors, dv);
        if (is_last) break;
        update_residual(parallel, static_cast<float>(alpha), residual, vectors);
        residual = vectors.residual.span();
    }
    return {.residual = first.x_x > 0 ? static_cast<float>(std::sqrt(now.x_x / first.x_x)) : 0.0f};
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
    SolveResult solve_linear(const SolverStep& step, ImplicitSystem& system, std::span<Vec4> dv) override;

  private:
    CgVectors vectors_;
};

}  // namespace weft
