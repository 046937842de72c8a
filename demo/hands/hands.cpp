#include "demo/hands/hands.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "demo/hands/project.h"
#include "engine/vector.h"

namespace weft::demo {
namespace {

constexpr float fan_before = 0.9f;         // distance of the fan from its target [m]
constexpr float growth_per_notch = 1.08f;  // of a held collider, by the wheel

Vec3 looking_along(const render::OrbitCamera& camera) {
    return to_vec3((to_vector(camera.target) - to_vector(camera.eye())).normalized());
}

}  // namespace

Hands::Holding Hands::take(const Pointer& pointer, float aspect, const Simulation& simulation,
                           const render::OrbitCamera& camera, const WindControl& wind) {
    if (pointer.over_panel || pointer.other_button || pointer.has_knife) return Holding::other;
    if (arrow_.is_under({aspect * pointer.x, pointer.y}, wind)) return Holding::arrow;
    if (brush.is_in_hand && brush.place()) {
        brush.begin();
        return Holding::brush;
    }
    const render::Ray ray = camera.ray(pointer.x, pointer.y, aspect);
    const auto cloth = pointed_cloth(simulation.world(), ray);
    const float nearer_than = cloth ? cloth->distance : std::numeric_limits<float>::infinity();
    const bool held = collider_.begin(simulation.world(), simulation.content().drawn_colliders, ray,
                                      looking_along(camera), nearer_than);
    return held ? Holding::collider : Holding::other;
}

bool Hands::update(const Pointer& pointer, float aspect, Simulation& simulation, render::OrbitCamera& camera,
                   WindControl& wind) {
    arrow_.place(camera, aspect);
    eye_ = camera.eye();
    if (brush.is_in_hand && !pointer.over_panel)
        brush.aim(simulation.world(), camera.ray(pointer.x, pointer.y, aspect));
    else
        brush.look_away();
    if (!pointer.left_button && !pointer.other_button) {
        holding_ = Holding::nothing;
        collider_.end();
    } else if (holding_ == Holding::nothing) {
        holding_ = take(pointer, aspect, simulation, camera, wind);
    }
    Pointer rest = pointer;
    if (holding_ == Holding::arrow) arrow_.drag({aspect * pointer.x, pointer.y}, wind);
    if (holding_ == Holding::collider) {
        collider_.aim(camera.ray(pointer.x, pointer.y, aspect));
        if (pointer.wheel != 0) collider_.scale(std::pow(growth_per_notch, pointer.wheel));
    }
    if (holding_ == Holding::brush)
        if (auto painted = brush.stroke(simulation); !painted) complaint_ = painted.error().message;
    if (holding_ != Holding::nothing && holding_ != Holding::other) rest.over_panel = true;
    interaction_.update(rest, aspect, simulation, camera);
    return holding_ == Holding::arrow;
}

Result<void> Hands::pin_or_unpin(Simulation& simulation, const render::Ray& ray) {
    if (interaction_.grab().active()) {
        interaction_.leave_pinned();
        return {};
    }
    const auto cloth = pointed_cloth(simulation.world(), ray);
    if (!cloth) return {};
    return cloth->is_pinned ? simulation.world().unpin(cloth->cloth, cloth->vertex)
                            : simulation.world().pin(cloth->cloth, cloth->vertex);
}

Result<void> Hands::throw_ball(Simulation& simulation, const render::Ray& ray) {
    return balls.throw_along(simulation.world(), ray);
}

void Hands::blow(const Simulation& simulation, const render::OrbitCamera& camera, const render::Ray& ray) {
    const Vector3 place = to_vector(pointed_place(simulation, camera, ray));
    const Vector3 way = to_vector(ray.direction);
    const float distance = std::max(0.3f, (place - to_vector(ray.origin)).dot(way) - fan_before);
    air.hold_fan({to_vec3(to_vector(ray.origin) + distance * way), ray.direction});
}

void Hands::blast(const Simulation& simulation, const render::OrbitCamera& camera, const render::Ray& ray) {
    air.blast_at(pointed_place(simulation, camera, ray));
}

void Hands::before_step(Simulation& simulation, float dt) {
    interaction_.before_step(simulation, dt);
    collider_.before_step(simulation.world(), dt);
    balls.before_step(simulation.world(), dt);
    const ColliderId held[] = {collider_.id()};
    const std::span<const ColliderId> moving = collider_.active() ? held : std::span<const ColliderId>();
    air.before_step(simulation.world(), moving, balls.bodies(), dt);
}

void Hands::after_step(const Simulation& simulation, float dt) {
    streaks.step(simulation.world(), dt, eye_);
}

HandMark Hands::mark() const {
    HandMark mark{.balls = balls.are_there()};
    const Grab& grab = interaction_.grab();
    if (grab.active() && !grab.was_pinned()) {
        mark.held = grab.cloth();
        mark.vertex = grab.vertex();
    }
    return mark;
}

Result<void> Hands::prepare(Simulation& simulation, const HandMark& mark) {
    return balls.set_there(simulation.world(), mark.balls);
}

void Hands::arrive_in(Simulation& simulation, const HandMark& mark) {
    if (mark.held != ClothId{}) (void)simulation.world().unpin(mark.held, mark.vertex);
    interaction_.forget();
    collider_.end();
    air.forget();
}

void Hands::begin(const Simulation& simulation) {
    interaction_.forget();
    collider_.end();
    balls.forget();
    air.forget();
    const render::OrbitCamera& camera = simulation.content().camera;
    streaks.begin(camera.target, 0.38f * camera.distance);
}

}  // namespace weft::demo
