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
    CgVectors(std::uint32_t particles, Unmade later)
        : residual(particles, later),
          preconditioned(particles, later),
          direction(particles, later),
          product(particles, later),
          partials(block_count(particles), later) {}
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

/// One cloth's share of a solve.
struct CgPart {
    ImplicitSystem& system;
    CgVectors& vectors;
    std::span<Vec4> dv;
};

/// No part does anything to another.
struct Uncoupled {
    double operator()(bool /*wants_products*/) const { return 0; }
};

/// Conjugate gradients (Hestenes and Stiefel 1952) from 0 on one equation of one or more parts: the solution
/// is added to each part's dv. precondition(k, r, z) writes z = P r from r, of which w may be anything, P
/// symmetric and positive definite on the free particles and 0 on the pinned ones, of which nothing more is
/// needed: a direction that is 0 there stays so (the filter of Baraff and Witkin 1998).
/// couple(wants_products) adds what the parts do to one another and themselves beyond their systems, C p for
/// the directions p, to the products if they are wanted, and returns p . C p. Each iteration multiplies once
/// and preconditions once. It ends early where single precision has nothing left to find; at what is not
/// finite it gives up. Unless it ended early, the last iterate that was preconditioned is the last but one.
///
/// iterations_for(decrement) says how many are wanted, up to `most`, once the first direction is known and
/// before anything is done: the direction of the call before still stands in vectors.preconditioned. If it
/// says 0, that goes back to vectors.direction, and no iteration is begun.
///
/// Parts is a range of CgPart, whose begin() and end() may be called often.
template <class Parts, class Precondition, class Couple, class IterationsFor>
CgResult conjugate_gradients(Parallel& parallel, const Parts& parts, int most,
                             const Precondition& precondition, const Couple& couple,
                             const IterationsFor& iterations_for) {
    constexpr CgResult failed{.ok = false};
    constexpr double rounding = 1e-14;  // of r . z, relative to its first value: 1e-7 in dv
    Products first, now;
    float length = 0;
    int begun = 0;
    for (int k = 0, iterations = most; k < iterations; ++k) {
        const auto residual_of = [&](const CgPart& part) -> std::span<const Vec4> {
            return k == 0 ? std::as_const(part.system.right_side()).span()
                          : std::as_const(part.vectors.residual).span();
        };
        const auto swap_directions = [&] {
            for (const CgPart& part : parts) std::swap(part.vectors.direction, part.vectors.preconditioned);
        };
        const auto multiply_directions = [&] {
            const bool wants_products = k + 1 < iterations;
            Products sum;
            for (const CgPart& part : parts)
                sum = sum + part.system.multiply_coupled(
                                parallel, residual_of(part), std::as_const(part.vectors.direction).span(),
                                wants_products ? part.vectors.product.span() : std::span<Vec4>());
            sum.x_wx += couple(wants_products);
            return sum;
        };
        std::size_t number = 0;
        for (const CgPart& part : parts)
            precondition(number++, residual_of(part), part.vectors.preconditioned.span());
        if (k == 0) {  // z is the direction
            swap_directions();
            first = now = multiply_directions();
            if (std::isfinite(now.b_x)) iterations = std::min(iterations_for(now.b_x), most);
            if (iterations <= 0) {
                swap_directions();
                return {};
            }
        } else {
            const double before = now.b_x;
            now = {};
            for (const CgPart& part : parts) now = now + products(parallel, residual_of(part), part.vectors);
            for (const CgPart& part : parts)
                turn_direction(parallel, static_cast<float>(now.b_x / before), part.vectors);
            length = 0;
            now.x_wx = multiply_directions().x_wx;
        }
        begun = k + 1;
        if (!std::isfinite(now.b_x)) return failed;
        if (!(now.b_x > rounding * first.b_x)) break;
        const double alpha = now.b_x / now.x_wx;
        if (std::isnan(now.x_wx)) return failed;
        if (!(now.x_wx > 0) || !std::isfinite(alpha)) break;
        length = static_cast<float>(alpha);
        for (const CgPart& part : parts) advance_along(parallel, length, part.vectors, part.dv);
        if (k + 1 == iterations) break;
        for (const CgPart& part : parts) update_residual(parallel, length, residual_of(part), part.vectors);
    }
    return {.left = first.x_x > 0 ? static_cast<float>(std::sqrt(now.x_x / first.x_x)) : 0.0f,
            .decrement = first.b_x,
            .slope = now.b_x,
            .length = length,
            .iterations = begun};
}
/// Of one cloth alone.
template <class Precondition>
CgResult conjugate_gradients(Parallel& parallel, ImplicitSystem& system, int iterations,
                             const Precondition& precondition, CgVectors& vectors, std::span<Vec4> dv) {
    const CgPart part{system, vectors, dv};
    return conjugate_gradients(
        parallel, std::span(&part, 1), iterations,
        [&](std::size_t, std::span<const Vec4> r, std::span<Vec4> z) { precondition(r, z); }, Uncoupled(),
        [=](double /*decrement*/) { return iterations; });
}

/// Conjugate gradients with the block diagonal as preconditioner (Baraff and Witkin 1998).
class ConjugateGradientSolver final : public LinearSolver {
  public:
    ConjugateGradientSolver(const ClothModel& model, const ClothSettings& settings);
    ConjugateGradientSolver(const ConjugateGradientSolver& other, const ClothModel& model)
        : LinearSolver(other, model), vectors_(model.particle_count) {}
    [[nodiscard]] std::unique_ptr<Solver> clone(const ClothModel& model) const override {
        return std::make_unique<ConjugateGradientSolver>(*this, model);
    }
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
