#include "demo/hands/project.h"

#include <algorithm>
#include <Eigen/Core>

#include "demo/hands/held_collider.h"
#include "engine/vector.h"

namespace weft::demo {

std::optional<Vec2> project(const render::OrbitCamera& camera, const Vec3& point, float aspect) {
    const render::Matrix4 view = camera.view(), projection = camera.projection(aspect);
    const Eigen::Vector4f seen = Eigen::Matrix4f(projection.data()) * Eigen::Matrix4f(view.data()) *
                                 Eigen::Vector4f(point.x, point.y, point.z, 1);
    if (seen.w() <= 1e-4f) return std::nullopt;
    return Vec2{(0.5f + 0.5f * seen.x() / seen.w()) * aspect, 0.5f - 0.5f * seen.y() / seen.w()};
}

std::optional<PointedCloth> pointed_cloth(const World& world, const render::Ray& ray) {
    const auto hit = world.cast_ray(ray.origin, ray.direction);
    if (!hit || !*hit) return std::nullopt;
    const ClothPoint& point = **hit;
    const ClothView view = world.cloth(point.cloth).value();
    const auto distance = [&](std::uint32_t particle) {
        return (xyz(view.positions[particle]) - to_vector(point.position)).squaredNorm();
    };
    const std::uint32_t particle = *std::ranges::min_element(view.triangles[point.triangle], {}, distance);
    const auto vertex = std::ranges::find(view.vertex_to_particle, particle);
    return PointedCloth{point.cloth, static_cast<std::uint32_t>(vertex - view.vertex_to_particle.begin()),
                        point.distance, view.positions[particle].w == 0};
}

Vec3 pointed_place(const Simulation& simulation, const render::OrbitCamera& camera, const render::Ray& ray) {
    float along = 2 * camera.distance;
    bool any = false;
    const auto meet = [&](float distance) {
        if (distance <= 0 || distance >= along) return;
        along = distance;
        any = true;
    };
    if (const auto cloth = pointed_cloth(simulation.world(), ray)) meet(cloth->distance);
    const SceneContent& content = simulation.content();
    for (const auto& colliders : {std::span(content.drawn_colliders), std::span(content.clad_colliders)})
        for (const ColliderId id : colliders) {
            const auto collider = simulation.world().collider(id);
            const auto distance = collider ? distance_to(*collider, ray) : std::nullopt;
            if (distance) meet(*distance);
        }
    if (ray.direction.y < 0) meet(-ray.origin.y / ray.direction.y);
    if (!any) along = camera.distance;
    return to_vec3(to_vector(ray.origin) + along * to_vector(ray.direction));
}

}  // namespace weft::demo
