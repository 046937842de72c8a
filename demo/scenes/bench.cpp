// A bench for fabrics: a strip that hangs beside its exact curve, and Cusick's drape with its coefficient.

#include <cmath>
#include <cstdio>
#include <numbers>

#include "demo/learn/drape.h"
#include "demo/must.h"
#include "demo/scene.h"
#include "demo/scenes/measures.h"

namespace weft::demo {
namespace {

constexpr float strip_length = 0.06f, strip_width = 0.03f;  // [m]
constexpr std::uint32_t strip_cells = 24;
constexpr float strip_cell = strip_length / strip_cells;
constexpr float clamp_begins =
    0.5f * strip_cell;  // two columns are pinned; half of the bend at the last is the clamp's
constexpr Vec3 strip_clamp{-0.24f, 0.36f, -0.5f * strip_width};
constexpr float table_radius = 0.09f, disc_radius = 0.15f;  // radii of Cusick's tester [m]
constexpr Vec3 drape_middle{0.12f, 0.30f, 0};
constexpr float bench_gravity = 9.81f;
constexpr Vec3 elastica_colour{0.95f, 0.35f, 0.02f};

/// A round block that stands on the ground; its side and its top do not share vertices, so that the rim is
/// sharp.
Mesh round_block(float radius, const Vec3& top) {
    constexpr std::uint32_t sides = 48;
    Mesh mesh;
    for (const auto& [height, row] : {std::pair(0.0f, 0), {top.y, 1}, {top.y, 2}})
        for (std::uint32_t k = 0; k < sides; ++k) {
            const float angle = 2 * std::numbers::pi_v<float> * static_cast<float>(k) / sides;
            mesh.positions.push_back(
                {top.x + radius * std::cos(angle), height, top.z + radius * std::sin(angle)});
        }
    mesh.positions.push_back(top);
    for (std::uint32_t k = 0; k < sides; ++k) {
        const std::uint32_t next = (k + 1) % sides;
        mesh.triangles.push_back({k, sides + k, sides + next});
        mesh.triangles.push_back({k, sides + next, next});
        mesh.triangles.push_back({2 * sides + k, 3 * sides, 2 * sides + next});
    }
    return mesh;
}

class Bench final : public Scene {
  public:
    [[nodiscard]] WorldSettings world_settings() const override {
        // testers keep draughts out
        return {.wind = {.air_density = 0}};
    }

    [[nodiscard]] Result<SceneContent> build(World& world, const SceneOptions& /*options*/) override {
        strip_mesh_ = must(make_sheet({.rows = 7,
                                       .columns = strip_cells + 1,
                                       .origin = {strip_clamp.x, strip_clamp.y, strip_clamp.z + strip_width},
                                       .u = {strip_length, 0, 0},
                                       .v = {0, 0, -strip_width}}));
        disc_mesh_ = drape_disc(disc_radius, 20, drape_middle);  // a ring lies on the table's rim

        ClothSettings settings;
        settings.fabric.bending = 4e-5f;
        settings.air_damping = 1;
        const auto strip = must(world.add_cloth(strip_mesh_, settings));
        const auto draped = must(world.add_cloth(disc_mesh_, settings));
        strip_ = strip;
        disc_ = draped;
        hold(world);

        SceneContent content;
        content.cloths.push_back({strip_, strip_mesh_, two_sided({0.12f, 0.30f, 0.55f})});
        content.cloths.push_back({disc_, disc_mesh_, two_sided({0.55f, 0.10f, 0.12f})});
        constexpr Vec3 wood{0.45f, 0.40f, 0.34f};
        content.solids.push_back(
            {round_block(table_radius - 0.001f, {drape_middle.x, drape_middle.y - 0.003f, drape_middle.z}),
             wood});
        content.solids.push_back(
            {round_block(0.03f, {strip_clamp.x - 0.02f, strip_clamp.y - 0.003f, 0}), wood});
        content.camera = {.target = {-0.02f, 0.28f, 0}, .distance = 0.85f, .yaw = 0.25f, .pitch = 0.22f};
        return content;
    }

