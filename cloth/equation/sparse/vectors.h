#pragma once
// Operations on whole vectors of one Vec4 a particle, in AlignedBuffers: the padding behind the last one is 0
// and is processed along with it.

#include <cmath>
#include <functional>
#include <span>

#include "engine/threads/parallel_blocks.h"
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

/// Four rows at a time, so that no sum waits for the one before it.
using FourRows = Eigen::Array<float, 4, 4>;
inline Eigen::Map<const FourRows, Eigen::Aligned16> load_four(const Vec4* rows) {
    return Eigen::Map<const FourRows, Eigen::Aligned16>(&rows->x);
}

inline void store_four(const FourRows& values, Vec4* rows) {
    Eigen::Map<FourRows, Eigen::Aligned16>(&rows->x) = values;
}

/// Sum over particles of x, y and z of term(i), which gives four rows, those of particles i to i + 3. In
/// single precision within a quarter of a block, in double beyond.
template <class Term>
double sum_fours(Parallel& parallel, std::size_t particles, std::span<double> partials, const Term& term) {
    return parallel.reduce(
        static_cast<std::uint32_t>(particles), partials, 0.0,
        [&](const BlockRange& range) {
            FourRows sum = FourRows::Zero();
            for (std::uint32_t i = range.begin; i < range.end; i += 4) sum += term(i);
            return sum.topRows<3>().cast<double>().sum();
        },
        std::plus<>{});
}

/// Sum over particles of a . b.
inline double dot(Parallel& parallel, std::span<const Vec4> a, std::span<const Vec4> b,
                  std::span<double> partials) {
    return sum_fours(parallel, a.size(), partials,
                     [&](std::uint32_t i) -> FourRows { return load_four(&a[i]) * load_four(&b[i]); });
}

/// |v|, for residuals such as |D^-1 (b - W dv)|.
inline double norm(Parallel& parallel, std::span<const Vec4> v, std::span<double> partials) {
    return std::sqrt(dot(parallel, v, v, partials));
}

/// |a - b|.
inline double distance(Parallel& parallel, std::span<const Vec4> a, std::span<const Vec4> b,
                       std::span<double> partials) {
    return std::sqrt(sum_fours(parallel, a.size(), partials, [&](std::uint32_t i) -> FourRows {
        return (load_four(&a[i]) - load_four(&b[i])).square();
    }));
}

/// out[i .. i + 3] = rows(i) for every fourth i.
template <class Rows>
void fill_fours(Parallel& parallel, std::span<Vec4> out, const Rows& rows) {
    parallel.ranges(static_cast<std::uint32_t>(out.size()), [&](const BlockRange& range) {
        for (std::uint32_t i = range.begin; i < range.end; i += 4) store_four(rows(i), &out[i]);
    });
}

/// y = x.
inline void copy(Parallel& parallel, std::span<const Vec4> x, std::span<Vec4> y) {
    fill_fours(parallel, y, [&](std::uint32_t i) -> FourRows { return load_four(&x[i]); });
}

/// x = 0.
inline void clear(Parallel& parallel, std::span<Vec4> x) {
    fill_fours(parallel, x, [](std::uint32_t) -> FourRows { return FourRows::Zero(); });
}

/// y = a x + b y.
inline void scale_and_add(Parallel& parallel, float a, std::span<const Vec4> x, float b, std::span<Vec4> y) {
    fill_fours(parallel, y,
               [&](std::uint32_t i) -> FourRows { return a * load_four(&x[i]) + b * load_four(&y[i]); });
}

/// out = a x + y.
inline void scale_and_add(Parallel& parallel, float a, std::span<const Vec4> x, std::span<const Vec4> y,
                          std::span<Vec4> out) {
    fill_fours(parallel, out,
               [&](std::uint32_t i) -> FourRows { return a * load_four(&x[i]) + load_four(&y[i]); });
}

}  // namespace weft
