#pragma once
// The program with a window.

#include <functional>

#include "demo/hands/hands.h"
#include "demo/options/options.h"
#include "demo/panels/panels.h"
#include "demo/scene_simulation.h"
#include "demo/time/timeline.h"

namespace weft::demo {

/// The program's state after a picture, for an observer.
struct AppFrame {
    int number = 0;  ///< from 0
    const Simulation& simulation;
    const WindControl& wind;
    const Hands& hands;
    const Timeline& timeline;
    const Playback& playback;
    const render::OrbitCamera& camera;
    const Panels& panels;
};
/// An observer, called after each picture; false closes the window.
using AppLook = std::function<bool(const AppFrame&)>;

/// Runs until the window is closed, or for Options::frames pictures. Returns the program's exit status: 1
/// where there is no display or no OpenGL 3.3.
[[nodiscard]] int run_app(const Options& options, Simulation simulation, const AppLook& look = {});

}  // namespace weft::demo
