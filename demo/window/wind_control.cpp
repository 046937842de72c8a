#include "demo/window/wind_control.h"

#include <algorithm>
#include <cmath>
#include <numbers>

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

}  // namespace weft::demo
