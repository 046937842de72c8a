// A hundred flags: a hundred copies of one cooked cloth.

#include <array>

#include "demo/scene.h"
#include "demo/scenes/measures.h"

namespace weft::demo {
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
        WorldSettings settings;
        settings.wind = {.velocity = {5.0f, 0, 1.5f}, .gust = 0.5f, .gust_length = 2.5f};
        return settings;
    }

    [[nodiscard]] Result<SceneContent> build(World& world, const SceneOptions& options) override {
        const std::uint32_t all = flag_rows * flag_columns;
        const std::uint32_t each = options.particles == 0 ? particles_of_flag : options.particles / all + 1;
        const GridSize grid = grid_size(each, flag_fly, flag_hoist);
        auto mesh = make_sheet({.rows = grid.rows,
                                .columns = grid.columns,
                                .origin = {0, mast, 0},
                                .u = {flag_fly, 0, 0},
                                .v = {0, -flag_hoist, 0}});
        if (!mesh) return mesh.error();
        mesh_ = std::move(*mesh);
        ClothSettings settings;
        settings.fabric.areal_density = 0.12f;
        settings.fabric.bending = 5e-6f;
        const auto cooked = CookedCloth::create(mesh_, settings);
        if (!cooked) return cooked.error();

        SceneContent content;
        for (std::uint32_t number = 0; number < all; ++number)
            if (auto raised = raise_flag(world, *cooked, number, content); !raised) return raised.error();
        content.camera = {.target = {0.3f, 0.9f, 0}, .distance = 11.5f, .yaw = 0.6f, .pitch = 0.32f};
        return content;
    }

    [[nodiscard]] int check_steps() const override { return 150; }

    [[nodiscard]] Result<void> check(const World& world) const override {
        Checks checks;
        for (const ClothId id : cloths_) {
            const auto view = world.cloth(id);
            if (!view) return view.error();
            checks.finite(*view);
            const Stretch stretch = structural_stretch(mesh_, *view);
            checks.at_most("worst stretch", stretch.worst, 1.4f);
            const float downwind = view->bounds.upper.x - view->bounds.lower.x;
            checks.at_least("how far a flag flies downwind [m]", downwind, 0.2f * flag_fly);
        }
        return checks.result();
    }

  private:
    Result<void> raise_flag(World& world, const CookedCloth& cooked, std::uint32_t number,
                            SceneContent& content) {
        const auto from_middle = [](std::uint32_t at, std::uint32_t count) {
            return flags_apart * (static_cast<float>(at) - 0.5f * static_cast<float>(count - 1));
        };
        const Vec3 foot{from_middle(number % flag_columns, flag_columns), 0,
                        from_middle(number / flag_columns, flag_rows)};
        const auto cloth = world.add_cloth(cooked, {.translation = foot});
        if (!cloth) return cloth.error();
        cloths_.push_back(*cloth);
        std::vector<std::uint32_t> hoist;
        for (std::uint32_t row = 0; row < mesh_.rows; ++row) hoist.push_back(row * mesh_.columns);
        if (auto pinned = world.pin(*cloth, hoist); !pinned) return pinned;
        const Vec3 colour = flag_colours[number % flag_colours.size()];
        content.cloths.push_back({*cloth, mesh_, two_sided(colour, 0.12f)});
        content.solids.push_back({make_mast({foot.x - 0.02f, 0, foot.z}), collider_colour});
        return {};
    }

    std::vector<ClothId> cloths_;
    Mesh mesh_;
};

}  // namespace

std::unique_ptr<Scene> make_flags_scene() {
    return std::make_unique<Flags>();
}

}  // namespace weft::demo
