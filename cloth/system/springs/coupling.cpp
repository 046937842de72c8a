#include "cloth/system/springs/coupling.h"

#include <algorithm>
#include <functional>
#include <numeric>
#include <utility>
#include <vector>

#include "cloth/system/springs/membrane.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "cloth/system/springs/coupling.cpp"
#include "hwy/foreach_target.h"  // before highway.h
#include "hwy/highway.h"

#include "engine/simd/lanes-inl.h"

HWY_BEFORE_NAMESPACE();
namespace weft::HWY_NAMESPACE {
namespace {

/// Of a group of 16 triangles three arrays are corners, three rest lengths, nine factors.
HWY_INLINE void shift_group(const std::uint32_t* corners, const float* rest_lengths, const float* factors,
                            const Vec4* positions, float* shifts) {
    for (std::uint32_t lane = 0; lane < group_lanes; lane += part_lanes) {
        Lanes3 x[3];
        for (std::uint32_t k = 0; k < 3; ++k) x[k] = gather_rows(positions, corners + k * group_lanes + lane);
        Lanes extension[3];
        for (std::uint32_t k = 0; k < 3; ++k) {
            const Lanes3 side = x[(k + 1) % 3] - x[k];
            extension[k] =
                hn::Sub(hn::Sqrt(dot(side, side)), load_lanes(rest_lengths + k * group_lanes + lane));
        }
        for (std::uint32_t k = 0; k < 3; ++k) {
            const float* const factor = factors + 3 * k * group_lanes + lane;
            Lanes shift = hn::Mul(load_lanes(factor), extension[0]);
            shift = hn::MulAdd(load_lanes(factor + group_lanes), extension[1], shift);
            shift = hn::MulAdd(load_lanes(factor + 2 * group_lanes), extension[2], shift);
            hn::Store(shift, Tag(), shifts + k * group_lanes + lane);
        }
    }
}

/// Along n_k what the changes of all three sides' lengths do to side k.
HWY_INLINE Lanes stiffen_group(const std::uint32_t* corners, const float* stiffness, const float* factors,
                               const Vec4* positions, const Vec4* x, std::uint32_t lane, Vec4* forces) {
    Lanes3 at[3], moved[3];
    for (std::uint32_t k = 0; k < 3; ++k) {
        at[k] = gather_rows(positions, corners + k * group_lanes + lane);
        moved[k] = gather_rows(x, corners + k * group_lanes + lane);
    }
    Lanes3 direction[3];
    Lanes change[3];
    for (std::uint32_t k = 0; k < 3; ++k) {
        const Lanes3 side = at[(k + 1) % 3] - at[k];
        const Lanes length = hn::Sqrt(dot(side, side));
        direction[k] = hn::Div(set(1), hn::Max(length, set(1e-12f))) * side;
        change[k] = dot(direction[k], moved[(k + 1) % 3] - moved[k]);
    }
    Lanes energy = set(0);
    for (std::uint32_t k = 0; k < 3; ++k) {
        const float* const factor = factors + 3 * k * group_lanes + lane;
        Lanes tension = hn::Mul(load_lanes(factor), change[0]);
        tension = hn::MulAdd(load_lanes(factor + group_lanes), change[1], tension);
        tension = hn::MulAdd(load_lanes(factor + 2 * group_lanes), change[2], tension);
        tension = hn::Neg(hn::Mul(load_lanes(stiffness + k * group_lanes + lane), tension));
        store_rows(tension * direction[k], set(0), forces + k * group_lanes + lane);
        energy = hn::MulAdd(tension, change[k], energy);
    }
    return energy;
}

double stiffen(std::uint32_t begin, std::uint32_t end, const std::uint32_t* corners, const float* stiffness,
               const float* factors, const Vec4* positions, const Vec4* x, Vec4* forces) {
    alignas(64) float sums[group_lanes] = {};
    for (std::uint32_t group = begin; group < end; ++group) {
        const std::size_t at = std::size_t{3} * group * group_lanes;
        for (std::uint32_t lane = 0; lane < group_lanes; lane += part_lanes) {
            const Lanes energy = stiffen_group(corners + at, stiffness + at, factors + 3 * at, positions, x,
                                               lane, forces + at);
            hn::Store(hn::Add(load_lanes(sums + lane), energy), Tag(), sums + lane);
        }
    }
    return std::accumulate(std::begin(sums), std::end(sums), 0.0);
}

void shift(std::uint32_t begin, std::uint32_t end, const std::uint32_t* corners, const float* rest_lengths,
           const float* factors, const Vec4* positions, float* shifts) {
    for (std::uint32_t group = begin; group < end; ++group) {
        const std::size_t at = std::size_t{3} * group * group_lanes;
        shift_group(corners + at, rest_lengths + at, factors + 3 * at, positions, shifts + at);
    }
}

}  // namespace
}  // namespace weft::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE  // what does not depend on the machine
namespace weft {

HWY_EXPORT(shift);
HWY_EXPORT(stiffen);

MembraneCoupling::MembraneCoupling(const CookedCloth& model, const SpringMatrix& matrix)
    : groups_((static_cast<std::uint32_t>(model.triangles.size()) + lanes - 1) / lanes),
      corners_(std::size_t{3} * groups_ * lanes),
      rest_lengths_(corners_.size()),
      factors_(3 * corners_.size()),
      sources_(2 * matrix.entries()),
      shifts_(corners_.size() + 1),
      stiffness_(corners_.size()),
      forces_(corners_.size()),
      partials_(block_count(groups_ * lanes)),
      corner_offsets_(model.corner_offsets.span()),
      ahead_(3 * model.triangles.size()),
      behind_(ahead_.size()) {
    std::vector<std::uint32_t> next(corner_offsets_.data(), corner_offsets_.data() + model.particle_count);
    for (std::uint32_t t = 0; t < model.triangles.size(); ++t) {
        for (std::uint32_t k = 0; k < 3; ++k) {
            const std::uint32_t at = next[model.triangles[t][k]]++;
            ahead_[at] = place(t, k);
            behind_[at] = place(t, (k + 2) % 3);
        }
    }
    std::ranges::fill(sources_.span(), static_cast<std::uint32_t>(corners_.size()));
    const auto shifted_by = [&](std::uint32_t i, std::uint32_t j, std::uint32_t side) {
        const std::uint32_t entry = matrix.entry(i, half_edge_between(model, i, j), j);
        if (entry == SpringMatrix::no_entry) return;
        const std::uint32_t slot = entry / lanes, lane = entry % lanes;
        std::uint32_t* source = &sources_[std::size_t{2} * slot * lanes + lane];
        if (*source < corners_.size()) source += lanes;
        *source = side;
    };
    for (std::uint32_t t = 0; t < model.triangles.size(); ++t) {
        for (std::uint32_t k = 0; k < 3; ++k) {
            const std::uint32_t i = model.triangles[t][k], j = model.triangles[t][(k + 1) % 3];
            corners_[place(t, k)] = i;
            shifted_by(i, j, place(t, k));
            shifted_by(j, i, place(t, k));
        }
    }
}

// The tension of side k, sum_m C'_km dl_m, over what its spring has for stiffness, is an extension: a shift
// of its rest length the other way.
void MembraneCoupling::set(const CookedCloth& model, const SpringMatrix& matrix,
                           const SpringTable& table) noexcept {
    if (empty()) return;
    for (std::uint32_t t = 0; t < model.triangles.size(); ++t) {
        const TriangleMembrane membrane = triangle_membrane(model, t, table.fabric());
        for (std::uint32_t k = 0; k < 3; ++k) {
            rest_lengths_[place(t, k)] = static_cast<float>(membrane.rest_lengths[k]);
            const auto [i, j] = std::minmax(model.triangles[t][k], model.triangles[t][(k + 1) % 3]);
            const std::uint32_t entry = matrix.entry(i, half_edge_between(model, i, j), j);
            const double stiffness = static_cast<double>(table.stiffness()[entry]);
            stiffness_[place(t, k)] = table.stiffness()[entry];
            for (std::uint32_t m = 0; m < 3; ++m) {
                const std::size_t at =
                    (std::size_t{t / lanes} * 9 + 3 * std::size_t{k} + m) * lanes + t % lanes;
                factors_[at] = stiffness > 0 ? static_cast<float>(-membrane.shared[k][m] / stiffness) : 0.0f;
            }
        }
    }
}

void MembraneCoupling::compute(Parallel& parallel, std::span<const Vec4> positions) {
    parallel.ranges(groups_ * lanes, [&](const BlockRange& range) {
        HWY_DYNAMIC_DISPATCH(shift)
        (range.begin / lanes, (range.end + lanes - 1) / lanes, corners_.data(), rest_lengths_.data(),
         factors_.data(), positions.data(), shifts_.data());
    });
}

double MembraneCoupling::stiffen(Parallel& parallel, std::span<const Vec4> positions,
                                 std::span<const Vec4> x) {
    return parallel.reduce(
        groups_ * lanes, partials_.span(), 0.0,
        [&](const BlockRange& range) {
            return HWY_DYNAMIC_DISPATCH(stiffen)(range.begin / lanes, (range.end + lanes - 1) / lanes,
                                                 corners_.data(), stiffness_.data(), factors_.data(),
                                                 positions.data(), x.data(), forces_.data());
        },
        std::plus<>{});
}

}  // namespace weft
#endif
