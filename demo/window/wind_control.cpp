#include "demo/window/wind_control.h"

#include <GLFW/glfw3.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#define GLFW_INCLUDE_NONE

namespace weft::demo {

WindControl::WindControl(const Vec3& velocity) : upwards_(velocity.y) {
    set_speed(std::hypot(velocity.x, velocity.z));
    if (speed_ > 0) heading_ = std::atan2(-velocity.z, velocity.x);
}

Vec3 WindControl::velocity() const {
    return {speed_ * std::cos(heading_), upwards_, -speed_ * std::sin(heading_)};
}

void WindControl::set_heading(float radians) {
    constexpr float turn = 2 * std::numbers::pi_v<float>;
    heading_ = radians - turn * std::ceil(radians / turn - 0.5f);
}

void WindControl::set_speed(float metres_per_second) {
    speed_ = std::clamp(metres_per_second, 0.0f, max_speed);
}

void WindControl::steer(float turn, float faster, float seconds) {
    set_heading(heading_ + turn * turn_rate * seconds);
    set_speed(speed_ + faster * speed_rate * seconds);
}

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
