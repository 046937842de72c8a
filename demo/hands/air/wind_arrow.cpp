#include "demo/hands/air/wind_arrow.h"

#include <algorithm>
#include <cmath>

#include "engine/vector.h"

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

namespace {

constexpr float shortest_life = 0.8f, longest_life = 2.0f;  // [s]
constexpr std::size_t turns = 6;  // steps in which every mote casts its ray once, for time

}  // namespace

float Streaks::random() {
    seed_ = 1664525u * seed_ + 1013904223u;  // Numerical Recipes' linear congruential generator
    return static_cast<float>(seed_ >> 8) * 0x1p-24f;
}

void Streaks::renew(Mote& mote) {
    const auto within = [&](float middle) { return middle + half_side_ * (2 * random() - 1); };
    mote.trail[0] = {within(middle_.x), std::max(0.02f, within(middle_.y)), within(middle_.z)};
    mote.kept = 1;
    mote.age = 0;
    mote.before_cloth = false;
    mote.lasts = shortest_life + (longest_life - shortest_life) * random();
}

void Streaks::begin(const Vec3& middle, float half_side) {
    middle_ = middle;
    half_side_ = half_side;
    motes_.assign(count, {});
    for (Mote& mote : motes_) {
        renew(mote);
        mote.age = mote.lasts * random();
    }
}

void Streaks::step(const World& world, float dt, const Vec3& eye) {
    if (!visible) return;
    places_.clear();
    for (const Mote& mote : motes_) places_.push_back(mote.trail[0]);
    air_.resize(places_.size());
    if (!world.sample_air(places_, air_)) return;
    turn_ = (turn_ + 1) % turns;
    for (std::size_t k = 0; k < motes_.size(); ++k) {
        Mote& mote = motes_[k];
        mote.age += dt;
        const Vector3 air = to_vector(air_[k]), there = to_vector(mote.trail[0]) + dt * air;
        if (mote.age > mote.lasts || (there - to_vector(middle_)).cwiseAbs().maxCoeff() > half_side_) {
            renew(mote);
            continue;
        }
        std::copy_backward(mote.trail.begin(), mote.trail.end() - 1, mote.trail.end());
        mote.trail[0] = to_vec3(there);
        mote.kept = std::min(mote.kept + 1, length);
        mote.speed = air.norm();
        if (k % turns != turn_) continue;
        const auto hit = world.cast_ray(mote.trail[0], to_vec3(there - to_vector(eye)));
        mote.before_cloth = hit && hit->has_value();
    }
}

std::vector<render::DrawnLine> Streaks::lines() const {
    std::vector<render::DrawnLine> lines;
    if (!visible) return lines;
    for (const Mote& mote : motes_) {
        if (mote.before_cloth) continue;
        const float youth = std::min(1.0f, std::min(mote.age, mote.lasts - mote.age) / 0.25f);
        const float strength = 0.65f * youth * std::min(1.0f, mote.speed / 6);
        for (std::size_t k = 0; k + 1 < mote.kept; ++k) {
            const float newer = 1 - static_cast<float>(k) / length;
            lines.push_back({mote.trail[k], mote.trail[k + 1], {1, 1, 1}, strength * newer});
        }
    }
    return lines;
}

}  // namespace weft::demo
