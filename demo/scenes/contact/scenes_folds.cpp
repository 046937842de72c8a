// Sheets and ribbons that come to lie on themselves.

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>

#include "demo/scenes/contact/contact_scene.h"

namespace weft::demo {

namespace {

using std::numbers::pi;

using Eigen::Vector3d;

/// A concertina of ten legs, dropped on its side.
ContactScene folddrop(std::uint32_t particles) {
    constexpr int legs = 10;
    constexpr double leg = 0.1, height = 0.4;
    const Piece sheet = piece(1, 0.5, or_else(particles, 4100), legs);
    // Limited, since with few particles legs would have to rise by more than their length.
    const double rise = std::min(3 * usual_distance(sheet.edge()), 0.9 * leg);
    const double run = std::sqrt(leg * leg - rise * rise);
    const auto place = [=](double u, double v) {
        const int k = std::min(legs - 1, static_cast<int>(u / leg));
        const double part = u / leg - k, forth = k % 2 == 0 ? part : 1 - part;
        const double wave = 1e-3 * std::sin(2 * pi * (v / 0.23 + 1.7 * u)) * std::sin(2 * pi * u / 0.31);
        return Vector3d((forth - 0.5) * run, height + u / leg * rise + wave, v - 0.25);
    };
    return {.name = "folddrop",
            .seconds = 10,
            .cloths = {{.mesh = placed_sheet(sheet, place)}},
            .colliders = {ground()},
            .world = still_air(),
            .rests = true};
}

/// A ribbon lowered end first at constant speed. The hand sways a little, which gives it a side to fold to.
ContactScene ribbon(std::uint32_t particles) {
    constexpr double length = 2.4, width = 0.1, low = 0.02, speed = 0.5, stop = 0.4;
    constexpr double sway = 0.015, period = 0.9;
    const Piece sheet = piece(length, width, or_else(particles, 1000));
    const auto place = [=](double u, double v) { return Vector3d(v - width / 2, low + u, 0); };
    const std::vector<std::uint32_t> top = column_of(sheet, sheet.columns - 1);
    const auto lower = [=](const SceneHandles& scene, double time) {
        const double height = std::max(low + length - speed * time, stop);
        const double ends = (low + length - stop) / speed;
        const double side = sway * std::sin(2 * pi * std::min(time, ends) / period);
        for (std::uint32_t row = 0; row < sheet.rows; ++row) {
            const double across = width * row / (sheet.rows - 1) - width / 2;
            scene.move_pin(0, top[row], to_point({across, height, side}));
        }
    };
    return {.name = "ribbon",
            .seconds = 12,
            .cloths = {{.mesh = placed_sheet(sheet, place), .pins = top}},
            .colliders = {ground()},
            .world = still_air(),
            .move = lower,
            .rests = true};
}

}  // namespace

std::vector<SceneMaker> fold_scenes() {
    return {{"folddrop", true, folddrop}, {"ribbon", true, ribbon}};
}

// Cloth laid over a sphere or drawn together: folds in which layers come near.

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
