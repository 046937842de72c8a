// Flags in gusts: one on its pole, a banner held at both ends, and a hundred of one cooked cloth.

#include <array>

#include "demo/must.h"
#include "demo/scene.h"
#include "demo/scenes/measures.h"

namespace weft::demo {

// A flag on its pole in a gusty wind.

namespace {

constexpr float fly = 1.5f, hoist = 1.0f;  // [m]
constexpr float hoist_top = 2.55f;         // height of the hoist's top, at the pole [m]
constexpr float pole_radius = 0.025f;      // [m]

class Flag final : public OneCloth {
  public:
    [[nodiscard]] WorldSettings world_settings() const override {
        return {.wind = {.velocity = {6.0f, 0, 1.0f}, .gust = 0.5f}, .substeps = 2};
    }

    [[nodiscard]] Result<SceneContent> build(World& world, const SceneOptions& options) override {
        mesh_ = sheet_of(options.particles_or(3000), {0, hoist_top, 0}, {fly, 0, 0}, {0, -hoist, 0});

        ClothSettings settings;
        settings.fabric.areal_density = 0.12f;
        settings.fabric.bending = 5e-6f;
        settings.self_collision.method = SelfCollisionMethod::contact;
        SceneContent content =
            add_cloth(world, settings, {.stripe_width = 0.25f},
                      {.target = {0.65f, 1.8f, 0}, .distance = 3.4f, .yaw = 0.35f, .pitch = 0.04f});
        must(world.pin(cloth_, column_of(mesh_, 0)));

        const float axis = -1.5f * pole_radius;
        const auto pole = must(
            world.add_collider({.shape = Capsule{{axis, 0, 0}, {axis, hoist_top + 0.06f, 0}, pole_radius}}));

        content.drawn_colliders = {pole};
        return content;
    }

    [[nodiscard]] Result<void> check(const World& world) const override {
        Checks checks;
        const ClothView view = checks.cloth(world, cloth_);
        for (const std::uint32_t vertex : column_of(mesh_, 0))
            checks.pinned_at(view, vertex, mesh_.positions[vertex]);
        checks.stretch(mesh_, view, 1.5f, 1.03f);

        Vector3 free_edge = Vector3::Zero();
        for (std::uint32_t row = 1; row <= mesh_.rows; ++row) {
            free_edge += vertex_position(view, row * mesh_.columns - 1) / static_cast<float>(mesh_.rows);
        }
        checks.at_least("the free edge's distance downwind [m]", free_edge.x(), 0.6f * fly);
        const float ripple = view.bounds.upper.z - view.bounds.lower.z;
        checks.at_least("the ripples' depth across the wind [m]", ripple, 0.05f);
        return checks.result();
    }
};

}  // namespace

std::unique_ptr<Scene> make_flag_scene() {
    return std::make_unique<Flag>();
}

// A banner held at both ends, across the wind.

namespace {

constexpr float banner_length = 2.4f, banner_height = 0.7f, banner_top = 2.2f;  // [m]
constexpr float ends_apart = 0.94f;  // over its length; it hangs and billows by the rest

class Banner final : public OneCloth {
  public:
    [[nodiscard]] WorldSettings world_settings() const override {
        return {.wind = {.velocity = {0.5f, 0, -5.0f}, .gust = 0.5f}, .substeps = 2};
    }

    [[nodiscard]] Result<SceneContent> build(World& world, const SceneOptions& options) override {
        mesh_ = sheet_of(options.particles_or(2400), {-0.5f * banner_length, banner_top, 0},
                         {banner_length, 0, 0}, {0, -banner_height, 0});
        ClothSettings settings;
        settings.fabric = {.areal_density = 0.14f, .warp = 800, .weft = 800, .shear = 200, .bending = 8e-6f};
        SceneContent content =
            add_cloth(world, settings, two_sided({0.07f, 0.2f, 0.42f}, 0.3f),
                      {.target = {0, 1.55f, 0}, .distance = 4.0f, .yaw = 0.5f, .pitch = 0.1f});
        for (const std::uint32_t end : {0u, mesh_.columns - 1})
            must(world.pin(cloth_, column_of(mesh_, end)));

        for (const float side : {-0.5f, 0.5f}) {
            const float x = side * (ends_apart * banner_length + 0.05f);
            const auto pole =
                must(world.add_collider({.shape = Capsule{{x, 0, 0}, {x, banner_top + 0.08f, 0}, 0.02f}}));
            content.drawn_colliders.push_back(pole);
        }
        return content;
    }

    /// The ends come together in the first second.
    void before_step(World& world, double time, float dt) override {
        if (time > 1.1) return;
        for (const std::uint32_t end : {0u, mesh_.columns - 1})
            for (const std::uint32_t vertex : column_of(mesh_, end))
                (void)world.move_pin(cloth_, vertex, place_of(vertex, time + static_cast<double>(dt)));
    }

    [[nodiscard]] int check_steps() const override { return 240; }

