#pragma once
// Commands of weft_study. Each returns the program's exit status: 0, or 1 after a message on standard error.

#include "demo/study/study_options.h"

namespace weft::study {

/// Speed against accuracy: every method over its settings, compared with the references.
int run_accuracy(const StudyOptions& options);
/// Where methods fail: stiffness against step, from flat, crumpled and collapsed starts.
int run_stability(const StudyOptions& options);
/// Measured beside known: strips, drapes, pendulums, friction and flags, by every force model.
int run_physics(const StudyOptions& options);
/// Time schemes: energy, nearness to the truth, rest, dependence on the step, and time.
int run_motion(const StudyOptions& options);
/// Crossing triangles: scenes where cloth collides with cloth, by every rung of self-collision.
int run_contact(const StudyOptions& options);
/// With --searches: recall, distance tests and time of the broad phases of avoidance.
int run_searches(const StudyOptions& options);
/// Time and motion error of many cloths: a budget beside one setting for all.
int run_budget(const StudyOptions& options);
/// All tables and charts that demo/charts keeps.
int run_all(const AllOptions& options);
/// Charts of the tables that the other commands wrote.
int run_plot(const PlotOptions& options);

}  // namespace weft::study
