#pragma once
// Preconditioned conjugate gradients on W dv = b.

#include <cmath>
#include <span>
#include <utility>

#include "cloth/equation/sparse/vectors.h"
#include "cloth/methods/linear/linear_solver.h"
#include "engine/vector.h"

namespace weft {

/// Dot products of a residual r and z = P r.
struct OfPreconditioned {
    double r_z = 0, z_z = 0;

    friend OfPreconditioned operator+(const OfPreconditioned& l, const OfPreconditioned& r) {
        return {l.r_z + r.r_z, l.z_z + r.z_z};
    }
};

/// The memory of one solve.
struct CgVectors {
    void lay_out(Scratch& scratch, std::uint32_t particles) {
        for (auto* vector : {&residual, &preconditioned, &direction, &product})
            scratch.take(*vector, particles);
        scratch.take(partials, block_count(particles));
    }

    ScratchArray<Vec4> residual, preconditioned, direction, product;  ///< r, z, p and W p
    ScratchArray<OfPreconditioned> partials;
};

// The passes over whole vectors that an iteration is made of.
[[nodiscard]] OfPreconditioned products(Parallel& parallel, std::span<const Vec4> residual,
                                        CgVectors& vectors);
/// p = z + beta p.
void turn_direction(Parallel& parallel, float beta, CgVectors& vectors);
/// dv += alpha p.
void advance_along(Parallel& parallel, float alpha, const CgVectors& vectors, std::span<Vec4> dv);
/// r = residual - alpha W p.
void update_residual(Parallel& parallel, float alpha, std::span<const Vec4> residual, CgVectors& vectors);

struct CgResult {
    float left = 0;  ///< |P (b - W dv)| / |P b| of the last iterate that was preconditioned; 0 for b = 0
    bool ok = true;  ///< false: something was not finite
};

/// Conjugate gradients (Hestenes and Stiefel 1952) from 0 on W dv = b: the solution is added to dv.
/// precondition(r, z) writes z = P r from r, whose w may be anything. P is symmetric, positive definite on
/// the free particles and 0 on the pinned ones, whose directions therefore stay 0 (the filter of Baraff and
/// Witkin 1998). Each iteration multiplies once and preconditions once. The loop ends early when r . z is
/// down to rounding, and gives up at values that are not finite.
template <class Precondition>
CgResult conjugate_gradients(Parallel& parallel, ImplicitSystem& system, int iterations,
                             const Precondition& precondition, CgVectors& vectors, std::span<Vec4> dv) {
    constexpr double rounding = 1e-14;  // of r . z, relative to its first value: 1e-7 in dv
    OfPreconditioned first, now;
    for (int k = 0; k < iterations; ++k) {
        const std::span<const Vec4> residual =
            k == 0 ? std::as_const(system.right_side()).span() : std::as_const(vectors.residual).span();
        precondition(residual, vectors.preconditioned.span());
        const double before = now.r_z;
        now = products(parallel, residual, vectors);
        if (k == 0)
            copy(parallel, vectors.preconditioned.span(), vectors.direction.span());
        else
            turn_direction(parallel, static_cast<float>(now.r_z / before), vectors);
        const bool is_last = k + 1 == iterations;
        const double x_wx = system
                                .multiply_coupled(parallel, {}, std::as_const(vectors.direction).span(),
                                                  is_last ? std::span<Vec4>() : vectors.product.span())
                                .x_wx;
        if (k == 0) first = now;
        if (!std::isfinite(now.r_z) || std::isnan(x_wx)) return {.ok = false};
        const double alpha = now.r_z / x_wx;
        if (!(now.r_z > rounding * first.r_z) || !(x_wx > 0) || !std::isfinite(alpha)) break;
        advance_along(parallel, static_cast<float>(alpha), vectors, dv);
        if (!is_last) update_residual(parallel, static_cast<float>(alpha), residual, vectors);
    }
    return {.left = first.z_z > 0 ? static_cast<float>(std::sqrt(now.z_z / first.z_z)) : 0.0f};
}

/// Conjugate gradients with the block diagonal as preconditioner (Baraff and Witkin 1998).
class ConjugateGradientSolver final : public LinearSolver {
  public:
    ConjugateGradientSolver(const ClothModel& model, const ClothSettings& settings);
    ConjugateGradientSolver(const ConjugateGradientSolver& other, const ClothModel& model)
        : LinearSolver(other, model) {}
    [[nodiscard]] std::unique_ptr<Solver> clone(const ClothModel& model) const override {
        return std::make_unique<ConjugateGradientSolver>(*this, model);
    }
    [[nodiscard]] bool serves(const ClothSettings& settings) const override {
        return std::holds_alternative<ConjugateGradient>(settings.method) && serves_system(settings);
    }
    void lay_out(Scratch& scratch, std::size_t pairs) override;

  protected:
    bool solve_linear(const SolverStep& step, ImplicitSystem& system, std::span<Vec4> dv) override;

  private:
    CgVectors vectors_;
};

}  // namespace weft
