#pragma once
// A run without a window: a fixed number of steps, then pictures, tables and a hash.

#include "demo/options/options.h"
#include "demo/scene_simulation.h"

namespace weft::demo {

/// Leaves in Options::out: final.png (or pictures of every n-th frame), frame_times.csv, final.obj; prints
/// the stages' percentiles and the state hash. Returns the program's exit status: 2 for a folder that cannot
/// be used, 1 where something could not be drawn or written; the rest is done all the same.
[[nodiscard]] int run_headless(const Options& options, Simulation& simulation);

}  // namespace weft::demo
