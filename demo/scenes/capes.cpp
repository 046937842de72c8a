// Five figures in capes, who turn to and fro in the wind.

#include <array>
#include <cmath>
#include <numbers>

#include "collision/colliders/nearest_surface.h"
#include "demo/must.h"
#include "demo/scene.h"
#include "demo/scenes/dolls.h"
#include "demo/scenes/measures.h"

namespace weft::demo {

namespace {

constexpr float cape_width = 0.62f, cape_length = 1.05f, shoulders = 1.43f;  // [m]
constexpr float neck = 0.17f;        // distance of the cape's pins from the figure's axis [m]
constexpr double settled_after = 2;  // [s]; from then on the hem is averaged: at one moment gusts decide it
constexpr double turns_by = 0.7, turns_in = 4;  // [rad], [s]
constexpr std::array<Vec3, 5> cape_places{
    {{0, 0, 0.5f}, {-0.95f, 0, 0}, {0.95f, 0, 0}, {-1.9f, 0, -0.5f}, {1.9f, 0, -0.5f}}};
constexpr std::array<Vec3, 5> cape_colours{{{0.5f, 0.03f, 0.05f},
                                            {0.05f, 0.12f, 0.4f},
                                            {0.32f, 0.2f, 0.03f},
                                            {0.05f, 0.22f, 0.1f},
                                            {0.25f, 0.06f, 0.3f}}};

/// The wearer's limbs about the World's origin, facing +Z.
const std::array<Collider, 10>& body() {
    static const std::array<Collider, 10> limbs{
        {{.shape = TaperedCapsule{{0, 0.98f, 0}, {0, 1.32f, 0}, 0.13f, 0.15f}},
         {.shape = Sphere{{0, 1.62f, 0.02f}, 0.11f}},
         {.shape = Capsule{{-0.09f, 0.08f, 0}, {-0.09f, 0.9f, 0}, 0.075f}},
         {.shape = Capsule{{0.09f, 0.08f, 0}, {0.09f, 0.9f, 0}, 0.075f}},
         {.shape = Capsule{{-0.14f, 1.36f, 0}, {0.14f, 1.36f, 0}, 0.07f}},
         {.shape = Capsule{{-0.2f, 1.34f, 0}, {-0.27f, 0.86f, 0.1f}, 0.05f}},
         {.shape = Capsule{{0.2f, 1.34f, 0}, {0.27f, 0.86f, 0.1f}, 0.05f}},
         {.shape = Capsule{{0, 1.38f, 0}, {0, 1.58f, 0.01f}, 0.055f}},
         {.shape = Capsule{{-0.09f, 0.045f, -0.035f}, {-0.09f, 0.04f, 0.13f}, 0.04f}},
         {.shape = Capsule{{0.09f, 0.045f, -0.035f}, {0.09f, 0.04f, 0.13f}, 0.04f}}}};
    return limbs;
}

/// The figure's limbs, within those of the body.
std::vector<FigureLimb> figure_limbs() {
    std::vector<FigureLimb> limbs;
    FigureLimb trunk = doll_limb(LimbKind::trunk, std::get<TaperedCapsule>(body()[0].shape));
    trunk.scale = {1, 1, 0.75f};
    limbs.push_back(trunk);
    const auto capsule = [](std::size_t limb) {
        const auto& [a, b, radius] = std::get<Capsule>(body()[limb].shape);
        return TaperedCapsule{a, b, radius, radius};
    };
    limbs.push_back(doll_limb(LimbKind::shoulder, capsule(4)));
    limbs.push_back(doll_limb(LimbKind::neck, capsule(7)));
    limbs.push_back(doll_limb(LimbKind::head, {{0, 1.588f, 0.02f}, {0, 1.633f, 0.02f}, 0.078f, 0.097f}));
    for (const std::size_t left : {0, 1}) {
        const TaperedCapsule leg = capsule(2 + left), from_hip{leg.b, leg.a, leg.radius_b, leg.radius_a};
        add_doll_leg(from_hip, capsule(8 + left), Matrix3::Identity(), limbs);
        add_doll_arm(capsule(5 + left), left == 1 ? 1.0f : -1.0f, limbs);
    }
    return limbs;
}

/// A rotation about +Y and a translation.
struct Stance {
    Vec3 place;
    float sin, cos;
    [[nodiscard]] Vec3 of(const Vec3& p) const {
        return {place.x + cos * p.x + sin * p.z, place.y + p.y, place.z - sin * p.x + cos * p.z};
    }
    [[nodiscard]] FigureLimb of(FigureLimb limb) const {
        for (Vector3* end : {&limb.a, &limb.b}) *end = to_vector(of(to_vec3(*end)));
        const Matrix3 turn{{cos, 0, sin}, {0, 1, 0}, {-sin, 0, cos}};
        limb.axes_a = turn * limb.axes_a;
        limb.axes_b = turn * limb.axes_b;
        return limb;
    }
    [[nodiscard]] Collider of(Collider limb) const {
        if (auto* sphere = std::get_if<Sphere>(&limb.shape)) sphere->center = of(sphere->center);
        if (auto* capsule = std::get_if<Capsule>(&limb.shape)) {
            capsule->a = of(capsule->a);
            capsule->b = of(capsule->b);
        }
        if (auto* tapered = std::get_if<TaperedCapsule>(&limb.shape)) {
            tapered->a = of(tapered->a);
            tapered->b = of(tapered->b);
        }
        return limb;
    }
};
Stance stance_of(std::size_t who, double time) {
    const double begins = std::min(1.0, time);
    const double phase = 2 * std::numbers::pi * (time / turns_in + 0.13 * static_cast<double>(who));
    const double angle = begins * begins * turns_by * std::sin(phase);
    return {cape_places[who], static_cast<float>(std::sin(angle)), static_cast<float>(std::cos(angle))};
}

/// Pinned place of the upper edge, `part` from 0 at one shoulder round the neck's back to 1 at the other.
Vec3 held_at(float part) {
    const float angle = std::numbers::pi_v<float> * (0.12f + 0.76f * part);
    return {-1.15f * neck * std::cos(angle), shoulders, -neck * std::sin(angle)};
}

class Capes final : public Scene {
  public:
    [[nodiscard]] WorldSettings world_settings() const override {
        return {.wind = {.velocity = {0.5f, 0, -2.4f}, .gust = 0.5f, .gust_length = 1.2f}, .substeps = 2};
    }

