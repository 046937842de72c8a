#pragma once
// What World::step says about the step that it took.

#include <cstdint>
#include <span>

#include "weft/profile.h"

namespace weft {

/// What World::step takes [s]. Below a microsecond single precision loses what a step changes.
inline constexpr float least_step = 1e-6f, greatest_step = 1;

/// Each flag names the setting to change.
enum class StepFlags : std::uint32_t {
    none = 0,
    /// dt was below least_step, above greatest_step, or no number: nothing was done. Pass one between them,
    /// as 1/60 s.
    invalid_dt = 1u << 0,
    /// A cloth's state stopped being finite, or left the 100 km around the origin. It is back at the start of
    /// the step, at rest. Lower the step, raise WorldSettings::substeps, or soften ClothSettings::fabric.
    state_restored = 1u << 1,
    /// More is close than there is memory for. By avoidance, particles have more neighbours than a list holds
    /// (16), and the rest wait for the next step. By contact, there are more than 16 pairs of features a
    /// particle: those of the list are pushed apart, and what touches goes a part of its way in this step, or
    /// one common way, or nowhere where it is pinned; nothing crosses. By impact zones, those that the list
    /// has no room for are let through. Lower SelfCollision::distance.
    contacts_dropped = 1u << 2,
    /// Particles were held to WorldSettings::max_speed; pins, too, that were to go faster: they get to their
    /// targets, but cloth follows at that speed. Raise it if they should be faster; otherwise look for a pin
    /// or a collider that jumps.
    speed_limited = 1u << 3,
    /// The method left more of a cloth's equation unsolved than Multilevel::tolerance: the cloth may stretch
    /// or lag. Raise ClothSettings::substeps, or Multilevel::passes;
    /// or lower Fabric::warp and weft over shear, or Fabric::damping.
    unsolved = 1u << 4,
    /// A pin was stopped by cloth that it would have had to pass through, see StepReport::pin_lag: no motion
    /// of the rest makes room. Move pins slower, or another way.
    pins_stopped = 1u << 5,
    /// By contact, something crosses that did not when the step began: a fault of Weft, please report it.
    /// Only builds with assertions look for it, since that takes as long as a search.
    crossed = 1u << 6,
    /// By step(): World::begin_step() began a step that has not ended, or another thread is in step().
    /// Nothing was done. Call end_step(); make calls of one World one after the other.
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
    std::uint32_t cloths = 0;             ///< that are enabled
    std::uint32_t sleeping_cloths = 0;    ///< of these, which were not stepped
    std::uint32_t reduced_cloths = 0;     ///< of these, whose rung is not 0: see ClothReport
    std::uint32_t particles = 0;          ///< that were stepped
    std::uint32_t collider_contacts = 0;  ///< particles that met a collider, in the last substep
    std::uint32_t self_contacts = 0;      ///< pairs that are close, in the last substep
    /// All that there were, in the whole step, for World::contacts() to choose from; 0 where
    /// WorldSettings::contact_reports is.
    std::uint32_t contacts = 0;
    std::uint32_t peak_self_contacts = 0;  ///< most of one particle, in the last substep; by avoidance
    /// By contact: particles that went less far than was solved for, in the last substep, since they would
    /// have passed through cloth.
    std::uint32_t truncated_particles = 0;
    float pin_lag = 0;  ///< the farthest that a pin is from its target, stopped by cloth [m]
    /// Particles that are beyond their leash or in their backstop, since cloth was in their way, by more than
    /// 1e-6 m; and the farthest of them [m].
    std::uint32_t limits_exceeded = 0;
    float limit_lag = 0;
    /// Places where an edge goes through a triangle, by contact, at the start of the last substep. Only a
    /// state that was given so has any, or one that was put back. Contact lets them apart, which may take a
    /// second, and counts more of them for a while on the way. Hooked folds can stay.
    std::uint32_t crossings = 0;
    /// Pairs of features that still collide after all rounds of impact zones of the last substep. Where the
    /// list had no room for all (StepFlags::contacts_dropped), the pairs that it left out count as one: pairs
    /// of edges first, then those of a vertex and a triangle, of late vertices before early ones.
    std::uint32_t unresolved_pairs = 0;
    std::uint32_t restored_cloths = 0;
    float peak_speed = 0;  ///< fastest particle [m/s]
    /// How far the worst cloth's velocities are from solving the equation of the step's last substep: 0
    /// solved, 1 fabric and contacts have done nothing; above 1, they have done harm. A sample: the same few
    /// particles in each step; with finite elements, of one step in 32. With the default, sheets stay below
    /// 0.25 and garments below 0.6, but for single steps. Where it stays above that the cloth is softer, or
    /// slower, than its settings say: give the method more iterations or passes, or the cloth substeps.
    /// Explicit and positional methods are measured by backward Euler's equation, which they approach as
    /// their iterations or substeps grow: with few, about 1 is what they have. So has cloth whose velocities
    /// are no numbers, and that was put back (StepFlags::state_restored).
    float residual = 0;
    float milliseconds = 0;  ///< the whole step
};

/// Of one cloth, what StepReport has of all together; of cloth that was not stepped, nothing.
struct ClothReport {
    StepFlags flags = StepFlags::none;
    bool enabled = true, asleep = false;
    std::uint32_t particles = 0;
    std::uint32_t collider_contacts = 0;
    /// Of cloths that were solved together in contact, the first has all pairs, crossings and truncations,
    /// and the flags of these.
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
    /// How WorldSettings::budget has the cloth stepped: 0 as it is set, 1 by one pass, 2 as it is set in
    /// every second step, of twice the length.
    std::uint32_t rung = 0;
    std::uint32_t rate = 1;  ///< steps that its last one was long
    /// That its threads took for it; cloths that are solved together share this by their particles.
    float milliseconds = 0;
};

}  // namespace weft