    [[nodiscard]] Result<void> check(const World& world) const override {
        Checks checks;
        const ClothView view = checks.cloth(world, cloth_);
        for (const std::uint32_t vertex : {0u, mesh_.columns - 1})
            checks.pinned_at(view, vertex, place_of(vertex, 2));
        checks.at_most("how far it billows, downwind being less [m]", view.bounds.lower.z, -0.1f);
        checks.at_least("how far it bulges against the wind [m]", -view.bounds.upper.z, -0.35f);
        checks.stretch(mesh_, view, 1.3f, 1.03f);
        return checks.result();
    }

  private:
    [[nodiscard]] Vec3 place_of(std::uint32_t vertex, double time) const {
        const Vec3& start = mesh_.positions[vertex];
        const auto part = static_cast<float>(std::min(time, 1.0));
        return {start.x * (1 - (1 - ends_apart) * part), start.y, start.z};
    }
};

}  // namespace

std::unique_ptr<Scene> make_banner_scene() {
    return std::make_unique<Banner>();
}

// A hundred flags: a hundred copies of one cooked cloth.

namespace {

constexpr std::uint32_t flag_rows = 10, flag_columns = 10;                              // of flags
constexpr float flags_apart = 1.15f, flag_fly = 0.75f, flag_hoist = 0.5f, mast = 1.9f;  // [m]
constexpr std::uint32_t particles_of_flag = 96;
constexpr std::array<Vec3, 5> flag_colours{{{0.55f, 0.06f, 0.07f},
                                            {0.06f, 0.20f, 0.45f},
                                            {0.60f, 0.45f, 0.05f},
                                            {0.10f, 0.35f, 0.15f},
                                            {0.70f, 0.68f, 0.62f}}};

/// A mast of eight sides.
Mesh make_mast(const Vec3& foot) {
    Mesh mesh;
    constexpr std::uint32_t sides = 8;
    for (std::uint32_t k = 0; k < sides; ++k) {
        const float angle = 6.2831853f * static_cast<float>(k) / sides;
        for (const float height : {0.0f, mast + 0.03f})
            mesh.positions.push_back(
                {foot.x + 0.014f * std::cos(angle), height, foot.z - 0.014f * std::sin(angle)});
    }
    for (std::uint32_t k = 0; k < sides; ++k) {
        const std::uint32_t a = 2 * k, b = 2 * ((k + 1) % sides);
        mesh.triangles.push_back({a, b, a + 1});
        mesh.triangles.push_back({b, b + 1, a + 1});
    }
    return mesh;
}

class Flags final : public Scene {
  public:
    [[nodiscard]] WorldSettings world_settings() const override {
        return {.wind = {.velocity = {5.0f, 0, 1.5f}, .gust = 0.5f, .gust_length = 2.5f}};
    }

    [[nodiscard]] Result<SceneContent> build(World& world, const SceneOptions& options) override {
        const std::uint32_t all = flag_rows * flag_columns;
        const std::uint32_t each = options.particles == 0 ? particles_of_flag : options.particles / all + 1;
        mesh_ = sheet_of(each, {0, mast, 0}, {flag_fly, 0, 0}, {0, -flag_hoist, 0});
        ClothSettings settings;
        settings.fabric.areal_density = 0.12f;
        settings.fabric.bending = 5e-6f;
        const auto cooked = must(CookedCloth::create(mesh_, settings));

        SceneContent content;
        for (std::uint32_t number = 0; number < all; ++number) raise_flag(world, cooked, number, content);
        content.camera = {.target = {0.3f, 0.9f, 0}, .distance = 11.5f, .yaw = 0.6f, .pitch = 0.32f};
        return content;
    }

    [[nodiscard]] int check_steps() const override { return 150; }

    [[nodiscard]] Result<void> check(const World& world) const override {
        Checks checks;
        for (const ClothId id : cloths_) {
            const ClothView view = checks.cloth(world, id);
            checks.stretch(mesh_, view, 1.4f);
            const float downwind = view.bounds.upper.x - view.bounds.lower.x;
            checks.at_least("how far a flag flies downwind [m]", downwind, 0.2f * flag_fly);
        }
        return checks.result();
    }

  private:
    void raise_flag(World& world, const CookedCloth& cooked, std::uint32_t number, SceneContent& content) {
        const auto from_middle = [](std::uint32_t at, std::uint32_t count) {
            return flags_apart * (static_cast<float>(at) - 0.5f * static_cast<float>(count - 1));
        };
        const Vec3 foot{from_middle(number % flag_columns, flag_columns), 0,
                        from_middle(number / flag_columns, flag_rows)};
        const auto cloth = must(world.add_cloth(cooked, {.translation = foot}));
        cloths_.push_back(cloth);
        must(world.pin(cloth, column_of(mesh_, 0)));
        const Vec3 colour = flag_colours[number % flag_colours.size()];
        content.cloths.push_back({cloth, mesh_, two_sided(colour, 0.12f)});
        content.solids.push_back({make_mast({foot.x - 0.02f, 0, foot.z}), collider_colour});
    }

    std::vector<ClothId> cloths_;
    Mesh mesh_;
};

}  // namespace

std::unique_ptr<Scene> make_flags_scene() {
    return std::make_unique<Flags>();
}

}  // namespace weft::demo
