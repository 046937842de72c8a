#pragma once
// Seams in a step: which cloths they join, their rows in an equation, and what breaks.

#include <span>

#include "cloth/simulation/simulation.h"

namespace weft {

/// Whether a seam joins two of the cloths that the step takes.
[[nodiscard]] bool joins_cloths(const Simulation& world);
/// Merges the groups of the cloths that the step takes, where seams join them. Follows a search for groups.
void join_seams(Simulation& world);
/// Cloths of a group that seams join take their step by one time scheme: by that of first order, if one of
/// them has no last step to go on from. Otherwise each would be fixed in the other's equation.
void agree_on_order(std::span<Cloth* const> group, float h);
/// Begins the seams of cloths whose equations are made; all other cloth is fixed where it is.
void begin_seams(Simulation& world, std::span<Cloth* const> set, float gamma);
/// Breaks stitches, at the velocities that were solved for.
void end_seams(Simulation& world, std::span<Cloth* const> set);

}  // namespace weft
