#pragma once
// The wind as a player steers it: by keys, and by a gamepad.

#include "weft/types.h"

namespace weft::demo {

/// A heading seen from above and a speed along the ground; the vertical component is not changed. The heading
/// is kept while the air is still, so that the wind returns with the same heading.
class WindControl {
  public:
    static constexpr float max_speed = 100.0f;  ///< along the ground [m/s], the most that --wind takes
    static constexpr float turn_rate = 1.6f;    ///< turning by keys [rad/s]
    static constexpr float speed_rate = 4.0f;   ///< change of speed by keys [m/s^2]

    WindControl() = default;
    explicit WindControl(const Vec3& velocity);

    /// The angle from +X to where the wind blows, anticlockwise seen from above, in (-pi, pi] [rad].
    [[nodiscard]] float heading() const { return heading_; }
    [[nodiscard]] float speed() const { return speed_; }
    [[nodiscard]] Vec3 velocity() const;

    void set_heading(float radians);
    void set_speed(float metres_per_second);  ///< kept within [0, max_speed]
    /// Keys held for `seconds`: `turn` 1 anticlockwise, -1 clockwise; `faster` 1, or -1 for slower.
    void steer(float turn, float faster, float seconds);

  private:
    float heading_ = 0, speed_ = 0, upwards_ = 0;
};

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
