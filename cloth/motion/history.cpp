#include "cloth/motion/history.h"

#include <algorithm>
#include <cmath>

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "cloth/motion/history.cpp"
#include "hwy/foreach_target.h"  // before highway.h
#include "hwy/highway.h"

#include "cloth/equation/sparse/stencil.h"
#include "engine/simd/lanes-inl.h"

#ifndef WEFT_CLOTH_MOTION_HISTORY_TYPES
#define WEFT_CLOTH_MOTION_HISTORY_TYPES
namespace weft {

/// Rows that the kernel reads, and the bases that it writes.
struct BaseRows {
    const Vec4 *positions, *velocities;                       // at present
    const Vec4 *displacements, *velocity_changes, *arrivals;  // of the last step
    Vec4 *base_positions, *base_velocities;
};

}  // namespace weft
#endif

HWY_BEFORE_NAMESPACE();
namespace weft::HWY_NAMESPACE {
namespace {

// x_base = x_n + (x_n - x_n-1) / divisor, and v_base from v alike. A pinned particle's bases are such that
// x_base + gamma v is x_n + h v. `last` is the length of the recorded step.
void make_bases(const BaseRows& rows, const BlockRange& range, float last, float divisor) {
    const Tag d;
    const Lanes kept = hn::Set(d, 1.0f / divisor), zero = hn::Zero(d);
    for (std::uint32_t i = range.begin; i < range.end; i += part_lanes) {
        const Lanes4 position = load_rows(rows.positions + i);
        const Lanes3 x = xyz(position), v = xyz(load_rows(rows.velocities + i)),
                     arrival = xyz(load_rows(rows.arrivals + i));
        const auto is_free = hn::Ne(position.w, zero);
        const auto went_on =
            hn::And(is_free,
                    hn::And(hn::Eq(x.x, arrival.x), hn::And(hn::Eq(x.y, arrival.y), hn::Eq(x.z, arrival.z))));
        const Lanes3 displacement =
            either(went_on, xyz(load_rows(rows.displacements + i)), hn::Set(d, last) * v);
        const Lanes3 change = keep_where(is_free, xyz(load_rows(rows.velocity_changes + i)));
        store_rows(mul_add(kept, displacement, x), position.w, rows.base_positions + i);
        store_rows(mul_add(kept, change, v), zero, rows.base_velocities + i);
    }
}

}  // namespace
}  // namespace weft::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE  // independent of the SIMD target
namespace weft {

HWY_EXPORT(make_bases);

namespace {

/// Bases of particles on a collider, without the normal component of their recorded velocity change: the
/// collider caused it, and the next step must not extrapolate it. Tangential changes are kept.
void forget_held(const ClothState& state, const BaseRows& rows, const BlockRange& range, float divisor) {
    if (state.held.touching.size() == 0) return;
    for (std::uint32_t i = range.begin; i < range.end && i < state.size(); ++i) {
        if (state.held.touching[i / Stencil::lanes] == 0 || xyz(state.held.normals[i]).isZero(0)) continue;
        const Vector3 v = xyz(state.velocities[i]), n = xyz(state.held.normals[i]);
        const Vector3 change = xyz(state.record.velocity_changes[i]);
        set_xyz(rows.base_positions[i], xyz(state.positions[i]) + state.record.h / divisor * v);
        set_xyz(rows.base_velocities[i], v + (change - n.dot(change) * n) / divisor);
    }
}

/// Mass-weighted mean of the recorded velocity changes of free particles.
class MeanChange {
  public:
    explicit MeanChange(const ClothState& state) : state_(state) {}
    void add(std::uint32_t particle) {
        const double m = 1 / static_cast<double>(state_.positions[particle].w);
        sum_ += m * xyz(state_.record.velocity_changes[particle]).cast<double>();
        mass_ += m;
    }
    [[nodiscard]] double mass() const { return mass_; }  ///< [kg]
    [[nodiscard]] Vector3 value() const { return (sum_ / mass_).cast<float>(); }

  private:
    const ClothState& state_;
    Eigen::Vector3d sum_ = Eigen::Vector3d::Zero();
    double mass_ = 0;
};

/// Greatest ratio h / last that is extrapolated in full. Variable-step BDF2 stops being zero-stable where
/// steps keep growing by 1 + sqrt(2) (Grigorieff 1983).
constexpr double greatest_ratio = 2;

}  // namespace

// Variable-step BDF2 (Grigorieff 1983; Hairer, Norsett, Wanner 1993, III.5), r = h / last:
//     x_base = x_n + r^2 / (1 + 2r) (x_n - x_n-1),   gamma = h (1 + r) / (1 + 2r).
// Beyond the greatest ratio the factor of x_n - x_n-1 stays constant, and gamma keeps straight motion exact:
// the shorter the last step was, the nearer to backward Euler.
Bdf bdf_after(float last, float h, float least_gamma) {
    constexpr float infinity = std::numeric_limits<float>::infinity();
    if (!(last > 0)) return {h, infinity};
    const double r = static_cast<double>(h) / static_cast<double>(last);
    const double clamped = std::min(r, greatest_ratio);
    const double divisor = (1 + 2 * clamped) / (clamped * clamped);
    const float gamma = h * static_cast<float>(1 - 1 / (divisor * r));
    if (gamma >= least_gamma) return {gamma, static_cast<float>(divisor)};
    return {least_gamma, least_gamma < h ? last / (h - least_gamma) : infinity};
}

void forget_contact(const PairRows& rows, std::uint32_t first, ClothState& state) {
    if (state.record.velocity_changes.size() == 0 || rows.empty()) return;
    const auto for_each_pushed = [&](const auto& visit) {
        rows.for_each_particle(first, first + state.size(), [&](const PairRows::AtParticle& at) {
            const float squared = at.impulse.squaredNorm();
            if (squared > 0) visit(at.particle - first, at.impulse / std::sqrt(squared));
        });
    };
    MeanChange mean(state);
    for_each_pushed([&](std::uint32_t i, const Vector3& /*n*/) { mean.add(i); });
    if (!(mean.mass() > 0)) return;
    const Vector3 common = mean.value();
    Eigen::Vector3d forgotten = Eigen::Vector3d::Zero();
    for_each_pushed([&](std::uint32_t i, const Vector3& n) {
        Vec4& change = state.record.velocity_changes[i];
        const Vector3 own = n.dot(xyz(change) - common) * n;
        change = to_vec4(xyz(change) - own, 0);
        forgotten += own.cast<double>() / static_cast<double>(state.positions[i].w);
    });
    // The common momentum of the touching particles stays as recorded.
    const Vector3 kept = (forgotten / mean.mass()).cast<float>();
    for_each_pushed([&](std::uint32_t i, const Vector3& /*n*/) {
        Vec4& change = state.record.velocity_changes[i];
        change = to_vec4(xyz(change) + kept, 0);
    });
}

void History::begin(Parallel& parallel, const ClothState& state, float divisor) {
    const BaseRows rows{.positions = state.positions.data(),
                        .velocities = state.velocities.data(),
                        .displacements = state.record.displacements.data(),
                        .velocity_changes = state.record.velocity_changes.data(),
                        .arrivals = state.record.arrivals.data(),
                        .base_positions = base_positions_.data(),
                        .base_velocities = base_velocities_.data()};
    parallel.ranges(state.size(), [&](const BlockRange& range) {
        HWY_DYNAMIC_DISPATCH(make_bases)(rows, range, state.record.h, divisor);
        forget_held(state, rows, range, divisor);
    });
}

}  // namespace weft
#endif
