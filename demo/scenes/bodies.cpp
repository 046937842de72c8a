// Bodies with mass that cloth holds: a ball that falls into a hammock, a box on a trampoline.

#include <algorithm>
#include <array>

#include "demo/scene.h"
#include "demo/scenes/holders.h"
#include "demo/scenes/measures.h"

namespace weft::demo {
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

class BodyScene : public Scene {
  public:
    explicit BodyScene(Props props) : props_(std::move(props)) {}
    [[nodiscard]] int check_steps() const override { return 600; }
    [[nodiscard]] WorldSettings world_settings() const override {
        WorldSettings settings;
        settings.wind.air_density = 0;
        return settings;
    }

    [[nodiscard]] Result<SceneContent> build(World& world, const SceneOptions& options) override {
        const GridSize grid =
            grid_size(options.particles == 0 ? 1600 : options.particles, cloth_side, cloth_side);
        auto mesh = make_sheet({.rows = grid.rows,
                                .columns = grid.columns,
                                .origin = {-0.5f * cloth_side, hung_at, -0.5f * cloth_side},
                                .u = {cloth_side, 0, 0},
                                .v = {0, 0, cloth_side}});
        if (!mesh) return mesh.error();
        mesh_ = std::move(*mesh);
        const auto cloth = world.add_cloth(mesh_, {.fabric = props_.fabric, .air_damping = 1});
        if (!cloth) return cloth.error();
        cloth_ = *cloth;
        if (auto held = world.pin(cloth_, held_vertices()); !held) return held.error();
        const auto body = world.add_body({.mass = props_.mass, .inertia = props_.inertia},
                                         {.position = props_.start, .rotation = props_.rotation});
        if (!body) return body.error();
        body_ = *body;
        const auto shape = world.add_collider(props_.shape);
        if (!shape) return shape.error();
        if (auto attached = world.attach_collider(body_, *shape); !attached) return attached.error();

        SceneContent content;
        content.cloths.push_back({cloth_, mesh_, two_sided({0.16f, 0.42f, 0.5f}, 0.1f)});
        content.drawn_colliders = {*shape};
        content.camera = {.target = {0, 0.75f, 0}, .distance = 2.6f, .yaw = 0.5f, .pitch = 0.3f};
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
        const auto view = world.cloth(cloth_);
        if (!view) return view.error();
        const auto state = world.body_state(body_);
        if (!state) return state.error();
        Checks checks;
        checks.finite(*view);
        const Vector3 where = to_vector(state->position);
        checks.at_least("the body's height [m]", where.y(), hung_at - 0.75f * cloth_side);
        checks.at_most("its height [m]", where.y(), hung_at + 0.2f);
        // The body still swings at this time, and a tilted box has moved aside. With smaller steps, which
        // damp less, a ball presses with .8 to 2 times its weight.
        checks.at_most("its way from the middle [m]", std::max(std::abs(where.x()), std::abs(where.z())),
                       0.3f);
        checks.at_most("its speed [m/s]", to_vector(state->velocity).norm(), 0.9f);
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
    ClothId cloth_;
    BodyId body_;
    Mesh mesh_;
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
