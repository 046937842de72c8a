#pragma once
// What touched what, for hosts that want to know.

#include <span>

#include "cloth/simulation/simulation.h"
#include "cloth/simulation/substep.h"
#include "cloth/solver/solver.h"

namespace weft {

/// Adds what colliders gave the cloth's particles in the equation; and by a change of velocities since they
/// were kept in `before`.
void add_impulses_of_equation(Worker& worker, Cloth& cloth, const StepEquation& equation);
void add_impulses_of_change(Worker& worker, Cloth& cloth, std::span<const Vec4> before);
/// What the equation's rows of contact gave each particle is kept, to be shared out among pairs.
void find_missing_impulses(const SolverStep& step, Cloth& cloth);
/// Reports a group's pairs once they are settled.
void log_pairs(Worker& worker, FeatureContact& space, std::span<Cloth* const> cloths);
/// Reports what avoidance is about to stop.
void log_avoidance(Worker& worker, Cloth& cloth, float h);
/// Finds which collider each particle with an impulse touches.
void find_touched_colliders(const Simulation& world, Worker& worker, Cloth& cloth);
/// Puts the step's list together.
void report_contacts(Simulation& world);

}  // namespace weft
