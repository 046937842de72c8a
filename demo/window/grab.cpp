#include "demo/window/grab.h"

#include <algorithm>
#include <optional>

#include "demo/window/pick.h"
#include "engine/vector.h"

namespace weft::demo {

bool Grab::begin(World& world, std::span<const SceneCloth> cloths, const render::Ray& ray,
                 const Vec3& forward) {
    std::optional<Hit> nearest;
    for (const SceneCloth& cloth : cloths) {
        const auto view = world.cloth(cloth.id);
        if (!view) continue;
        const auto hit = first_hit(*view, ray);
        if (!hit || (nearest && hit->distance >= nearest->distance)) continue;
        nearest = hit;
        cloth_ = cloth.id;
        const auto vertex = std::ranges::find(view->vertex_to_particle, hit->particle);
        vertex_ = static_cast<std::uint32_t>(vertex - view->vertex_to_particle.begin());
        was_pinned_ = view->positions[hit->particle].w == 0;
        hand_ = to_vec3(xyz(view->positions[hit->particle]));
    }
    active_ = nearest && world.pin(cloth_, vertex_).ok();
    forward_ = forward;
    target_ = hand_;
    return active_;
}

void Grab::aim(const render::Ray& ray) {
    const Vector3 forward = to_vector(forward_), origin = to_vector(ray.origin),
                  direction = to_vector(ray.direction);
    const float approach = direction.dot(forward);
    if (approach <= 0) return;  // the ray never reaches the plane
    const float distance = (to_vector(hand_) - origin).dot(forward) / approach;
    target_ = to_vec3(origin + distance * direction);
}

void Grab::before_step(World& world, float dt) {
    if (!active_) return;
    const Vector3 way = to_vector(target_) - to_vector(hand_);
    const float length = way.norm(), reach = max_speed * dt;
    hand_ = to_vec3(to_vector(hand_) + (length > reach ? reach / length : 1.0f) * way);
    active_ = world.move_pin(cloth_, vertex_, hand_).ok();
}

void Grab::end(World& world) {
    if (active_ && !was_pinned_) (void)world.unpin(cloth_, vertex_);
    active_ = false;
}

}  // namespace weft::demo
