#pragma once
// The part of the frame that features have: which cloths may touch, what is near what, and motion that lets
// nothing through.

#include <span>

#include "cloth/simulation/simulation.h"
#include "cloth/simulation/substep.h"

namespace weft {

/// Finds where the cloth will be in a substep of h seconds as far as can be told.
void expect(const Simulation& world, Cloth& cloth, float h);
/// Finds the groups of cloths that may touch, by where they are expected.
void meet(Simulation& world);

/// Lays out the group's features where they are, and finds what is near what over h seconds.
void find_features(Simulation& world, Worker& worker, FeatureContact& space, std::span<Cloth* const> cloths,
                   float h);
/// The last that moves particles in a part of a substep: what would pass through anything is cut.
void settle_features(Simulation& world, Worker& worker, FeatureContact& space, std::span<Cloth* const> cloths,
                     const Substep& part);
/// Cuts anew, without common motion, where that has moved cloth into colliders or to other groups.
void keep_common_motion_out(const Simulation& world, Worker& worker, FeatureContact& space,
                            std::span<Cloth* const> cloths, float h);
/// Whether some of the cloth is at another group's side.
[[nodiscard]] bool is_taken_out_of_own_space(const Simulation& world, Worker& worker, FeatureContact& space,
                                             std::size_t body, const Cloth& cloth);

}  // namespace weft
