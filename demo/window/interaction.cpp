#include "demo/window/interaction.h"

#include <cmath>

#include "engine/vector.h"

namespace weft::demo {
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
