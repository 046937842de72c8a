#pragma once
// Cloth in a moving frame that is to feel only a part of the frame's acceleration.
//
// The frame goes from the origin o to o + d and turns by Rot(n, a) in a step of h. Its cloth lives in a world
// in which it goes by s d and turns by Rot(n, e a), s and e being FrameInertia::linear and angular: so it
// feels s times the acceleration of its origin, e times Euler's and Coriolis', and e^2 times the centrifugal
// one. The rest carries the cloth as it is, before the step:
//     x <- o + (1 - s) d + A (x - o),   A = Rot(n, (1 - e) a)
//     v <- u + A (v - u),               u = s times the velocity of the origin in the last step
// and what is left of the centrifugal acceleration is a kick: v <- v + h (c - e^2) (w^2 r - (w . r) w), c
// being FrameInertia::centrifugal, w = n a / h, r the way from the frame's axis.

#include <optional>

#include "cloth/motion/rigid_motion.h"
#include "weft/collider.h"
#include "weft/settings.h"

namespace weft {

struct ClothState;
struct FrameState;
class Parallel;

struct Carried {
    RigidMotion by;                    ///< of all points
    Eigen::Vector3d velocity, change;  ///< u, and what it had changed by [m/s]
    Eigen::Vector3d origin;            ///< of the frame, once carried [m]
    Eigen::Vector3d spin;              ///< w [1/s]
    double outwards = 0;               ///< h (c - e^2) [s]
    bool moves = false;                ///< else there is a kick alone
};

/// What a step of dt seconds begins with; none if nothing is to be done.
[[nodiscard]] std::optional<Carried> carry_of(const FrameState& frame, const FrameInertia& inertia, float dt);
/// Does it to a cloth before a step.
void carry(Parallel& parallel, const Carried& carried, ClothState& state);
/// At its end: puts where it began back to where the last one had ended.
void leave_start_behind(Parallel& parallel, const Carried& carried, ClothState& state);
/// A step of dt seconds has ended, taken by the cloth in one part or in several: the frame is where it was to
/// be. Nothing it carries counts as faster than max_speed.
void arrive(FrameState& frame, float dt, bool in_one_part, float max_speed) noexcept;

[[nodiscard]] Collider moved(const Collider& collider, const RigidMotion& by);

/// A teleport of all that a cloth's state holds.
void move_all(Parallel& parallel, const RigidMotion& by, ClothState& state);
/// A teleport of the cloth, while its pins' targets, its skin and its frame stay.
void move_alone(Parallel& parallel, const RigidMotion& by, ClothState& state);

}  // namespace weft
