// Sheets that lie on one another, as one mesh and as separate cloths.

#include <cmath>
#include <numbers>
#include <string>

#include "demo/scenes/contact/contact_scene.h"

namespace weft::demo {

namespace {

/// `count` sheets of 0.4 m, just over the ground.
ContactScene stack(int count, Made made, std::uint32_t particles) {
    const std::uint32_t each = particles == 0 ? 1024 : particles / static_cast<std::uint32_t>(count);
    const Piece sheet = piece(0.4, 0.4, each);
    std::vector<Mesh> sheets;
    for (int k = 0; k < count; ++k)
        sheets.push_back(level_sheet(sheet, 0.006 + 1.2 * usual_distance(sheet.edge()) * k, 0.07 * k));
    return {.name = named("stack " + std::to_string(count), made),
            .seconds = 12,
            .cloths = layered(sheets, made),
            .colliders = {ground()},
            .world = still_air(),
            .rests = true};
}

SceneMaker stack_maker(int count, Made made, bool quick) {
    return {named("stack " + std::to_string(count), made), quick,
            [=](std::uint32_t particles) { return stack(count, made, particles); }};
}

/// Three sheets of 1 m over a sphere that lies on the ground.
ContactScene stacked(Made made, std::uint32_t particles) {
    constexpr float radius = 0.3f;
    const Piece sheet = piece(1, 1, (particles == 0 ? 6000 : particles) / 3);
    std::vector<Mesh> sheets;
    for (int k = 0; k < 3; ++k) sheets.push_back(level_sheet(sheet, 0.75 + 0.04 * k, 0.3 * k));
    return {.name = named("stacked", made),
            .seconds = 10,
            .cloths = layered(sheets, made),
            .colliders = {ground(), {.shape = Sphere{{0, radius, 0}, radius}}},
            .world = still_air(),
            .rests = true};
}

SceneMaker stacked_maker(Made made, bool quick) {
    return {named("stacked", made), quick, [=](std::uint32_t particles) { return stacked(made, particles); }};
}

}  // namespace

std::vector<SceneMaker> stack_scenes() {
    std::vector<SceneMaker> makers;
    for (const int count : {2, 3, 5, 10}) makers.push_back(stack_maker(count, Made::one_mesh, count == 2));
    for (const int count : {2, 5}) makers.push_back(stack_maker(count, Made::cloths, count == 2));
    makers.push_back(stacked_maker(Made::one_mesh, true));
    makers.push_back(stacked_maker(Made::cloths, false));
    return makers;
}

// Scenes of contact that the demo shows, and the study does not judge.

namespace {

using Eigen::Vector3d;

/// Ten sheets on the ground, each a cloth of its own.
ContactScene ten_sheets(std::uint32_t particles) {
    constexpr int sheets = 10;
    const Piece sheet = piece(0.4, 0.4, or_else(particles, 3000) / sheets);
    std::vector<Mesh> all;
    for (int k = 0; k < sheets; ++k)
        all.push_back(level_sheet(sheet, 0.006 + 1.2 * usual_distance(sheet.edge()) * k, 0.07 * k));
    return {.name = "ten sheets",
            .seconds = 8,
            .cloths = layered(all, Made::cloths),
            .colliders = {ground()},
            .world = still_air(),
            .rests = true};
}

/// A strip that hangs: its lower end is turned twice round, held up a bit, and let go.
ContactScene twist_and_release(std::uint32_t particles) {
    constexpr double length = 1, width = 0.3, takes = 3.5, lets_go = 4, turns = 2, raised = 0.12, high = 1.3;
    const Piece strip = piece(length, width, or_else(particles, 1600));
    const auto place = [](double u, double v) {
        return Vector3d(
            v - width / 2, high - u,
            1e-3 * std::sin(2 * std::numbers::pi * u / 0.29) * std::cos(2 * std::numbers::pi * v / 0.17));
    };
    ContactScene scene{.name = "twist and release",
                       .seconds = 8,
                       .cloths = {{.mesh = placed_sheet(strip, place)}},
                       .world = still_air()};
    const std::vector<std::uint32_t> top = column_of(strip, 0), low = column_of(strip, strip.columns - 1);
    for (const auto* end : {&top, &low}) {
        scene.cloths[0].pins.insert(scene.cloths[0].pins.end(), end->begin(), end->end());
        scene.holders.push_back({0, Holder::rod, *end});
    }
    scene.move = [=](const SceneHandles& handles, double time) {
        const long frame = std::lround(time / ContactScene::step());
        const long last = std::lround(lets_go / ContactScene::step());
        if (frame == last) handles.unpin(0, low);
        if (frame >= last) return;
        const double part = std::min(time / takes, 1.0), angle = 2 * std::numbers::pi * turns * part;
        for (std::uint32_t row = 0; row < strip.rows; ++row) {
            const double across = width * row / (strip.rows - 1) - width / 2;
            handles.move_pin(0, low[row],
                             to_point({across * std::cos(angle), high - length + raised * part,
                                       across * std::sin(angle)}));
        }
    };
    return scene;
}

}  // namespace

std::vector<SceneMaker> shown_scenes() {
    return {{"ten sheets", false, ten_sheets}, {"twist and release", false, twist_and_release}};
}

}  // namespace weft::demo
