#pragma once
// Hands' things drawn over the picture: the wind's arrow, the fan, the blast, pins.

#include "demo/hands/hands.h"

namespace weft::demo {

/// Between ImGuiLayer's begin() and end(); it lies under all panels.
void draw_overlay(const Hands& hands, const Simulation& simulation, const render::OrbitCamera& camera,
                  const WindControl& wind);

/// The controls of hands, in whatever panel is open, and a line for each of their keys.
void hands_controls(Hands& hands);
/// A section of the column with them.
void hands_panel(Hands& hands);

}  // namespace weft::demo
