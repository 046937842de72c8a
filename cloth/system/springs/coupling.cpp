#include "cloth/system/springs/coupling.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <limits>
#include <numeric>
#include <utility>
#include <vector>

#include "cloth/mesh/list_checks.h"
#include "cloth/system/springs/membrane.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "cloth/system/springs/coupling.cpp"
#include "hwy/foreach_target.h"  // before highway.h
#include "hwy/highway.h"

#include "engine/simd/lanes-inl.h"

HWY_BEFORE_NAMESPACE();
namespace weft::HWY_NAMESPACE {
namespace {

/// The strain of triangles that stiffen along one axis, as TriangleStiffening has it.
struct AxisLanes {
    Lanes v[3];
    Lanes strain, reached, modulus;  // reached: c, half the slope
};
HWY_INLINE AxisLanes along_axis(const float* stiffening, std::uint32_t axis, const Lanes* extension) {
    AxisLanes result;
    const float* const strains = stiffening + 3 * axis * group_lanes;
    for (std::uint32_t k = 0; k < 3; ++k) result.v[k] = load_lanes(strains + k * group_lanes);
    result.strain = hn::Mul(result.v[0], extension[0]);
    for (std::uint32_t k = 1; k < 3; ++k)
        result.strain = hn::MulAdd(result.v[k], extension[k], result.strain);
    result.reached = hn::Min(hn::Max(result.strain, set(0)), set(static_cast<float>(last_stiffening_strain)));
    result.modulus = load_lanes(stiffening + (6 + axis) * group_lanes);
    return result;
}
/// What bounds the slope along an axis on side k.
HWY_INLINE Lanes own_slope(const AxisLanes& axis, std::uint32_t k) {
    const Lanes sum = hn::Add(hn::Add(hn::Abs(axis.v[0]), hn::Abs(axis.v[1])), hn::Abs(axis.v[2]));
    const Lanes size = hn::Abs(axis.v[k]);
    const Lanes bound = hn::Mul(size, hn::Max(size, hn::Mul(set(static_cast<float>(least_bound)), sum)));
    return hn::Mul(hn::Mul(axis.modulus, hn::Add(axis.reached, axis.reached)), bound);
}

/// Where a group's is; `of` is null where there is none.
struct StiffeningOfGroup {
    const float* of;
    float *tensions, *slopes;
};

HWY_INLINE void stiffening_of_group(const float* stiffening, const Lanes* extension, float* tensions,
                                    float* slopes) {
    const AxisLanes axes[2] = {along_axis(stiffening, 0, extension), along_axis(stiffening, 1, extension)};
    for (std::uint32_t k = 0; k < 3; ++k) {
        Lanes tension = set(0), slope = set(0);
        for (const AxisLanes& axis : axes) {
            const Lanes g = hn::Mul(axis.reached, hn::Sub(hn::Add(axis.strain, axis.strain), axis.reached));
            tension = hn::MulAdd(hn::Mul(axis.modulus, g), axis.v[k], tension);
            slope = hn::Add(slope, own_slope(axis, k));
        }
        hn::Store(tension, Tag(), tensions + k * group_lanes);
        hn::Store(slope, Tag(), slopes + k * group_lanes);
    }
}

/// Of a group of 16 triangles three arrays are corners, three rest lengths, nine factors.
template <bool stiffens>
HWY_INLINE void shift_group(const std::uint32_t* corners, const float* rest_lengths, const float* factors,
                            const Vec4* positions, float* shifts, const StiffeningOfGroup& extra) {
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
        if constexpr (stiffens)
            stiffening_of_group(extra.of + lane, extension, extra.tensions + lane, extra.slopes + lane);
    }
}

/// What those changes do to the tension of side k by stiffening, beyond its own slope.
HWY_INLINE Lanes stiffening_change(const float* stiffening, const Lanes* extension, const Lanes* change,
                                   std::uint32_t k) {
    Lanes tension = set(0);
    for (std::uint32_t a = 0; a < 2; ++a) {
        const AxisLanes axis = along_axis(stiffening, a, extension);
        Lanes strain = hn::Mul(axis.v[0], change[0]);
        for (std::uint32_t m = 1; m < 3; ++m) strain = hn::MulAdd(axis.v[m], change[m], strain);
        const Lanes slope = hn::Mul(hn::Mul(axis.modulus, hn::Add(axis.reached, axis.reached)), axis.v[k]);
        tension = hn::MulAdd(slope, strain, tension);
        tension = hn::NegMulAdd(own_slope(axis, k), change[k], tension);
    }
    return tension;
}

/// Along n_k what the changes of all three sides' lengths do to side k.
template <bool stiffens>
HWY_INLINE Lanes stiffen_group(const std::uint32_t* corners, const float* rest_lengths,
                               const float* stiffness, const float* factors, const float* stiffening,
                               const Vec4* positions, const Vec4* x, std::uint32_t lane, Vec4* forces) {
    Lanes3 at[3], moved[3];
    for (std::uint32_t k = 0; k < 3; ++k) {
        at[k] = gather_rows(positions, corners + k * group_lanes + lane);
        moved[k] = gather_rows(x, corners + k * group_lanes + lane);
    }
    Lanes3 direction[3];
    Lanes change[3], extension[3];
    for (std::uint32_t k = 0; k < 3; ++k) {
        const Lanes3 side = at[(k + 1) % 3] - at[k];
        const Lanes length = hn::Sqrt(dot(side, side));
        direction[k] = hn::Div(set(1), hn::Max(length, set(1e-12f))) * side;
        change[k] = dot(direction[k], moved[(k + 1) % 3] - moved[k]);
        if constexpr (stiffens)
            extension[k] = hn::Sub(length, load_lanes(rest_lengths + k * group_lanes + lane));
    }
    Lanes energy = set(0);
    for (std::uint32_t k = 0; k < 3; ++k) {
        const float* const factor = factors + 3 * k * group_lanes + lane;
        Lanes tension = hn::Mul(load_lanes(factor), change[0]);
        tension = hn::MulAdd(load_lanes(factor + group_lanes), change[1], tension);
        tension = hn::MulAdd(load_lanes(factor + 2 * group_lanes), change[2], tension);
        tension = hn::Neg(hn::Mul(load_lanes(stiffness + k * group_lanes + lane), tension));
        if constexpr (stiffens)
            tension = hn::Add(tension, stiffening_change(stiffening + lane, extension, change, k));
        store_rows(tension * direction[k], set(0), forces + k * group_lanes + lane);
        energy = hn::MulAdd(tension, change[k], energy);
    }
    return energy;
}

const float* of_group(const float* stiffening, std::uint32_t group) {
    return stiffening == nullptr ? nullptr : stiffening + std::size_t{8} * group * group_lanes;
}

template <bool stiffens>
double stiffen_groups(std::uint32_t begin, std::uint32_t end, const std::uint32_t* corners,
                      const float* rest_lengths, const float* stiffness, const float* factors,
                      const float* stiffening, const Vec4* positions, const Vec4* x, Vec4* forces) {
    alignas(64) float sums[group_lanes] = {};
    for (std::uint32_t group = begin; group < end; ++group) {
        const std::size_t at = std::size_t{3} * group * group_lanes;
        for (std::uint32_t lane = 0; lane < group_lanes; lane += part_lanes) {
            const Lanes energy =
                stiffen_group<stiffens>(corners + at, rest_lengths + at, stiffness + at, factors + 3 * at,
                                        of_group(stiffening, group), positions, x, lane, forces + at);
            hn::Store(hn::Add(load_lanes(sums + lane), energy), Tag(), sums + lane);
        }
    }
    return std::accumulate(std::begin(sums), std::end(sums), 0.0);
}

template <bool stiffens>
void shift_groups(std::uint32_t begin, std::uint32_t end, const std::uint32_t* corners,
                  const float* rest_lengths, const float* factors, const float* stiffening,
                  const Vec4* positions, float* shifts, float* tensions, float* slopes) {
    for (std::uint32_t group = begin; group < end; ++group) {
        const std::size_t at = std::size_t{3} * group * group_lanes;
        const float* const extra = of_group(stiffening, group);
        shift_group<stiffens>(
            corners + at, rest_lengths + at, factors + 3 * at, positions, shifts + at,
            stiffens ? StiffeningOfGroup{extra, tensions + at, slopes + at} : StiffeningOfGroup{});
    }
}

double stiffen(std::uint32_t begin, std::uint32_t end, const std::uint32_t* corners,
               const float* rest_lengths, const float* stiffness, const float* factors,
               const float* stiffening, const Vec4* positions, const Vec4* x, Vec4* forces) {
    const auto groups = stiffening != nullptr ? stiffen_groups<true> : stiffen_groups<false>;
    return groups(begin, end, corners, rest_lengths, stiffness, factors, stiffening, positions, x, forces);
}

void shift(std::uint32_t begin, std::uint32_t end, const std::uint32_t* corners, const float* rest_lengths,
           const float* factors, const float* stiffening, const Vec4* positions, float* shifts,
           float* tensions, float* slopes) {
    const auto groups = stiffening != nullptr ? shift_groups<true> : shift_groups<false>;
    groups(begin, end, corners, rest_lengths, factors, stiffening, positions, shifts, tensions, slopes);
}

}  // namespace
}  // namespace weft::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE  // what does not depend on the machine
namespace weft {

HWY_EXPORT(shift);
HWY_EXPORT(stiffen);

MembraneCoupling::MembraneCoupling(const ClothModel& model, const SpringMatrix& matrix, bool stiffens)
    : groups_(groups_of(model)),
      corners_(std::size_t{3} * groups_ * lanes),
      rest_lengths_(corners_.size()),
      factors_(3 * corners_.size()),
      sources_(2 * matrix.entries()),
      shifts_(corners_.size() + 1),
      stiffness_(corners_.size()),
      stiffening_(stiffens ? std::size_t{8} * groups_ * lanes : 0),
      extra_tensions_(stiffens ? corners_.size() + 1 : 0),
      extra_stiffness_(extra_tensions_.size()),
      forces_(corners_.size()),
      partials_(block_count(groups_ * lanes)),
      corner_offsets_(model.corner_offsets.span()),
      ahead_(3 * model.triangles.size()) {
    std::vector<std::uint32_t> next(corner_offsets_.data(), corner_offsets_.data() + model.particle_count);
    for (std::uint32_t t = 0; t < model.triangles.size(); ++t) {
        for (std::uint32_t k = 0; k < 3; ++k) ahead_[next[model.triangles[t][k]]++] = place(t, k);
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

bool MembraneCoupling::is_sound(const ClothModel& model, std::size_t entries, bool stiffens) const {
    const std::size_t sides = std::size_t{3} * groups_of(model) * lanes;
    return stiffest_extra_ >= 0 && stiffest_extra_ <= std::numeric_limits<float>::max() &&
           corners_.size() == sides && rest_lengths_.size() == sides && factors_.size() == 3 * sides &&
           sources_.size() == 2 * entries && stiffness_.size() == sides &&
           stiffening_.size() == (stiffens ? std::size_t{8} * groups_of(model) * lanes : 0) &&
           ahead_.size() == 3 * model.triangles.size() && are_below(corners_.span(), model.particle_count) &&
           are_below(sources_.span(), sides + 1) && are_below(ahead_.span(), sides);
}

void MembraneCoupling::complete(const ClothModel& model, Unmade later) {
    groups_ = groups_of(model);
    shifts_ = AlignedBuffer<float>(corners_.size() + 1, later);
    extra_tensions_ = AlignedBuffer<float>(stiffening_.size() > 0 ? shifts_.size() : 0, later);
    extra_stiffness_ = AlignedBuffer<float>(extra_tensions_.size(), later);
    forces_ = AlignedBuffer<Vec4>(corners_.size(), later);
    partials_ = AlignedBuffer<double>(block_count(groups_ * lanes), later);
    corner_offsets_ = model.corner_offsets.span();
}

void MembraneCoupling::make_own() {
    rest_lengths_.make_own();
    factors_.make_own();
    stiffness_.make_own();
    stiffening_.make_own();
}

// The tension of side k, sum_m C'_km dl_m, over what its spring has for stiffness, is an extension: a shift
// of its rest length the other way.
void MembraneCoupling::set(const ClothModel& model, const SpringMatrix& matrix,
                           const SpringTable& table) noexcept {
    if (empty()) return;
    stiffest_extra_ = 0;
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
        if (stiffening_.size() > 0) set_stiffening(model, t, table.fabric());
    }
}

void MembraneCoupling::set_stiffening(const ClothModel& model, std::uint32_t triangle,
                                      const Fabric& fabric) noexcept {
    const TriangleStiffening stiffening = triangle_stiffening(model, triangle, fabric);
    const auto number = [&](std::size_t k) -> float& {
        return stiffening_[(std::size_t{triangle / lanes} * 8 + k) * lanes + triangle % lanes];
    };
    std::array<double, 3> pulled{};  // by strains at the end of the law, both axes at once
    for (std::size_t axis = 0; axis < 2; ++axis) {
        double sum = 0;
        for (const double v : stiffening.strains[axis]) sum += std::abs(v);
        for (std::size_t k = 0; k < 3; ++k) {
            const double v = stiffening.strains[axis][k];
            number(3 * axis + k) = static_cast<float>(v);
            pulled[k] += stiffening.moduli[axis] * 2 * last_stiffening_strain *
                         std::max(v * v, least_bound * sum * std::abs(v));
        }
        number(6 + axis) = static_cast<float>(stiffening.moduli[axis]);
    }
    for (const double own : pulled)  // a spring is a side of two triangles
        stiffest_extra_ = std::max(stiffest_extra_, static_cast<float>(2 * own));
}

void MembraneCoupling::compute(Parallel& parallel, std::span<const Vec4> positions) {
    parallel.ranges(groups_ * lanes, [&](const BlockRange& range) {
        HWY_DYNAMIC_DISPATCH(shift)
        (range.begin / lanes, (range.end + lanes - 1) / lanes, corners_.data(), rest_lengths_.data(),
         factors_.data(), stiffening_.data(), positions.data(), shifts_.data(), extra_tensions_.data(),
         extra_stiffness_.data());
    });
}

double MembraneCoupling::stiffen(Parallel& parallel, std::span<const Vec4> positions,
                                 std::span<const Vec4> x) {
    return parallel.reduce(
        groups_ * lanes, partials_.span(), 0.0,
        [&](const BlockRange& range) {
            return HWY_DYNAMIC_DISPATCH(stiffen)(range.begin / lanes, (range.end + lanes - 1) / lanes,
                                                 corners_.data(), rest_lengths_.data(), stiffness_.data(),
                                                 factors_.data(), stiffening_.data(), positions.data(),
                                                 x.data(), forces_.data());
        },
        std::plus<>{});
}

}  // namespace weft
#endif
