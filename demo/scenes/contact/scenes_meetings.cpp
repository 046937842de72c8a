// Sheets that collide with each other.

#include <cmath>
#include <string>
#include <utility>

#include "demo/scenes/contact/contact_scene.h"

namespace weft::demo {

namespace {

using Eigen::Vector3d;

/// Two sheets of 0.4 m that fly towards each other at 1 m/s in all, a bit tilted and beside each other. A
/// World gives cloth no speed, so all their vertices are held and moved for three steps, and let go then.
ContactScene zero_gravity_meeting(Made made, std::uint32_t particles) {
    constexpr double side = 0.4, apart = 0.15, speed = 0.5;
    constexpr long held_frames = 3;
    const Piece sheet = piece(side, side, or_else(particles, 2048) / 2);
    const auto at = [=](double sign) {
        return placed_sheet(sheet, [=](double u, double v) {
            const double x = u - side / 2, z = v - side / 2;
            return Vector3d(x + sign * 0.05, sign * (apart / 2 + 0.1 * x + 0.05 * z), z + sign * 0.03);
        });
    };
    const std::vector<Mesh> sheets{at(-1), at(1)};
    ContactScene scene{.name = named("zero gravity", made),
                       .seconds = 3,
                       .world = zero_gravity(),
                       .free_from = (held_frames + 1.5) * ContactScene::step()};
    scene.cloths = layered(sheets, made);
    for (PlacedCloth& cloth : scene.cloths) {
        cloth.settings.air_damping = 0;
        for (std::uint32_t i = 0; i < cloth.mesh.positions.size(); ++i) cloth.pins.push_back(i);
    }
    std::vector<std::vector<Vec3>> starts;
    std::vector<std::vector<std::uint32_t>> all;
    for (const PlacedCloth& cloth : scene.cloths) {
        starts.push_back(cloth.mesh.positions);
        all.push_back(cloth.pins);
    }
    scene.free_momentum = side * side * static_cast<double>(Fabric{}.areal_density) * 2 * speed;
    scene.move = [=](const SceneHandles& handles, double time) {
        const long frame = std::lround(time / ContactScene::step());
        for (std::size_t c = 0; c < starts.size(); ++c) {
            const auto count = static_cast<std::uint32_t>(starts[c].size());
            if (frame == held_frames + 1) handles.unpin(c, all[c]);
            for (std::uint32_t i = 0; i < count && frame <= held_frames; ++i) {
                const bool upper = made == Made::one_mesh ? i >= count / 2 : c == 1;
                Vec3 p = starts[c][i];
                p.y += static_cast<float>((upper ? -speed : speed) * time);
                handles.move_pin(c, i, p);
            }
        }
    };
    return scene;
}

/// A sheet hung by its four corners, and a smaller one dropped on it: tilted, since level sheets may pass
/// through each other within one step, and cross at none.
ContactScene dropped_on(Made made, std::uint32_t particles) {
    const Piece below = piece(1, 1, or_else(particles, 4000) * 4 / 5);
    const Piece above = piece(0.5, 0.5, or_else(particles, 4000) / 5);
    Mesh tilted = level_sheet(above, 1.25, 0.4);
    for (Vec3& p : tilted.positions) p.y += 0.15f * p.x;
    ContactScene scene{.name = named("dropped on", made),
                       .seconds = 8,
                       .cloths = layered({level_sheet(below, 1, 0), tilted}, made),
                       .colliders = {ground()},
                       .world = still_air(),
                       .rests = true};
    const std::uint32_t row = below.rows - 1, column = below.columns - 1;
    for (const auto& [r, c] : {std::pair(0u, 0u), {0u, column}, {row, 0u}, {row, column}})
        scene.cloths[0].pins.push_back(vertex_at(below, r, c));
    scene.holders = {{0, Holder::posts, scene.cloths[0].pins}};
    return scene;
}

/// The orientation of a strip's width.
enum class Lying { flat, on_edge };

/// Two strips of ten cells by two: one held at its ends, the other dropped across it, its vertices over the
/// middles of cells. Edges meet edges, and no vertex comes near another.
ContactScene cross_strips(Lying lying) {
    constexpr double cell = 0.05, gap = 0.06;
    const Piece strip{10 * cell, 2 * cell, 11, 3};
    const auto at = [=](bool upper) {
        return placed_sheet(strip, [=](double u, double v) {
            const double along = u - strip.length / 2, across = v - cell;
            const double height =
                (upper ? gap : 0) + (lying == Lying::on_edge ? v + (upper ? 2 * cell : 0) : 0);
            const double side = lying == Lying::flat ? across : 0;
            return upper ? Vector3d(side + cell / 2, height, along + cell / 2)
                         : Vector3d(along, height, side);
        });
    };
    ContactScene scene{.name = lying == Lying::flat ? "cross-strips" : "cross-strips on edge",
                       .seconds = 4,
                       .cloths = {joined({at(false), at(true)})},
                       .world = still_air()};
    for (const std::uint32_t column : {0u, strip.columns - 1})
        for (const std::uint32_t vertex : column_of(strip, column)) scene.cloths[0].pins.push_back(vertex);
    return scene;
}

SceneMaker maker(ContactScene (*make)(Made, std::uint32_t), const std::string& name, Made made, bool quick) {
    return {named(name, made), quick, [=](std::uint32_t particles) { return make(made, particles); }};
}

SceneMaker strips_maker(Lying lying, const std::string& name) {
    return {name, true, [=](std::uint32_t) { return cross_strips(lying); }};
}

}  // namespace

std::vector<SceneMaker> meeting_scenes() {
    return {maker(zero_gravity_meeting, "zero gravity", Made::one_mesh, true),
            maker(zero_gravity_meeting, "zero gravity", Made::cloths, false),
            maker(dropped_on, "dropped on", Made::one_mesh, true),
            maker(dropped_on, "dropped on", Made::cloths, false),
            strips_maker(Lying::flat, "cross-strips"),
            strips_maker(Lying::on_edge, "cross-strips on edge")};
}

}  // namespace weft::demo
