#pragma once
// Reports of contacts, for hosts that ask for them.

#include <span>

#include "cloth/simulation/simulation.h"
#include "cloth/simulation/substep.h"
#include "cloth/solver/solver.h"

namespace weft {

/// Add colliders' impulses on the cloth's particles: those in the equation; those that changed velocities
/// since `before`.
void add_impulses_of_equation(Worker& worker, Cloth& cloth, const StepEquation& equation);
void add_impulses_of_change(Worker& worker, Cloth& cloth, std::span<const Vec4> before);
/// Stores the impulse of the equation's contact rows on each particle, to be credited to pairs later.
void find_missing_impulses(const SolverStep& step, Cloth& cloth);
/// Reports a group's pairs once they are settled.
void log_pairs(Worker& worker, FeatureContact& space, std::span<Cloth* const> cloths);
/// Reports the pairs whose approach avoidance is about to stop.
void log_avoidance(Worker& worker, Cloth& cloth, float h);
/// Finds which collider each particle with an impulse touches.
void find_touched_colliders(const Simulation& world, Worker& worker, Cloth& cloth);
/// Makes the step's list of contacts.
void report_contacts(Simulation& world);

}  // namespace weft
