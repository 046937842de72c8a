// A square sheet that falls over a sphere and onto the ground.

#include "demo/scene.h"
#include "demo/scenes/measures.h"

namespace weft::demo {
namespace {

constexpr float square_side = 2.0f;  // [m]
constexpr float fall = 0.35f;        // from the start to the top of the sphere [m]
constexpr Sphere sphere{{0, 0.4f, 0}, 0.4f};
constexpr float thickness = 0.008f;  // [m]

class Sheet final : public Scene {
  public:
    [[nodiscard]] WorldSettings world_settings() const override {
        WorldSettings settings;
        settings.wind.air_density = 0.6f;  // thin still air: the sheet falls in a second
        return settings;
    }

    [[nodiscard]] Result<SceneContent> build(World& world, const SceneOptions& options) override {
        const GridSize grid =
            grid_size(options.particles == 0 ? 3000 : options.particles, square_side, square_side);
        auto mesh = make_sheet(
            {.rows = grid.rows,
             .columns = grid.columns,
             .origin = {-0.5f * square_side, sphere.center.y + sphere.radius + fall, -0.5f * square_side},
             .u = {square_side, 0, 0},
             .v = {0, 0, square_side}});
        if (!mesh) return mesh.error();
        mesh_ = std::move(*mesh);

        ClothSettings settings;
        settings.self_collision = {.method = SelfCollisionMethod::contact};
        settings.thickness = thickness;
        const auto cloth = world.add_cloth(mesh_, settings);
        if (!cloth) return cloth.error();
        cloth_ = *cloth;
        const auto ball = world.add_collider({.shape = sphere, .friction = 0.5f});
        if (!ball) return ball.error();
        const auto ground = world.add_collider({.shape = Plane{}, .friction = 0.6f});
        if (!ground) return ground.error();

        SceneContent content;
        content.cloths.push_back({cloth_, mesh_, two_sided({0.62f, 0.45f, 0.16f}, 0.18f)});
        content.drawn_colliders = {*ball};
        content.camera = {.target = {0, 0.32f, 0}, .distance = 3.1f, .yaw = 0.6f, .pitch = 0.45f};
        return content;
    }

    [[nodiscard]] Result<void> check(const World& world) const override {
        const auto view = world.cloth(cloth_);
        if (!view) return view.error();
        Checks checks;
        checks.finite(*view);
        checks.at_least("the lowest point's height [m]", view->bounds.lower.y, 0.5f * thickness);

        float nearest = square_side, fastest = 0;
        for (std::size_t i = 0; i < view->positions.size(); ++i) {
            nearest = std::min(nearest, (xyz(view->positions[i]) - to_vector(sphere.center)).norm());
            fastest = std::max(fastest, xyz(view->velocities[i]).norm());
        }
        checks.at_least("the least distance from the sphere's centre [m]", nearest,
                        sphere.radius + 0.5f * thickness);
        checks.at_most("the fastest particle's speed, once it has come to rest [m/s]", fastest, 0.2f);

        const Vector3 summit = to_vector(sphere.center) + Vector3(0, sphere.radius + thickness, 0);
        const Vector3 centre = vertex_position(*view, (mesh_.rows / 2) * mesh_.columns + mesh_.columns / 2);
        checks.at_most("the sheet's centre's distance from the top of the sphere [m]",
                       (centre - summit).norm(), 0.1f);

        const Stretch stretch = structural_stretch(mesh_, *view);
        checks.at_most("worst stretch", stretch.worst, 1.1f);
        checks.at_most("mean stretch", stretch.mean, 1.02f);
        const float corner = vertex_position(*view, 0).y();
        checks.at_most("a corner's height above the ground [m]", corner, 0.2f);
        return checks.result();
    }

  private:
    ClothId cloth_;
    Mesh mesh_;
};

}  // namespace

std::unique_ptr<Scene> make_sheet_scene() {
    return std::make_unique<Sheet>();
}

}  // namespace weft::demo
