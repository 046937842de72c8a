// Cloth by default settings beside its own motion in eight substeps of six passes, which shows the error of a
// step of 1/60 s.

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <numbers>

#include "demo/character/figure/figure.h"
#include "demo/must.h"
#include "demo/scene.h"
#include "demo/scenes/dolls.h"
#include "demo/scenes/measures.h"
#include "engine/least_turn.h"

namespace weft::demo {
namespace {

constexpr float figure_cell_of_legs = 0.026f;  // [m]
constexpr std::array<int, 2> substeps{1, 8};   // of the cloth to the left and to the right
constexpr std::array<Vec3, 2> colours{{{0.55f, 0.06f, 0.07f}, {0.06f, 0.20f, 0.45f}}};

/// Two cloths in one wind, one for each of `substeps`, labelled with their speeds.
class Pair : public Scene {
  public:
    explicit Pair(const Wind& wind) : wind_(wind) {}

    [[nodiscard]] WorldSettings world_settings() const override { return {.wind = wind_}; }

    void before_step(World& world, double /*time*/, float /*dt*/) override {
        for (std::size_t k = 0; k < cloths_.size(); ++k) {
            const auto view = world.cloth(cloths_[k]);
            if (!view) continue;
            float sum = 0;
            for (const Vec4& v : view->velocities) sum += xyz(v).squaredNorm();
            const float now = sum / static_cast<float>(view->velocities.size());
            constexpr float forgets = 1.0f / 120;  // a time constant of two seconds
            squared_speeds_[k] += forgets * (now - squared_speeds_[k]);
        }
    }

    void annotate(const World& world, Annotation& to) const override {
        for (std::size_t k = 0; k < cloths_.size(); ++k) {
            const auto view = world.cloth(cloths_[k]);
            if (!view) continue;
            char words[80];
            std::snprintf(words, sizeof words, "%s: %.1f m/s", k == 0 ? "as it is set" : "in 8 substeps",
                          static_cast<double>(std::sqrt(squared_speeds_[k])));
            to.words.push_back({label_at(k), words, {0.15f, 0.08f, 0.02f}});
        }
    }

  protected:
    [[nodiscard]] virtual Vec3 label_at(std::size_t k) const = 0;

    void add(World& world, std::size_t k, Mesh mesh, ClothSettings settings,
             std::span<const std::uint32_t> pins, SceneContent& content) {
        settings.substeps = substeps[k];
        if (substeps[k] > 1)
            settings.method = Multilevel{.passes = 6, .tolerance = 320};  // 8 x 40: as much in a frame
        const auto cloth = must(world.add_cloth(mesh, settings));
        cloths_.push_back(cloth);
        meshes_.push_back(mesh);
        content.cloths.push_back({cloth, std::move(mesh), two_sided(colours[k])});
        must(world.pin(cloth, pins));
    }
    /// Expects cloths to be finite and stretched by at most `worst`, and the default not to be too slow.
    [[nodiscard]] Checks check_cloths(const World& world, float worst) const {
        Checks checks;
        for (std::size_t k = 0; k < cloths_.size(); ++k) {
            const ClothView view = checks.cloth(world, cloths_[k]);
            checks.stretch(meshes_[k], view, worst);
        }
        checks.at_least("the speed of the cloth as it is set over its truth's",
                        std::sqrt(squared_speeds_[0] / squared_speeds_[1]), 0.5f);
        return checks;
    }

    std::vector<ClothId> cloths_;
    std::vector<Mesh> meshes_;
    std::array<float, 2> squared_speeds_{};

  private:
    Wind wind_;
};

class FlagBesideTruth final : public Pair {
    static constexpr float fly = 1.5f, hoist = 1.0f, top = 2.2f, apart = 2.1f, pole = 0.02f;  // [m]

  public:
    FlagBesideTruth() : Pair({.velocity = {8, 0, 0.8f}, .gust = 0.3f}) {}

    [[nodiscard]] Result<SceneContent> build(World& world, const SceneOptions& options) override {
        const std::uint32_t each = options.particles == 0 ? 925 : options.particles / 2 + 1;
        SceneContent content;
        for (std::size_t k = 0; k < substeps.size(); ++k) {
            Mesh mesh = sheet_of(each, {pole_at(k), top, 0}, {fly, 0, 0}, {0, -hoist, 0});
            const std::vector<std::uint32_t> pins = column_of(mesh, 0);
            add(world, k, std::move(mesh), {}, pins, content);
            const float axis = pole_at(k) - 1.5f * pole;
            const auto stands =
                must(world.add_collider({.shape = Capsule{{axis, 0, 0}, {axis, top + 0.05f, 0}, pole}}));
            content.drawn_colliders.push_back(stands);
        }
        content.camera = {.target = {-0.2f, 1.5f, 0}, .distance = 4.2f, .yaw = 0, .pitch = 0.05f};
        return content;
    }

    [[nodiscard]] Result<void> check(const World& world) const override {
        return check_cloths(world, 1.6f).result();
    }

  private:
    static float pole_at(std::size_t k) { return k == 0 ? -apart : 0.2f; }
    [[nodiscard]] Vec3 label_at(std::size_t k) const override { return {pole_at(k) + 0.2f, top + 0.3f, 0}; }
};

/// Cones of cotton on legs that walk, pinned round their waists.
class SkirtBesideTruth final : public Pair {
    static constexpr float waist = 0.15f, flare = 0.4f, length = 0.55f, apart = 1.4f;  // [m]

  public:
    SkirtBesideTruth() : Pair({.velocity = {3, 0, 1}, .gust = 0.3f}) {}

