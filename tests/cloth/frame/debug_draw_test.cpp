// World::debug_draw: the lines that a host gets.

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <limits>
#include <map>
#include <string>
#include <vector>

#include "tests/cloth/fixtures.h"
#include "weft/weft.h"

namespace weft::test::drawn {
namespace {

struct Line {
    Vec3 from, to, colour;
};

struct Drawing {
    std::vector<Line> lines;
    std::vector<std::string> words;

    static Drawing of(const World& world, DebugParts parts) {
        Drawing drawing;
        const DebugCanvas canvas{
            .user = &drawing,
            .line =
                [](void* user, const Vec3& from, const Vec3& to, const Vec3& colour) {
                    static_cast<Drawing*>(user)->lines.push_back({from, to, colour});
                },
            .text = [](void* user, const Vec3&, const char* words,
                       const Vec3&) { static_cast<Drawing*>(user)->words.emplace_back(words); }};
        world.debug_draw(canvas, parts);
        return drawing;
    }
};

float length(const Line& line) {
    return std::hypot(line.to.x - line.from.x, line.to.y - line.from.y, line.to.z - line.from.z);
}

ClothId add_sheet(World& world, const ClothSettings& settings = {}) {
    const Mesh mesh = make_sheet({.rows = 5, .columns = 4, .origin = {0, 1, 0}}).value();
    return world.add_cloth(mesh, settings).value();
}

TEST(DebugDraw, EdgesAreGreyAtRestAndRedWhereTheyAreLonger) {
    World world = World::create().value();
    const ClothId cloth = add_sheet(world);
    const Drawing rest = Drawing::of(world, DebugParts::strain);
    EXPECT_EQ(rest.lines.size(), world.cloth_info(cloth)->structural_springs);
    for (const Line& line : rest.lines) EXPECT_NEAR(line.colour.x, line.colour.z, 1e-3f);
    ASSERT_TRUE(world.pin(cloth, std::vector<std::uint32_t>{0, 3, 16, 19}));
    const Vec4 corner = world.cloth(cloth)->positions[0];
    ASSERT_TRUE(world.move_pin(cloth, 0, {corner.x - 0.3f, corner.y, corner.z}));
    for (int i = 0; i < 30; ++i) world.step(h);
    const Drawing pulled = Drawing::of(world, DebugParts::strain);
    const Line longest = *std::ranges::max_element(pulled.lines, {}, length);
    EXPECT_GT(longest.colour.x, 0.99f);
    EXPECT_LT(longest.colour.z, 0.2f);
}

TEST(DebugDraw, CollidersAreLinesOnTheirSurfaces) {
    World world = World::create().value();
    add_sheet(world);
    const auto drawn = [&](const Collider& collider) {
        const ColliderId id = world.add_collider(collider).value();
        const Drawing drawing = Drawing::of(world, DebugParts::colliders);
        EXPECT_TRUE(world.remove_collider(id));
        return drawing.lines;
    };
    for (const Line& line : drawn({.shape = Sphere{{1, 2, 3}, 0.5f}}))
        EXPECT_NEAR(std::hypot(line.from.x - 1, line.from.y - 2, line.from.z - 3), 0.5f, 1e-5f);
    // Of two balls of one size the lines between run along the axis; of others where the cone touches both.
    const auto cone = drawn({.shape = TaperedCapsule{{0, 0, 0}, {1, 0, 0}, 0.3f, 0.1f}});
    const auto sides = std::span(cone).last(4);
    for (const Line& line : sides) {
        EXPECT_NEAR(std::hypot(line.from.x, line.from.y, line.from.z), 0.3f, 1e-5f);
        EXPECT_NEAR(std::hypot(line.to.x - 1, line.to.y, line.to.z), 0.1f, 1e-5f);
        const float along = (line.to.x - line.from.x) * line.from.x +
                            (line.to.y - line.from.y) * line.from.y + (line.to.z - line.from.z) * line.from.z;
        EXPECT_NEAR(along, 0, 1e-5f);
    }
    const auto box = drawn({.shape = Box{{0, 1, 0}, {0, 0, std::sin(0.25f), std::cos(0.25f)}, {1, 2, 3}}});
    EXPECT_EQ(box.size(), 12u);
    std::vector<float> lengths;
    for (const Line& line : box) lengths.push_back(length(line));
    std::ranges::sort(lengths);
    EXPECT_NEAR(lengths[0], 2, 1e-4f);
    EXPECT_NEAR(lengths[5], 4, 1e-4f);
    EXPECT_NEAR(lengths[11], 6, 1e-4f);
    for (const Line& line : drawn({.shape = Plane{{0, 2, 0}, -0.5f}})) {
        EXPECT_NEAR(line.from.y, -0.5f, 1e-5f);
        EXPECT_NEAR(line.to.y, -0.5f, 1e-5f);
    }
}

TEST(DebugDraw, PlanesReachUnderAllCloths) {
    World world = World::create().value();
    for (const float x : {-20.0f, 30.0f}) {
        const ClothId cloth = add_sheet(world);
        ASSERT_TRUE(world.move_cloth(cloth, {.translation = {x, 0, 0}}));
    }
    ASSERT_TRUE(world.add_collider({.shape = Plane{{0, 1, 0}, 0}}));
    float least = 0, most = 0;
    for (const Line& line : Drawing::of(world, DebugParts::colliders).lines) {
        least = std::min({least, line.from.x, line.to.x});
        most = std::max({most, line.from.x, line.to.x});
    }
    EXPECT_LT(least, -20);
    EXPECT_GT(most, 30);
}

TEST(DebugDraw, HeldShapesAreWhereTheirInstancesAre) {
    World world = World::create().value();
    const std::array<Vec3, 4> vertices{{{0, 0, 0}, {0.2f, 0, 0}, {0, 0.2f, 0}, {0, 0, 0.2f}}};
    const std::array<std::array<std::uint32_t, 3>, 4> triangles{{{0, 2, 1}, {0, 1, 3}, {0, 3, 2}, {1, 2, 3}}};
    const ShapeId mesh = world.add_shape(TriangleMesh{vertices, triangles}).value();
    const std::array<float, 6> heights{0, 0, 0, 0, 0.5f, 0};
    const ShapeId ground = world.add_shape(HeightField{2, 3, 1, heights}).value();
    ASSERT_TRUE(world.add_collider({.shape = PlacedShape{mesh, {5, 0, 0}}}));
    EXPECT_EQ(Drawing::of(world, DebugParts::colliders).lines.size(), 12u);
    for (const Line& line : Drawing::of(world, DebugParts::colliders).lines) EXPECT_GE(line.from.x, 5);
    ASSERT_TRUE(world.add_collider({.shape = PlacedShape{ground}}));
    EXPECT_EQ(Drawing::of(world, DebugParts::colliders).lines.size(), 12u + 7u);
}

TEST(DebugDraw, PinsContactsAndSpeedsAreSeen) {
    WorldSettings settings;
    settings.contact_reports = 64;
    World world = World::create(settings).value();
    const ClothId cloth = add_sheet(world);
    ASSERT_TRUE(world.pin(cloth, 0));
    EXPECT_EQ(Drawing::of(world, DebugParts::pins).lines.size(), 3u);
    ASSERT_TRUE(world.move_pin(cloth, 0, {0, 2, 0}));
    EXPECT_EQ(Drawing::of(world, DebugParts::pins).lines.size(), 4u);
    ASSERT_TRUE(world.move_pin(cloth, 0, {0, 1, 0}));
    ASSERT_TRUE(world.add_collider({.shape = Plane{{0, 1, 0}, 0.8f}}));
    for (int i = 0; i < 30; ++i) world.step(h);
    ASSERT_GT(world.contacts().size(), 0u);
    const Drawing contacts = Drawing::of(world, DebugParts::contacts);
    ASSERT_EQ(contacts.lines.size(), world.contacts().size());
    for (const Line& line : contacts.lines) EXPECT_GT(line.to.y, line.from.y);
    const Drawing speeds = Drawing::of(world, DebugParts::velocities);
    ASSERT_EQ(speeds.lines.size(), 20u);
    const auto view = *world.cloth(cloth);
    EXPECT_NEAR(length(speeds.lines[19]),
                h * std::hypot(view.velocities[19].x, view.velocities[19].y, view.velocities[19].z), 1e-6f);
}

TEST(DebugDraw, WordsSayWhatAClothDoes) {
    World world = World::create().value();
    ClothSettings settings;
    settings.sleep_speed = 1000;
    const ClothId cloth = add_sheet(world, settings);
    EXPECT_EQ(Drawing::of(world, DebugParts::cloths).words,
              std::vector<std::string>{"cloth 0: 20 particles, awake"});
    for (int i = 0; i < 40; ++i) world.step(h);
    EXPECT_EQ(Drawing::of(world, DebugParts::cloths).words,
              std::vector<std::string>{"cloth 0: 20 particles, asleep"});
    ASSERT_TRUE(world.set_enabled(cloth, false));
    EXPECT_EQ(Drawing::of(world, DebugParts::cloths).words,
              std::vector<std::string>{"cloth 0: 20 particles, off"});
}

TEST(DebugDraw, NormalsStartAtParticlesAndAreHalfAnEdgeLong) {
    World world = World::create().value();
    const ClothId cloth = add_sheet(world);
    const Drawing drawing = Drawing::of(world, DebugParts::normals);
    ASSERT_EQ(drawing.lines.size(), 20u);
    for (std::size_t i = 0; i < 20; ++i) {
        EXPECT_EQ(drawing.lines[i].from.x, world.cloth(cloth)->positions[i].x);
        EXPECT_NEAR(drawing.lines[i].to.y - 1, 0.5f * world.cloth_info(cloth)->mean_edge, 1e-5f);
    }
}

TEST(DebugDraw, LeashesAreRedAtTheirEndsAndBackstopsAreMarked) {
    World world = World::create().value();
    const ClothId cloth = add_sheet(world);
    EXPECT_TRUE(Drawing::of(world, DebugParts::leashes).lines.empty());
    std::vector<float> leashes(20, 0.1f);
    leashes[7] = std::numeric_limits<float>::infinity();
    ASSERT_TRUE(world.set_map(cloth, Map::leash, leashes));
    EXPECT_TRUE(Drawing::of(world, DebugParts::leashes).lines.empty()) << "nobody has said where the skin is";
    std::vector<Vec3> places, up(20, Vec3{0, 1, 0});
    for (const Vec4& p : world.cloth(cloth)->positions) places.push_back({p.x, p.y, p.z});
    ASSERT_TRUE(world.set_skin(cloth, places, {}));
    for (const Line& line : Drawing::of(world, DebugParts::leashes).lines) EXPECT_GT(line.colour.y, 0.8f);
    for (int i = 0; i < 60; ++i) world.step(h);  // it falls to where all are taut
    const Drawing taut = Drawing::of(world, DebugParts::leashes);
    ASSERT_EQ(taut.lines.size(), 19u) << "one has none";
    const Line longest = *std::ranges::max_element(taut.lines, {}, length);
    EXPECT_NEAR(length(longest), 0.1f, 1e-4f);
    EXPECT_NEAR(longest.from.y, 1, 1e-5f) << "from the skin";
    EXPECT_GT(longest.colour.x, 0.99f);
    ASSERT_TRUE(world.set_map(cloth, Map::leash, {}));
    ASSERT_TRUE(world.set_map(cloth, Map::backstop, std::vector<float>(20, 0.25f)));
    ASSERT_TRUE(world.set_skin(cloth, places, up));
    const Drawing stops = Drawing::of(world, DebugParts::leashes);
    ASSERT_EQ(stops.lines.size(), 3 * 20u);
    const Line& cross = stops.lines[1];  // along y
    EXPECT_NEAR(0.5f * (cross.from.y + cross.to.y), 0.75f, 1e-5f) << "behind the skin";
}

TEST(DebugDraw, LevelsAreFewerTheCoarserAndOnlyOfTheMultilevelMethod) {
    World world = World::create().value();
    const Mesh mesh = make_sheet({.rows = 40, .columns = 40}).value();
    const ClothId cloth = world.add_cloth(mesh).value();
    const Drawing drawing = Drawing::of(world, DebugParts::levels);
    std::map<int, std::size_t> count_of;  // by length, in halves of an edge
    const auto view = *world.cloth(cloth);
    const float edge = world.cloth_info(cloth)->mean_edge;
    for (const Line& line : drawing.lines) {
        ++count_of[static_cast<int>(std::lround(length(line) / (0.5f * edge)))];
        const auto at_line = [&](const Vec4& p) {
            return std::abs(p.x - 0.5f * (line.from.x + line.to.x)) < 1e-5f &&
                   std::abs(p.z - 0.5f * (line.from.z + line.to.z)) < 1e-5f;
        };
        EXPECT_TRUE(std::ranges::any_of(view.positions, at_line)) << "at a particle";
    }
    ASSERT_GE(count_of.size(), 2u);
    std::size_t before = 3 * 1600u;
    for (const auto& [level, count] : count_of) {
        EXPECT_LT(count, before) << level;
        EXPECT_EQ(count % 3, 0u);
        before = count;
    }
    ClothSettings settings;
    settings.method = Jacobi{};
    ASSERT_TRUE(world.set_cloth_settings(cloth, settings));
    EXPECT_TRUE(Drawing::of(world, DebugParts::levels).lines.empty());
}

TEST(DebugDraw, CostsAreThoseOfTheLastStep) {
    World world = World::create().value();
    const ClothId cloth = add_sheet(world);
    world.step(h);
    const Drawing drawing = Drawing::of(world, DebugParts::costs);
    ASSERT_EQ(drawing.words.size(), 1u);
    std::array<char, 96> expected{};
    std::snprintf(expected.data(), expected.size(), "cloth 0: %.3f of %.3f ms",
                  static_cast<double>(world.cloth_report(cloth)->milliseconds),
                  static_cast<double>(world.report().milliseconds));
    EXPECT_EQ(drawing.words[0], expected.data());
}

TEST(DebugDraw, OnlyWhatIsAskedForAndNothingWithoutACanvas) {
    World world = World::create().value();
    add_sheet(world);
    EXPECT_TRUE(Drawing::of(world, DebugParts::none).lines.empty());
    EXPECT_TRUE(Drawing::of(world, DebugParts::tangles).lines.empty());
    world.debug_draw({}, DebugParts::all);
}

TEST(DebugDraw, TanglesAreMarkedUntilTheyAreGone) {
    World world = World::create().value();
    ClothSettings settings;
    settings.self_collision = {.method = SelfCollisionMethod::contact};
    for (const float turn : {0.0f, 1.0f}) {
        const Mesh mesh = make_sheet({.rows = 15,
                                      .columns = 15,
                                      .origin = {0.1f * turn, 1 + 0.1f * turn, 0},
                                      .u = {0.3f, -0.2f * turn, 0},
                                      .v = {0, 0, 0.3f}})
                              .value();
        ASSERT_TRUE(world.add_cloth(mesh, settings));
    }
    world.step(h);
    ASSERT_GT(world.report().crossings, 0u);
    EXPECT_GT(Drawing::of(world, DebugParts::tangles).lines.size(), 0u);
}

}  // namespace
}  // namespace weft::test::drawn
