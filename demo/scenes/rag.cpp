// A rag over a ball that goes to and fro.

#include <algorithm>
#include <cmath>
#include <numbers>

#include "demo/scene.h"
#include "demo/scenes/measures.h"

namespace weft::demo {
namespace {

constexpr float rag_side = 0.8f, rag_ball = 0.22f, ball_height = 0.55f;  // [m]
constexpr double swings_by = 0.45, swings_in = 2.4, swings_from = 0.8;   // [m], [s], [s]

class Rag final : public Scene {
  public:
    [[nodiscard]] Result<SceneContent> build(World& world, const SceneOptions& options) override {
        const GridSize grid =
            grid_size(options.particles == 0 ? 2500 : options.particles, rag_side, rag_side);
        auto mesh =
            make_sheet({.rows = grid.rows,
                        .columns = grid.columns,
                        .origin = {-0.5f * rag_side, ball_height + rag_ball + 0.02f, -0.5f * rag_side},
                        .u = {rag_side, 0, 0},
                        .v = {0, 0, rag_side}});
        if (!mesh) return mesh.error();
        mesh_ = std::move(*mesh);
        ClothSettings settings;
        settings.fabric = {.areal_density = 0.25f, .warp = 600, .weft = 600, .shear = 120, .bending = 1e-5f};
        settings.self_collision = {.method = SelfCollisionMethod::contact};
        const auto cloth = world.add_cloth(mesh_, settings);
        if (!cloth) return cloth.error();
        cloth_ = *cloth;
        const auto ball = world.add_collider({.shape = ball_at(0), .friction = 0.8f});
        if (!ball) return ball.error();
        ball_ = *ball;
        if (auto ground = world.add_collider({.shape = Plane{}}); !ground) return ground.error();

        SceneContent content;
        content.cloths.push_back({cloth_, mesh_, two_sided({0.42f, 0.14f, 0.36f}, 0.1f)});
        content.drawn_colliders = {ball_};
        content.camera = {.target = {0, 0.45f, 0}, .distance = 2.4f, .yaw = 0.35f, .pitch = 0.22f};
        return content;
    }

    void before_step(World& world, double time, float dt) override {
        time_ = time + static_cast<double>(dt);
        (void)world.move_collider(ball_, {.shape = ball_at(time_), .friction = 0.8f});
    }

    [[nodiscard]] int check_steps() const override { return 300; }

    [[nodiscard]] Result<void> check(const World& world) const override {
        const auto view = world.cloth(cloth_);
        if (!view) return view.error();
        Checks checks;
        checks.finite(*view);
        const Vector3 middle = to_vector(ball_at(time_).center);
        float nearest = rag_side;
        for (const Vec4& particle : view->positions)
            nearest = std::min(nearest, (xyz(particle) - middle).norm());
        checks.at_least("the least distance from the ball's middle [m]", nearest, rag_ball);
        const Vector3 centre = vertex_position(*view, (mesh_.rows / 2) * mesh_.columns + mesh_.columns / 2);
        checks.at_most("how far the rag has slid off the ball's top [m]",
                       (centre - middle - Vector3(0, rag_ball, 0)).norm(), 0.12f);
        checks.at_most("worst stretch", structural_stretch(mesh_, *view).worst, 1.3f);
        return checks.result();
    }

  private:
    [[nodiscard]] static Sphere ball_at(double time) {
        const double phase = 2 * std::numbers::pi / swings_in * std::max(0.0, time - swings_from);
        const auto x = static_cast<float>(swings_by * (1 - std::cos(phase)) / 2);
        const auto z = static_cast<float>(0.4 * swings_by * std::sin(phase) * std::sin(phase));
        return {{x, ball_height, z}, rag_ball};
    }

    ClothId cloth_;
    ColliderId ball_;
    Mesh mesh_;
    double time_ = 0;
};

}  // namespace

std::unique_ptr<Scene> make_rag_scene() {
    return std::make_unique<Rag>();
}

}  // namespace weft::demo
