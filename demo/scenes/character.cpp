// Somebody walks, in a dress or in a garment from an OBJ file.

#include "demo/character/character.h"

#include <optional>

#include "demo/scene.h"
#include "demo/scenes/measures.h"
#include "demo/study/contact/crossings.h"

namespace weft::demo {
namespace {

class CharacterScene final : public Scene {
  public:
    [[nodiscard]] WorldSettings world_settings() const override {
        WorldSettings settings;
        settings.wind.velocity = {0, 0, -1.2f};  // who walks on the spot has the air come at them
        settings.wind.gust = 0.2f;
        return settings;
    }

    [[nodiscard]] Result<SceneContent> build(World& world, const SceneOptions& options) override {
        CharacterSettings settings;
        settings.motion = options.motion;
        settings.garment = options.garment;
        settings.particles = options.particles;
        settings.cloth.fabric.areal_density = 0.16f;
        settings.cloth.self_collision.enabled = true;
        settings.cloth.self_collision.method = SelfCollisionMethod::contact;
        auto made = Character::create(settings);
        if (!made) return made.error();
        character_.emplace(std::move(*made));
        if (auto entered = character_->enter(world); !entered) return entered.error();
        if (auto ground = world.add_collider({.shape = Plane{}}); !ground) return ground.error();

        SceneContent content;
        content.cloths.push_back(
            {character_->cloth(), character_->garment().mesh, {.front = character_->garment().colour}});
        content.drawn_colliders = character_->colliders();
        content.camera = {.target = {0, 0.85f, 0}, .distance = 3.0f, .yaw = 0.6f, .pitch = 0.08f};
        return content;
    }

    void before_step(World& world, double time, float dt) override {
        character_->before_step(world, time, dt);
    }

    [[nodiscard]] Result<void> check(const World& world) const override {
        const auto view = world.cloth(character_->cloth());
        if (!view) return view.error();
        Checks checks;
        checks.finite(*view);
        study::TriangleSoup soup;
        soup.add(*view);
        if (soup.finite())
            checks.at_most("triangles that cross", static_cast<float>(study::count_crossings(soup).all), 0);
        checks.at_most("mean stretch", structural_stretch(character_->garment().mesh, *view).mean, 1.02f);
        return checks.result();
    }

  private:
    std::optional<Character> character_;
};

}  // namespace

std::unique_ptr<Scene> make_character_scene() {
    return std::make_unique<CharacterScene>();
}

}  // namespace weft::demo
