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

/// True if the shape is finite, and one that change() scales.
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

namespace {

constexpr float cellar = -300;        // height at which balls wait [m]
constexpr float out_of_sight = -5;    // below it a ball is lost [m]
constexpr float rolling = 0.985f;     // share of the speed along the floor that each touch leaves
constexpr float least_bounce = 0.4f;  // a slower ball does not bounce [m/s]

BodySettings settings_of(float mass) {
    const float inertia = 0.4f * mass * Balls::radius * Balls::radius;
    return {.mass = mass, .inertia = {inertia, inertia, inertia}, .damping = 0.05f, .angular_damping = 0.5f};
}

BodyState waiting(std::size_t which) {
    return {.position = {2.0f * static_cast<float>(which), cellar, 0}};
}

bool waits(const BodyState& state) {
    return state.position.y < out_of_sight;
}

}  // namespace

Result<void> Balls::add(World& world) {
    for (std::size_t k = 0; k < count; ++k) {
        const BodyState state = waiting(k);
        const auto body = world.add_body(settings_of(mass), state);
        if (!body) return body.error();
        bodies_.push_back(*body);
        const auto ball = world.add_collider({.shape = Sphere{state.position, radius}, .friction = 0.5f});
        if (!ball) return ball.error();
        balls_.push_back(*ball);
        if (auto attached = world.attach_collider(*body, *ball); !attached) return attached;
    }
    return {};
}

Result<void> Balls::set_there(World& world, bool there) {
    if (there == are_there()) return {};
    if (there) {
        auto added = add(world);
        if (!added) (void)set_there(world, false);
        return added;
    }
    for (const ColliderId ball : balls_) (void)world.remove_collider(ball);
    for (const BodyId body : bodies_) (void)world.remove_body(body);
    forget();
    return {};
}

Result<void> Balls::throw_along(World& world, const render::Ray& ray) {
    if (auto there = set_there(world, true); !there) return there;
    const BodyId body = bodies_[next_];
    next_ = (next_ + 1) % count;
    if (auto set = world.set_body_settings(body, settings_of(mass)); !set) return set;
    const Vector3 direction = to_vector(ray.direction);
    const Vector3 start = to_vector(ray.origin) + 2 * radius * direction;
    return world.set_body_state(body, {.position = to_vec3(start), .velocity = to_vec3(speed * direction)});
}

void Balls::before_step(World& world, float dt) {
    for (std::size_t k = 0; k < bodies_.size(); ++k) {
        const auto read = world.body_state(bodies_[k]);
        if (!read) continue;
        BodyState state = *read;
        if (waits(state)) {
            if (state.position.y < 2 * cellar || state.position.y > cellar + 1)
                (void)world.set_body_state(bodies_[k], waiting(k));
            continue;
        }
        if (state.velocity.y > 0 || state.position.y + dt * state.velocity.y > radius) continue;
        state.position.y = std::max(state.position.y, radius);
        const float back = -bounce * state.velocity.y;
        state.velocity = {rolling * state.velocity.x, back > least_bounce ? back : 0,
                          rolling * state.velocity.z};
        (void)world.set_body_state(bodies_[k], state);
    }
}

void Balls::forget() {
    balls_.clear();
    bodies_.clear();
    next_ = 0;
}

std::span<const ColliderId> Balls::in_play(const World& world) {
    shown_.clear();
    for (std::size_t k = 0; k < bodies_.size(); ++k) {
        const auto state = world.body_state(bodies_[k]);
        if (state && !waits(*state)) shown_.push_back(balls_[k]);
    }
    return shown_;
}

}  // namespace weft::demo
