#pragma once
// Transport of cloths by their frames; motions of colliders and of worn limits over a substep.

#include <span>

#include "cloth/simulation/simulation.h"
#include "cloth/simulation/substep.h"

namespace weft {

/// Before a step of dt seconds: teleports cloths whose frames jump, and plans the transport by their frames.
void plan_carries(Simulation& world, float dt);

/// Fills `motions` with those of the unattached colliders with any of these layers over the substep, triggers
/// left out. `cloth`: the cloth whose transport and teleport they are relative to, or null.
void fill_motions(const Simulation& world, std::vector<ColliderMotion>& motions, std::uint32_t mask,
                  const Substep& substep, const Cloth* cloth);
/// Updates the motions of colliders that a set's cloths may meet. A cloth that its frame transports has a
/// list of its own, relative to the transport.
void see_colliders(const Simulation& world, Worker& worker, std::span<Cloth* const> set,
                   const Substep& substep);
[[nodiscard]] inline std::vector<ColliderMotion>& colliders_of(const Worker& worker, Cloth& cloth) {
    return cloth.sees_own_colliders() ? cloth.seen_colliders : worker.motions;
}
/// Motions of the colliders that are in the cloth's equation.
[[nodiscard]] inline std::span<const ColliderMotion> colliders_in_equation(const Worker& worker,
                                                                           Cloth& cloth) {
    return meets_in_equation(cloth.settings) ? std::span<const ColliderMotion>(colliders_of(worker, cloth))
                                             : std::span<const ColliderMotion>();
}
/// Begins the cloth's contacts in an equation, if it has any.
void begin_contacts(const Worker& worker, Cloth& cloth, const ClothSide& side, const Substep& part);

/// Puts the cloth back within its leashes and backstops.
void hold_worn(Simulation& world, Worker& worker, Cloth& cloth);
/// After the step: measures by how much worn limits gave way, and moves the skin to its targets.
void end_worn(Worker& worker, Cloth& cloth);

}  // namespace weft
