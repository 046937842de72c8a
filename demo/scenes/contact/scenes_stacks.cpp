// Sheets that lie on one another, as one mesh and as separate cloths.

#include <string>

#include "demo/scenes/contact/scene_meshes.h"

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

}  // namespace weft::demo