    [[nodiscard]] Result<SceneContent> build(World& world, const SceneOptions& options) override {
        const std::uint32_t each = options.particles == 0 ? 640 : options.particles / 2 + 1;
        const auto rows =
            std::max(2u, static_cast<std::uint32_t>(std::sqrt(static_cast<float>(each) / 1.6f)));
        ClothSettings settings;
        settings.fabric = Fabric::named("cotton").value();
        SceneContent content;
        for (std::size_t k = 0; k < substeps.size(); ++k) {
            const std::uint32_t columns = std::max(3u, each / rows);
            std::vector<std::uint32_t> pins;
            for (std::uint32_t c = 0; c < columns; ++c) pins.push_back(c);
            add(world, k, cone(rows, columns, middle(k)), settings, pins, content);
            for (std::size_t limb = 0; limb < 3; ++limb) {
                const auto id = must(world.add_collider({.shape = limb_at(k, limb, 0)}));
                limbs_.push_back(id);
            }
        }
        content.clad_colliders = limbs_;
        figure_ = std::make_shared<const Figure>(legs_at(0, 0), figure_cell_of_legs);
        for (std::size_t k = 0; k < substeps.size(); ++k)
            content.solids.push_back(
                figure_solid(*figure_, 3 * k, [this, k](std::span<Vec3> to, SolidMoment moment) {
                    figure_->place(legs_at(k, moment == SolidMoment::now ? now_ : before_), to);
                }));
        content.camera = {.target = {0, 0.6f, 0}, .distance = 3.2f, .yaw = 0, .pitch = 0.08f};
        return content;
    }

    void before_step(World& world, double time, float dt) override {
        Pair::before_step(world, time, dt);
        before_ = static_cast<float>(time);
        now_ = before_ + dt;
        for (std::size_t i = 0; i < limbs_.size(); ++i)
            (void)world.move_collider(limbs_[i], {.shape = limb_at(i / 3, i % 3, now_)});
    }

    void go_to(double time) override { now_ = before_ = static_cast<float>(time); }

    [[nodiscard]] Result<void> check(const World& world) const override {
        return check_cloths(world, 1.8f).result();
    }

  private:
    /// The limbs within one skirt's colliders, for the figure.
    [[nodiscard]] static std::vector<FigureLimb> legs_at(std::size_t k, float time) {
        std::vector<FigureLimb> limbs{doll_limb(LimbKind::trunk, limb_at(k, 0, time))};
        for (const std::size_t leg : {1, 2}) {
            const TaperedCapsule capsule = limb_at(k, leg, time);
            const Vector3 foot = to_vector(capsule.b);
            const Matrix3 axes = least_turn({0, -1, 0}, foot - to_vector(capsule.a)).toRotationMatrix();
            // The leg's round end has room for a small shoe.
            const float size = capsule.radius_b;
            const auto in_foot = [&](float ahead) {
                return to_vec3(foot + size * (axes * Vector3(0, -0.42f, ahead)));
            };
            add_doll_leg(capsule, {in_foot(-0.4f), in_foot(0.4f), 0.4f * size, 0.4f * size}, axes, limbs);
        }
        return limbs;
    }

    static float middle(std::size_t k) { return (k == 0 ? -0.5f : 0.5f) * apart; }
    [[nodiscard]] Vec3 label_at(std::size_t k) const override { return {middle(k) - 0.2f, 1.2f, 0}; }

    static Mesh cone(std::uint32_t rows, std::uint32_t columns, float x) {
        Mesh mesh;
        for (std::uint32_t r = 0; r < rows; ++r) {
            for (std::uint32_t c = 0; c < columns; ++c) {
                const float turn =
                    2 * std::numbers::pi_v<float> * static_cast<float>(c) / static_cast<float>(columns);
                const float down = length * static_cast<float>(r) / static_cast<float>(rows - 1);
                const float radius = waist + flare * down;
                mesh.positions.push_back({x + radius * std::sin(turn), 1 - down, radius * std::cos(turn)});
                if (r + 1 == rows) continue;
                const std::uint32_t i = r * columns + c, j = r * columns + (c + 1) % columns;
                mesh.triangles.push_back({i, i + columns, j});
                mesh.triangles.push_back({j, i + columns, j + columns});
            }
        }
        return mesh;
    }
    /// Limb 0: the hips; 1 and 2: legs that swing.
    static TaperedCapsule limb_at(std::size_t k, std::size_t limb, float time) {
        const float x = middle(k);
        if (limb == 0) return {{x - 0.04f, 0.95f, 0}, {x + 0.04f, 0.95f, 0}, 0.11f, 0.11f};
        const float side = limb == 1 ? 1.0f : -1.0f;
        const float swing = 0.45f * side * std::sin(5.7f * time), hip = x + 0.09f * side;
        constexpr float leg = 0.85f;
        return {{hip, 0.9f, 0}, {hip, 0.9f - leg * std::cos(swing), leg * std::sin(swing)}, 0.08f, 0.07f};
    }

    std::vector<ColliderId> limbs_;
    std::shared_ptr<const Figure> figure_;  // of both skirts' legs
    float now_ = 0, before_ = 0;            // times at which the figures are drawn [s]
};

}  // namespace

std::unique_ptr<Scene> make_truth_scene() {
    return std::make_unique<FlagBesideTruth>();
}
std::unique_ptr<Scene> make_worn_truth_scene() {
    return std::make_unique<SkirtBesideTruth>();
}

}  // namespace weft::demo
