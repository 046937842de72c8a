// A step's report, of each cloth and of all of them.

#include <algorithm>
#include <cmath>
#include <limits>

#include "cloth/step/step_report.h"

namespace weft {

namespace {

StepFlags flags_of(const Cloth& cloth, float max_speed) {
    StepFlags flags = StepFlags::none;
    const auto raise = [&](bool raised, StepFlags flag) {
        if (raised) flags = flags | flag;
    };
    raise(cloth.restored, StepFlags::state_restored);
    raise(cloth.pins_limited || std::sqrt(cloth.extent.peak_speed_squared) > 0.999f * max_speed,
          StepFlags::speed_limited);
    raise(cloth.unsolved, StepFlags::unsolved);
    raise(cloth.pin_lag > 0, StepFlags::pins_stopped);
    raise(cloth.feature_counts.crossed, StepFlags::crossed);
    raise(cloth.self_counts.dropped > 0 || cloth.feature_counts.overflowed, StepFlags::contacts_dropped);
    return flags;
}

std::uint32_t sum_at_most(std::uint64_t a, std::uint64_t b) {
    return static_cast<std::uint32_t>(
        std::min<std::uint64_t>(a + b, std::numeric_limits<std::uint32_t>::max()));
}

}  // namespace

ClothReport Simulation::report_of(const Cloth& cloth) const {
    ClothReport of{.enabled = cloth.settings.enabled,
                   .asleep = cloth.is_asleep(),
                   .particles = cloth.model.particle_count};
    if (!cloth.was_stepped) return of;
    of.flags = flags_of(cloth, settings.max_speed);
    of.collider_contacts = cloth.collider_contacts;
    of.self_contacts = cloth.self_counts.pairs + cloth.feature_counts.pairs;
    of.peak_self_contacts = cloth.self_counts.peak;
    of.truncated_particles = cloth.feature_counts.truncated;
    of.crossings = cloth.feature_counts.tangles.crossings;
    of.unresolved_pairs = sum_at_most(0, cloth.feature_counts.unresolved);
    of.pin_lag = cloth.pin_lag;
    of.limits_exceeded = cloth.limit_lag.particles;
    of.limit_lag = cloth.limit_lag.most;
    of.peak_speed = std::sqrt(cloth.extent.peak_speed_squared);
    of.residual = cloth.residual;
    if (cloth.state.detail) {
        of.rung = cloth.state.detail->rung;
        of.rate = cloth.state.detail->rate;
    }
    of.milliseconds = 1e-6f * static_cast<float>(cloth.nanoseconds);
    return of;
}

void add_to_report(StepReport& report, const ClothReport& cloth) {
    ++report.cloths;
    report.flags = report.flags | cloth.flags;
    if (has(cloth.flags, StepFlags::state_restored)) ++report.restored_cloths;
    if (cloth.rung > 0) ++report.reduced_cloths;
    report.particles += cloth.particles;
    report.collider_contacts += cloth.collider_contacts;
    report.self_contacts += cloth.self_contacts;
    report.peak_self_contacts = std::max(report.peak_self_contacts, cloth.peak_self_contacts);
    report.truncated_particles += cloth.truncated_particles;
    report.crossings += cloth.crossings;
    report.unresolved_pairs = sum_at_most(report.unresolved_pairs, cloth.unresolved_pairs);
    report.pin_lag = std::max(report.pin_lag, cloth.pin_lag);
    report.limits_exceeded += cloth.limits_exceeded;
    report.limit_lag = std::max(report.limit_lag, cloth.limit_lag);
    report.peak_speed = std::max(report.peak_speed, cloth.peak_speed);
    report.residual = std::max(report.residual, cloth.residual);
}

}  // namespace weft
