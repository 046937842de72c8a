// A sheet over each kind of shape.

#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <variant>
#include <vector>

#include "collision/colliders/nearest_surface.h"
#include "demo/must.h"
#include "demo/scene.h"
#include "demo/scenes/measures.h"
#include "demo/scenes/solids.h"

namespace weft::demo {
namespace {

constexpr float sheet_side = 0.9f;    // of a sheet [m]
constexpr float apart = 1.35f;        // from one shape's middle to the next [m]
constexpr float kept_apart = 0.008f;  // [m]
constexpr std::uint32_t in_a_row = 4;

/// One shape about the World's origin, standing on the ground.
struct Stand {
    const char* name;
    float top;  ///< [m]
    std::variant<Sphere, Capsule, TaperedCapsule, Box, ConvexHull, TriangleMesh, DistanceField, HeightField>
        shape;
    Mesh drawn{};   ///< of a shape that a World holds
    Vec3 middle{};  ///< place of its own space's origin [m]
    Vec3 front;     ///< colour of its sheet
};

const std::vector<Vec2>& vase() {
    static const std::vector<Vec2> profile{{0, 0},          {0.14f, 0},      {0.17f, 0.05f}, {0.19f, 0.14f},
                                           {0.17f, 0.24f},  {0.11f, 0.32f},  {0.08f, 0.38f}, {0.09f, 0.43f},
                                           {0.07f, 0.455f}, {0.03f, 0.465f}, {0, 0.47f}};
    return profile;
}

constexpr std::uint32_t hill_side = 17;
const std::vector<float>& hill() {
    static const std::vector<float> heights = [] {
        std::vector<float> made;
        for (std::uint32_t row = 0; row < hill_side; ++row)
            for (std::uint32_t column = 0; column < hill_side; ++column) {
                const float x = 2 * static_cast<float>(column) / (hill_side - 1) - 1;
                const float z = 2 * static_cast<float>(row) / (hill_side - 1) - 1;
                const float round = std::max(0.0f, 1 - x * x) * std::max(0.0f, 1 - z * z);
                made.push_back(round * (0.26f + 0.08f * std::cos(7 * x) * std::cos(5 * z)));
            }
        return made;
    }();
    return heights;
}

class Shapes final : public Scene {
  public:
    [[nodiscard]] int check_steps() const override { return 300; }

    [[nodiscard]] Result<SceneContent> build(World& world, const SceneOptions& options) override {
        make_stands();
        SceneContent content;
        must(world.add_collider({.shape = Plane{}, .friction = 0.6f}));
        for (std::uint32_t k = 0; k < stands_.size(); ++k) {
            const std::uint32_t each = options.particles / static_cast<std::uint32_t>(stands_.size());
            build_stand(world, k, each, content);
        }
        content.camera = {.target = {0, 0.12f, 0.1f}, .distance = 5.1f, .yaw = 0.08f, .pitch = 0.6f};
        return content;
    }

    [[nodiscard]] Result<void> check(const World& world) const override {
        Checks checks;
        for (std::size_t k = 0; k < stands_.size(); ++k) {
            const std::string of = std::string(", over the ") + stands_[k].name;
            const ClothView view = checks.cloth(world, cloths_[k]);
            const Collider collider = must(world.collider(colliders_[k]));
            checks.at_least("the lowest point's height [m]" + of, view.bounds.lower.y, 0.5f * kept_apart);
            checks.at_least("the highest point's [m]" + of, view.bounds.upper.y, stands_[k].top - 0.02f);
            float fastest = 0, nearest = sheet_side;
            for (std::size_t i = 0; i < view.positions.size(); ++i) {
                fastest = std::max(fastest, xyz(view.velocities[i]).norm());
                if (!std::holds_alternative<PlacedShape>(collider.shape))
                    nearest = std::min(nearest, nearest_surface(collider, xyz(view.positions[i])).distance);
            }
            checks.at_least("the least distance from it [m]" + of, nearest, 0.5f * kept_apart);
            checks.at_most("the fastest particle's speed, once it has come to rest [m/s]" + of, fastest,
                           0.3f);
        }
        return checks.result();
    }

