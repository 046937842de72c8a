// A garment from an OBJ file whose texture coordinates are its flat pattern, or from a glTF file, hung by its
// highest opening in a breeze.

#include <algorithm>
#include <cstdio>
#include <string>
#include <utility>

#include "demo/character/garment/garment_mesh.h"
#include "demo/character/garment/gltf_mesh.h"
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
        WorldSettings settings;
        settings.wind.velocity = {0.25f, 0, 0.65f};
        settings.wind.gust = 0.7f;
        settings.wind.gust_length = 0.5f;
        // Folds of uneven triangles press on each other, and contact is resolved after the step.
        settings.substeps = 2;
        return settings;
    }

    [[nodiscard]] Result<SceneContent> build(World& world, const SceneOptions& options) override {
        if (options.garment.empty()) {
            return Error{ErrorCode::invalid_argument,
                         "scene garment needs an OBJ or glTF file; name one with --garment"};
        }
        auto mesh = load_garment(options, note_);
        if (!mesh) return mesh.error();
        mesh_ = std::move(*mesh);
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
        const auto cloth = world.add_cloth(mesh_, settings);
        if (!cloth) return cloth.error();
        cloth_ = *cloth;
        pins_ = held_vertices(mesh_, options.hold);
        for (const std::uint32_t vertex : pins_) {
            if (auto pinned = world.pin(cloth_, vertex); !pinned) return pinned.error();
        }
        const auto ground = world.add_collider({.shape = Plane{}});
        if (!ground) return ground.error();
        auto content = this->content(world);
        if (!content || options.simulated == 0) return content;
        if (auto bound = draw_over(content->cloths.front(), world, drawn, {.reach = made.reach + more_reach});
            !bound)
            return bound.error();
        content->notes.push_back(std::to_string(drawn.positions.size()) + " vertices are drawn over " +
                                 std::to_string(mesh_.positions.size()) + " that are simulated");
        return content;
    }

    [[nodiscard]] Result<void> check(const World& world) const override {
        const auto view = world.cloth(cloth_);
        if (!view) return view.error();
        Checks checks;
        checks.finite(*view);
        for (const std::uint32_t vertex : pins_) checks.pinned_at(*view, vertex, mesh_.positions[vertex]);
        const Stretch stretch = structural_stretch(mesh_, *view);
        checks.at_most("worst stretch", stretch.worst, 1.5f);
        checks.at_most("mean stretch", stretch.mean, 1.01f);
        checks.at_least("the lowest point's height above the ground [m]", view->bounds.lower.y, 0.1f);
        checks.at_most("the hem's fall since the start [m]", above_ground - view->bounds.lower.y, 0.25f);
        return checks.result();
    }

  private:
    [[nodiscard]] Result<SceneContent> content(const World& world) const {
        const auto view = world.cloth(cloth_);
        if (!view) return view.error();
        const Bounds& box = view->bounds;
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
