#pragma once
// Steers the wind by a gamepad.

#include "demo/window/wind_control.h"

namespace weft::demo {

/// State of the first gamepad that GLFW knows; sticks in [-1, 1], right and away from the player > 0.
struct Gamepad {
    bool is_there = false;
    float left_right = 0, left_away = 0;  ///< the left stick
    float triggers = 0;                   ///< right trigger minus left trigger, in [-1, 1]
    bool throws = false, blasts = false;  ///< buttons A and B, held
};

/// Precondition: GLFW runs.
[[nodiscard]] Gamepad read_gamepad();

/// The left stick sets the wind's heading as a camera of that yaw sees it; a released stick keeps it. The
/// triggers change the speed, by up to twice the keys' rate.
void steer_by(const Gamepad& pad, float camera_yaw, float seconds, WindControl& wind);

}  // namespace weft::demo
