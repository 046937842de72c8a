// Scenes of contact as scenes of the demo.

#include <algorithm>
#include <array>
#include <cmath>

#include "demo/must.h"
#include "demo/scene.h"
#include "demo/scenes/contact/contact_scene.h"
#include "demo/scenes/measures.h"
#include "demo/study/crossings/crossings.h"

namespace weft::demo {
namespace {

// A colour for each sheet.
constexpr std::array<Vec3, 5> colours{{{0.55f, 0.06f, 0.07f},
                                       {0.06f, 0.20f, 0.45f},
                                       {0.60f, 0.45f, 0.05f},
                                       {0.10f, 0.35f, 0.15f},
                                       {0.35f, 0.12f, 0.40f}}};

const Vec3& colour_of(std::size_t sheet) {
    return colours[sheet % colours.size()];
}

/// Sheets that are joined in one cloth have a colour each, over a front that is darker than the back.
SceneCloth coloured(ClothId id, const PlacedCloth& cloth, std::size_t number) {
    SceneCloth content{id, cloth.mesh, two_sided(colour_of(number))};
    if (cloth.layers.size() < 2) return content;
    content.look = two_sided({0.03f, 0.03f, 0.03f});
    for (std::uint32_t vertex = 0; vertex < cloth.mesh.positions.size(); ++vertex) {
        const auto above = std::ranges::upper_bound(cloth.layers, vertex);
        const Vec3& c = colour_of(static_cast<std::size_t>(above - cloth.layers.begin()) - 1);
        content.tints.push_back({c.x, c.y, c.z, 0.75f});
    }
    return content;
}

render::OrbitCamera camera_at(const ContactScene& scene, const StageView& view) {
    Vector3 lower = Vector3::Constant(1e9f), upper = -lower;
    for (const PlacedCloth& cloth : scene.cloths) {
        for (const Vec3& p : cloth.mesh.positions) {
            lower = lower.cwiseMin(to_vector(p));
            upper = upper.cwiseMax(to_vector(p));
        }
    }
    const bool has_ground = !scene.colliders.empty();
    if (has_ground) lower.y() = std::min(lower.y(), 0.0f);
    const Vector3 middle = 0.5f * (lower + upper);
    const float height = has_ground ? 0.3f * upper.y() : middle.y();
    return {.target = {middle.x(), height - view.lower, middle.z()},
            .distance = 1.5f * (upper - lower).norm() / view.nearer,
            .yaw = 0.6f,
            .pitch = 0.4f};
}

class ContactStage final : public Scene {
  public:
    ContactStage(SceneMaker maker, const StageView& view) : maker_(std::move(maker)), view_(view) {}

    [[nodiscard]] WorldSettings world_settings() const override { return maker_.make(0).world; }

    [[nodiscard]] Result<SceneContent> build(World& world, const SceneOptions& options) override {
        scene_ = maker_.make(options.particles);
        SceneContent content;
        for (PlacedCloth& cloth : scene_.cloths) {
            cloth.settings.self_collision.method = SelfCollisionMethod::contact;
            if (view_.damping > 0) cloth.settings.fabric.damping = view_.damping;
            if (view_.air_damping > 0) cloth.settings.air_damping = view_.air_damping;
            const auto id = must(world.add_cloth(cloth.mesh, cloth.settings));
            must(world.pin(id, cloth.pins));
            content.cloths.push_back(coloured(id, cloth, content.cloths.size()));
            cloths_.push_back(id);
        }
        for (const Collider& collider : scene_.colliders) {
            const auto id = must(world.add_collider(collider));
            colliders_.push_back(id);
            if (!std::holds_alternative<Plane>(collider.shape)) content.drawn_colliders.push_back(id);
        }
        content.camera = camera_at(scene_, view_);
        const Vec3& gravity = scene_.world.gravity;
        if (gravity.x == 0 && gravity.y == 0 && gravity.z == 0) content.ground_height = -1.5f;
        return content;
    }

    void before_step(World& world, double time, float dt) override {
        if (scene_.move) scene_.move(Handles(*this, world), time + static_cast<double>(dt));
    }

    /// Draws what holds the cloth, and planes that face down as grates.
    void annotate(const World& world, Annotation& to) const override {
        for (const auto& [cloth, holder, vertices] : scene_.holders)
            draw_holder(world.cloth(cloths_[cloth]).value(), vertices, holder, to);
        for (const ColliderId id : colliders_) {
            const auto collider = world.collider(id);
            const auto* plane = std::get_if<Plane>(&collider->shape);
            if (plane != nullptr && plane->normal.y < 0) draw_grate(-plane->offset, to);
        }
    }

    [[nodiscard]] int check_steps() const override { return view_.check_steps; }

    [[nodiscard]] Result<void> check(const World& world) const override {
        Checks checks;
        study::TriangleSoup soup;
        for (const ClothId id : cloths_) {
            const ClothView view = checks.cloth(world, id);
            soup.add(view);
        }
        if (soup.finite())
            checks.at_most("triangles that cross", static_cast<float>(study::count_crossings(soup).all), 0);
        return checks.result();
    }

  private:
    class Handles final : public SceneHandles {
      public:
        Handles(ContactStage& stage, World& world) : stage_(stage), world_(world) {}
        void move_pin(std::size_t cloth, std::uint32_t vertex, const Vec3& target) const override {
            (void)world_.move_pin(stage_.cloths_.at(cloth), vertex, target);
        }
        void unpin(std::size_t cloth, const std::vector<std::uint32_t>& vertices) const override {
            (void)world_.unpin(stage_.cloths_.at(cloth), vertices);
        }
        void move_collider(std::size_t collider, const Collider& target) const override {
            (void)world_.move_collider(stage_.colliders_.at(collider), target);
        }

      private:
        ContactStage& stage_;
        World& world_;
    };

    SceneMaker maker_;
    StageView view_;
    ContactScene scene_;
    std::vector<ClothId> cloths_;
    std::vector<ColliderId> colliders_;
};

}  // namespace

std::unique_ptr<Scene> make_contact_stage(std::string_view name, const StageView& view) {
    std::vector<SceneMaker> makers = contact_scenes();
    for (SceneMaker& shown : shown_scenes()) makers.push_back(std::move(shown));
    return std::make_unique<ContactStage>(*std::ranges::find(makers, name, &SceneMaker::name), view);
}

}  // namespace weft::demo
