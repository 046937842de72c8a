#pragma once
// Preconditioned conjugate gradients on W dv = b.

#include <cmath>
#include <limits>
#include <span>
#include <utility>

#include "cloth/implicit/linear_solver.h"
#include "engine/vector.h"

namespace weft {

/// The memory of one solve.
struct CgVectors {
    /// r . z and z . z of a residual r and z = P r.
    struct Products {
        double residual = 0, preconditioned = 0;
    };

    explicit CgVectors(std::uint32_t particles)
        : residual(particles),
          preconditioned(particles),
          direction(particles),
          product(particles),
          partials(block_count(particles)) {}
    [[nodiscard]] std::size_t bytes() const noexcept;

    AlignedBuffer<Vec4> residual, preconditioned, direction, product;  ///< r, z, p and W p; w 0
    AlignedBuffer<Products> partials;
};

// The passes over whole vectors that an iteration is made of.
/// dv = 0, p = 0, r = b.
void start_from_rest(Parallel& parallel, std::span<const Vec4> b, CgVectors& vectors, std::span<Vec4> dv);
[[nodiscard]] CgVectors::Products products(Parallel& parallel, CgVectors& vectors);
/// p = z + beta p.
void turn_direction(Parallel& parallel, float beta, CgVectors& vectors);
/// dv += alpha p, r -= alpha W p.
void advance_along(Parallel& parallel, float alpha, CgVectors& vectors, std::span<Vec4> dv);

/// Conjugate gradients (Hestenes and Stiefel 1952) from dv = 0. precondition(r, z) writes z = P r, P
/// symmetric and positive definite on the free particles and 0 on the pinned ones, of which nothing more is
/// needed: a direction that is 0 there stays so (the filter of Baraff and Witkin 1998). Each iteration
/// multiplies once and preconditions once. It ends early where single precision has nothing left to find; at
/// what is not finite it gives up and returns not a number. Returns |P (b - W dv)| / |P b| of the last
/// iterate that was preconditioned: the last but one, unless it ended early; 0 for b = 0.
template <class Precondition>
float conjugate_gradients(Parallel& parallel, ImplicitSystem& system, int iterations,
                          const Precondition& precondition, CgVectors& vectors, std::span<Vec4> dv) {
    constexpr float no_number = std::numeric_limits<float>::quiet_NaN();
    constexpr double rounding = 1e-14;  // of r . z, relative to its first value: 1e-7 in dv
    start_from_rest(parallel, system.right_side().span(), vectors, dv);
    CgVectors::Products first, before, now;
    for (int k = 0; k < iterations; ++k) {
        precondition(std::as_const(vectors.residual).span(), vectors.preconditioned.span());
        before = now;
        now = products(parallel, vectors);
        if (k == 0) first = now;
        if (!std::isfinite(now.residual)) return no_number;
        if (!(now.residual > rounding * first.residual)) break;

        const double beta = k == 0 ? 0 : now.residual / before.residual;
        turn_direction(parallel, static_cast<float>(beta), vectors);
        const double curvature =
            system.multiply(parallel, std::as_const(vectors.direction).span(), vectors.product.span());
        const double alpha = now.residual / curvature;
        if (std::isnan(curvature)) return no_number;
        if (!(curvature > 0) || !std::isfinite(alpha)) break;
        advance_along(parallel, static_cast<float>(alpha), vectors, dv);
    }
    return first.preconditioned > 0 ? static_cast<float>(std::sqrt(now.preconditioned / first.preconditioned))
                                    : 0.0f;
}

/// Conjugate gradients with the block diagonal as preconditioner (Baraff and Witkin 1998).
class ConjugateGradientSolver final : public LinearSolver {
  public:
    ConjugateGradientSolver(const CookedCloth& model, const ClothSettings& settings);
    [[nodiscard]] std::size_t bytes() const noexcept override;

  protected:
    float solve_linear(const SolverStep& step, ImplicitSystem& system) override;

  private:
    CgVectors vectors_;
};

}  // namespace weft
