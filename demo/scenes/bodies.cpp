// Bodies with mass that cloth holds: a bar, a ball in a hammock, a box on a trampoline.

#include <algorithm>
#include <array>
#include <cmath>

#include "demo/must.h"
#include "demo/scene.h"
#include "demo/scenes/measures.h"
#include "demo/scenes/solids.h"

namespace weft::demo {

// Cloth on a rigid body: a wall hanging whose lower edge is fixed to a wooden bar, in a gusty wind.

namespace {

constexpr float hanging_width = 0.8f, hanging_length = 1.1f, hung_height = 1.6f;  // [m]
constexpr float bar_thickness = 0.035f, bar_mass = 0.8f;                          // [m], [kg]

class Bar final : public OneCloth {
  public:
    [[nodiscard]] WorldSettings world_settings() const override {
        return {.wind = {.velocity = {0.5f, 0, -2.4f}, .gust = 0.6f, .gust_length = 1.0f}};
    }

    [[nodiscard]] Result<SceneContent> build(World& world, const SceneOptions& options) override {
        mesh_ = sheet_of(options.particles_or(1500), {-0.5f * hanging_width, hung_height, 0},
                         {hanging_width, 0, 0}, {0, -hanging_length, 0});
        ClothSettings settings;
        settings.fabric = {
            .areal_density = 0.25f, .warp = 2000, .weft = 2000, .shear = 400, .bending = 2e-5f};
        SceneContent content =
            add_cloth(world, settings, two_sided({0.42f, 0.12f, 0.08f}, 0.16f),
                      {.target = {0, 1.0f, 0}, .distance = 2.9f, .yaw = 0.7f, .pitch = 0.12f});
        top_ = row_of(mesh_, 0);
        must(world.pin(cloth_, top_));
        const ColliderId shown = add_bar(world, row_of(mesh_, mesh_.rows - 1));

        content.drawn_colliders = {shown};
        return content;
    }

    void annotate(const World& world, Annotation& to) const override {
        draw_holder(world.cloth(cloth_).value(), top_, Holder::rod, to);
    }

    [[nodiscard]] Result<void> check(const World& world) const override {
        Checks checks;
        const ClothView view = checks.cloth(world, cloth_);
        const auto state = must(world.body_state(bar_));
        const std::uint32_t first = (mesh_.rows - 1) * mesh_.columns, last = first + mesh_.columns - 1;
        const Vector3 left = vertex_position(view, first), right = vertex_position(view, last);
        checks.at_most("how far the bar is from its edge of the cloth [m]",
                       (0.5f * (left + right) - to_vector(state.position)).norm(), 1e-3f);
        checks.at_most("how much the edge has stretched [m]", std::abs((right - left).norm() - hanging_width),
                       2e-3f);
        checks.at_least("the bar's height [m]", state.position.y, hung_height - 1.1f * hanging_length);
        checks.at_most("the bar's height [m]", state.position.y, hung_height);
        checks.at_most("where the wind has it, less being downwind [m]", state.position.z, 0.3f);
        checks.stretch(mesh_, view, 1.25f);
        return checks.result();
    }

  private:
    /// Adds the bar. Its collider is drawn only: it is on no layer, so that no cloth collides with it.
    ColliderId add_bar(World& world, const std::vector<std::uint32_t>& edge) {
        const Vec3 middle{0, hung_height - hanging_length, 0};
        const float along = bar_mass / 12 * hanging_width * hanging_width;
        const float about = bar_mass / 6 * bar_thickness * bar_thickness;
        bar_ =
            must(world.add_body({.mass = bar_mass, .inertia = {about, along, along}, .angular_damping = 0.2f},
                                {.position = middle}));
        const Vec3 half{0.5f * hanging_width + 0.03f, 0.5f * bar_thickness, 0.5f * bar_thickness};
        const auto shape =
            must(world.add_collider({.shape = Box{.center = middle, .half_extents = half}, .layers = 0}));
        must(world.attach_collider(bar_, shape));
        must(world.attach(bar_, cloth_, edge));
        return shape;
    }

    BodyId bar_;
    std::vector<std::uint32_t> top_;
};

}  // namespace

std::unique_ptr<Scene> make_bar_scene() {
    return std::make_unique<Bar>();
}

// Bodies with mass that cloth holds: a ball that falls into a hammock, a box on a trampoline.

namespace {

constexpr float cloth_side = 1.2f;  // of the cloth [m]
constexpr float hung_at = 0.9f;     // height of the pins [m]

struct Props {
    Fabric fabric;
    bool border = false;  ///< pinned all round, otherwise by its corners
    float mass = 0;       ///< of the body [kg]
    Collider shape;
    Vec3 inertia{}, start{};
    Rotation rotation{};
};

class BodyScene : public OneCloth {
  public:
    explicit BodyScene(Props props) : props_(std::move(props)) {}
    [[nodiscard]] int check_steps() const override { return 600; }
    [[nodiscard]] WorldSettings world_settings() const override { return {.wind = {.air_density = 0}}; }

