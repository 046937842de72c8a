#pragma once
// From the world to the picture and back.

#include <optional>

#include "demo/scene_simulation.h"
#include "weft/render/camera.h"

namespace weft::demo {

/// Where a point is in the picture, in heights of it from its upper left corner; none behind the camera.
[[nodiscard]] std::optional<Vec2> project(const render::OrbitCamera& camera, const Vec3& point, float aspect);

/// Where the ray first meets cloth: which, at which vertex, and how far along it [m].
struct PointedCloth {
    ClothId cloth;
    std::uint32_t vertex = 0;
    float distance = 0;
    bool is_pinned = false;
};
[[nodiscard]] std::optional<PointedCloth> pointed_cloth(const Simulation& simulation, const render::Ray& ray);

/// What the ray first meets: cloth, a collider that is drawn, the floor; else as far off as the camera looks.
[[nodiscard]] Vec3 pointed_place(const Simulation& simulation, const render::OrbitCamera& camera,
                                 const render::Ray& ray);

}  // namespace weft::demo
