// Somebody walks, in a dress or in a garment from an OBJ file; and a crowd of them.

#include "demo/character/character.h"

#include <algorithm>
#include <array>

#include "demo/character/figure/figure.h"
#include "demo/character/garment/wear.h"
#include "demo/must.h"
#include "demo/scene.h"
#include "demo/scenes/dolls.h"
#include "demo/scenes/measures.h"
#include "demo/study/crossings/crossings.h"

namespace weft::demo {
namespace {

constexpr std::uint32_t crowd_rows = 4, crowd_columns = 5;
constexpr float crowd_spacing = 1.3f;             // [m]
constexpr std::uint32_t particles_of_many = 800;  // of each dress in a crowd
/// Distance from limbs [m]: edges of 5 cm are chords of a knee, and 5 mm let 3.5 mm of it through.
constexpr float crowd_thickness = 0.01f;
constexpr std::uint32_t drawn_vertices = 30000;  // of a dress
constexpr std::array<Vec3, 4> crowd_colours{
    {{0.30f, 0.05f, 0.12f}, {0.05f, 0.14f, 0.32f}, {0.34f, 0.22f, 0.03f}, {0.06f, 0.22f, 0.12f}}};

constexpr float figure_edges = 64, crowd_edges = 38;  // of figures' meshes, from soles to crown

class Walkers final : public Scene {
  public:
    Walkers(std::uint32_t rows, std::uint32_t columns, bool run = false)
        : rows_(rows), columns_(columns), run_(run) {}

    [[nodiscard]] WorldSettings world_settings() const override {
        // Walkers stay on the spot, so that the air moves towards them instead.
        return {.wind = {.velocity = {0, 0, run_ ? -3.0f : -1.2f}, .gust = 0.2f}};
    }

    [[nodiscard]] Result<SceneContent> build(World& world, const SceneOptions& options) override {
        must(world.add_collider({.shape = Plane{}}));
        SceneContent content;
        for (std::uint32_t number = 0; number < rows_ * columns_; ++number) {
            auto made = must(Character::create(settings_of(number, options)));
            Character& character = walkers_.emplace_back(std::move(made));
            must(character.enter(world));
            const Vec3 colour = number == 0 ? character.garment().colour : crowd_colours[number % 4];
            SceneCloth& cloth = content.cloths.emplace_back(
                SceneCloth{character.cloth(), character.garment().mesh, two_sided(colour)});
            cloth.surface = character.garment().surface;
            cloth.maps = character.garment().maps;
            if (const Mesh& fine = character.garment().fine; !fine.positions.empty())
                must(draw_over(cloth, world, fine, {.reach = character.garment().reach}));
            content.clad_colliders.insert(content.clad_colliders.end(), character.colliders().begin(),
                                          character.colliders().end());
            content.solids.push_back(character.skin_places() ? skin_of(character)
                                                             : figure_of(number, !options.garment.empty()));
        }
        content.notes = walkers_.front().garment().notes;
        const float size = 0.5f * crowd_spacing * static_cast<float>(rows_ + columns_ - 2);
        content.camera = {.target = {0, 0.85f, 0},
                          .distance = 3.0f + 1.25f * size,
                          .yaw = 0.6f,
                          .pitch = is_crowd() ? 0.3f : 0.08f};
        return content;
    }

    void before_step(World& world, double time, float dt) override {
        for (Character& character : walkers_) character.before_step(world, time, dt);
    }

    [[nodiscard]] Result<void> give_skin(World& world, ClothId cloth) override {
        const auto worn = std::ranges::find(walkers_, cloth, &Character::cloth);
        return worn == walkers_.end() ? Scene::give_skin(world, cloth) : worn->give_skin(world);
    }

    void go_to(double time) override {
        for (Character& character : walkers_) character.go_to(time);
    }