    [[nodiscard]] Result<SceneContent> build(World& world, const SceneOptions& options) override {
        mesh_ = sheet_of(options.particles_or(1600), {-0.5f * cloth_side, hung_at, -0.5f * cloth_side},
                         {cloth_side, 0, 0}, {0, 0, cloth_side});
        SceneContent content = add_cloth(
            world, {.fabric = props_.fabric, .air_damping = 1}, two_sided({0.16f, 0.42f, 0.5f}, 0.1f),
            {.target = {0, 0.75f, 0}, .distance = 2.6f, .yaw = 0.5f, .pitch = 0.3f});
        must(world.pin(cloth_, held_vertices()));
        body_ = must(world.add_body({.mass = props_.mass, .inertia = props_.inertia},
                                    {.position = props_.start, .rotation = props_.rotation}));
        const auto shape = must(world.add_collider(props_.shape));
        must(world.attach_collider(body_, shape));

        content.drawn_colliders = {shape};
        return content;
    }

    void annotate(const World& world, Annotation& to) const override {
        const ClothView view = world.cloth(cloth_).value();
        const std::uint32_t side = mesh_.columns - 1, last = (mesh_.rows - 1) * mesh_.columns;
        const std::array corners{0u, side, last + side, last};
        draw_holder(view, corners, Holder::posts, to);
        if (!props_.border) return;
        for (std::size_t k = 0; k < corners.size(); ++k)
            draw_holder(view, std::array{corners[k], corners[(k + 1) % 4]}, Holder::rod, to);
    }

    [[nodiscard]] Result<void> check(const World& world) const override {
        Checks checks;
        checks.cloth(world, cloth_);
        const auto state = must(world.body_state(body_));
        const Vector3 where = to_vector(state.position);
        checks.at_least("the body's height [m]", where.y(), hung_at - 0.75f * cloth_side);
        checks.at_most("its height [m]", where.y(), hung_at + 0.2f);
        // The body still swings at this time, and a tilted box has moved aside. With smaller steps, which
        // damp less, a ball presses with .8 to 2 times its weight.
        checks.at_most("its way from the middle [m]", std::max(std::abs(where.x()), std::abs(where.z())),
                       0.3f);
        checks.at_most("its speed [m/s]", to_vector(state.velocity).norm(), 0.9f);
        const float weight = 9.81f * props_.mass;
        const float force = to_vector(world.body_impulses().front().linear).y() * 60;
        checks.at_least("what the cloth bears [N]", force, 0.6f * weight);
        checks.at_most("what the cloth bears [N]", force, 2.0f * weight);
        return checks.result();
    }

  private:
    [[nodiscard]] std::vector<std::uint32_t> held_vertices() const {
        std::vector<std::uint32_t> vertices;
        for (std::uint32_t row = 0; row < mesh_.rows; ++row)
            for (std::uint32_t column = 0; column < mesh_.columns; ++column) {
                const int ends = (row == 0 || row + 1 == mesh_.rows ? 1 : 0) +
                                 (column == 0 || column + 1 == mesh_.columns ? 1 : 0);
                if (ends >= (props_.border ? 1 : 2)) vertices.push_back(row * mesh_.columns + column);
            }
        return vertices;
    }

    Props props_;
    BodyId body_;
};

}  // namespace

std::unique_ptr<Scene> make_ball_scene() {
    constexpr float mass = 1.5f, radius = 0.14f, inertia = 0.4f * mass * radius * radius;
    const Vec3 start{0.05f, hung_at + 0.45f, 0.03f};
    return std::make_unique<BodyScene>(
        Props{.fabric = {.areal_density = 0.3f, .warp = 1500, .weft = 1500, .shear = 300},
              .mass = mass,
              .shape = {.shape = Sphere{start, radius}, .friction = 0.5f},
              .inertia = {inertia, inertia, inertia},
              .start = start});
}

std::unique_ptr<Scene> make_trampoline_scene() {
    constexpr float mass = 3, edge = 0.24f, inertia = mass * edge * edge / 6;
    const Vec3 start{0.03f, hung_at + 0.6f, 0};
    const Rotation tilted{0.13f, 0, 0.1f, 0.98641776f};
    return std::make_unique<BodyScene>(Props{
        .fabric = {.areal_density = 0.3f, .warp = 6000, .weft = 6000, .shear = 1500},
        .border = true,
        .mass = mass,
        .shape = {.shape = Box{start, tilted, {0.5f * edge, 0.5f * edge, 0.5f * edge}}, .friction = 0.5f},
        .inertia = {inertia, inertia, inertia},
        .start = start,
        .rotation = tilted});
}

}  // namespace weft::demo
