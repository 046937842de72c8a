// A garment from an OBJ file whose texture coordinates are its flat pattern, or from a glTF file, hung by its
// highest opening in a breeze.

#include <algorithm>
#include <cstdio>
#include <string>
#include <utility>

#include "demo/character/garment/garment_mesh.h"
#include "demo/character/garment/gltf_file.h"
#include "demo/must.h"
#include "demo/scene.h"
#include "demo/scenes/measures.h"

namespace weft::demo {
namespace {

constexpr float above_ground = 0.45f;  // the lowest point's height at the start [m]
constexpr float more_reach = 0.002f;   // by which drawn vertices are bound beyond the farthest one [m]

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

/// The file's mesh, its triangles quartered while `particles` is more than twice the number of vertices.
/// `note`: a unit that was guessed.
Result<Mesh> load_garment(const SceneOptions& options, std::string& note) {
    const bool gltf = is_gltf(options.garment);
    auto loaded =
        gltf ? read_gltf_mesh(options.garment) : load_obj(options.garment, {.texcoords_are_pattern = true});
    if (!loaded && !gltf) loaded = load_obj(options.garment);  // some corners have no texture coordinates
    if (!loaded) return loaded.error();
    Mesh mesh = std::move(*loaded);
    if (options.y_is_up || gltf)
        for (Vec3& p : mesh.positions) p = {p.x, -p.z, p.y};
    const float unit = options.unit > 0 ? options.unit : guessed_unit(mesh);
    for (Vec3& p : mesh.positions) p = to_vec3(unit * to_vector(p));
    if (options.unit == 0 && unit != 1) note = unit_in_words(options.garment, unit);
    drop_unfit_pattern(mesh);
    stand_upright(mesh, above_ground);
    while (options.particles > 2 * mesh.positions.size()) mesh = refined(mesh);
    return mesh;
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
        mesh_ = must(load_garment(options, note_));
        Mesh drawn;
        ProxyReport made;
        if (options.simulated > 0) {
            auto proxy = make_proxy(mesh_, {.particles = options.simulated}, &made);
            if (!proxy) return Error{proxy.error().code, "--simulate: " + proxy.error().message};
            drawn = std::exchange(mesh_, std::move(*proxy));
        }

        ClothSettings settings;
        settings.fabric.areal_density = 0.18f;
        settings.self_collision.method = SelfCollisionMethod::contact;
        cloth_ = must(world.add_cloth(mesh_, settings));
        pins_ = held_vertices(mesh_, options.hold);
        must(world.pin(cloth_, pins_));
        must(world.add_collider({.shape = Plane{}}));
        SceneContent content = this->content(world);
        if (options.simulated == 0) return content;
        must(draw_over(content.cloths.front(), world, drawn, {.reach = made.reach + more_reach}));
        content.notes.push_back(std::to_string(drawn.positions.size()) + " vertices are drawn over " +
                                std::to_string(mesh_.positions.size()) + " that are simulated");
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
        content.cloths.push_back({cloth_, mesh_, two_sided({0.13f, 0.32f, 0.26f})});
        if (!note_.empty()) content.notes.push_back(note_);
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
    std::string note_;
};

}  // namespace

std::unique_ptr<Scene> make_garment_scene() {
    return std::make_unique<HungGarment>();
}

}  // namespace weft::demo
