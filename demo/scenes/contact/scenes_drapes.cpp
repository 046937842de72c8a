// Cloth laid over a sphere or drawn together: folds in which layers come near.

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>

#include "demo/scenes/contact/scene_meshes.h"

namespace weft::demo {

namespace {

using Eigen::Vector3d;

/// A sheet of 2 m over a sphere that lies on the ground.
ContactScene drape(const std::string& name, std::uint32_t particles) {
    constexpr float radius = 0.4f;
    return {.name = name,
            .seconds = 6,
            .cloths = {{.mesh = level_sheet(piece(2, 2, particles), 0.82, 0)}},
            .colliders = {ground(), {.shape = Sphere{{0, radius, 0}, radius}}},
            .world = still_air(),
            .rests = true};
}

SceneMaker drape_maker(const std::string& name, std::uint32_t usual, bool quick) {
    return {name, quick, [=](std::uint32_t particles) { return drape(name, or_else(particles, usual)); }};
}

/// A curtain held at every eighth vertex of its upper edge, and drawn together to a quarter in four seconds.
ContactScene gathered(std::uint32_t particles) {
    constexpr double width = 1.6, height = 1.2, takes = 4;
    const Piece sheet = piece(width, height, or_else(particles, 4100), 8);
    const auto place = [=](double u, double v) {
        return Vector3d(u - width / 2, v, 2e-3 * std::sin(2 * std::numbers::pi * (u / 0.11 + 0.3 * v)));
    };
    ContactScene scene{.name = "gathered",
                       .seconds = 8,
                       .cloths = {{.mesh = placed_sheet(sheet, place)}},
                       .world = still_air(),
                       .rests = true};
    PlacedCloth& cloth = scene.cloths[0];
    for (std::uint32_t column = 0; column < sheet.columns; column += 8)
        cloth.pins.push_back(vertex_at(sheet, sheet.rows - 1, column));
    scene.holders = {{0, Holder::rod, cloth.pins}, {0, Holder::hands, cloth.pins}};
    std::vector<Vec3> starts;
    for (const std::uint32_t vertex : cloth.pins) starts.push_back(cloth.mesh.positions[vertex]);
    scene.move = [pins = cloth.pins, starts](const SceneHandles& handles, double time) {
        const auto part = static_cast<float>(1 - 0.75 * std::min(time / takes, 1.0));
        for (std::size_t k = 0; k < pins.size(); ++k)
            handles.move_pin(0, pins[k], {part * starts[k].x, starts[k].y, starts[k].z});
    };
    return scene;
}

}  // namespace

std::vector<SceneMaker> drape_scenes() {
    return {drape_maker("drape", 4096, true),
            drape_maker("drape 16k", 16384, false),
            {"gathered", true, gathered}};
}

}  // namespace weft::demo
