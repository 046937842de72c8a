// A flag on its pole in a gusty wind.

#include "demo/scene.h"
#include "demo/scenes/measures.h"

namespace weft::demo {
namespace {

constexpr float fly = 1.5f, hoist = 1.0f;  // [m]
constexpr float hoist_top = 2.55f;         // height of the hoist's top, at the pole [m]
constexpr float pole_radius = 0.025f;      // [m]

class Flag final : public Scene {
  public:
    [[nodiscard]] WorldSettings world_settings() const override {
        WorldSettings settings;
        settings.wind.velocity = {6.0f, 0, 1.0f};
        settings.wind.gust = 0.5f;
        settings.substeps = 4;
        return settings;
    }

    [[nodiscard]] Result<SceneContent> build(World& world, const SceneOptions& options) override {
        const GridSize grid = grid_size(options.particles == 0 ? 3000 : options.particles, fly, hoist);
        auto mesh = make_sheet({.rows = grid.rows,
                                .columns = grid.columns,
                                .origin = {0, hoist_top, 0},
                                .u = {fly, 0, 0},
                                .v = {0, -hoist, 0}});
        if (!mesh) return mesh.error();
        mesh_ = std::move(*mesh);

        ClothSettings settings;
        settings.fabric.areal_density = 0.12f;
        settings.fabric.bending = 5e-6f;
        settings.self_collision.method = SelfCollisionMethod::contact;
        const auto cloth = world.add_cloth(mesh_, settings);
        if (!cloth) return cloth.error();
        cloth_ = *cloth;
        for (std::uint32_t row = 0; row < mesh_.rows; ++row) {
            if (auto pinned = world.pin(cloth_, row * mesh_.columns); !pinned) return pinned.error();
        }

        const float axis = -1.5f * pole_radius;
        const auto pole =
            world.add_collider({.shape = Capsule{{axis, 0, 0}, {axis, hoist_top + 0.06f, 0}, pole_radius}});
        if (!pole) return pole.error();

        SceneContent content;
        content.cloths.push_back({cloth_, mesh_, {.stripe_width = 0.25f}});
        content.drawn_colliders = {*pole};
        content.camera = {.target = {0.65f, 1.8f, 0}, .distance = 3.4f, .yaw = 0.35f, .pitch = 0.04f};
        return content;
    }

    [[nodiscard]] Result<void> check(const World& world) const override {
        const auto view = world.cloth(cloth_);
        if (!view) return view.error();
        Checks checks;
        checks.finite(*view);
        for (std::uint32_t row = 0; row < mesh_.rows; ++row) {
            checks.pinned_at(*view, row * mesh_.columns, mesh_.positions[row * mesh_.columns]);
        }
        const Stretch stretch = structural_stretch(mesh_, *view);
        checks.at_most("worst stretch", stretch.worst, 1.5f);
        checks.at_most("mean stretch", stretch.mean, 1.03f);

        Vector3 free_edge = Vector3::Zero();
        for (std::uint32_t row = 1; row <= mesh_.rows; ++row) {
            free_edge += vertex_position(*view, row * mesh_.columns - 1) / static_cast<float>(mesh_.rows);
        }
        checks.at_least("the free edge's distance downwind [m]", free_edge.x(), 0.6f * fly);
        const float ripple = view->bounds.upper.z - view->bounds.lower.z;
        checks.at_least("the ripples' depth across the wind [m]", ripple, 0.05f);
        return checks.result();
    }

  private:
    ClothId cloth_;
    Mesh mesh_;
};

}  // namespace

std::unique_ptr<Scene> make_flag_scene() {
    return std::make_unique<Flag>();
}

}  // namespace weft::demo
