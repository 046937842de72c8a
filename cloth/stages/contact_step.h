#pragma once
// Contact of features in a step: groups of cloths that may touch, detection, and the cut of their motion, so
// that nothing crosses anew.

#include <span>

#include "cloth/simulation/simulation.h"
#include "cloth/simulation/substep.h"

namespace weft {

/// Predicts the swept range of the cloth in a substep of h seconds.
void expect(const Simulation& world, Cloth& cloth, float h);
/// Finds the groups of cloths that may touch, by their swept ranges.
void meet(Simulation& world);

/// Places the group's features at their positions, and detects the pairs that are near over h seconds.
void find_features(Simulation& world, Worker& worker, FeatureContact& space, std::span<Cloth* const> cloths,
                   float h);
/// Cuts the motion of a part of a substep, so that nothing crosses anew. No later stage moves particles.
void settle_features(Simulation& world, Worker& worker, FeatureContact& space, std::span<Cloth* const> cloths,
                     const Substep& part);
/// Repeats the cut without common motion, if that has moved cloth into colliders or out of its own space.
void keep_common_motion_out(const Simulation& world, Worker& worker, FeatureContact& space,
                            std::span<Cloth* const> cloths, float h);
/// Whether the common motion has moved any of the cloth out of its own space.
[[nodiscard]] bool is_taken_out_of_own_space(const Simulation& world, Worker& worker, FeatureContact& space,
                                             std::size_t body, const Cloth& cloth);

}  // namespace weft
