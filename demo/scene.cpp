#include "demo/scene.h"

#include <algorithm>
#include <utility>

namespace weft::demo {

void Scene::before_step(World& /*world*/, double /*time*/, float /*dt*/) {}

void Scene::go_to(double /*time*/) {}

bool Scene::cut_before_step(World& /*world*/, SceneContent& /*content*/) {
    return false;
}

Result<void> Scene::give_skin(World& /*world*/, ClothId /*cloth*/) {
    return Error{ErrorCode::unsupported,
                 "a leash ties cloth to somebody who wears it; nobody wears this cloth"};
}

render::FabricLook two_sided(const Vec3& front, float stripe_width) {
    const auto paler = [](float part) { return 0.5f * part + 0.25f; };
    return {.front = front,
            .back = {paler(front.x), paler(front.y), paler(front.z)},
            .stripe_width = stripe_width};
}

Result<void> draw_over(SceneCloth& cloth, const World& world, const Mesh& fine,
                       const DrawnMeshSettings& binding) {
    const auto view = world.cloth(cloth.id);
    if (!view) return view.error();
    auto drawn = DrawnMesh::bind(
        *view, {.vertices = fine.positions, .triangles = fine.triangles, .texcoords = fine.texcoords},
        binding);
    if (!drawn) return drawn.error();
    cloth.fine = fine;
    cloth.drawn = std::make_shared<const DrawnMesh>(std::move(*drawn));
    return {};
}

const SceneEntry* find_scene(std::string_view name) {
    const std::span<const SceneEntry> scenes = all_scenes();
    const auto found =
        std::ranges::find(scenes, name, [](const SceneEntry& e) { return std::string_view(e.name); });
    return found == scenes.end() ? nullptr : &*found;
}

}  // namespace weft::demo
