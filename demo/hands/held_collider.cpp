#include "demo/hands/held_collider.h"

#include <algorithm>
#include <cmath>

#include "collision/colliders/nearest_surface.h"
#include "engine/vector.h"

namespace weft::demo {
namespace {

void move(Vec3& point, const Vector3& by) {
    point = to_vec3(to_vector(point) + by);
}
void scale(Vec3& point, const Vector3& middle, float factor) {
    point = to_vec3(middle + factor * (to_vector(point) - middle));
}

void change(Sphere& sphere, const Vector3& by, float factor) {
    move(sphere.center, by);
    sphere.radius *= factor;
}
void change(Capsule& capsule, const Vector3& by, float factor) {
    const Vector3 middle = 0.5f * (to_vector(capsule.a) + to_vector(capsule.b));
    for (Vec3* end : {&capsule.a, &capsule.b}) {
        scale(*end, middle, factor);
        move(*end, by);
    }
    capsule.radius *= factor;
}
void change(TaperedCapsule& capsule, const Vector3& by, float factor) {
    const Vector3 middle = 0.5f * (to_vector(capsule.a) + to_vector(capsule.b));
    for (Vec3* end : {&capsule.a, &capsule.b}) {
        scale(*end, middle, factor);
        move(*end, by);
    }
    capsule.radius_a *= factor;
    capsule.radius_b *= factor;
}
void change(Box& box, const Vector3& by, float factor) {
    move(box.center, by);
    box.half_extents = to_vec3(factor * to_vector(box.half_extents));
}
void change(PlacedShape& placed, const Vector3& by, float /*factor*/) {
    move(placed.position, by);
}
void change(Plane& plane, const Vector3& by, float /*factor*/) {
    plane.offset += by.dot(to_vector(plane.normal).normalized());
}

/// Whether the shape is finite, and one that change() scales.
bool can_be_held(const Collider& collider) {
    return !std::holds_alternative<Plane>(collider.shape) &&
           !std::holds_alternative<PlacedShape>(collider.shape);
}

}  // namespace

// Sphere tracing (Hart 1996): each step along the ray is the distance to the nearest surface.
std::optional<float> distance_to(const Collider& collider, const render::Ray& ray) {
    if (!can_be_held(collider)) return std::nullopt;
    constexpr float farthest = 200, touching = 1e-3f;
    const Vector3 origin = to_vector(ray.origin), direction = to_vector(ray.direction);
    float along = 0;
    for (int step = 0; step < 200 && along < farthest; ++step) {
        const float free = nearest_surface(collider, origin + along * direction).distance;
        if (free < touching) return along;
        along += free;
    }
    return std::nullopt;
}

bool HeldCollider::begin(const World& world, std::span<const ColliderId> colliders, const render::Ray& ray,
                         const Vec3& forward, float nearer_than) {
    active_ = false;
    for (const ColliderId id : colliders) {
        const auto collider = world.collider(id);
        if (!collider) continue;
        const auto distance = distance_to(*collider, ray);
        if (!distance || *distance >= nearer_than) continue;
        nearer_than = *distance;
        id_ = id;
        active_ = true;
    }
    forward_ = forward;
    hand_ = target_ = to_vec3(to_vector(ray.origin) + nearer_than * to_vector(ray.direction));
    size_ = wanted_size_ = 1;
    return active_;
}

void HeldCollider::aim(const render::Ray& ray) {
    const Vector3 forward = to_vector(forward_), direction = to_vector(ray.direction);
    const float approach = direction.dot(forward);
    if (approach <= 0) return;  // the ray never reaches the plane
    const Vector3 origin = to_vector(ray.origin);
    target_ = to_vec3(origin + (to_vector(hand_) - origin).dot(forward) / approach * direction);
}

void HeldCollider::scale(float factor) {
    wanted_size_ = std::clamp(wanted_size_ * factor, 0.02f, 50.0f);
}

void HeldCollider::before_step(World& world, float dt) {
    if (!active_) return;
    auto collider = world.collider(id_);
    if (!collider) return end();
    const Vector3 way = to_vector(target_) - to_vector(hand_);
    const float length = way.norm(), farthest = max_speed * dt;
    const Vector3 by = (length > farthest ? farthest / length : 1.0f) * way;
    const float most = std::pow(max_growth, dt);
    const float factor = std::clamp(wanted_size_ / size_, 1 / most, most);
    std::visit([&](auto& shape) { change(shape, by, factor); }, collider->shape);
    if (!world.move_collider(id_, *collider)) return end();  // a body moves it
    hand_ = to_vec3(to_vector(hand_) + by);
    size_ *= factor;
}

}  // namespace weft::demo
