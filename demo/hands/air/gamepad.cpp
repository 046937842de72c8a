#include "demo/hands/air/gamepad.h"

#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>

#include <cmath>

namespace weft::demo {
namespace {

constexpr float still = 0.25f;  // dead zone of a stick

}  // namespace

Gamepad read_gamepad() {
    for (int which = GLFW_JOYSTICK_1; which <= GLFW_JOYSTICK_LAST; ++which) {
        GLFWgamepadstate state;
        if (glfwGetGamepadState(which, &state) != GLFW_TRUE) continue;
        const auto axis = [&](int number) { return state.axes[number]; };
        return {
            .is_there = true,
            .left_right = axis(GLFW_GAMEPAD_AXIS_LEFT_X),
            .left_away = -axis(GLFW_GAMEPAD_AXIS_LEFT_Y),
            .triggers = 0.5f * (axis(GLFW_GAMEPAD_AXIS_RIGHT_TRIGGER) - axis(GLFW_GAMEPAD_AXIS_LEFT_TRIGGER)),
            .throws = state.buttons[GLFW_GAMEPAD_BUTTON_A] == GLFW_PRESS,
            .blasts = state.buttons[GLFW_GAMEPAD_BUTTON_B] == GLFW_PRESS};
    }
    return {};
}

void steer_by(const Gamepad& pad, float camera_yaw, float seconds, WindControl& wind) {
    if (!pad.is_there) return;
    constexpr float quarter_turn = 1.5707963f;
    if (std::hypot(pad.left_right, pad.left_away) > still)
        wind.set_heading(camera_yaw + quarter_turn - std::atan2(pad.left_right, pad.left_away));
    if (std::abs(pad.triggers) > 0.05f) wind.steer(0, 2 * pad.triggers, seconds);
}

}  // namespace weft::demo
