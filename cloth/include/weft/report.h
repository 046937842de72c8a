#pragma once
// Report of World::step on the step that it took.

#include <cstdint>
#include <span>

#include "weft/profile.h"

namespace weft {

/// Range of World::step's dt [s]. Below a microsecond single precision loses what a step changes.
inline constexpr float least_step = 1e-6f, greatest_step = 1;

/// Problems of a step. Each flag's comment names the setting to change.
enum class StepFlags : std::uint32_t {
    none = 0,
    /// dt was below least_step, above greatest_step, or no number: nothing was done. Pass one between them,
    /// as 1/60 s.
    invalid_dt = 1u << 0,
    /// A cloth's state stopped being finite, or left the 100 km around the origin. It is back at the start of
    /// the step, at rest. Lower the step, raise WorldSettings::substeps, or soften ClothSettings::fabric.
    state_restored = 1u << 1,
    /// More pairs are close than there is memory for. Lower SelfCollision::distance. By avoidance, a particle
    /// has more neighbours than its list holds (16); the rest wait for the next step. By contact, there are
    /// more than 16 pairs of features a particle. The listed pairs are pushed apart; touching cloth moves
    /// only a part of its way in this step, or by one common motion, or not at all where it is pinned.
    /// Nothing crosses. By impact zones, pairs beyond the list's room pass through.
    contacts_dropped = 1u << 2,
    /// Particles were limited to WorldSettings::max_speed. Pins beyond it reach their targets, but cloth
    /// follows at that speed. Raise it if cloth should be faster; otherwise look for a pin or a collider that
    /// jumps.
    speed_limited = 1u << 3,
    /// The method left more of a cloth's equation unsolved than Multilevel::tolerance: the cloth may stretch
    /// or lag. Raise ClothSettings::substeps, or Multilevel::passes;
    /// or lower Fabric::warp and weft over shear, or Fabric::damping.
    unsolved = 1u << 4,
    /// A pin was stopped by cloth that it would have passed through, see StepReport::pin_lag: no motion of
    /// the other cloth makes room. Move pins slower, or another way.
    pins_stopped = 1u << 5,
    /// By contact, features cross that did not when the step began: a fault of Weft, please report it. Only
    /// builds with assertions check, since that takes as long as a search.
    crossed = 1u << 6,
    /// Returned by step(): World::begin_step() began a step that has not ended, or another thread is in
    /// step(). Nothing was done. Call end_step(); make calls of one World one after the other.
    step_under_way = 1u << 7,
};
constexpr StepFlags operator|(StepFlags a, StepFlags b) {
    return static_cast<StepFlags>(static_cast<std::uint32_t>(a) | static_cast<std::uint32_t>(b));
}
constexpr bool has(StepFlags flags, StepFlags flag) {
    return (static_cast<std::uint32_t>(flags) & static_cast<std::uint32_t>(flag)) != 0;
}

struct StepReport {
    StepFlags flags = StepFlags::none;
    std::uint64_t step = 0;  ///< steps taken since the World was made, this one included
    int substeps = 0;
    std::uint32_t cloths = 0;             ///< enabled cloths
    std::uint32_t sleeping_cloths = 0;    ///< enabled cloths that sleep, and were not stepped
    std::uint32_t reduced_cloths = 0;     ///< enabled cloths whose rung is not 0: see ClothReport
    std::uint32_t particles = 0;          ///< particles that were stepped
    std::uint32_t collider_contacts = 0;  ///< particles that met a collider, in the last substep
    std::uint32_t self_contacts = 0;  ///< pairs that are close (by zones: that collide), in the last substep
    /// Contacts of the whole step, of which World::contacts() has the strongest; 0 if
    /// WorldSettings::contact_reports is 0.
    std::uint32_t contacts = 0;
    std::uint32_t peak_self_contacts = 0;  ///< most pairs of one particle, in the last substep; by avoidance
    /// By contact: particles whose motion was cut short in the last substep, since they would have passed
    /// through cloth.
    std::uint32_t truncated_particles = 0;
    float pin_lag = 0;  ///< greatest distance of a pin that cloth stopped from its target [m]
    /// Particles that are beyond their leash or in their backstop by more than 1e-6 m, since cloth was in
    /// their way; and the greatest excess [m].
    std::uint32_t limits_exceeded = 0;
    float limit_lag = 0;
    /// By contact: places where an edge goes through a triangle at the start of the last substep. Only a
    /// state that was given so, or put back, has any. Contact separates crossed cloth, which may take a
    /// second; meanwhile the count may rise. Hooked folds can stay crossed.
    std::uint32_t crossings = 0;
    /// Pairs of features that still collide after all rounds of impact zones of the last substep. Pairs that
    /// the list had no room for (StepFlags::contacts_dropped) count as one. It leaves out pairs of edges
    /// first, then those of a vertex and a triangle, of late vertices before early ones.
    std::uint32_t unresolved_pairs = 0;
    std::uint32_t restored_cloths = 0;
    float peak_speed = 0;  ///< speed of the fastest particle [m/s]
    /// Relative residual of the last substep's equation, of the worst cloth: 0 solved, 1 as if fabric and
    /// contacts had done nothing, above 1 worse than that. It is sampled: the same few particles in each
    /// step; with finite elements, in one step of 32. With the default, sheets stay below 0.25 and garments
    /// below 0.6, except in single steps. If it stays above that, the cloth is softer, or slower, than its
    /// settings say: give the method more iterations or passes, or the cloth substeps. Explicit and
    /// positional methods are measured by backward Euler's equation, which they approach as their iterations
    /// or substeps grow: with few, about 1 is normal. Cloth that was put back, its velocities being no
    /// numbers (StepFlags::state_restored), has about 1, too.
    float residual = 0;
    float milliseconds = 0;             ///< time of the whole step [ms]
    std::uint32_t broken_stitches = 0;  ///< stitches of seams that broke, see World::stitch()
};

/// The part of StepReport of one cloth; of a cloth that was not stepped only enabled, asleep and particles.
struct ClothReport {
    StepFlags flags = StepFlags::none;
    bool enabled = true, asleep = false;
    std::uint32_t particles = 0;
    std::uint32_t collider_contacts = 0;
    /// If cloths were solved together in contact, the first has all pairs, crossings and truncations, and the
    /// flags of these.
    std::uint32_t self_contacts = 0;
    std::uint32_t peak_self_contacts = 0;
    std::uint32_t truncated_particles = 0;
    std::uint32_t crossings = 0;
    std::uint32_t unresolved_pairs = 0;
    float pin_lag = 0;
    std::uint32_t limits_exceeded = 0;
    float limit_lag = 0;
    float peak_speed = 0;
    float residual = 0;
    /// Level of detail by WorldSettings::budget: 0 as the cloth is set, 1 by one pass, 2 as it is set in
    /// every second step, of twice the length.
    std::uint32_t rung = 0;
    std::uint32_t rate = 1;  ///< length of the cloth's last step, in steps of the World
    /// Time that threads took for the cloth [ms]; cloths that are solved together share it by their
    /// particles.
    float milliseconds = 0;
};

}  // namespace weft
