#include "cloth/implicit/jacobi.h"

#include <cmath>
#include <functional>
#include <utility>

namespace weft {

namespace {

// Kang, eq. 7, first line: dv_i = W_ii^-1 b_i.
void first_guess(Parallel& parallel, ImplicitSystem& system) {
    parallel.ranges(static_cast<std::uint32_t>(system.right_side.size()), [&](const BlockRange& range) {
        for (std::uint32_t i = range.begin; i < range.end; ++i) {
            system.velocity_change[i] = to_vec4(system.inverse_diagonal[i] * xyz(system.right_side[i]), 0);
        }
    });
}

// Kang, eq. 7, second line: dv_i <- W_ii^-1 (b_i + sum_j A_ij dv_j). Its eq. 6 drops the brackets.
void iterate(Parallel& parallel, const CookedCloth& model, ImplicitSystem& system) {
    parallel.ranges(model.particle_count, [&](const BlockRange& range) {
        for (std::uint32_t i = range.begin; i < range.end; ++i) {
            // Lane w of every dv is 0, so that c . dv is d . dv; what lane w of the sum gathers is dropped.
            Vector4 sum = load(system.right_side[i]);
            for (std::uint32_t e = model.spring_offsets[i]; e < model.spring_offsets[i + 1]; ++e) {
                const Vector4 c = load(system.coefficients[e]);
                const Vector4 dv = load(system.velocity_change[model.neighbours[e]]);
                sum += c.w() * dv + c.dot(dv) * c;
            }
            system.scratch[i] = to_vec4(system.inverse_diagonal[i] * sum.head<3>(), 0);
        }
    });
    std::swap(system.velocity_change, system.scratch);
}

/// Sum over particles of |term(i)|^2.
template <class Term>
double sum_of_squares(Parallel& parallel, std::uint32_t n, std::span<double> partials, const Term& term) {
    return parallel.reduce(
        n, partials, 0.0,
        [&](const BlockRange& range) {
            double sum = 0;
            for (std::uint32_t i = range.begin; i < range.end; ++i)
                sum += static_cast<double>(term(i).squaredNorm());
            return sum;
        },
        std::plus<>{});
}

}  // namespace

float solve_jacobi(Parallel& parallel, const CookedCloth& model, int iterations, ImplicitSystem& system,
                   std::span<double> partials) {
    first_guess(parallel, system);
    if (iterations == 0) return 1;

    const double start = sum_of_squares(parallel, model.particle_count, partials,
                                        [&](std::uint32_t i) { return xyz(system.velocity_change[i]); });
    for (int k = 0; k < iterations; ++k) iterate(parallel, model, system);
    // One iteration changes the iterate by its preconditioned residual.
    const double change = sum_of_squares(parallel, model.particle_count, partials, [&](std::uint32_t i) {
        return Vector3(xyz(system.velocity_change[i]) - xyz(system.scratch[i]));
    });
    return start > 0 ? static_cast<float>(std::sqrt(change / start)) : 0.0f;
}

}  // namespace weft