    void annotate(const World& world, Annotation& to) const override {
        const auto strip = world.cloth(strip_), draped = world.cloth(disc_);
        const auto settings = world.cloth_settings(strip_);
        if (!strip || !draped || !settings) return;
        const float length = strip_length - clamp_begins;
        const std::vector<Vec2> curve = elastica_curve(gamma_of(settings->fabric), 49);
        const auto place = [&](const Vec2& p, float z) {
            return Vec3{strip_clamp.x + clamp_begins + length * p.x, strip_clamp.y + length * p.y, z};
        };
        for (const float z : {strip_clamp.z - 0.002f, strip_clamp.z + strip_width + 0.002f})
            for (std::size_t i = 1; i < curve.size(); ++i)
                to.lines.push_back({place(curve[i - 1], z), place(curve[i], z), elastica_colour});

        char words[120];
        std::snprintf(words, sizeof words, "end's drop: exact %.3f, simulated %.3f lengths",
                      static_cast<double>(-curve.back().y), static_cast<double>(drop(*strip)));
        to.words.push_back({{strip_clamp.x - 0.02f, strip_clamp.y + 0.05f, 0}, words, {0.15f, 0.08f, 0.02f}});
        std::snprintf(words, sizeof words, "drape coefficient %.0f %%",
                      static_cast<double>(100 * coefficient(*draped)));
        to.words.push_back(
            {{drape_middle.x - 0.06f, drape_middle.y + 0.06f, 0}, words, {0.15f, 0.08f, 0.02f}});
    }

    [[nodiscard]] int check_steps() const override { return 600; }
    [[nodiscard]] Result<void> check(const World& world) const override {
        Checks checks;
        const ClothView strip = checks.cloth(world, strip_), draped = checks.cloth(world, disc_);
        const float exact = -elastica_curve(gamma_of(world.cloth_settings(strip_)->fabric), 2).back().y;
        checks.at_most("the end's drop, off the exact [lengths]", std::abs(drop(strip) - exact), 0.03f);
        checks.at_least("drape coefficient", coefficient(draped), 0.2f);
        checks.at_most("drape coefficient", coefficient(draped), 0.95f);
        return checks.result();
    }

  private:
    void hold(World& world) const {
        std::vector<std::uint32_t> held;
        for (std::uint32_t vertex = 0; vertex < strip_mesh_.positions.size(); ++vertex)
            if (strip_mesh_.positions[vertex].x < strip_clamp.x + 1.001f * strip_cell) held.push_back(vertex);
        must(world.pin(strip_, held));
        held.clear();
        for (std::uint32_t vertex = 0; vertex < disc_mesh_.pattern.size(); ++vertex)
            if (std::hypot(disc_mesh_.pattern[vertex].x, disc_mesh_.pattern[vertex].y) <
                1.0001f * table_radius)
                held.push_back(vertex);
        must(world.pin(disc_, held));
    }

    [[nodiscard]] static double gamma_of(const Fabric& fabric) {
        const double length = static_cast<double>(strip_length - clamp_begins);
        const double weight = static_cast<double>(fabric.areal_density) * static_cast<double>(bench_gravity);
        return std::min(
            weight * length * length * length / std::max(1e-9, static_cast<double>(fabric.bending)), 100.0);
    }
    /// Drop of the free end, in lengths.
    [[nodiscard]] float drop(const ClothView& strip) const {
        float sum = 0;
        for (std::uint32_t row = 1; row <= strip_mesh_.rows; ++row)
            sum += strip_clamp.y - vertex_position(strip, row * strip_mesh_.columns - 1).y();
        return sum / static_cast<float>(strip_mesh_.rows) / (strip_length - clamp_begins);
    }
    [[nodiscard]] float coefficient(const ClothView& draped) const {
        return drape_coefficient(shadow_area(disc_mesh_, draped), table_radius, disc_radius);
    }

    Mesh strip_mesh_, disc_mesh_;
    ClothId strip_, disc_;
};

}  // namespace

std::unique_ptr<Scene> make_bench_scene() {
    return std::make_unique<Bench>();
}

}  // namespace weft::demo
