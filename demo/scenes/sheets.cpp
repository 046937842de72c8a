// Sheets on balls and on the ground, and a ribbon that is lowered end first.

#include <algorithm>
#include <cmath>
#include <numbers>

#include "demo/must.h"
#include "demo/scene.h"
#include "demo/scenes/measures.h"

namespace weft::demo {

// A square sheet that falls over a sphere and onto the ground.

namespace {

constexpr float square_side = 2.0f;  // [m]
constexpr float fall = 0.35f;        // from the start to the top of the sphere [m]
constexpr Sphere sphere{{0, 0.4f, 0}, 0.4f};
constexpr float thickness = 0.008f;  // [m]
constexpr float damping = 0.01f;     // [s], so that pleats come to rest

class Sheet final : public OneCloth {
  public:
    [[nodiscard]] WorldSettings world_settings() const override {
        // thin still air: the sheet falls in a second
        return {.wind = {.air_density = 0.6f}};
    }

    [[nodiscard]] Result<SceneContent> build(World& world, const SceneOptions& options) override {
        mesh_ = sheet_of(options.particles_or(3000),
                         {-0.5f * square_side, sphere.center.y + sphere.radius + fall, -0.5f * square_side},
                         {square_side, 0, 0}, {0, 0, square_side});

        ClothSettings settings;
        settings.fabric.damping = damping;
        settings.self_collision = {.method = SelfCollisionMethod::contact};
        settings.thickness = thickness;
        SceneContent content =
            add_cloth(world, settings, two_sided({0.62f, 0.45f, 0.16f}, 0.18f),
                      {.target = {0, 0.32f, 0}, .distance = 3.1f, .yaw = 0.6f, .pitch = 0.45f});
        const auto ball = must(world.add_collider({.shape = sphere, .friction = 0.5f}));
        must(world.add_collider({.shape = Plane{}, .friction = 0.6f}));

        content.drawn_colliders = {ball};
        return content;
    }

    [[nodiscard]] Result<void> check(const World& world) const override {
        Checks checks;
        const ClothView view = checks.cloth(world, cloth_);
        checks.at_least("the lowest point's height [m]", view.bounds.lower.y, 0.5f * thickness);

        float nearest = square_side, fastest = 0;
        for (std::size_t i = 0; i < view.positions.size(); ++i) {
            nearest = std::min(nearest, (xyz(view.positions[i]) - to_vector(sphere.center)).norm());
            fastest = std::max(fastest, xyz(view.velocities[i]).norm());
        }
        checks.at_least("the least distance from the sphere's centre [m]", nearest,
                        sphere.radius + 0.5f * thickness);
        checks.at_most("the fastest particle's speed, once it has come to rest [m/s]", fastest, 0.2f);

        const Vector3 summit = to_vector(sphere.center) + Vector3(0, sphere.radius + thickness, 0);
        const Vector3 centre = vertex_position(view, (mesh_.rows / 2) * mesh_.columns + mesh_.columns / 2);
        checks.at_most("the sheet's centre's distance from the top of the sphere [m]",
                       (centre - summit).norm(), 0.1f);

        checks.stretch(mesh_, view, 1.1f, 1.02f);
        const float corner = vertex_position(view, 0).y();
        checks.at_most("a corner's height above the ground [m]", corner, 0.2f);
        return checks.result();
    }
};

}  // namespace

std::unique_ptr<Scene> make_sheet_scene() {
    return std::make_unique<Sheet>();
}

// A rag over a ball that goes to and fro.

namespace {

constexpr float rag_side = 0.8f, rag_ball = 0.22f, ball_height = 0.55f;  // [m]
constexpr double swings_by = 0.45, swings_in = 2.4, swings_from = 0.8;   // [m], [s], [s]

class Rag final : public OneCloth {
  public:
    [[nodiscard]] Result<SceneContent> build(World& world, const SceneOptions& options) override {
        mesh_ = sheet_of(options.particles_or(2500),
                         {-0.5f * rag_side, ball_height + rag_ball + 0.02f, -0.5f * rag_side},
                         {rag_side, 0, 0}, {0, 0, rag_side});
        ClothSettings settings;
        settings.fabric = {.areal_density = 0.25f, .warp = 600, .weft = 600, .shear = 120, .bending = 1e-5f};
        settings.self_collision = {.method = SelfCollisionMethod::contact};
        SceneContent content =
            add_cloth(world, settings, two_sided({0.42f, 0.14f, 0.36f}, 0.1f),
                      {.target = {0, 0.45f, 0}, .distance = 2.4f, .yaw = 0.35f, .pitch = 0.22f});
        ball_ = must(world.add_collider({.shape = ball_at(0), .friction = 0.8f}));
        must(world.add_collider({.shape = Plane{}}));

        content.drawn_colliders = {ball_};
        return content;
    }

