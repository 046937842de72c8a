#include "demo/character/body/round_cone.h"

#include <cmath>

namespace weft::demo {
namespace {

SurfaceDistance from_ball(const Vector3& point, const Vector3& centre, float radius) {
    const Vector3 away = point - centre;
    const float distance = away.norm();
    return {distance - radius, distance > 0 ? Vector3(away / distance) : Vector3::UnitY()};
}

}  // namespace

RoundCone::RoundCone(const Vector3& a, const Vector3& b, float radius_a, float radius_b)
    : a_(a), b_(b), radius_a_(radius_a), radius_b_(radius_b) {
    const Vector3 axis = b - a;
    length_ = axis.norm();
    const float shrink = radius_a - radius_b;
    is_ball_ = length_ <= std::abs(shrink);
    if (is_ball_) return;
    along_ = axis / length_;
    sine_ = shrink / length_;
    cosine_ = std::sqrt(1 - sine_ * sine_);
}

SurfaceDistance RoundCone::distance_to(const Vector3& point) const {
    if (is_ball_)
        return radius_a_ > radius_b_ ? from_ball(point, a_, radius_a_) : from_ball(point, b_, radius_b_);
    const Vector3 from_a = point - a_;
    const float x = from_a.dot(along_);
    const Vector3 across = from_a - x * along_;
    const float y = across.norm();
    const float t =
        (x - y * sine_ / cosine_) / length_;  // where the cone's normal through the point meets the axis
    if (t <= 0) return from_ball(point, a_, radius_a_);
    if (t >= 1) return from_ball(point, b_, radius_b_);
    const Vector3 out = y > 0 ? Vector3(across / y) : along_.unitOrthogonal();
    const Vector3 normal = cosine_ * out + sine_ * along_;
    return {normal.dot(from_a) - radius_a_, normal};
}

}  // namespace weft::demo
