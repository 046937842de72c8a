#include "cloth/methods/linear/conjugate_gradient.h"

#include <functional>

#include "cloth/equation/sparse/vectors.h"

namespace weft {

OfPreconditioned products(Parallel& parallel, std::span<const Vec4> residual, CgVectors& vectors) {
    return parallel.reduce(
        static_cast<std::uint32_t>(residual.size()), vectors.partials.span(), OfPreconditioned{},
        [&](const BlockRange& range) {
            FourRows with_residual = FourRows::Zero(), squares = FourRows::Zero();
            for (std::uint32_t i = range.begin; i < range.end; i += 4) {
                const auto z = load_four(&vectors.preconditioned[i]);
                with_residual += z * load_four(&residual[i]);
                squares += z * z;
            }
            return OfPreconditioned{.r_z = with_residual.topRows<3>().cast<double>().sum(),
                                    .z_z = squares.topRows<3>().cast<double>().sum()};
        },
        std::plus<>{});
}

void turn_direction(Parallel& parallel, float beta, CgVectors& vectors) {
    scale_and_add(parallel, 1.0f, vectors.preconditioned.span(), beta, vectors.direction.span());
}

void advance_along(Parallel& parallel, float alpha, const CgVectors& vectors, std::span<Vec4> dv) {
    scale_and_add(parallel, alpha, vectors.direction.span(), 1.0f, dv);
}

void update_residual(Parallel& parallel, float alpha, std::span<const Vec4> residual, CgVectors& vectors) {
    scale_and_add(parallel, -alpha, vectors.product.span(), residual, vectors.residual.span());
}

ConjugateGradientSolver::ConjugateGradientSolver(const ClothModel& model, const ClothSettings& settings)
    : LinearSolver(model, settings) {}

bool ConjugateGradientSolver::solve_linear(const SolverStep& step, ImplicitSystem& system,
                                           std::span<Vec4> dv) {
    const auto block_diagonal = [&](std::span<const Vec4> residual, std::span<Vec4> preconditioned) {
        system.precondition(step.parallel, residual, 1.0f, preconditioned);
    };
    clear(step.parallel, dv);
    return conjugate_gradients(step.parallel, system,
                               std::get<ConjugateGradient>(step.settings.method).iterations, block_diagonal,
                               vectors_, dv)
        .ok;
}

void ConjugateGradientSolver::lay_out(Scratch& scratch, std::size_t pairs) {
    LinearSolver::lay_out(scratch, pairs);
    vectors_.lay_out(scratch, particles());
}

}  // namespace weft
