#pragma once
// Cloth in a moving reference frame, with only a part of the frame's inertial forces.
//
// In a step of h the frame's origin o moves to o + d, and the frame turns by Rot(n, a). The cloth is
// simulated as if the frame moved by s d and turned by Rot(n, e a), s and e being FrameInertia::linear and
// angular: s times the origin's acceleration acts on it, e times Euler's and Coriolis', and e^2 times the
// centrifugal one. The rest of the frame's motion transports the cloth rigidly before the step:
//     x <- o + (1 - s) d + A (x - o),   A = Rot(n, (1 - e) a)
//     v <- u + A (v - u),               u = s times the velocity of the origin in the last step
// The rest of the centrifugal acceleration is a kick: v <- v + h (c - e^2) (w^2 r - (w . r) w), c being
// FrameInertia::centrifugal, w = n a / h, and r the position relative to the moved origin.

#include <optional>

#include "cloth/motion/rigid_motion.h"
#include "weft/collider.h"
#include "weft/settings.h"

namespace weft {

struct ClothState;
struct FrameState;
class Parallel;

/// How a frame transports its cloth before a step.
struct Carried {
    RigidMotion by;                    ///< motion of all points
    Eigen::Vector3d velocity, change;  ///< u, and its change in the last step [m/s]
    Eigen::Vector3d origin;            ///< of the frame, after the transport [m]
    Eigen::Vector3d spin;              ///< w [1/s]
    double outwards = 0;               ///< h (c - e^2) [s]
    bool moves = false;                ///< false: there is the kick alone
};

/// The part of a frame's motion in a step that acts on its cloth: what the cloth's velocities are measured
/// by.
struct ActingMotion {
    Vector3 velocity = Vector3::Zero();  ///< of the origin [m/s]
    Vector3 spin = Vector3::Zero();      ///< [1/s]
    Vector3 origin = Vector3::Zero();    ///< [m]
};
[[nodiscard]] ActingMotion acting_motion(const FrameState& frame, const FrameInertia& inertia, float dt);
/// Clamps the velocities of free particles, less the motion of their place, to the length `max_speed` [m/s].
void limit_speeds(Parallel& parallel, const ActingMotion& of, float max_speed,
                  std::span<const Vec4> positions, std::span<Vec4> velocities);

/// The rigid motion of a frame that jumps: one whose way to its target is longer than `distance` [m], or
/// whose turn is wider than `angle` [rad]; 0: no such limit. None if it does not jump. The motion leaves out
/// what the frame would have gone on in dt seconds at its last speed, so that pins keep their speed.
[[nodiscard]] std::optional<RigidMotion> jump_of(const FrameState& frame, float distance, float angle,
                                                 float dt);
/// Teleports a cloth with its frame before a step. The frame keeps its target. A pin's target goes along
/// where that makes the pin's way shorter; the skin's goes along if the host has not set it for this step.
void jump(Parallel& parallel, const RigidMotion& by, ClothState& state);

/// The transport before a step of dt seconds; none if there is neither motion nor kick.
[[nodiscard]] std::optional<Carried> carry_of(const FrameState& frame, const FrameInertia& inertia, float dt);
/// Applies the transport to a cloth, before a step.
void carry(Parallel& parallel, const Carried& carried, ClothState& state);
/// At the end of the step: moves previous_positions back to where the last step ended.
void leave_start_behind(Parallel& parallel, const Carried& carried, ClothState& state);
/// Ends a step of dt seconds, which the cloth took in one part or in several: the frame is at its target. Its
/// velocity is clamped to max_speed.
void arrive(FrameState& frame, float dt, bool in_one_part, float max_speed) noexcept;

[[nodiscard]] Collider moved(const Collider& collider, const RigidMotion& by);

/// Teleports all that a cloth's state holds.
void move_all(Parallel& parallel, const RigidMotion& by, ClothState& state);
/// Teleports the cloth, while its pins' targets, its skin and its frame stay.
void move_alone(Parallel& parallel, const RigidMotion& by, ClothState& state);

}  // namespace weft
