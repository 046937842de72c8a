#include "demo/scene.h"

#include <algorithm>

namespace weft::demo {

void Scene::before_step(World& /*world*/, double /*time*/, float /*dt*/) {}

bool Scene::cut_before_step(World& /*world*/, SceneContent& /*content*/) {
    return false;
}

const SceneEntry* find_scene(std::string_view name) {
    const std::span<const SceneEntry> scenes = all_scenes();
    const auto found =
        std::ranges::find(scenes, name, [](const SceneEntry& e) { return std::string_view(e.name); });
    return found == scenes.end() ? nullptr : &*found;
}

}  // namespace weft::demo