  private:
    void make_stands() {
        const float turn = 0.5f * 0.6f;
        const Mesh ring = torus(0.22f, 0.075f, 48, 20), pot = turned(vase(), 40, false),
                   rock = stone({0.26f, 0.22f, 0.22f});
        const HeightField field{hill_side, hill_side, 0.05f, hill()};
        const float top_of_hill = *std::ranges::max_element(hill());
        const auto solid = [](const Mesh& mesh) {
            return TriangleMesh{mesh.positions, mesh.triangles, true};
        };
        stands_.clear();
        stands_.push_back({"ball", 0.5f, Sphere{{0, 0.25f, 0}, 0.25f}, {}, {}, {0.60f, 0.10f, 0.09f}});
        stands_.push_back({"capsule",
                           0.45f,
                           Capsule{{-0.2f, 0.3f, 0.06f}, {0.2f, 0.3f, -0.06f}, 0.15f},
                           {},
                           {},
                           {0.62f, 0.42f, 0.08f}});
        stands_.push_back({"tapered capsule",
                           0.53f,
                           TaperedCapsule{{0, 0.17f, 0}, {0.04f, 0.47f, 0}, 0.17f, 0.06f},
                           {},
                           {},
                           {0.12f, 0.38f, 0.18f}});
        stands_.push_back({"box",
                           0.36f,
                           Box{{0, 0.18f, 0}, {0, std::sin(turn), 0, std::cos(turn)}, {0.2f, 0.18f, 0.2f}},
                           {},
                           {},
                           {0.08f, 0.24f, 0.50f}});
        stands_.push_back({"hull", 0.42f, ConvexHull{}, rock, {0, 0.2f, 0}, {0.35f, 0.14f, 0.42f}});
        stands_.push_back({"mesh", 0.075f, TriangleMesh{}, ring, {0, 0.08f, 0}, {0.08f, 0.40f, 0.44f}});
        stands_.push_back(
            {"distance field", 0.47f, DistanceField{.cell = 0.012f}, pot, {}, {0.55f, 0.28f, 0.10f}});
        stands_.push_back({"height field",
                           top_of_hill,
                           field,
                           surface_of(field),
                           {-0.4f, 0, -0.4f},
                           {0.16f, 0.15f, 0.15f}});
        for (Stand& stand : stands_) {
            if (auto* mesh = std::get_if<TriangleMesh>(&stand.shape)) *mesh = solid(stand.drawn);
            if (auto* distances = std::get_if<DistanceField>(&stand.shape))
                distances->mesh = solid(stand.drawn);
            if (auto* hull = std::get_if<ConvexHull>(&stand.shape)) hull->points = stand.drawn.positions;
        }
    }

    void build_stand(World& world, std::uint32_t k, std::uint32_t particles, SceneContent& content) {
        Stand& stand = stands_[k];
        const Vec3 at{apart * (static_cast<float>(k % in_a_row) - 0.5f * (in_a_row - 1)), 0,
                      apart * (k < in_a_row ? 0.5f : -0.5f)};
        const Collider collider = place(world, stand, at);
        const auto added = must(world.add_collider(collider));
        colliders_.push_back(added);
        content.drawn_colliders.push_back(added);
        for (Vec3& p : stand.drawn.positions)
            p = {p.x + at.x + stand.middle.x, p.y + at.y + stand.middle.y, p.z + at.z + stand.middle.z};
        if (!stand.drawn.positions.empty()) content.solids.push_back({stand.drawn, collider_colour});

        // Each sheet is turned by another angle, so that their folds differ.
        const float angle = 0.3f + 0.35f * static_cast<float>(k);
        const Vector3 u(sheet_side * std::cos(angle), 0, sheet_side * std::sin(angle)), v(-u.z(), 0, u.x());
        const Vector3 corner = Vector3(at.x, stand.top + stand.middle.y + 0.06f, at.z) - 0.5f * (u + v);
        const Mesh mesh =
            sheet_of(particles == 0 ? 1600 : particles, to_vec3(corner), to_vec3(u), to_vec3(v));
        ClothSettings settings;
        settings.fabric.damping = 0.01f;  // so that pleats come to rest
        settings.thickness = kept_apart;
        settings.self_collision = {.method = SelfCollisionMethod::contact};
        const auto cloth = must(world.add_cloth(mesh, settings));
        cloths_.push_back(cloth);
        content.cloths.push_back({cloth, mesh, two_sided(stand.front, 0.09f)});
    }

    /// The collider of a stand at this place, with its shape in the World if it needs one.
    [[nodiscard]] Collider place(World& world, const Stand& stand, const Vec3& at) const {
        Collider collider{.friction = 0.5f};
        const auto moved = [&](const Vec3& p) { return Vec3{p.x + at.x, p.y + at.y, p.z + at.z}; };
        if (const auto* ball = std::get_if<Sphere>(&stand.shape))
            collider.shape = Sphere{moved(ball->center), ball->radius};
        else if (const auto* capsule = std::get_if<Capsule>(&stand.shape))
            collider.shape = Capsule{moved(capsule->a), moved(capsule->b), capsule->radius};
        else if (const auto* tapered = std::get_if<TaperedCapsule>(&stand.shape))
            collider.shape =
                TaperedCapsule{moved(tapered->a), moved(tapered->b), tapered->radius_a, tapered->radius_b};
        else if (const auto* box = std::get_if<Box>(&stand.shape))
            collider.shape = Box{moved(box->center), box->rotation, box->half_extents};
        else {
            const auto held = std::visit(
                [&](const auto& shape) {
                    if constexpr (requires { Shape{shape}; }) return must(world.add_shape(shape));
                    return ShapeId{};
                },
                stand.shape);
            collider.shape = PlacedShape{held, moved(stand.middle)};
        }
        return collider;
    }

    std::vector<Stand> stands_;
    std::vector<ClothId> cloths_;
    std::vector<ColliderId> colliders_;
};

}  // namespace

std::unique_ptr<Scene> make_shapes_scene() {
    return std::make_unique<Shapes>();
}

}  // namespace weft::demo
