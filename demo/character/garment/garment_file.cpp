#include "demo/character/garment/garment_file.h"

#include <algorithm>
#include <charconv>
#include <fstream>
#include <map>
#include <optional>
#include <set>
#include <string_view>
#include <utility>

#include "cloth/mesh/obj/obj_lines.h"
#include "cloth/mesh/obj/words.h"
#include "demo/character/garment/garment_mesh.h"
#include "demo/character/garment/painted_maps.h"

namespace weft::demo {
namespace {

constexpr float smallest = 0.1f, largest = 3;  // [m]

/// The materials of an OBJ file, and the vertices that have them.
struct MaterialUse {
    std::vector<std::string> names;     // in order of use
    std::vector<bool> used, simulated;  // by `v` line
    std::string library;
    std::size_t vertices = 0;  // `v` lines
};

/// The rest of a line as one name, inner blanks included.
std::string whole_name(std::string_view text) {
    const std::size_t begin = std::min(text.find_first_not_of(" \t"), text.size());
    const std::size_t end = text.find_last_not_of(" \t");
    return end == std::string_view::npos ? std::string() : std::string(text.substr(begin, end + 1 - begin));
}

bool is_simulated(std::string_view material) {
    return material.ends_with("Free");
}

/// Marks the vertices of a face. Precondition: load_obj has checked the file's indices.
void use_face(std::string_view corners, bool simulated, MaterialUse& use) {
    for (std::string_view corner = take_word(corners); !corner.empty(); corner = take_word(corners)) {
        std::int64_t index = 0;
        std::from_chars(corner.data(), corner.data() + corner.size(), index);
        const auto vertex =
            static_cast<std::size_t>(index < 0 ? static_cast<std::int64_t>(use.vertices) + index : index - 1);
        if (vertex >= use.used.size()) use.used.resize(vertex + 1), use.simulated.resize(vertex + 1);
        use.used[vertex] = true;
        if (simulated) use.simulated[vertex] = true;
    }
}

Result<MaterialUse> read_materials(const std::filesystem::path& file) {
    std::ifstream stream(file, std::ios::binary);
    const std::string name = file.string();
    ObjLines lines(stream, name);
    MaterialUse use;
    bool simulated = false;
    for (;;) {
        const auto more = lines.next();
        if (!more) return more.error();
        if (!*more) return use;
        std::string_view rest = lines.text();
        const std::string_view keyword = take_word(rest);
        if (keyword == "v") ++use.vertices;
        if (keyword == "f") use_face(rest, simulated, use);
        if (keyword == "mtllib") use.library = whole_name(rest);
        if (keyword != "usemtl") continue;
        const std::string material = whole_name(rest);
        simulated = is_simulated(material);
        if (std::ranges::find(use.names, material) == use.names.end()) use.names.push_back(material);
    }
}

/// Diffuse colours by material.
std::optional<std::map<std::string, Vec3>> read_colours(const std::filesystem::path& file) {
    std::error_code ignored;
    if (!std::filesystem::is_regular_file(file, ignored)) return std::nullopt;
    std::ifstream stream(file, std::ios::binary);
    const std::string name = file.string();
    ObjLines lines(stream, name);
    std::map<std::string, Vec3> colours;
    std::string material;
    for (auto more = lines.next(); more && *more; more = lines.next()) {
        std::string_view rest = lines.text();
        const std::string_view keyword = take_word(rest);
        if (keyword == "newmtl") colours[material = whole_name(rest)] = Garment().colour;
        if (keyword != "Kd" || material.empty()) continue;
        std::array<float, 3> rgb{};
        for (float& part : rgb) {
            const std::string_view word = take_word(rest);
            std::from_chars(word.data(), word.data() + word.size(), part);
            part = part > 0 ? std::min(part, 1.0f) : 0;  // NaN as well
        }
        colours[material] = {rgb[0], rgb[1], rgb[2]};
    }
    return colours;
}

void take_colour(const std::filesystem::path& file, const MaterialUse& use, Garment& garment) {
    if (use.library.empty())
        return garment.notes.push_back(file.string() + " names no MTL file; its colour is the default");
    const std::filesystem::path library = file.parent_path() / use.library;
    const auto colours = read_colours(library);
    if (!colours)
        return garment.notes.push_back(library.string() + " cannot be read; the names in " + file.string() +
                                       " still say what is simulated, and its colour is the default");
    for (const std::string& material : use.names) {
        if (!colours->contains(material))
            garment.notes.push_back(library.string() + " has no material " + material);
    }
    const auto first = std::ranges::find_if(use.names, is_simulated);
    if (const auto found = colours->find(*first); found != colours->end()) garment.colour = found->second;
}

Result<void> check_size(const std::filesystem::path& file, const Mesh& mesh) {
    std::pair<float, const char*> longest{};
    for (const auto& [coordinate, axis] : {std::pair(&Vec3::x, "x"), {&Vec3::y, "y"}, {&Vec3::z, "z"}}) {
        const auto [low, high] = std::ranges::minmax(mesh.positions, {}, coordinate);
        if (const float size = high.*coordinate - low.*coordinate; size >= longest.first)
            longest = {size, axis};
    }
    const auto& [size, axis] = longest;
    if (size >= smallest && size <= largest) return {};
    return Error{
        ErrorCode::invalid_mesh,
        file.string() + ": is " + std::to_string(size) + " m along " + axis +
            ", its longest side; that of a garment that fits is 0.1 to 3 m; choose its unit where it is not "
            "in metres"};
}

/// A metre, or the smaller unit by which the mesh has a garment's size.
float unit_by_size(const Mesh& mesh) {
    const float guess = guessed_unit(mesh);
    return guess == 0.01f || guess == 0.001f || guess == 0.0254f ? guess : 1;
}

Result<Mesh> read_mesh(const std::filesystem::path& file, float unit, Garment& garment) {
    ObjReport report;
    auto mesh = load_obj(file, {}, &report);
    if (!mesh) return mesh;
    if (report.crossing_faces > 0)
        garment.notes.push_back(file.string() + ": faces whose outlines cross themselves: " +
                                std::to_string(report.crossing_faces) + "; their triangles overlap");
    if (unit == 0) unit = unit_by_size(*mesh);
    for (Vec3& p : mesh->positions) p = to_vec3(unit * to_vector(p));
    mesh->pattern = mesh->texcoords;
    drop_unfit_pattern(*mesh);
    return mesh;
}

void hold_by_opening(const std::filesystem::path& file, Garment& garment) {
    stand_upright(garment.mesh, 0);
    garment.fixed = highest_opening(garment.mesh);
    garment.from_waist = count_openings(garment.mesh) == 2;
    garment.notes.push_back(file.string() + " has no materials; it is held by its highest opening");
}

Result<void> hold_by_materials(const std::filesystem::path& file, const MaterialUse& use, Garment& garment) {
    if (std::ranges::none_of(use.names, is_simulated))
        return Error{ErrorCode::invalid_mesh,
                     file.string() + ": of its materials, " + use.names.front() +
                         " and others, none ends in \"Free\"; name so what is simulated"};
    garment.stands_ready = true;
    for (std::uint32_t vertex = 0; vertex < use.used.size(); ++vertex) {
        if (use.used[vertex] && !use.simulated[vertex]) garment.fixed.push_back(vertex);
    }
    take_colour(file, use, garment);
    return {};
}

}  // namespace

Result<Garment> read_garment(const std::filesystem::path& file, float unit) {
    Garment garment;
    auto mesh = read_mesh(file, unit, garment);
    if (!mesh) return mesh.error();
    garment.mesh = std::move(*mesh);
    if (auto fits = check_size(file, garment.mesh); !fits) return fits.error();
    const auto use = read_materials(file);
    if (!use) return use.error();
    if (use->names.empty())
        hold_by_opening(file, garment);
    else if (auto held = hold_by_materials(file, *use, garment); !held)
        return held.error();
    if (auto maps = read_maps(file, use->vertices, read_vertex_colours(file), garment); !maps)
        return maps.error();
    return garment;
}

}  // namespace weft::demo
