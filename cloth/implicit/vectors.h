#pragma once
// Operations on whole vectors of one Vec4 a particle.

#include <cmath>
#include <functional>
#include <span>

#include "engine/parallel_blocks.h"
#include "engine/vector.h"

namespace weft {

/// Sum over particles of term(i), in double precision. Precondition: partials.size() >= block_count(n).
template <class Term>
double sum_over_particles(Parallel& parallel, std::uint32_t n, std::span<double> partials, const Term& term) {
    return parallel.reduce(
        n, partials, 0.0,
        [&](const BlockRange& range) {
            double sum = 0;
            for (std::uint32_t i = range.begin; i < range.end; ++i) sum += term(i);
            return sum;
        },
        std::plus<>{});
}

/// |D^-1 (b - W dv)| and the like are measured so.
inline double norm(Parallel& parallel, std::span<const Vec4> v, std::span<double> partials) {
    return std::sqrt(
        sum_over_particles(parallel, static_cast<std::uint32_t>(v.size()), partials,
                           [&](std::uint32_t i) { return static_cast<double>(xyz(v[i]).squaredNorm()); }));
}

inline double dot(Parallel& parallel, std::span<const Vec4> a, std::span<const Vec4> b,
                  std::span<double> partials) {
    return sum_over_particles(parallel, static_cast<std::uint32_t>(a.size()), partials, [&](std::uint32_t i) {
        return static_cast<double>(load(a[i]).dot(load(b[i])));
    });
}

/// y = a x + b y.
inline void scale_and_add(Parallel& parallel, float a, std::span<const Vec4> x, float b, std::span<Vec4> y) {
    parallel.ranges(static_cast<std::uint32_t>(y.size()), [&](const BlockRange& range) {
        for (std::uint32_t i = range.begin; i < range.end; ++i) {
            Eigen::Map<Vector4, Eigen::Aligned16>(&y[i].x) = a * load(x[i]) + b * load(y[i]);
        }
    });
}

}  // namespace weft
