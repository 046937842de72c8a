// Map::collider_mask: which vertices meet which colliders; and the friction of a cloth's two sides.

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <functional>
#include <string>
#include <vector>

#include "tests/cloth/fixtures.h"
#include "weft/weft.h"

namespace weft::test::masks {
namespace {

constexpr float g = 9.81f;  // [m/s^2]

World still_air(const Vec3& gravity = downwards) {
    WorldSettings settings{.gravity = gravity, .threads = 1};
    settings.wind.air_density = 0;
    return World::create(settings).value();
}

/// A level sheet of a metre about the origin.
Mesh level_sheet(std::uint32_t side, float height = 0) {
    return make_sheet({.rows = side,
                       .columns = side,
                       .origin = {-0.5f, height, -0.5f},
                       .u = {1, 0, 0},
                       .v = {0, 0, 1}})
        .value();
}

/// Single triangles beside one another, at the ground's thickness.
Mesh triangles_apart(bool is_second_turned = false) {
    Mesh mesh;
    for (const float z : {0.0f, 1.0f}) {
        const auto first = static_cast<std::uint32_t>(mesh.positions.size());
        for (const Vec3& p : {Vec3{0, 0.005f, z}, Vec3{0, 0.005f, z + 0.1f}, Vec3{0.1f, 0.005f, z}})
            mesh.positions.push_back(p);
        mesh.triangles.push_back({first, first + 1, first + 2});
        if (is_second_turned && first > 0) std::swap(mesh.triangles.back()[1], mesh.triangles.back()[2]);
    }
    return mesh;
}

std::vector<ClothSettings> ways_to_meet() {
    std::vector<ClothSettings> ways(5);
    ways[1].method = Xpbd{};
    ways[1].substeps = 8;
    ways[2].collider_response = ColliderResponse::velocity_filter;
    ways[3].self_collision = {.method = SelfCollisionMethod::contact};
    ways[4].method = ConjugateGradient{};
    for (ClothSettings& way : ways) way.air_damping = 0;
    return ways;
}

TEST(ColliderMasks, EachVertexMeetsTheLayersOfItsMask) {
    for (const ClothSettings& settings : ways_to_meet()) {
        World world = still_air();
        const ClothId cloth = world.add_cloth(triangles_apart(), settings).value();
        ASSERT_TRUE(world.add_collider({.shape = Plane{}, .layers = 2}));
        ASSERT_TRUE(world.set_map(cloth, Map::collider_mask, std::vector<float>{3, 3, 3, 1, 1, 1}));
        for (int k = 0; k < 30; ++k) world.step(h);
        const ClothView view = world.cloth(cloth).value();
        const auto height = [&](std::size_t v) { return view.positions[view.vertex_to_particle[v]].y; };
        EXPECT_NEAR(height(0), 0.005f, 0.012f) << settings.method.index();  // the filter lets it in by a step
        EXPECT_NEAR(height(3), -g / 8, 0.05f) << settings.method.index();
    }
}

/// All that a collider does to a sheet in half a second: it lies there, falls fast, is placed over the cloth.
void meet_everything(World& world, const std::function<void(Collider&)>& change) {
    const auto changed = [&](Collider collider) {
        change(collider);
        return collider;
    };
    const std::array<Vec3, 4> corners{{{0, 0, 0}, {0.2f, 0, 0}, {0, 0.2f, 0}, {0, 0, 0.2f}}};
    const std::array<std::array<std::uint32_t, 3>, 4> sides{{{0, 2, 1}, {0, 1, 3}, {0, 3, 2}, {1, 2, 3}}};
    const ShapeId mesh = world.add_shape(TriangleMesh{corners, sides}).value();
    for (const Collider& collider :
         {Collider{.shape = Sphere{{0, -0.2f, 0}, 0.15f}},
          Collider{.shape = TaperedCapsule{{0.3f, -0.3f, 0}, {0.3f, -0.3f, 0.4f}, 0.1f, 0.05f}},
          Collider{.shape = Box{{-0.3f, -0.2f, -0.3f}, {}, {0.1f, 0.1f, 0.1f}}},
          Collider{.shape = PlacedShape{mesh, {0.2f, -0.3f, -0.4f}, {}}},
          Collider{.shape = Plane{.offset = -0.4f}}})
        ASSERT_TRUE(world.add_collider(changed(collider)));
    const ColliderId rod =
        world.add_collider(changed({.shape = Capsule{{-0.2f, 1, -0.6f}, {-0.2f, 1, 0.6f}, 0.01f}})).value();
    const ColliderId over = world.add_collider(changed({.shape = Sphere{{5, 5, 5}, 0.3f}})).value();
    const BodyId body = world.add_body({.mass = 0.2f}, {.position = {-0.3f, -0.2f, 0.3f}}).value();
    const Collider ball{.shape = Sphere{{-0.3f, -0.2f, 0.3f}, 0.1f}};
    ASSERT_TRUE(world.attach_collider(body, world.add_collider(changed(ball)).value()));
    for (int k = 0; k < 30; ++k) {
        const float y = 1 - 0.3f * static_cast<float>(k);
        ASSERT_TRUE(world.move_collider(
            rod, changed({.shape = Capsule{{-0.2f, y, -0.6f}, {-0.2f, y, 0.6f}, 0.01f}})));
        if (k == 20) {
            ASSERT_TRUE(world.place_collider(over, changed({.shape = Sphere{{0.2f, -0.3f, 0.2f}, 0.3f}})));
        }
        world.step(h);
    }
}

std::vector<Vec4> positions_of(const World& world, ClothId id) {
    const ClothView view = world.cloth(id).value();
    return {view.positions.begin(), view.positions.end()};
}

// In whatever way cloth meets a collider, a map of one value is ClothSettings::collider_mask of that value.
TEST(ColliderMasks, OneValueIsTheClothsMask) {
    for (const ClothSettings& settings : ways_to_meet())
        for (const std::uint32_t mask : {0u, 2u, 3u}) {
            ClothSettings masked = settings;
            masked.collider_mask = mask;
            World by_map = still_air(), by_setting = still_air();
            const ClothId a = by_map.add_cloth(level_sheet(13), settings).value();
            const ClothId b = by_setting.add_cloth(level_sheet(13), masked).value();
            ASSERT_TRUE(
                by_map.set_map(a, Map::collider_mask, std::vector<float>(169, static_cast<float>(mask))));
            for (World* world : {&by_map, &by_setting}) meet_everything(*world, [](Collider&) {});
            EXPECT_TRUE(same_bytes(positions_of(by_map, a), positions_of(by_setting, b)))
                << settings.method.index() << ", mask " << mask;
        }
}

TEST(ColliderMasks, WithoutTheMapNothingIsLeftOfIt) {
    World with = still_air(), without = still_air();
    const ClothId a = with.add_cloth(level_sheet(13)).value();
    const ClothId b = without.add_cloth(level_sheet(13)).value();
    const std::size_t bytes = with.cloth_info(a)->bytes;
    ASSERT_TRUE(with.set_map(a, Map::collider_mask, std::vector<float>(169, 0)));
    ASSERT_TRUE(with.set_map(a, Map::collider_mask, {}));
    EXPECT_EQ(with.cloth_info(a)->bytes, bytes);
    for (World* world : {&with, &without}) meet_everything(*world, [](Collider&) {});
    EXPECT_TRUE(same_bytes(positions_of(with, a), positions_of(without, b)));
}

/// A sheet pinned at its border, of which the half x > 0 alone meets colliders of layer 1.
struct HalfSheet {
    static constexpr std::uint32_t side = 21;
    World world = still_air({});
    ClothId cloth;

