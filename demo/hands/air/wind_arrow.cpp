#include "demo/hands/air/wind_arrow.h"

#include <algorithm>
#include <cmath>

namespace weft::demo {
namespace {

constexpr float least_pitch = 0.6f;                 // [rad]
constexpr float shortest = 0.05f, longest = 0.30f;  // length in still air, and its limit in a storm
constexpr float half_way = 10;                      // speed at the length midway between them [m/s]
constexpr Vec2 foot_from_middle = {0, 0.24f};

float length_at(float speed) {
    return shortest + (longest - shortest) * speed / (speed + half_way);
}
float speed_at(float length) {
    constexpr float nearly = 0.999f;
    const float part = std::clamp((length - shortest) / (longest - shortest), 0.0f, nearly);
    return half_way * part / (1 - part);
}

}  // namespace

void WindArrow::place(const render::OrbitCamera& camera, float aspect) {
    foot_ = {0.5f * aspect + foot_from_middle.x, 0.5f + foot_from_middle.y};
    heading_ = camera.yaw + 1.5707963f;
    rise_ = std::sin(std::max(std::abs(camera.pitch), least_pitch));
}

Vec2 WindArrow::at(float right, float away) const {
    return {foot_.x + right, foot_.y - rise_ * away};
}

Vec2 WindArrow::tip(const WindControl& wind) const {
    const float left = wind.heading() - heading_, length = length_at(wind.speed());
    return at(-length * std::sin(left), length * std::cos(left));
}

bool WindArrow::is_under(Vec2 pointer, const WindControl& wind) const {
    const Vec2 end = tip(wind);
    const float x = end.x - foot_.x, y = end.y - foot_.y;
    const float dx = pointer.x - foot_.x, dy = pointer.y - foot_.y;
    const float part = std::clamp((dx * x + dy * y) / (x * x + y * y), 0.0f, 1.0f);
    return std::hypot(dx - part * x, dy - part * y) < reach;
}

void WindArrow::drag(Vec2 pointer, WindControl& wind) const {
    const float right = pointer.x - foot_.x, away = (foot_.y - pointer.y) / rise_;
    const float length = std::hypot(right, away);
    if (length > 0.3f * shortest) wind.set_heading(heading_ - std::atan2(right, away));
    wind.set_speed(speed_at(length));
}

}  // namespace weft::demo
