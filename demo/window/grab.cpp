#include "demo/window/grab.h"

#include "demo/hands/project.h"
#include "demo/scenes/measures.h"
#include "engine/vector.h"

namespace weft::demo {

bool Grab::begin(World& world, const render::Ray& ray, const Vec3& forward) {
    const auto pointed = pointed_cloth(world, ray);
    if (!pointed) return active_ = false;
    cloth_ = pointed->cloth;
    vertex_ = pointed->vertex;
    was_pinned_ = pointed->is_pinned;
    hand_ = to_vec3(vertex_position(world.cloth(cloth_).value(), vertex_));
    active_ = world.pin(cloth_, vertex_).ok();
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
