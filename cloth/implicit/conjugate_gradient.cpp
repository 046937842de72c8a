#include "cloth/implicit/conjugate_gradient.h"

namespace weft {

std::size_t CgVectors::bytes() const noexcept {
    return residual.bytes() + preconditioned.bytes() + direction.bytes() + product.bytes() + partials.bytes();
}

void start_from_rest(Parallel& parallel, std::span<const Vec4> b, CgVectors& vectors, std::span<Vec4> dv) {
    parallel.ranges(static_cast<std::uint32_t>(dv.size()), [&](const BlockRange& range) {
        for (std::uint32_t i = range.begin; i < range.end; ++i) {
            dv[i] = vectors.direction[i] = {};
            vectors.residual[i] = to_vec4(xyz(b[i]), 0);
        }
    });
}

CgVectors::Products products(Parallel& parallel, CgVectors& vectors) {
    using Products = CgVectors::Products;
    return parallel.reduce(
        static_cast<std::uint32_t>(vectors.residual.size()), vectors.partials.span(), Products{},
        [&](const BlockRange& range) {
            Products sum;
            for (std::uint32_t i = range.begin; i < range.end; ++i) {
                const Vector4 z = load(vectors.preconditioned[i]);
                sum.residual += static_cast<double>(z.dot(load(vectors.residual[i])));
                sum.preconditioned += static_cast<double>(z.squaredNorm());
            }
            return sum;
        },
        [](const Products& l, const Products& r) {
            return Products{l.residual + r.residual, l.preconditioned + r.preconditioned};
        });
}

void turn_direction(Parallel& parallel, float beta, CgVectors& vectors) {
    parallel.ranges(static_cast<std::uint32_t>(vectors.direction.size()), [&](const BlockRange& range) {
        for (std::uint32_t i = range.begin; i < range.end; ++i) {
            store(vectors.direction[i], load(vectors.preconditioned[i]) + beta * load(vectors.direction[i]));
        }
    });
}

void advance_along(Parallel& parallel, float alpha, CgVectors& vectors, std::span<Vec4> dv) {
    parallel.ranges(static_cast<std::uint32_t>(dv.size()), [&](const BlockRange& range) {
        for (std::uint32_t i = range.begin; i < range.end; ++i) {
            store(dv[i], load(dv[i]) + alpha * load(vectors.direction[i]));
            store(vectors.residual[i], load(vectors.residual[i]) - alpha * load(vectors.product[i]));
        }
    });
}

ConjugateGradientSolver::ConjugateGradientSolver(const CookedCloth& model, const ClothSettings& settings)
    : LinearSolver(model, settings), vectors_(model.particle_count) {}

float ConjugateGradientSolver::solve_linear(const SolverStep& step, ImplicitSystem& system) {
    const auto block_diagonal = [&](std::span<const Vec4> residual, std::span<Vec4> preconditioned) {
        system.precondition(step.parallel, residual, 1.0f, preconditioned);
    };
    return conjugate_gradients(step.parallel, system,
                               std::get<ConjugateGradient>(step.settings.method).iterations, block_diagonal,
                               vectors_, step.velocity_change);
}

std::size_t ConjugateGradientSolver::bytes() const noexcept {
    return LinearSolver::bytes() + vectors_.bytes();
}

}  // namespace weft
