#pragma once
// Bodies as unknowns of the equation of the cloths that touch them. A contact gives particle i the impulse
// c_i - G_i (v_i - A_i V) and the body the opposite, where A_i V is the velocity of the body's point there.
// With its own balance M (V - V_free) = -sum A_i^T (...) the body is eliminated from the cloth's equation,
//     W dv - U R U^T dv = b + U R g,   U_i = G_i A_i,   R = (M + sum A_i^T G_i A_i)^-1,
// six columns a body, which are multiplied out and never stored: W is made as if bodies were kinematic.

#include <cstdint>
#include <span>
#include <vector>

#include "cloth/equation/moving_body.h"
#include "cloth/equation/step_equation.h"
#include "collision/shapes/collider_motion.h"
#include "weft/collider.h"
#include "weft/types.h"

namespace weft {

/// A collider that a body carries.
struct CarriedCollider {
    std::uint32_t motion;  ///< its place among the substep's
    std::uint32_t body;
    const Collider* own;  ///< in the body's frame
};

/// Momentum that History took from the base of a particle that a collider held [kg m/s].
[[nodiscard]] Vector3 forgotten(const StepEquation& equation, std::uint32_t particle);

class BodyCoupling {
  public:
    /// Reserves memory for these numbers of bodies and of cloths that are solved together.
    void reserve(std::size_t bodies, std::size_t cloths);

    /// Begins a solve with these bodies and the motions of their colliders.
    void begin(std::span<MovingBody> bodies, std::span<const CarriedCollider> carried,
               std::span<ColliderMotion> motions);
    /// Adds a cloth's equation; cloths are numbered in the order of these calls. Its contacts list the
    /// pushes.
    void join(const StepEquation& equation) { equations_.push_back(&equation); }
    [[nodiscard]] std::size_t cloths() const noexcept { return equations_.size(); }

    // A linearisation, after those of the contacts of all cloths at `velocities`: all cloths are gathered,
    // then bodies are eliminated.
    void gather(std::size_t cloth, std::span<const Vec4> velocities);
    void eliminate();
    /// Adds U R g to the right-hand side b.
    void add_to_right_side(std::size_t cloth, std::span<Vec4> right_side) const;

    // A product with the matrix: all cloths are taken, then each is given its part.
    void take(std::size_t cloth, std::span<const Vec4> x);
    /// Returns -x . U R U^T x.
    double respond();
    /// product -= U R U^T x.
    void give(std::size_t cloth, std::span<Vec4> product) const;

    // After a change of velocities: bodies, their colliders and the contacts' constant impulses follow.
    void look(std::size_t cloth, std::span<const Vec4> velocities);
    void follow();
    /// Moves the colliders to where bodies are now.
    void move_colliders();

  private:
    struct Eliminated {
        Matrix6 stiffness = Matrix6::Zero();     // sum A^T G A
        Vector6 pressed = Vector6::Zero();       // sum A^T of the impulses that contacts give cloth
        Vector6 sum = Vector6::Zero();           // sum A^T G x of what is taken
        Vector6 answer = Vector6::Zero();        // R sum
        Vector6 extra = Vector6::Zero();         // R g
        Vector6 departure = Vector6::Zero();     // z: V = V_free + root z
        Vector6 missing = Vector6::Zero();       // root^T g
        Matrix6 response = Matrix6::Identity();  // (1 + root^T stiffness root)^-1: R = root response root^T
    };
    template <class Visit>
    void for_each_push(std::size_t cloth, const Visit& visit) const;

    std::span<MovingBody> bodies_;
    std::span<const CarriedCollider> carried_;
    std::span<ColliderMotion> motions_;
    std::vector<const StepEquation*> equations_;
    std::vector<Eliminated> eliminated_;
    bool is_first_ = true;
};

}  // namespace weft
