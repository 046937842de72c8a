#include "demo/character/garment/garment_file.h"

#include <algorithm>
#include <utility>

#include "demo/character/garment/garment_mesh.h"
#include "demo/character/garment/obj_materials.h"
#include "demo/character/garment/painted_maps.h"

namespace weft::demo {
namespace {

constexpr float smallest = 0.1f, largest = 3;  // [m]

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

void hold_by_opening(const std::filesystem::path& file, const ObjMaterials& use, bool y_is_up,
                     Garment& garment) {
    if (y_is_up)
        for (Vec3& p : garment.mesh.positions) p = {p.x, -p.z, p.y};
    stand_upright(garment.mesh, 0);
    garment.fixed = highest_opening(garment.mesh);
    garment.from_waist = count_openings(garment.mesh) == 2;
    garment.notes.push_back(file.string() +
                            (use.names.empty()
                                 ? " has no materials"
                                 : " has no material whose name ends in \"Free\", which would say what "
                                   "is simulated") +
                            "; it is held by its highest opening");
}

void hold_by_materials(const ObjMaterials& use, Garment& garment) {
    garment.stands_ready = true;
    for (std::uint32_t vertex = 0; vertex < use.used.size(); ++vertex) {
        if (use.used[vertex] && !use.simulated[vertex]) garment.fixed.push_back(vertex);
    }
}

/// The colours of all materials, and of the whole: the first simulated one's, else the first one's.
void take_colours(const std::filesystem::path& file, const ObjMaterials& use, Garment& garment) {
    garment.surface = read_mtl(file, use, garment.colour, garment.notes);
    if (garment.surface.parts.empty()) return;
    const auto found = std::ranges::find_if(use.names, is_simulated);
    const auto first = found == use.names.end() ? 0 : found - use.names.begin();
    garment.colour = garment.surface.parts[static_cast<std::size_t>(first) + 1].front;
}

}  // namespace

Result<Garment> read_garment(const std::filesystem::path& file, float unit, bool y_is_up) {
    Garment garment;
    auto mesh = read_mesh(file, unit, garment);
    if (!mesh) return mesh.error();
    garment.mesh = std::move(*mesh);
    if (auto fits = check_size(file, garment.mesh); !fits) return fits.error();
    const auto use = read_obj_materials(file);
    if (!use) return use.error();
    if (std::ranges::any_of(use->names, is_simulated))
        hold_by_materials(*use, garment);
    else
        hold_by_opening(file, *use, y_is_up, garment);
    if (!use->names.empty()) take_colours(file, *use, garment);
    if (auto maps = read_maps(file, use->vertices, read_vertex_colours(file), garment); !maps)
        return maps.error();
    return garment;
}

}  // namespace weft::demo
