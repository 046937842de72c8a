#pragma once
// The part of the frame that bodies have; see body_stage.h.

#include <span>

#include "cloth/simulation/simulation.h"
#include "cloth/simulation/substep.h"

namespace weft {

/// Whether the cloth is attached to a body, or one may come near it in a step of dt seconds.
[[nodiscard]] bool is_near_bodies(const Simulation& world, const Cloth& cloth, float dt);

/// Around all groups' solves.
void begin_bodies(Simulation& world, const Substep& substep);
void end_bodies(Simulation& world, const Substep& substep);

/// Bounding box of a collider that is no plane.
[[nodiscard]] Bounds box_of(const Collider& collider, const HeldShape* held);
/// Keeps a body that moves as expected out of the colliders that no body carries.
void stop_at_colliders(Simulation& world, std::size_t number, const Substep& part);

/// Around a group's solve: it integrates bodies over the substep.
void take_bodies(Simulation& world, std::span<Cloth* const> cloths, const Substep& substep);
void leave_bodies(Simulation& world, std::span<Cloth* const> cloths);

/// Around one equation's solve, with the cloths of a set; then the end of the group's part.
void start_part_of_bodies(Simulation& world, std::span<Cloth* const> cloths, const Substep& part,
                          float gamma);
void finish_part_of_bodies(Simulation& world, std::span<Cloth* const> cloths);
void end_part_of_bodies(Simulation& world, std::span<Cloth* const> cloths);

/// Adds the motions of colliders that bodies carry.
void add_carried_motions(const Simulation& world, std::vector<ColliderMotion>& motions, std::uint32_t mask,
                         const Substep& substep);
/// Puts bodies into a cloth's equation; then takes what it gave them.
void carry_bodies(Simulation& world, Cloth& cloth, StepEquation& equation);
void collect_from_equation(Simulation& world, Cloth& cloth, const StepEquation& equation);
void keep_momentum_of_bodies(Simulation& world, std::span<Cloth* const> cloths,
                             std::span<const StepEquation> equations);
/// See collide(): of a cloth that may meet bodies.
[[nodiscard]] std::uint32_t collide_with_bodies(Simulation& world, Worker& worker, Cloth& cloth, float h,
                                                std::span<const Vec4> starts);
/// Puts attached particles where their bodies are.
void place_attached(Simulation& world, std::span<Cloth* const> cloths);

}  // namespace weft