    [[nodiscard]] Result<SceneContent> build(World& world, const SceneOptions& options) override {
        const auto people = static_cast<std::uint32_t>(cape_places.size());
        const std::uint32_t each = options.particles == 0 ? 900 : options.particles / people;
        const GridSize grid = grid_size(each, cape_width, cape_length);
        must(world.add_collider({.shape = Plane{}}));
        SceneContent content;
        for (std::size_t who = 0; who < people; ++who) dress(world, grid, who, content);
        figure_ = std::make_shared<const Figure>(figure_limbs(), 0.028f);
        for (std::size_t who = 0; who < people; ++who)
            content.solids.push_back(figure_solid(
                *figure_, who,
                [this, who](std::span<Vec3> to, SolidMoment moment) {
                    const Stance stance = stance_of(who, moment == SolidMoment::now ? now_ : before_);
                    std::vector<FigureLimb> limbs;
                    for (const FigureLimb& limb : figure_limbs()) limbs.push_back(stance.of(limb));
                    figure_->place(limbs, to);
                },
                Suit{}));
        content.camera = {.target = {0, 0.9f, -0.2f}, .distance = 5.4f, .yaw = 2.6f, .pitch = 0.14f};
        return content;
    }

    void go_to(double time) override { now_ = before_ = time; }

    void before_step(World& world, double time, float dt) override {
        before_ = time;
        now_ = time + static_cast<double>(dt);
        for (std::size_t who = 0; who < wearers_.size(); ++who) {
            const Stance stance = stance_of(who, time + static_cast<double>(dt));
            Wearer& wearer = wearers_[who];
            if (const auto view = world.cloth(wearer.cape); view && time > settled_after) {
                wearer.behind += behind(wearer, *view);
                ++wearer.steps;
            }
            for (std::size_t limb = 0; limb < wearer.limbs.size(); ++limb)
                (void)world.move_collider(wearer.limbs[limb], stance.of(body()[limb]));
            for (std::uint32_t column = 0; column < columns_; ++column)
                (void)world.move_pin(wearer.cape, column, stance.of(held_at(part_of(column))));
        }
    }

