#include "demo/hands/balls.h"

#include <cmath>

#include "engine/vector.h"

namespace weft::demo {
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