    HalfSheet() {
        cloth = world.add_cloth(level_sheet(side)).value();
        std::vector<std::uint32_t> border;
        std::vector<float> masks;
        for (std::uint32_t i = 0; i < side * side; ++i) {
            if (i / side == 0 || i / side == side - 1 || i % side == 0 || i % side == side - 1)
                border.push_back(i);
            masks.push_back(i % side > side / 2 ? 1.0f : 2.0f);
        }
        EXPECT_TRUE(world.pin(cloth, border));
        EXPECT_TRUE(world.set_map(cloth, Map::collider_mask, masks));
    }
    /// Drives a rod down through the sheet's plane at this x, at 3 m/s; returns how far the cloth was pushed.
    float strike(float x, float radius) {
        const auto at = [&](float y) {
            return Collider{.shape = Capsule{{x, y, -0.2f}, {x, y, 0.2f}, radius}};
        };
        const ColliderId rod = world.add_collider(at(0.1f)).value();
        float lowest = 0;
        for (int k = 1; k <= 4; ++k) {
            EXPECT_TRUE(world.move_collider(rod, at(0.1f - 0.05f * static_cast<float>(k))));
            world.step(h);
            for (const Vec4& p : world.cloth(cloth)->positions) lowest = std::min(lowest, p.y);
        }
        return -lowest;
    }
};

TEST(ColliderMasks, ARodPassesTheHalfThatDoesNotMeetIt) {
    for (const float radius : {0.002f, 0.05f}) {
        EXPECT_EQ(HalfSheet().strike(-0.25f, radius), 0) << radius;
        EXPECT_GT(HalfSheet().strike(0.25f, radius), 0.08f) << radius;
    }
}

// A collider that is placed over cloth pushes out what meets it, and nothing else.
TEST(ColliderMasks, OnlyWhatMeetsAPlacedColliderComesOutOfIt) {
    HalfSheet half;
    ASSERT_TRUE(half.world.add_collider({.shape = Sphere{{0, -0.05f, 0}, 0.2f}}));
    for (int k = 0; k < 90; ++k) half.world.step(h);  // at .1 m/s
    const ClothView view = half.world.cloth(half.cloth).value();
    const std::uint32_t middle = HalfSheet::side * (HalfSheet::side / 2) + HalfSheet::side / 2;
    const auto height = [&](std::uint32_t v) { return view.positions[view.vertex_to_particle[v]].y; };
    EXPECT_GT(height(middle + 1), 0.13f);
    EXPECT_LT(height(middle - 3), height(middle + 3) - 0.02f);
}

TEST(ColliderMasks, OnlyWhatMeetsABoxIsLedOutOfItsMiddle) {
    Mesh mesh;
    for (const float z : {-0.1f, 0.1f}) {
        const auto first = static_cast<std::uint32_t>(mesh.positions.size());
        for (const Vec3& p : {Vec3{0, -0.05f, z}, Vec3{0, 0.05f, z}, Vec3{0.1f, 0.05f, z}})
            mesh.positions.push_back(p);
        mesh.triangles.push_back({first, first + 1, first + 2});
    }
    World world = still_air({});
    const ClothId cloth = world.add_cloth(mesh).value();
    ASSERT_TRUE(world.set_map(cloth, Map::collider_mask, std::vector<float>{1, 1, 1, 2, 2, 2}));
    ASSERT_TRUE(world.add_collider({.shape = Box{.center = {}, .half_extents = {0.3f, 0.2f, 0.3f}}}));
    for (int k = 0; k < 30; ++k) world.step(h);
    const ClothView view = world.cloth(cloth).value();
    for (std::size_t v = 0; v < mesh.positions.size(); ++v) {
        const Vec4& now = view.positions[view.vertex_to_particle[v]];
        const float moved = (xyz(now) - to_vector(mesh.positions[v])).norm();
        if (v < 3)
            EXPECT_GT(moved, 0.03f) << v;
        else
            EXPECT_LT(moved, 1e-6f) << v;
    }
}

TEST(ColliderMasks, OfWeldedVerticesAllBitsCount) {
    const Vec3 corner{0.5f, 0, 0.5f};
    const Mesh mesh{.positions = {{-0.5f, 0, -0.5f}, {0.5f, 0, -0.5f}, {-0.5f, 0, 0.5f}, corner, corner},
                    .triangles = {{0, 2, 3}, {0, 4, 1}}};
    for (const std::uint32_t layers : {1u, 2u}) {
        World world = still_air({});
        const ClothId cloth = world.add_cloth(mesh).value();
        ASSERT_EQ(world.cloth(cloth)->vertex_to_particle[3], world.cloth(cloth)->vertex_to_particle[4]);
        ASSERT_TRUE(world.set_map(cloth, Map::collider_mask, std::vector<float>{0, 0, 0, 1, 2}));
        ASSERT_TRUE(world.add_collider({.shape = Sphere{{0.5f, -0.1f, 0.5f}, 0.12f}, .layers = layers}));
        for (int k = 0; k < 30; ++k) world.step(h);
        const std::uint32_t joined = world.cloth(cloth)->vertex_to_particle[3];
        EXPECT_GT(world.cloth(cloth)->positions[joined].y, 0.02f) << layers;
    }
}

TEST(ColliderMasks, GoOnAfterACut) {
    HalfSheet half;
    const Mesh whole = level_sheet(HalfSheet::side);
    const std::vector<MeshEdge> across{{10 * HalfSheet::side + 9, 10 * HalfSheet::side + 10},
                                       {10 * HalfSheet::side + 10, 10 * HalfSheet::side + 11},
                                       {10 * HalfSheet::side + 11, 10 * HalfSheet::side + 12}};
    const MeshCut cut = cut_mesh(whole, across).value();
    ASSERT_TRUE(half.world.recut_cloth(half.cloth, cut.mesh, cut.from));
    EXPECT_EQ(half.strike(-0.25f, 0.05f), 0);
    EXPECT_GT(half.strike(0.25f, 0.05f), 0.08f);
}

TEST(ColliderMasks, ReportsAndTriggersAreOfWhatMeets) {
    WorldSettings settings{.contact_reports = 1000, .threads = 1};
    World world = World::create(settings).value();
    const ClothId cloth = world.add_cloth(triangles_apart()).value();
    const ColliderId ground = world.add_collider({.shape = Plane{}, .layers = 1}).value();
    const ColliderId trigger =
        world.add_collider({.shape = Plane{.offset = 1}, .layers = 2, .is_trigger = true}).value();
    ASSERT_TRUE(world.set_map(cloth, Map::collider_mask, std::vector<float>{1, 1, 1, 2, 2, 2}));
    for (int k = 0; k < 10; ++k) world.step(h);
    const auto particles = world.cloth(cloth)->vertex_to_particle.subspan(3);
    bool touched = false, triggered = false;
    for (const Contact& contact : world.contacts()) {
        touched = touched || contact.collider == ground;
        triggered = triggered || contact.collider == trigger;
        const bool is_of_second = std::ranges::find(particles, contact.particle) != particles.end();
        EXPECT_EQ(is_of_second, contact.collider == trigger);
    }
    EXPECT_TRUE(touched && triggered);
}

TEST(ColliderMasks, AValueThatIsNoMaskIsNamed) {
    World world = still_air();
    const ClothId cloth = world.add_cloth(triangles_apart()).value();
    const auto error = [&](float value) {
        const auto set = world.set_map(cloth, Map::collider_mask, std::vector<float>{1, 1, 1, 1, value, 1});
        return set ? std::string() : set.error().message;
    };
    EXPECT_EQ(error(0), "");
    EXPECT_EQ(error(most_collider_mask), "");
    EXPECT_NE(error(0.5f).find("Map::collider_mask[4] is 0.5; it must be a whole number"), std::string::npos)
        << error(0.5f);
    EXPECT_NE(error(-1).find("Map::collider_mask[4] is -1"), std::string::npos);
    EXPECT_NE(error(16777216).find("from 0 to 16777215"), std::string::npos) << error(16777216);
}

// On a slope of 0.4 the side of friction 0.6 stays, and that of 0.2 slides by (sin - 0.2 cos) g t^2 / 2.
TEST(FrictionOfSides, IsThatOfTheSideThatTouches) {
    for (const Method& method : {Method(Multilevel{}), Method(Xpbd{})})
        for (const bool by_body : {false, true}) {
            if (by_body && method.index() != 0) continue;  // whose equation has no bodies
            World world = still_air({0.4f * g, -g, 0});
            ClothSettings settings;
            settings.method = method;
            settings.air_damping = 0;
            settings.back_friction_ratio = 1.0f / 3;
            const ClothId cloth = world.add_cloth(triangles_apart(true), settings).value();
            const Collider ground{.shape = Box{{0, -1, 0}, {}, {20, 1, 20}}, .friction = 0.6f};
            const ColliderId floor = world.add_collider(ground).value();
            if (by_body) {
                const BodyId heavy =
                    world.add_body({.mass = 10, .inertia = {1e6f, 1e6f, 1e6f}, .gravity_scale = 0}).value();
                ASSERT_TRUE(world.attach_collider(heavy, floor));
            }
            const float up = world.cloth(cloth)->normals[world.cloth(cloth)->vertex_to_particle[0]].y;
            for (int k = 0; k < 60; ++k) world.step(h);
            const ClothView view = world.cloth(cloth).value();
            const auto x = [&](std::size_t v) { return view.positions[view.vertex_to_particle[v]].x; };
            const std::size_t on_back = up > 0 ? 0 : 3, on_front = 3 - on_back;
            EXPECT_NEAR(x(on_front), 0, 0.005f) << method.index() << by_body;
            EXPECT_NEAR(x(on_back), 0.2f * g / 2, 0.1f) << method.index() << by_body;
        }
}

// A rod that is drawn across a sheet, so thin that only whole triangles meet it, drags the rough side
// farther.
TEST(FrictionOfSides, IsThatOfWholeTriangles) {
    const auto dragged = [](float ratio) {
        World world = still_air({});
        ClothSettings settings;
        settings.back_friction_ratio = ratio;
        settings.air_damping = 0;
        const ClothId cloth = world.add_cloth(level_sheet(11), settings).value();
        const float back = -world.cloth(cloth)->normals[60].y;
        const auto at = [&](int k) {
            const float t = static_cast<float>(k) / 10, y = back * (0.03f - 0.06f * t);
            const float x = 0.02f + 0.3f * t;
            return Collider{.shape = Capsule{{x, y, -0.6f}, {x, y, 0.6f}, 0.002f}, .friction = 0.5f};
        };
        const ColliderId rod = world.add_collider(at(0)).value();
        for (int k = 1; k <= 10; ++k) {
            EXPECT_TRUE(world.move_collider(rod, at(k)));
            world.step(h);
        }
        double mean = 0;
        for (const Vec4& p : world.cloth(cloth)->positions) mean += static_cast<double>(p.x) / 121;
        return mean;
    };
    EXPECT_GT(dragged(1), 3 * dragged(0.1f));
    EXPECT_GT(dragged(0.1f), 0);
}

}  // namespace
}  // namespace weft::test::masks
