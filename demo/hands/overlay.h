#pragma once
// The hands' overlay on the picture: the wind's arrow, the fan, the blast, pins.

#include "demo/hands/hands.h"

namespace weft::demo {

/// Draws the overlay under all panels, with dots at pins if `pins` is set. Called between ImGuiLayer's
/// begin() and end().
void draw_overlay(const Hands& hands, const Simulation& simulation, const render::OrbitCamera& camera,
                  const WindControl& wind, bool pins);

/// Adds the hands' controls, and a line for each of their keys, to the open panel.
void hands_controls(Hands& hands);
/// A section of the column with these controls.
void hands_panel(Hands& hands);

}  // namespace weft::demo
