#pragma once
// Projection from the world to the picture, and back along rays.

#include <optional>

#include "demo/scene_simulation.h"
#include "weft/render/camera.h"

namespace weft::demo {

/// Place of a point in the picture, in picture heights from the upper left corner; none behind the camera.
[[nodiscard]] std::optional<Vec2> project(const render::OrbitCamera& camera, const Vec3& point, float aspect);

/// The first hit of a ray on cloth: the cloth, the nearest vertex, and the distance along the ray [m].
struct PointedCloth {
    ClothId cloth;
    std::uint32_t vertex = 0;
    float distance = 0;
    bool is_pinned = false;
};
[[nodiscard]] std::optional<PointedCloth> pointed_cloth(const World& world, const render::Ray& ray);

/// The ray's first hit on cloth, a collider that is seen or the floor, within twice the camera's distance.
/// Without a hit: the point at the camera's distance.
[[nodiscard]] Vec3 pointed_place(const Simulation& simulation, const render::OrbitCamera& camera,
                                 const render::Ray& ray);

}  // namespace weft::demo
