// Cloth on a rigid body: a wall hanging whose lower edge is fixed to a wooden bar, in a gusty wind.

#include <algorithm>
#include <cmath>

#include "demo/scene.h"
#include "demo/scenes/holders.h"
#include "demo/scenes/measures.h"

namespace weft::demo {
namespace {

constexpr float hanging_width = 0.8f, hanging_length = 1.1f, hung_height = 1.6f;  // [m]
constexpr float bar_thickness = 0.035f, bar_mass = 0.8f;                          // [m], [kg]

class Bar final : public Scene {
  public:
    [[nodiscard]] WorldSettings world_settings() const override {
        WorldSettings settings;
        settings.wind = {.velocity = {0.5f, 0, -2.4f}, .gust = 0.6f, .gust_length = 1.0f};
        return settings;
    }

    [[nodiscard]] Result<SceneContent> build(World& world, const SceneOptions& options) override {
        const GridSize grid =
            grid_size(options.particles == 0 ? 1500 : options.particles, hanging_width, hanging_length);
        auto mesh = make_sheet({.rows = grid.rows,
                                .columns = grid.columns,
                                .origin = {-0.5f * hanging_width, hung_height, 0},
                                .u = {hanging_width, 0, 0},
                                .v = {0, -hanging_length, 0}});
        if (!mesh) return mesh.error();
        mesh_ = std::move(*mesh);
        ClothSettings settings;
        settings.fabric = {
            .areal_density = 0.25f, .warp = 2000, .weft = 2000, .shear = 400, .bending = 2e-5f};
        const auto cloth = world.add_cloth(mesh_, settings);
        if (!cloth) return cloth.error();
        cloth_ = *cloth;
        std::vector<std::uint32_t> lower;
        top_.clear();
        for (std::uint32_t column = 0; column < mesh_.columns; ++column) {
            top_.push_back(column);
            lower.push_back((mesh_.rows - 1) * mesh_.columns + column);
        }
        if (auto pinned = world.pin(cloth_, top_); !pinned) return pinned.error();
        const auto shown = add_bar(world, lower);
        if (!shown) return shown.error();

        SceneContent content;
        content.cloths.push_back({cloth_, mesh_, two_sided({0.42f, 0.12f, 0.08f}, 0.16f)});
        content.drawn_colliders = {*shown};
        content.camera = {.target = {0, 1.0f, 0}, .distance = 2.9f, .yaw = 0.7f, .pitch = 0.12f};
        return content;
    }

    void annotate(const World& world, Annotation& to) const override {
        draw_holder(world.cloth(cloth_).value(), top_, Holder::rod, to);
    }

    [[nodiscard]] Result<void> check(const World& world) const override {
        const auto view = world.cloth(cloth_);
        if (!view) return view.error();
        const auto state = world.body_state(bar_);
        if (!state) return state.error();
        Checks checks;
        checks.finite(*view);
        const std::uint32_t first = (mesh_.rows - 1) * mesh_.columns, last = first + mesh_.columns - 1;
        const Vector3 left = vertex_position(*view, first), right = vertex_position(*view, last);
        checks.at_most("how far the bar is from its edge of the cloth [m]",
                       (0.5f * (left + right) - to_vector(state->position)).norm(), 1e-3f);
        checks.at_most("how much the edge has stretched [m]", std::abs((right - left).norm() - hanging_width),
                       2e-3f);
        checks.at_least("the bar's height [m]", state->position.y, hung_height - 1.1f * hanging_length);
        checks.at_most("the bar's height [m]", state->position.y, hung_height);
        checks.at_most("where the wind has it, less being downwind [m]", state->position.z, 0.3f);
        checks.at_most("worst stretch", structural_stretch(mesh_, *view).worst, 1.25f);
        return checks.result();
    }

  private:
    /// Adds the bar. Its collider is drawn only: it is on no layer, so that no cloth collides with it.
    Result<ColliderId> add_bar(World& world, const std::vector<std::uint32_t>& edge) {
        const Vec3 middle{0, hung_height - hanging_length, 0};
        const float along = bar_mass / 12 * hanging_width * hanging_width;
        const float about = bar_mass / 6 * bar_thickness * bar_thickness;
        const auto bar =
            world.add_body({.mass = bar_mass, .inertia = {about, along, along}, .angular_damping = 0.2f},
                           {.position = middle});
        if (!bar) return bar.error();
        bar_ = *bar;
        const Vec3 half{0.5f * hanging_width + 0.03f, 0.5f * bar_thickness, 0.5f * bar_thickness};
        const auto shape =
            world.add_collider({.shape = Box{.center = middle, .half_extents = half}, .layers = 0});
        if (!shape) return shape.error();
        if (auto attached = world.attach_collider(bar_, *shape); !attached) return attached.error();
        if (auto attached = world.attach(bar_, cloth_, edge); !attached) return attached.error();
        return *shape;
    }

    ClothId cloth_;
    BodyId bar_;
    Mesh mesh_;
    std::vector<std::uint32_t> top_;
};

}  // namespace

std::unique_ptr<Scene> make_bar_scene() {
    return std::make_unique<Bar>();
}

}  // namespace weft::demo
