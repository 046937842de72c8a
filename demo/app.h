#pragma once
// The program with a window.

#include "demo/options.h"
#include "demo/scene_simulation.h"

namespace weft::demo {

/// Runs until the window is closed, or for Options::frames pictures. Returns the program's exit status: 1
/// where there is no display or no OpenGL 3.3.
[[nodiscard]] int run_app(const Options& options, Simulation simulation);

}  // namespace weft::demo
