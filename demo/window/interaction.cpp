#include "demo/window/interaction.h"

#include <cmath>

#include "demo/hands/project.h"
#include "demo/scenes/measures.h"
#include "engine/vector.h"

namespace weft::demo {

namespace {

constexpr float blade_length = 100.0f;  // of the blade, from the eye [m]

Vec3 tip(const render::Ray& ray) {
    return to_vec3(to_vector(ray.origin) + blade_length * to_vector(ray.direction));
}

}  // namespace

void Knife::begin(const Simulation& simulation, const render::Ray& ray) {
    last_ = ray;
    strokes_.assign(simulation.content().cloths.size(), {});
}

Result<void> Knife::draw_to(const render::Ray& ray, Simulation& simulation) {
    const Blade blade{last_.origin, tip(last_), ray.origin, tip(ray)};
    last_ = ray;
    Result<void> done;
    for (std::size_t k = 0; k < strokes_.size(); ++k) {
        const SceneCloth& cloth = simulation.content().cloths[k];
        const auto positions = vertex_positions(simulation.world(), cloth.id);
        if (!positions) return positions.error();
        const auto edges = edges_along(cloth.mesh, *positions, blade, strokes_[k]);
        if (!edges) return edges.error();
        if (edges->empty()) continue;
        if (auto cut = simulation.cut(k, *edges); !cut) done = cut;
    }
    return done;
}

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

namespace {

constexpr float radians_per_height = 3.0f;  // angle of orbiting per drag over the picture's height
constexpr float zoom_per_notch = 1.12f;

Vec3 looking_direction(const render::OrbitCamera& camera) {
    return to_vec3((to_vector(camera.target) - to_vector(camera.eye())).normalized());
}

}  // namespace

Interaction::Drag Interaction::begin_drag(const Pointer& pointer, float aspect, Simulation& simulation,
                                          const render::OrbitCamera& camera) {
    if (pointer.over_panel) return Drag::panel;
    if (pointer.other_button) return Drag::pan;
    const render::Ray ray = camera.ray(pointer.x, pointer.y, aspect);
    if (pointer.has_knife) {
        knife_.begin(simulation, ray);
        return Drag::cut;
    }
    const bool held = grab_.begin(simulation.world(), ray, looking_direction(camera));
    return held ? Drag::grab : Drag::orbit;
}

void Interaction::update(const Pointer& pointer, float aspect, Simulation& simulation,
                         render::OrbitCamera& camera) {
    if (!pointer.over_panel && pointer.wheel != 0) camera.zoom(std::pow(zoom_per_notch, pointer.wheel));

    if (!pointer.left_button && !pointer.other_button) {
        if (drag_ == Drag::grab) grab_.end(simulation.world());
        drag_ = Drag::none;
        return;
    }
    if (drag_ == Drag::none) drag_ = begin_drag(pointer, aspect, simulation, camera);
    switch (drag_) {
        case Drag::grab:
            grab_.aim(camera.ray(pointer.x, pointer.y, aspect));
            break;
        case Drag::cut:
            if (auto cut = knife_.draw_to(camera.ray(pointer.x, pointer.y, aspect), simulation); !cut)
                complaint_ = cut.error().message;
            break;
        case Drag::orbit:
            camera.orbit(-radians_per_height * pointer.right, radians_per_height * pointer.down);
            break;
        case Drag::pan:
            camera.pan(-pointer.right, pointer.down);
            break;
        case Drag::panel:
        case Drag::none:
            break;
    }
}

}  // namespace weft::demo
