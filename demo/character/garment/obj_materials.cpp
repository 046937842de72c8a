#include "demo/character/garment/obj_materials.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <fstream>
#include <map>
#include <optional>
#include <string_view>

#include "cloth/mesh/obj/obj_lines.h"
#include "cloth/mesh/obj/words.h"

namespace weft::demo {
namespace {

/// The rest of a line as one name, inner blanks included.
std::string whole_name(std::string_view text) {
    const std::size_t begin = std::min(text.find_first_not_of(" \t"), text.size());
    const std::size_t end = text.find_last_not_of(" \t");
    return end == std::string_view::npos ? std::string() : std::string(text.substr(begin, end + 1 - begin));
}

/// Marks the vertices of a face, and its triangles.
void use_face(std::string_view corners, std::uint32_t material, ObjMaterials& use) {
    const bool simulated = material > 0 && is_simulated(use.names[material - 1]);
    std::size_t count = 0;
    for (std::string_view corner = take_word(corners); !corner.empty();
         corner = take_word(corners), ++count) {
        std::int64_t index = 0;
        std::from_chars(corner.data(), corner.data() + corner.size(), index);
        const auto vertex =
            static_cast<std::size_t>(index < 0 ? static_cast<std::int64_t>(use.vertices) + index : index - 1);
        if (vertex >= use.used.size()) use.used.resize(vertex + 1), use.simulated.resize(vertex + 1);
        use.used[vertex] = true;
        if (simulated) use.simulated[vertex] = true;
    }
    use.of_triangle.insert(use.of_triangle.end(), std::max<std::size_t>(count, 2) - 2, material);
}

/// A material of an MTL file.
struct MtlMaterial {
    std::optional<Vec3> colour{};
    std::string picture{};  // file's name; empty: none
};

Vec3 colour_of(std::string_view text) {
    std::array<float, 3> rgb{};
    for (float& part : rgb) {
        const std::string_view word = take_word(text);
        std::from_chars(word.data(), word.data() + word.size(), part);
        part = part > 0 ? std::min(part, 1.0f) : 0;  // NaN as well
    }
    return {rgb[0], rgb[1], rgb[2]};
}

/// The file's name of a map_Kd statement: after options, as in "-s 1 1 1 print.png", its last word.
/// Separators are those of any system.
std::string picture_name(std::string_view text) {
    std::string name = whole_name(text);
    if (name.starts_with('-')) name.erase(0, name.find_last_of(" \t") + 1);
    std::ranges::replace(name, '\\', '/');
    return name;
}

/// None: the file cannot be read.
std::optional<std::map<std::string, MtlMaterial>> read_library(const std::filesystem::path& file) {
    std::error_code ignored;
    if (!std::filesystem::is_regular_file(file, ignored)) return std::nullopt;
    std::ifstream stream(file, std::ios::binary);
    const std::string name = file.string();
    ObjLines lines(stream, name);
    std::map<std::string, MtlMaterial> materials;
    MtlMaterial* present = nullptr;
    for (auto more = lines.next(); more && *more; more = lines.next()) {
        std::string_view rest = lines.text();
        const std::string_view keyword = take_word(rest);
        if (keyword == "newmtl") present = &materials[whole_name(rest)];
        if (present == nullptr) continue;
        if (keyword == "Kd") present->colour = colour_of(rest);
        if (keyword == "map_Kd") present->picture = picture_name(rest);
    }
    return materials;
}

}  // namespace

Result<ObjMaterials> read_obj_materials(const std::filesystem::path& obj) {
    std::ifstream stream(obj, std::ios::binary);
    const std::string name = obj.string();
    ObjLines lines(stream, name);
    ObjMaterials use;
    std::uint32_t present = 0;
    for (;;) {
        const auto more = lines.next();
        if (!more) return more.error();
        if (!*more) return use;
        std::string_view rest = lines.text();
        const std::string_view keyword = take_word(rest);
        if (keyword == "v") ++use.vertices;
        if (keyword == "f") use_face(rest, present, use);
        if (keyword == "mtllib") use.library = whole_name(rest);
        if (keyword != "usemtl") continue;
        const std::string material = whole_name(rest);
        const auto found = std::ranges::find(use.names, material);
        present = static_cast<std::uint32_t>(found - use.names.begin()) + 1;
        if (found == use.names.end()) use.names.push_back(material);
    }
}

SurfaceParts read_mtl(const std::filesystem::path& obj, const ObjMaterials& materials,
                      const Vec3& default_colour, std::vector<std::string>& notes) {
    if (materials.library.empty()) {
        notes.push_back(obj.string() + " names no MTL file; its colour is the default");
        return {};
    }
    const std::filesystem::path library = obj.parent_path() / materials.library;
    const auto known = read_library(library);
    if (!known) {
        notes.push_back(library.string() + " cannot be read; the names in " + obj.string() +
                        " still say what is simulated, and its colour is the default");
        return {};
    }
    std::map<std::string, std::shared_ptr<const render::Image>> pictures;
    const auto picture_of = [&](const std::string& name) -> std::shared_ptr<const render::Image> {
        if (name.empty()) return nullptr;
        const auto [found, is_new] = pictures.try_emplace(name);
        if (!is_new) return found->second;
        auto read = read_picture(library.parent_path() / name);
        if (!read) notes.push_back(read.error().message);
        return found->second = read ? *std::move(read) : nullptr;
    };
    SurfaceParts surface{.parts = {part_of({}, default_colour)}, .of_triangle = materials.of_triangle};
    for (const std::string& name : materials.names) {
        const auto material = known->find(name);
        if (material == known->end()) {
            notes.push_back(library.string() + " has no material " + name);
            surface.parts.push_back(part_of({}, default_colour));
            continue;
        }
        const MtlMaterial& of = material->second;
        surface.parts.push_back(part_of(of.colour, default_colour, picture_of(of.picture)));
    }
    return surface;
}

}  // namespace weft::demo
