// A garment from an OBJ file whose texture coordinates are its flat pattern, or from a glTF file, hung by its
// highest opening in a breeze.

#include <algorithm>
#include <cstdio>
#include <string>
#include <utility>

#include "demo/character/garment/garment_mesh.h"
#include "demo/character/garment/gltf_file.h"
#include "demo/character/garment/obj_materials.h"
#include "demo/character/garment/painted_maps.h"
#include "demo/must.h"
#include "demo/scene.h"
#include "demo/scenes/measures.h"

namespace weft::demo {
namespace {

constexpr Vec3 cloth_colour{0.13f, 0.32f, 0.26f};
constexpr float above_ground = 0.45f;  // the lowest point's height at the start [m]

std::vector<std::uint32_t> held_vertices(const Mesh& mesh, Hold hold) {
    switch (hold) {
        case Hold::highest_opening:
            return highest_opening(mesh);
        case Hold::top:
            return topmost(mesh);
        case Hold::border:
            return border_vertices(mesh);
        case Hold::nothing:
            break;
    }
    return {};
}

std::string unit_in_words(const std::filesystem::path& file, float unit) {
    char words[64];
    std::snprintf(words, sizeof words, " is read in units of %.4g mm", static_cast<double>(1000 * unit));
    return file.filename().string() + words + ", which gives it a garment's size";
}

/// The colours of an OBJ file's materials; none where it has no materials.
SurfaceParts surface_of(const std::filesystem::path& obj, const ObjMaterials& materials,
                        std::vector<std::string>& notes) {
    return materials.names.empty() ? SurfaceParts() : read_mtl(obj, materials, cloth_colour, notes);
}

Mesh load_mesh(const std::filesystem::path& obj) {
    auto loaded = load_obj(obj, {.texcoords_are_pattern = true});
    return loaded ? *std::move(loaded) : must(load_obj(obj));  // some corners may have no texture coordinates
}

/// Reads maps, of which those that need a body are left out.
void take_maps(const std::filesystem::path& file, std::size_t vertices, std::span<const Vec3> painted,
               Garment& garment) {
    must(read_maps(file, vertices, painted, garment));
    const auto needs_body = [](const PaintedMap& each) {
        return each.map == Map::leash || each.map == Map::backstop || each.map == Map::backstop_radius;
    };
    if (std::erase_if(garment.maps, needs_body) > 0)
        garment.notes.push_back("leashes and backstops are left out: they need somebody who wears the cloth");
}

/// Reads the file. Triangles are quartered while `particles` is more than twice the number of vertices.
Garment load_garment(const SceneOptions& options) {
    const std::filesystem::path& file = options.garment;
    Garment garment;
    Mesh& mesh = garment.mesh;
    if (is_gltf(file)) {
        GltfSurface surface;
        mesh = must(read_gltf_mesh(file, &surface));
        garment.surface = std::move(surface.parts);
        garment.notes = std::move(surface.notes);
        // The maps of somebody's clothes count the vertices of what is worn alone.
        if (!has_skin(file)) take_maps(file, mesh.positions.size(), {}, garment);
    } else {
        mesh = load_mesh(file);
        const ObjMaterials materials = must(read_obj_materials(file));
        garment.surface = surface_of(file, materials, garment.notes);
        take_maps(file, materials.vertices, read_vertex_colours(file), garment);
    }
    if (options.y_is_up || is_gltf(file))
        for (Vec3& p : mesh.positions) p = {p.x, -p.z, p.y};
    const float unit = options.unit > 0 ? options.unit : guessed_unit(mesh);
    for (Vec3& p : mesh.positions) p = to_vec3(unit * to_vector(p));
    if (options.unit == 0 && unit != 1) garment.notes.push_back(unit_in_words(file, unit));
    drop_unfit_pattern(mesh);
    stand_upright(mesh, above_ground);
    while (options.particles > 2 * mesh.positions.size()) refine(garment);
    return garment;
}

class HungGarment final : public Scene {
  public:
    [[nodiscard]] WorldSettings world_settings() const override {
        // Folds of uneven triangles press on each other, and contact is resolved after the step.
        return {.wind = {.velocity = {0.25f, 0, 0.65f}, .gust = 0.7f, .gust_length = 0.5f}, .substeps = 2};
    }

    [[nodiscard]] Result<SceneContent> build(World& world, const SceneOptions& options) override {
        if (options.garment.empty()) {
            return Error{ErrorCode::invalid_argument,
                         "scene garment needs an OBJ or glTF file; name one with --garment"};
        }
        Garment garment = load_garment(options);
        if (options.simulated > 0) must(simulate_proxy(garment, options.simulated));
        mesh_ = garment.mesh;

        ClothSettings settings;
        settings.fabric.areal_density = 0.18f;
        settings.self_collision.method = SelfCollisionMethod::contact;
        cloth_ = must(world.add_cloth(mesh_, settings));
        pins_ = held_vertices(mesh_, options.hold);
        pins_.insert(pins_.end(), garment.fixed.begin(), garment.fixed.end());
        must(world.pin(cloth_, pins_));
        for (const PaintedMap& painted : garment.maps)
            must(world.set_map(cloth_, painted.map, painted.values));
        must(world.add_collider({.shape = Plane{}}));
        SceneContent content = this->content(world);
        SceneCloth& cloth = content.cloths.front();
        cloth.surface = std::move(garment.surface);
        cloth.maps = std::move(garment.maps);
        content.notes = std::move(garment.notes);
        if (options.simulated > 0) must(draw_over(cloth, world, garment.fine, {.reach = garment.reach}));
        return content;
    }

    [[nodiscard]] Result<void> check(const World& world) const override {
        Checks checks;
        const ClothView view = checks.cloth(world, cloth_);
        for (const std::uint32_t vertex : pins_) checks.pinned_at(view, vertex, mesh_.positions[vertex]);
        checks.stretch(mesh_, view, 1.5f, 1.01f);
        checks.at_least("the lowest point's height above the ground [m]", view.bounds.lower.y, 0.1f);
        checks.at_most("the hem's fall since the start [m]", above_ground - view.bounds.lower.y, 0.25f);
        return checks.result();
    }

  private:
    [[nodiscard]] SceneContent content(const World& world) const {
        const Bounds box = must(world.cloth(cloth_)).bounds;
        SceneContent content;
        content.cloths.push_back({cloth_, mesh_, two_sided(cloth_colour)});
        const float size = std::max(
            {box.upper.x - box.lower.x, box.upper.y - box.lower.y, 0.7f * (box.upper.z - box.lower.z)});
        content.camera = {.target = {0, 0.5f * (box.lower.y + box.upper.y) - 0.05f, 0},
                          .distance = 0.4f + 1.7f * size,
                          .yaw = 0.5f,
                          .pitch = 0.1f};
        return content;
    }

    ClothId cloth_;
    Mesh mesh_;
    std::vector<std::uint32_t> pins_;
};

}  // namespace

std::unique_ptr<Scene> make_garment_scene() {
    return std::make_unique<HungGarment>();
}

}  // namespace weft::demo