    void before_step(World& world, double time, float dt) override {
        time_ = time + static_cast<double>(dt);
        (void)world.move_collider(ball_, {.shape = ball_at(time_), .friction = 0.8f});
    }

    [[nodiscard]] int check_steps() const override { return 300; }

    [[nodiscard]] Result<void> check(const World& world) const override {
        Checks checks;
        const ClothView view = checks.cloth(world, cloth_);
        const Vector3 middle = to_vector(ball_at(time_).center);
        float nearest = rag_side;
        for (const Vec4& particle : view.positions)
            nearest = std::min(nearest, (xyz(particle) - middle).norm());
        checks.at_least("the least distance from the ball's middle [m]", nearest, rag_ball);
        const Vector3 centre = vertex_position(view, (mesh_.rows / 2) * mesh_.columns + mesh_.columns / 2);
        checks.at_most("how far the rag has slid off the ball's top [m]",
                       (centre - middle - Vector3(0, rag_ball, 0)).norm(), 0.12f);
        checks.stretch(mesh_, view, 1.3f);
        return checks.result();
    }

  private:
    [[nodiscard]] static Sphere ball_at(double time) {
        const double phase = 2 * std::numbers::pi / swings_in * std::max(0.0, time - swings_from);
        const auto x = static_cast<float>(swings_by * (1 - std::cos(phase)) / 2);
        const auto z = static_cast<float>(0.4 * swings_by * std::sin(phase) * std::sin(phase));
        return {{x, ball_height, z}, rag_ball};
    }

    ColliderId ball_;
    double time_ = 0;
};

}  // namespace

std::unique_ptr<Scene> make_rag_scene() {
    return std::make_unique<Rag>();
}

// A long ribbon, lowered end first at constant speed, piles up on itself.

namespace {

constexpr float ribbon_width = 0.1f, length = 2.4f;  // [m]
constexpr double speed = 0.5;                        // at which the top is lowered [m/s]
constexpr float start_height = 0.02f;                // height of the lower end [m]
constexpr float hold_height = 0.4f;                  // height at which the top stops [m]

// The hand that lowers the ribbon sways: without that a flat ribbon would have no side to fold to.
constexpr float sway = 0.015f;       // [m]
constexpr double sway_period = 0.9;  // [s]

class Ribbon final : public OneCloth {
  public:
    [[nodiscard]] WorldSettings world_settings() const override {
        return {.wind = {.gust = 0}, .substeps = 2};
    }

    [[nodiscard]] Result<SceneContent> build(World& world, const SceneOptions& options) override {
        mesh_ = sheet_of(options.particles_or(1000), {-0.5f * ribbon_width, start_height + length, 0},
                         {ribbon_width, 0, 0}, {0, -length, 0});
        distance_ = 0.8f * length / static_cast<float>(mesh_.rows - 1);

        ClothSettings settings;
        settings.fabric = {.areal_density = 0.2f,
                           .warp = 200.0f,
                           .weft = 200.0f,
                           .shear = 80.0f,
                           .bending = 2e-5f,
                           .damping = 0.01f};
        settings.air_damping = 2.0f;  // so that it is still by 6 s
        settings.self_collision = {.method = SelfCollisionMethod::contact, .friction = 0.4f};
        settings.thickness = 0.5f * distance_;
        SceneContent content =
            add_cloth(world, settings,
                      {.front = {0.50f, 0.05f, 0.20f}, .back = {0.70f, 0.50f, 0.15f}, .roughness = 0.4f},
                      {.target = {0, 0.2f, 0}, .distance = 1.0f, .yaw = 0.7f, .pitch = 0.35f});
        must(world.pin(cloth_, row_of(mesh_, 0)));
        must(world.add_collider({.shape = Plane{}, .friction = 0.7f}));

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
        Checks checks;
        const ClothView view = checks.cloth(world, cloth_);
        for (std::uint32_t column = 0; column < mesh_.columns; ++column) {
            checks.pinned_at(view, column, hand(column));
        }
        checks.at_least("the lowest point's height [m]", view.bounds.lower.y, 0.25f * distance_);
        checks.at_least("the least distance between layers, in self-collision distances",
                        closest_layers(mesh_, view, 4 * distance_) / distance_, 0.05f);
        checks.at_least("the pile's height in self-collision distances", pile_height(view) / distance_, 2.0f);
        checks.at_most("the pile's reach from under the top [m]", reach(view), 0.35f);
        checks.stretch(mesh_, view, 1.3f);
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

    float distance_ = 0;
    double time_ = 0;
};

}  // namespace

std::unique_ptr<Scene> make_ribbon_scene() {
    return std::make_unique<Ribbon>();
}

}  // namespace weft::demo
