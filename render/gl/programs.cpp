#include "render/gl/programs.h"

#include <array>
#include <string>
#include <vector>

namespace weft::render {

namespace {

constexpr const char* header = "#version 330 core\n";

constexpr std::pair<const char*, int> samplers[] = {
    {"sun_compare", unit::sun_compare},
    {"sun_depth", unit::sun_depth},
    {"sky_depth", unit::sky_depth},
    {"positions", unit::positions},
    {"previous_positions", unit::previous_positions},
    {"normals", unit::normals},
    {"picture", unit::picture},
    {"colours", unit::colours},
    {"print", unit::print},
};

struct Recipe {
    Program Programs::*program;
    const char* name;
    std::vector<const char*> vertex, fragment;  // names of files, joined in order
};

std::vector<const char*> texts(const std::vector<const char*>& names) {
    std::vector<const char*> result{header};
    for (const char* name : names) result.push_back(shader_source(name));
    return result;
}

const Recipe recipes[] = {
    {&Programs::sky, "sky", {"screen.vert"}, {"frame.glsl", "sky.glsl", "tone.glsl", "sky.frag"}},
    {&Programs::ground,
     "ground",
     {"frame.glsl", "ground.vert"},
     {"frame.glsl", "sky.glsl", "tone.glsl", "light.glsl", "ground.frag"}},
    {&Programs::solid,
     "solid",
     {"solid.vert"},
     {"frame.glsl", "sky.glsl", "tone.glsl", "light.glsl", "solid.frag"}},
    {&Programs::cloth,
     "cloth",
     {"cloth.vert"},
     {"frame.glsl", "sky.glsl", "tone.glsl", "light.glsl", "weave.glsl", "cloth.frag"}},
    {&Programs::cloth_lines, "cloth lines", {"cloth.vert"}, {"lines.frag"}},
    {&Programs::lines, "lines", {"frame.glsl", "lines.vert"}, {"colour.frag"}},
    {&Programs::display, "display", {"screen.vert"}, {"display.frag"}},
    {&Programs::solid_depth, "solid depth", {"solid.vert"}, {"depth.frag"}},
    {&Programs::cloth_depth, "cloth depth", {"cloth.vert"}, {"depth.frag"}},
};

}  // namespace

Result<Programs> Programs::build() {
    Programs programs;
    for (const Recipe& recipe : recipes) {
        auto linked = Program::link(recipe.name, texts(recipe.vertex), texts(recipe.fragment));
        if (!linked) return linked.error();
        Program& program = programs.*recipe.program;
        program = std::move(*linked);
        program.use();
        for (const auto& [uniform, texture_unit] : samplers) program.set(uniform, texture_unit);
        program.bind_block("Frame", frame_binding);
    }
    return programs;
}

}  // namespace weft::render
