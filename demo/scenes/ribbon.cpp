// A long ribbon, lowered end first at constant speed, piles up on itself.

#include <algorithm>

#include "demo/scene.h"
#include "demo/scenes/measures.h"

namespace weft::demo {
namespace {

constexpr float width = 0.1f, length = 3.0f;  // [m]
constexpr float speed = 0.5f;                 // at which the top is lowered [m/s]
constexpr float start_height = 0.02f;         // of the lower end [m]
constexpr float hold_height = 0.35f;          // where the top stops [m]

class Ribbon final : public Scene {
  public:
    [[nodiscard]] WorldSettings world_settings() const override {
        WorldSettings settings;
        settings.wind.gust = 0;
        settings.substeps = 8;
        return settings;
    }

    [[nodiscard]] Result<SceneContent> build(World& world, const SceneOptions& options) override {
        const GridSize grid = grid_size(options.particles == 0 ? 3000 : options.particles, width, length);
        auto mesh = make_sheet({.rows = grid.rows,
                                .columns = grid.columns,
                                .origin = {-0.5f * width, start_height + length, 0},
                                .u = {width, 0, 0},
                                .v = {0, -length, 0}});
        if (!mesh) return mesh.error();
        mesh_ = std::move(*mesh);
        distance_ = 0.8f * length / static_cast<float>(grid.rows - 1);

        ClothSettings settings;
        settings.solver.iterations = 7;
        settings.self_collision = {.enabled = true, .distance = distance_, .friction = 0.4f};
        settings.thickness = 0.5f * distance_;
        const auto cloth = world.add_cloth(mesh_, settings);
        if (!cloth) return cloth.error();
        cloth_ = *cloth;
        for (std::uint32_t column = 0; column < mesh_.columns; ++column) {
            if (auto pinned = world.pin(cloth_, column); !pinned) return pinned.error();
        }
        const auto ground = world.add_collider({.shape = Plane{}, .friction = 0.7f});
        if (!ground) return ground.error();

        SceneContent content;
        content.cloths.push_back(
            {cloth_,
             mesh_,
             {.front = {0.50f, 0.05f, 0.20f}, .back = {0.70f, 0.50f, 0.15f}, .roughness = 0.4f}});
        content.camera = {.target = {0, 0.18f, 0}, .distance = 1.3f, .yaw = 0.7f, .pitch = 0.4f};
        return content;
    }

    void before_step(World& world, double time, float dt) override {
        top_ = top_height(time + static_cast<double>(dt));
        for (std::uint32_t column = 0; column < mesh_.columns; ++column) {
            (void)world.move_pin(cloth_, column, {mesh_.positions[column].x, top_, 0});
        }
    }

    [[nodiscard]] int check_steps() const override { return 360; }

    [[nodiscard]] Result<void> check(const World& world) const override {
        const auto view = world.cloth(cloth_);
        if (!view) return view.error();
        Checks checks;
        checks.finite(*view);
        for (std::uint32_t column = 0; column < mesh_.columns; ++column) {
            checks.pinned_at(*view, column, {mesh_.positions[column].x, top_, 0});
        }
        checks.at_least("the lowest point's height [m]", view->bounds.lower.y, 0.25f * distance_);
        checks.at_least("the least distance between layers, in self-collision distances",
                        closest_layers(mesh_, *view, 4 * distance_) / distance_, 0.5f);
        checks.at_least("the pile's height in self-collision distances", pile_height(*view) / distance_,
                        3.0f);
        checks.at_most("the pile's reach from under the top [m]", reach(*view), 0.5f);
        checks.at_most("worst stretch", structural_stretch(mesh_, *view).worst, 1.3f);
        return checks.result();
    }

  private:
    [[nodiscard]] static float top_height(double time) {
        return std::max(hold_height, start_height + length - speed * static_cast<float>(time));
    }

    /// Of the half that was lowered first, all of which lies in the pile.
    [[nodiscard]] float pile_height(const ClothView& view) const {
        float height = 0;
        for (std::uint32_t row = mesh_.rows / 2; row < mesh_.rows; ++row) {
            height = std::max(height, vertex_position(view, row * mesh_.columns).y());
        }
        return height;
    }

    [[nodiscard]] static float reach(const ClothView& view) {
        return std::max(
            {-view.bounds.lower.x, view.bounds.upper.x, -view.bounds.lower.z, view.bounds.upper.z});
    }

    ClothId cloth_;
    Mesh mesh_;
    float distance_ = 0;
    float top_ = start_height + length;
};

}  // namespace

std::unique_ptr<Scene> make_ribbon_scene() {
    return std::make_unique<Ribbon>();
}

}  // namespace weft::demo
