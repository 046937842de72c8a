#include "cloth/frame/advance/history.h"

#include <cmath>

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "cloth/frame/advance/history.cpp"
#include "hwy/foreach_target.h"  // before highway.h
#include "hwy/highway.h"

#include "engine/simd/lanes-inl.h"

#ifndef WEFT_CLOTH_FRAME_HISTORY_TYPES
#define WEFT_CLOTH_FRAME_HISTORY_TYPES
namespace weft {

/// What the kernel reads, and the bases that it writes.
struct BaseRows {
    const Vec4 *positions, *velocities;                       // the present ones
    const Vec4 *displacements, *velocity_changes, *arrivals;  // recorded
    Vec4 *base_positions, *base_velocities;
};

}  // namespace weft
#endif

HWY_BEFORE_NAMESPACE();
namespace weft::HWY_NAMESPACE {
namespace {

// Curtiss and Hirschfelder 1952: x_base = (4 x_n - x_n-1) / 3 = x_n + (x_n - x_n-1) / 3, and v likewise. A
// pinned particle's bases are such that x_base + gamma v is x_n + h v.
void make_bases(const BaseRows& rows, const BlockRange& range, float h) {
    const Tag d;
    const Lanes third = hn::Set(d, 1.0f / 3.0f), zero = hn::Zero(d);
    for (std::uint32_t i = range.begin; i < range.end; i += part_lanes) {
        const Lanes4 position = load_rows(rows.positions + i);
        const Lanes3 x = xyz(position), v = xyz(load_rows(rows.velocities + i)),
                     arrival = xyz(load_rows(rows.arrivals + i));
        const auto is_free = hn::Ne(position.w, zero);
        const auto went_on =
            hn::And(is_free,
                    hn::And(hn::Eq(x.x, arrival.x), hn::And(hn::Eq(x.y, arrival.y), hn::Eq(x.z, arrival.z))));
        const Lanes3 displacement =
            either(went_on, xyz(load_rows(rows.displacements + i)), hn::Set(d, h) * v);
        const Lanes3 change = keep_where(is_free, xyz(load_rows(rows.velocity_changes + i)));
        store_rows(mul_add(third, displacement, x), position.w, rows.base_positions + i);
        store_rows(mul_add(third, change, v), zero, rows.base_velocities + i);
    }
}

}  // namespace
}  // namespace weft::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE  // what does not depend on the machine
namespace weft {

HWY_EXPORT(make_bases);

namespace {

/// What a collider holds was stopped by it along the normal: a change that the next step must not go on with.
/// Along the surface it slides on as it did.
void forget_held(const ClothState& state, const BaseRows& rows, const BlockRange& range) {
    if (state.held.touching.size() == 0) return;
    for (std::uint32_t i = range.begin; i < range.end && i < state.size(); ++i) {
        if (state.held.touching[i / Stencil::lanes] == 0 || xyz(state.held.normals[i]).isZero(0)) continue;
        const Vector3 v = xyz(state.velocities[i]), n = xyz(state.held.normals[i]);
        const Vector3 change = xyz(state.record.velocity_changes[i]);
        set_xyz(rows.base_positions[i], xyz(state.positions[i]) + state.record.h / 3 * v);
        set_xyz(rows.base_velocities[i], v + (change - n.dot(change) * n) / 3);
    }
}

}  // namespace

void forget_contact(const PairRows& rows, std::uint32_t first, ClothState& state) {
    if (state.record.velocity_changes.size() == 0 || rows.empty()) return;
    const auto for_each_pushed = [&](const auto& visit) {
        rows.for_each_particle(first, first + state.size(), [&](const PairRows::AtParticle& at) {
            const float squared = at.impulse.squaredNorm();
            if (squared > 0) visit(at.particle - first, at.impulse / std::sqrt(squared));
        });
    };
    Eigen::Vector3d sum = Eigen::Vector3d::Zero();
    double mass = 0;
    for_each_pushed([&](std::uint32_t i, const Vector3& /*n*/) {
        const double m = 1 / static_cast<double>(state.positions[i].w);
        sum += m * xyz(state.record.velocity_changes[i]).cast<double>();
        mass += m;
    });
    if (!(mass > 0)) return;
    const Vector3 common = (sum / mass).cast<float>();
    Eigen::Vector3d forgotten = Eigen::Vector3d::Zero();
    for_each_pushed([&](std::uint32_t i, const Vector3& n) {
        Vec4& change = state.record.velocity_changes[i];
        const Vector3 own = n.dot(xyz(change) - common) * n;
        change = to_vec4(xyz(change) - own, 0);
        forgotten += own.cast<double>() / static_cast<double>(state.positions[i].w);
    });
    // What they have together is as before.
    const Vector3 kept = (forgotten / mass).cast<float>();
    for_each_pushed([&](std::uint32_t i, const Vector3& /*n*/) {
        Vec4& change = state.record.velocity_changes[i];
        change = to_vec4(xyz(change) + kept, 0);
    });
}

void History::begin(Parallel& parallel, const ClothState& state) {
    const BaseRows rows{.positions = state.positions.data(),
                        .velocities = state.velocities.data(),
                        .displacements = state.record.displacements.data(),
                        .velocity_changes = state.record.velocity_changes.data(),
                        .arrivals = state.record.arrivals.data(),
                        .base_positions = base_positions_.data(),
                        .base_velocities = base_velocities_.data()};
    parallel.ranges(state.size(), [&](const BlockRange& range) {
        HWY_DYNAMIC_DISPATCH(make_bases)(rows, range, state.record.h);
        forget_held(state, rows, range);
    });
}

}  // namespace weft
#endif
