#pragma once
// How colliders and limits move over a substep, as cloths see them that frames carry.

#include <span>

#include "cloth/simulation/simulation.h"
#include "cloth/simulation/substep.h"

namespace weft {

/// Plans how frames carry cloths before a step of dt seconds.
void plan_carries(Simulation& world, float dt);

/// Finds how colliders move that a set's cloths may meet; a cloth that is carried sees them its own way.
void see_colliders(const Simulation& world, Worker& worker, std::span<Cloth* const> set,
                   const Substep& substep);
[[nodiscard]] inline std::vector<ColliderMotion>& colliders_of(const Worker& worker, Cloth& cloth) {
    return cloth.carried ? cloth.seen_colliders : worker.motions;
}
/// Those of them that are in the cloth's equation.
[[nodiscard]] inline std::span<const ColliderMotion> colliders_in_equation(const Worker& worker,
                                                                           Cloth& cloth) {
    return meets_in_equation(cloth.settings) ? std::span<const ColliderMotion>(colliders_of(worker, cloth))
                                             : std::span<const ColliderMotion>();
}
/// Begins the cloth's contacts in an equation, if it has any.
void begin_contacts(const Worker& worker, Cloth& cloth, const ClothSide& side, const Substep& part);

/// Puts the cloth back within its leashes and backstops.
void hold_worn(Simulation& world, Worker& worker, Cloth& cloth);
/// Once the step has ended: how far limits gave way to cloth, and what the next step begins with.
void end_worn(Worker& worker, Cloth& cloth);

}  // namespace weft
