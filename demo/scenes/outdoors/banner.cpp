// A banner held at both ends, across the wind.

#include "demo/scene.h"
#include "demo/scenes/measures.h"

namespace weft::demo {
namespace {

constexpr float banner_length = 2.4f, banner_height = 0.7f, hung_at = 2.2f;  // [m]
constexpr float ends_apart = 0.94f;  // over its length; it hangs and billows by the rest

class Banner final : public Scene {
  public:
    [[nodiscard]] WorldSettings world_settings() const override {
        WorldSettings settings;
        settings.wind.velocity = {0.5f, 0, -5.0f};
        settings.wind.gust = 0.5f;
        settings.substeps = 2;
        return settings;
    }

    [[nodiscard]] Result<SceneContent> build(World& world, const SceneOptions& options) override {
        const GridSize grid =
            grid_size(options.particles == 0 ? 2400 : options.particles, banner_length, banner_height);
        auto mesh = make_sheet({.rows = grid.rows,
                                .columns = grid.columns,
                                .origin = {-0.5f * banner_length, hung_at, 0},
                                .u = {banner_length, 0, 0},
                                .v = {0, -banner_height, 0}});
        if (!mesh) return mesh.error();
        mesh_ = std::move(*mesh);
        ClothSettings settings;
        settings.fabric = {.areal_density = 0.14f, .warp = 800, .weft = 800, .shear = 200, .bending = 8e-6f};
        const auto cloth = world.add_cloth(mesh_, settings);
        if (!cloth) return cloth.error();
        cloth_ = *cloth;
        std::vector<std::uint32_t> ends;
        for (std::uint32_t row = 0; row < mesh_.rows; ++row) {
            ends.push_back(row * mesh_.columns);
            ends.push_back((row + 1) * mesh_.columns - 1);
        }
        if (auto pinned = world.pin(cloth_, ends); !pinned) return pinned.error();

        SceneContent content;
        for (const float side : {-0.5f, 0.5f}) {
            const float x = side * (ends_apart * banner_length + 0.05f);
            const auto pole =
                world.add_collider({.shape = Capsule{{x, 0, 0}, {x, hung_at + 0.08f, 0}, 0.02f}});
            if (!pole) return pole.error();
            content.drawn_colliders.push_back(*pole);
        }
        content.cloths.push_back({cloth_, mesh_, two_sided({0.07f, 0.2f, 0.42f}, 0.3f)});
        content.camera = {.target = {0, 1.55f, 0}, .distance = 4.0f, .yaw = 0.5f, .pitch = 0.1f};
        return content;
    }

    /// The ends come together in the first second.
    void before_step(World& world, double time, float dt) override {
        if (time > 1.1) return;
        for (std::uint32_t row = 0; row < mesh_.rows; ++row)
            for (const std::uint32_t vertex : {row * mesh_.columns, (row + 1) * mesh_.columns - 1})
                (void)world.move_pin(cloth_, vertex, place_of(vertex, time + static_cast<double>(dt)));
    }

    [[nodiscard]] int check_steps() const override { return 240; }

    [[nodiscard]] Result<void> check(const World& world) const override {
        const auto view = world.cloth(cloth_);
        if (!view) return view.error();
        Checks checks;
        checks.finite(*view);
        for (const std::uint32_t vertex : {0u, mesh_.columns - 1})
            checks.pinned_at(*view, vertex, place_of(vertex, 2));
        checks.at_most("how far it billows, downwind being less [m]", view->bounds.lower.z, -0.1f);
        checks.at_least("how far it bulges against the wind [m]", -view->bounds.upper.z, -0.35f);
        const Stretch stretch = structural_stretch(mesh_, *view);
        checks.at_most("worst stretch", stretch.worst, 1.3f);
        checks.at_most("mean stretch", stretch.mean, 1.03f);
        return checks.result();
    }

  private:
    [[nodiscard]] Vec3 place_of(std::uint32_t vertex, double time) const {
        const Vec3& start = mesh_.positions[vertex];
        const auto part = static_cast<float>(std::min(time, 1.0));
        return {start.x * (1 - (1 - ends_apart) * part), start.y, start.z};
    }

    ClothId cloth_;
    Mesh mesh_;
};

}  // namespace

std::unique_ptr<Scene> make_banner_scene() {
    return std::make_unique<Banner>();
}

}  // namespace weft::demo