    [[nodiscard]] int check_steps() const override { return 300; }

    [[nodiscard]] Result<void> check(const World& world) const override {
        Checks checks;
        for (const Wearer& wearer : wearers_) {
            const ClothView view = checks.cloth(world, wearer.cape);
            float deepest = 1;
            for (const Vec4& particle : view.positions)
                for (const ColliderId limb : wearer.limbs)
                    if (particle.w > 0)
                        deepest =
                            std::min(deepest, nearest_surface(*world.collider(limb), xyz(particle)).distance);
            checks.at_least("the least distance of a cape from who wears it [m]", deepest, 0);
            checks.stretch(wearer.mesh, view, 1.4f, 1.03f);
            checks.at_least("how far the hem flies behind, in the mean over the last three seconds [m]",
                            wearer.behind / static_cast<float>(wearer.steps), 0.03f);
        }
        return checks.result();
    }

  private:
    struct Wearer {
        ClothId cape;
        Mesh mesh;
        std::vector<ColliderId> limbs;
        float behind = 0;  ///< summed over steps [m]
        int steps = 0;
    };
    /// Mean distance of the hem behind the pinned edge [m].
    [[nodiscard]] float behind(const Wearer& wearer, const ClothView& view) const {
        float sum = 0;
        for (std::uint32_t k = 0; k < columns_; ++k) {
            const std::uint32_t hem = (wearer.mesh.rows - 1) * columns_ + k;
            sum += vertex_position(view, k).z() - vertex_position(view, hem).z();
        }
        return sum / static_cast<float>(columns_);
    }
    [[nodiscard]] float part_of(std::uint32_t column) const {
        return static_cast<float>(column) / static_cast<float>(columns_ - 1);
    }

    void dress(World& world, const GridSize& grid, std::size_t who, SceneContent& content) {
        columns_ = grid.columns;
        const Stance stance = stance_of(who, 0);
        auto mesh = must(make_sheet({.rows = grid.rows, .columns = grid.columns}));
        mesh.pattern.clear();
        for (std::uint32_t k = 0; k < grid.rows * grid.columns; ++k) {
            const float part = part_of(k % grid.columns);
            const float down =
                cape_length * static_cast<float>(k / grid.columns) / static_cast<float>(grid.rows - 1);
            const Vec3 top = held_at(part);
            const float out = 1 + 0.9f * down;  // it widens downwards, off the back
            mesh.positions[k] = stance.of({out * top.x, top.y - 0.93f * down, out * top.z - 0.1f * down});
            mesh.pattern.push_back({cape_width * part, down});
        }
        ClothSettings settings;
        settings.fabric = {
            .areal_density = 0.28f, .warp = 600, .weft = 600, .shear = 100, .bending = 1.5e-5f};
        settings.thickness = 0.012f;
        const auto cape = must(world.add_cloth(mesh, settings));
        must(world.pin(cape, row_of(mesh, 0)));
        Wearer wearer{cape, mesh, {}};
        for (const Collider& limb : body()) {
            const auto added = must(world.add_collider(stance.of(limb)));
            wearer.limbs.push_back(added);
            content.clad_colliders.push_back(added);
        }
        content.cloths.push_back({cape, mesh, {.front = {0.2f, 0.17f, 0.15f}, .back = cape_colours[who]}});
        wearers_.push_back(std::move(wearer));
    }

    std::uint32_t columns_ = 0;
    std::shared_ptr<const Figure> figure_;  // of all people
    double now_ = 0, before_ = 0;           // times at which it is drawn [s]
    std::vector<Wearer> wearers_;
};

}  // namespace

std::unique_ptr<Scene> make_capes_scene() {
    return std::make_unique<Capes>();
}

}  // namespace weft::demo
