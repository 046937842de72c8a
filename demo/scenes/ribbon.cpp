// A long ribbon, lowered end first at constant speed, piles up on itself.

#include <algorithm>
#include <cmath>
#include <numbers>

#include "demo/scene.h"
#include "demo/scenes/measures.h"

namespace weft::demo {
namespace {

constexpr float ribbon_width = 0.1f, length = 2.4f;  // [m]
constexpr double speed = 0.5;                        // at which the top is lowered [m/s]
constexpr float start_height = 0.02f;                // height of the lower end [m]
constexpr float hold_height = 0.4f;                  // height at which the top stops [m]

// The hand that lowers the ribbon sways: without that a flat ribbon would have no side to fold to.
constexpr float sway = 0.015f;       // [m]
constexpr double sway_period = 0.9;  // [s]

class Ribbon final : public Scene {
  public:
    [[nodiscard]] WorldSettings world_settings() const override {
        WorldSettings settings;
        settings.wind.gust = 0;
        settings.substeps = 2;
        return settings;
    }

    [[nodiscard]] Result<SceneContent> build(World& world, const SceneOptions& options) override {
        const GridSize grid =
            grid_size(options.particles == 0 ? 1000 : options.particles, ribbon_width, length);
        auto mesh = make_sheet({.rows = grid.rows,
                                .columns = grid.columns,
                                .origin = {-0.5f * ribbon_width, start_height + length, 0},
                                .u = {ribbon_width, 0, 0},
                                .v = {0, -length, 0}});
        if (!mesh) return mesh.error();
        mesh_ = std::move(*mesh);
        distance_ = 0.8f * length / static_cast<float>(grid.rows - 1);

        ClothSettings settings;
        settings.fabric = {.areal_density = 0.2f,
                           .warp = 200.0f,
                           .weft = 200.0f,
                           .shear = 80.0f,
                           .bending = 2e-5f,
                           .damping = 1e-3f};
        settings.air_damping = 1.0f;
        settings.self_collision = {.method = SelfCollisionMethod::contact, .friction = 0.4f};
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
        content.camera = {.target = {0, 0.2f, 0}, .distance = 1.0f, .yaw = 0.7f, .pitch = 0.35f};
        return content;
    }

    void before_step(World& world, double time, float dt) override {
        time_ = time + static_cast<double>(dt);
        for (std::uint32_t column = 0; column < mesh_.columns; ++column) {
            (void)world.move_pin(cloth_, column, hand(column));
        }
    }

    [[nodiscard]] int check_steps() const override { return 360; }

    [[nodiscard]] Result<void> check(const World& world) const override {
        const auto view = world.cloth(cloth_);
        if (!view) return view.error();
        Checks checks;
        checks.finite(*view);
        for (std::uint32_t column = 0; column < mesh_.columns; ++column) {
            checks.pinned_at(*view, column, hand(column));
        }
        checks.at_least("the lowest point's height [m]", view->bounds.lower.y, 0.25f * distance_);
        checks.at_least("the least distance between layers, in self-collision distances",
                        closest_layers(mesh_, *view, 4 * distance_) / distance_, 0.05f);
        checks.at_least("the pile's height in self-collision distances", pile_height(*view) / distance_,
                        2.0f);
        checks.at_most("the pile's reach from under the top [m]", reach(*view), 0.35f);
        checks.at_most("worst stretch", structural_stretch(mesh_, *view).worst, 1.3f);
        return checks.result();
    }

  private:
    /// Pinned place of the top row's vertex of this column.
    [[nodiscard]] Vec3 hand(std::uint32_t column) const {
        const Vec3 start = mesh_.positions[column];
        const double lowered = std::min(speed * time_, static_cast<double>(start.y - hold_height));
        const double swing = std::sin(2 * std::numbers::pi * lowered / (speed * sway_period));
        return {start.x, start.y - static_cast<float>(lowered), sway * static_cast<float>(swing)};
    }

    /// Greatest height of the half that was lowered first, all of which lies in the pile.
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
    double time_ = 0;
};

}  // namespace

std::unique_ptr<Scene> make_ribbon_scene() {
    return std::make_unique<Ribbon>();
}

}  // namespace weft::demo
