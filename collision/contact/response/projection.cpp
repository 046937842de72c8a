#include "collision/contact/response/projection.h"

#include <algorithm>
#include <cmath>
#include <functional>

#include "collision/contact/response/leverage.h"
#include "engine/vector.h"

namespace weft {

namespace {

// The gap from differences to the first corner: weights add up to 0, so that neither the pair's position nor
// a motion that all corners share enters, however large.
float predicted_gap(const FeaturePair& pair, const PairShape& shape, std::span<const Vec4> positions,
                    std::span<const Vec4> displacements) {
    const Vector4 x = load(positions[pair.corners[0]]), d = load(displacements[pair.corners[0]]);
    Vector4 between = Vector4::Zero();  // w: unused
    for (std::uint32_t i = 1; i < 4; ++i) {
        const std::uint32_t corner = pair.corners[i];
        between += shape.weight(i) * ((load(positions[corner]) - x) + (load(displacements[corner]) - d));
    }
    return xyz(shape.normal).dot(between.head<3>());
}

float inverse_mass_of_gap(const FeaturePair& pair, const PairShape& shape, std::span<const Vec4> positions) {
    const auto inverse_mass = [&](std::uint32_t i) { return positions[pair.corners[i]].w; };
    return mobility_of_gap({inverse_mass(0), inverse_mass(1), inverse_mass(2), inverse_mass(3)},
                           {shape.weight(0), shape.weight(1), shape.weight(2), shape.weight(3)});
}

}  // namespace

void PairProjection::lay_out(Scratch& scratch, std::size_t particles, std::size_t pairs) {
    incidence_.lay_out(scratch, particles, pairs);
    scratch.take(impulses_, pairs);
    scratch.take(has_impulse_, pairs);
    scratch.take(sharers_, particles);
    scratch.take(block_counts_, block_count(static_cast<std::uint32_t>(pairs)));
}

std::uint32_t PairProjection::project(Parallel& parallel, std::span<const Vec4> positions,
                                      const PairList& pairs, std::span<const std::uint8_t> exempt,
                                      PairLengths wanted, std::uint32_t iterations,
                                      std::span<Vec4> displacements) {
    if (pairs.size == 0 || pairs.size > impulses_.size()) return 0;
    std::uint32_t first = 0;
    for (std::uint32_t iteration = 0; iteration < iterations; ++iteration) {
        const std::uint32_t active = find_impulses(parallel, positions, pairs, exempt, wanted, displacements);
        if (active == 0) break;
        if (iteration == 0) first = active;
        // Few of a list's pairs are too near: building rows of these alone is faster than reading all.
        incidence_.build(parallel, pairs.pairs.span().first(pairs.size), has_impulse_.span());
        share_impulses(parallel, positions, pairs);
        apply_impulses(parallel, positions, pairs, displacements);
    }
    return first;
}

std::uint32_t PairProjection::find_impulses(Parallel& parallel, std::span<const Vec4> positions,
                                            const PairList& pairs, std::span<const std::uint8_t> exempt,
                                            PairLengths wanted, std::span<const Vec4> displacements) {
    const auto find = [&](std::uint32_t k) {
        const FeaturePair& pair = pairs.pairs[k];
        const PairShape& shape = pairs.shapes[k];
        if (!(shape.normal.w > 0) || (!exempt.empty() && exempt[k] != 0)) return 0.0f;
        const float lacking = wanted[k] - predicted_gap(pair, shape, positions, displacements);
        if (!(lacking > 0)) return 0.0f;
        const float impulse = lacking / inverse_mass_of_gap(pair, shape, positions);
        return std::isfinite(impulse) ? impulse : 0.0f;  // all corners are pinned, or it is not a number
    };
    const auto find_block = [&](const BlockRange& block) {
        std::uint32_t active = 0;
        for (std::uint32_t k = block.begin; k < block.end; ++k) {
            impulses_[k] = find(k);
            has_impulse_[k] = impulses_[k] > 0 ? 1 : 0;
            active += has_impulse_[k];
        }
        return active;
    };
    return parallel.reduce(pairs.size, block_counts_.span(), 0u, find_block, std::plus<>());
}

void PairProjection::share_impulses(Parallel& parallel, std::span<const Vec4> positions,
                                    const PairList& pairs) {
    parallel.ranges(incidence_.rows(), [&](const BlockRange& block) {
        for (std::uint32_t row = block.begin; row < block.end; ++row) {
            const auto count = static_cast<std::uint32_t>(incidence_.places(row).size());
            const std::uint32_t particle = incidence_.particle(row);
            sharers_[particle] = positions[particle].w > 0 ? count : 0;
        }
    });
    parallel.ranges(pairs.size, [&](const BlockRange& block) {
        for (std::uint32_t k = block.begin; k < block.end; ++k) {
            if (!(impulses_[k] > 0)) continue;
            std::uint32_t most = 1;
            for (const std::uint32_t corner : pairs.pairs[k].corners) most = std::max(most, sharers_[corner]);
            impulses_[k] /= static_cast<float>(most);
        }
    });
}

void PairProjection::apply_impulses(Parallel& parallel, std::span<const Vec4> positions,
                                    const PairList& pairs, std::span<Vec4> displacements) {
    parallel.ranges(incidence_.rows(), [&](const BlockRange& block) {
        for (std::uint32_t row = block.begin; row < block.end; ++row) {
            const std::uint32_t particle = incidence_.particle(row);
            if (sharers_[particle] == 0) continue;  // pinned
            Vector3 sum = Vector3::Zero();
            for (const std::uint32_t place : incidence_.places(row)) {
                const PairShape& shape = pairs.shapes[place / 4];
                sum += shape.weight(place % 4) * impulses_[place / 4] * xyz(shape.normal);
            }
            set_xyz(displacements[particle], xyz(displacements[particle]) + positions[particle].w * sum);
        }
    });
}

}  // namespace weft