    [[nodiscard]] Result<void> check(const World& world) const override {
        Checks checks;
        study::TriangleSoup soup;
        for (const Character& character : walkers_) {
            const ClothView view = checks.cloth(world, character.cloth());
            soup.add(view);
            constexpr float kept = 0.005f;  // [m]
            const auto wear = WearMeter(character.garment().mesh, kept).measure(view, character.capsules());
            // The skin differs from the capsules of the limbs by its chords and its folds.
            if (!character.skin_places())
                checks.at_most("triangles inside the body", static_cast<float>(wear.inside), 0);
            if (is_crowd()) checks.at_most("how much of a knee is seen [m]", wear.deepest, 1e-3f);
            checks.at_most("the 99th percentile of stretch", wear.stretch_99, run_ ? 1.07f : 1.04f);
        }
        if (soup.finite())
            checks.at_most("triangles that cross", static_cast<float>(study::count_crossings(soup).all), 0);
        return checks.result();
    }

  private:
    /// The triangles that cloth meets.
    [[nodiscard]] static SceneSolid skin_of(const Character& character) {
        return {{.positions = *character.skin_places(), .triangles = character.skin().triangles()},
                complexions[0].skin,
                [places = character.skin_places()](std::span<Vec3> to, SolidMoment) {
                    std::ranges::copy(*places, to.begin());
                }};
    }

    /// A smooth figure within the capsules that cloth meets. Walkers of one skeleton have one.
    /// With a garment from a file, which may be a shirt, it wears a suit.
    [[nodiscard]] SceneSolid figure_of(std::uint32_t number, bool has_garment) {
        const Character& character = walkers_[number];
        if (!figure_)
            figure_ = std::make_shared<const BodyFigure>(character.body(), character.skeleton(),
                                                         is_crowd() ? crowd_edges : figure_edges);
        const auto place = [this, number](std::span<Vec3> to, SolidMoment moment) {
            const Character& who = walkers_[number];
            const auto& [pose, capsules] = moment == SolidMoment::now ? who.body_now() : who.body_before();
            figure_->place(pose, capsules, to);
        };
        if (!has_garment) return figure_solid(figure_->figure(), number, place);
        return figure_solid(figure_->figure(), number, place, Suit{.has_sleeves = false});
    }

    [[nodiscard]] bool is_crowd() const { return rows_ * columns_ > 1; }

    [[nodiscard]] CharacterSettings settings_of(std::uint32_t number, const SceneOptions& options) const {
        CharacterSettings settings;
        settings.motion = options.motion;
        settings.runs = run_;
        settings.garment = options.garment;
        settings.unit = options.unit;
        settings.y_is_up = options.y_is_up;
        settings.simulated = options.simulated;
        settings.speed = options.speed;
        if (options.skin) settings.surface = BodySurface::skin;
        settings.particles = options.particles / (rows_ * columns_);
        if (settings.particles == 0 && is_crowd()) settings.particles = particles_of_many;
        const auto from_middle = [](std::uint32_t at, std::uint32_t count) {
            return crowd_spacing * (static_cast<float>(at) - 0.5f * static_cast<float>(count - 1));
        };
        settings.place = {from_middle(number % columns_, columns_), 0, from_middle(number / columns_, rows_)};
        settings.ahead = 0.137 * number;
        if (!is_crowd() && options.particles == 0) settings.drawn = drawn_vertices;
        settings.cloth.fabric.areal_density = 0.16f;
        if (is_crowd()) settings.cloth.thickness = crowd_thickness;
        settings.cloth.self_collision.method = SelfCollisionMethod::contact;
        return settings;
    }

    std::uint32_t rows_, columns_;
    bool run_;
    std::vector<Character> walkers_;
    std::shared_ptr<const BodyFigure> figure_;
};

}  // namespace

std::unique_ptr<Scene> make_character_scene() {
    return std::make_unique<Walkers>(1, 1);
}
std::unique_ptr<Scene> make_runner_scene() {
    return std::make_unique<Walkers>(1, 1, true);
}
std::unique_ptr<Scene> make_crowd_scene() {
    return std::make_unique<Walkers>(crowd_rows, crowd_columns);
}

}  // namespace weft::demo
