// Cloth that is forced upon itself: squeezed, twisted, pulled through itself.

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>

#include "demo/scenes/contact/contact_scene.h"

namespace weft::demo {

namespace {

using std::numbers::pi;

using Eigen::Vector3d;

/// The ceiling's height: down at 0.3 m/s to 8 cm, there for two seconds, and up again.
double ceiling_height(double time) {
    constexpr double high = 1.02, low = 0.08, speed = 0.3, stays = 2;
    constexpr double down = (high - low) / speed;
    if (time < down) return high - speed * time;
    return std::min(high, low + speed * std::max(0.0, time - down - stays));
}

Collider ceiling(double time) {
    return {.shape = Plane{{0, -1, 0}, static_cast<float>(-ceiling_height(time))}};
}

/// An upright sheet under a ceiling that comes down.
ContactScene crumple(std::uint32_t particles) {
    const Piece sheet = piece(1, 0.5, or_else(particles, 4100));
    const auto place = [](double u, double v) {
        const double wave = 2e-3 * std::sin(2 * pi * (u / 0.37 + 0.2 * v)) * std::cos(2 * pi * v / 0.45);
        return Vector3d(v - 0.25, 0.006 + u, wave);
    };
    return {.name = "crumple",
            .seconds = 10,
            .cloths = {{.mesh = placed_sheet(sheet, place)}},
            .colliders = {ground(), ceiling(0)},
            .world = still_air(),
            .move = [](const SceneHandles& scene, double time) { scene.move_collider(1, ceiling(time)); },
            .rests = true};
}

/// A strip whose ends are turned against each other by one turn each, and come nearer.
ContactScene twist(std::uint32_t particles) {
    constexpr double length = 1, width = 0.3, takes = 6, nearer = 0.15;
    const Piece strip = piece(length, width, or_else(particles, 4100));
    const auto place = [](double u, double v) {
        return Vector3d(u - length / 2, v - width / 2,
                        1e-3 * std::sin(2 * pi * u / 0.29) * std::cos(2 * pi * v / 0.17));
    };
    ContactScene scene{.name = "twist",
                       .seconds = 8,
                       .cloths = {{.mesh = placed_sheet(strip, place)}},
                       .world = still_air()};
    scene.world.gravity = {};
    const std::vector<std::uint32_t> left = column_of(strip, 0), right = column_of(strip, strip.columns - 1);
    for (const auto* end : {&left, &right}) {
        scene.cloths[0].pins.insert(scene.cloths[0].pins.end(), end->begin(), end->end());
        scene.holders.push_back({0, Holder::rod, *end});
    }
    scene.move = [=](const SceneHandles& handles, double time) {
        const double part = std::min(time / takes, 1.0), angle = 2 * pi * part;
        const double x = (length - nearer * part) / 2;
        for (std::uint32_t row = 0; row < strip.rows; ++row) {
            const double across = width * row / (strip.rows - 1) - width / 2;
            for (const double side : {-1.0, 1.0})
                handles.move_pin(
                    0, side < 0 ? left[row] : right[row],
                    to_point({side * x, across * std::cos(angle), side * across * std::sin(angle)}));
        }
    };
    return scene;
}

/// A sheet folded in two, held by the four corners of its lower layer: the middle of the upper one is pulled
/// down through it. There is no way to do that without passing through.
ContactScene yank(const std::string& name, double speed, std::uint32_t particles) {
    constexpr double length = 1, width = 0.5, apart = 0.05, depth = 0.35, waits = 0.1;
    constexpr double bend = pi * apart / 2, leg = (length - bend) / 2;
    const Piece sheet = piece(length, width, or_else(particles, 4100));
    const auto place = [](double u, double v) {
        const double turned = std::clamp((u - leg) / bend, 0.0, 1.0) * pi;
        const double x = u < leg ? u : u > leg + bend ? length - u : leg;
        return Vector3d(x + apart / 2 * std::sin(turned), 1 + apart / 2 * (1 - std::cos(turned)),
                        v - width / 2);
    };
    ContactScene scene{
        .name = name, .seconds = 3, .cloths = {{.mesh = placed_sheet(sheet, place)}}, .world = still_air()};
    const auto column = [&](double u) {
        return static_cast<std::uint32_t>(std::lround(u / length * (sheet.columns - 1)));
    };
    const std::uint32_t pulled = vertex_at(sheet, sheet.rows / 2, column(leg + bend + leg / 2));
    PlacedCloth& cloth = scene.cloths[0];
    for (const std::uint32_t c : {0u, column(leg)})
        for (const std::uint32_t row : {0u, sheet.rows - 1}) cloth.pins.push_back(vertex_at(sheet, row, c));
    cloth.pins.push_back(pulled);
    scene.holders = {{0, Holder::hands, cloth.pins}};
    scene.move = [=, start = cloth.mesh.positions[pulled]](const SceneHandles& handles, double time) {
        const double down = std::clamp(speed * (time - waits), 0.0, depth);
        handles.move_pin(0, pulled, {start.x, start.y - static_cast<float>(down), start.z});
    };
    return scene;
}

SceneMaker yank_maker(int speed, bool quick) {
    const std::string name = "yank " + std::to_string(speed);
    return {name, quick, [=](std::uint32_t particles) { return yank(name, speed, particles); }};
}

}  // namespace

std::vector<SceneMaker> forced_scenes() {
    return {{"crumple", true, crumple}, {"twist", true, twist}, yank_maker(5, false),
            yank_maker(10, true),       yank_maker(20, false),  yank_maker(40, false)};
}

}  // namespace weft::demo
