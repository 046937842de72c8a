// Layers of one cloth, which self-collision keeps apart.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "tests/cloth/fixtures.h"
#include "tests/cloth/meshes.h"

namespace weft::test {
namespace {

constexpr std::uint32_t side = 12;
constexpr float spacing = 0.02f, length = spacing * (side - 1);

/// A horizontal square of side * side particles.
Mesh square(std::uint32_t particles = side, float size = length) {
    return make_sheet({.rows = particles, .columns = particles, .u = {size, 0, 0}, .v = {0, 0, size}})
        .value();
}

/// Two squares, the upper one `gap` above the other: particles [0, side^2) are the lower one's vertices.
Mesh two_layers(float gap) {
    Mesh one = square();
    one.rows = one.columns = 0;
    return joined(one, one, {0, gap, 0});
}

ClothSettings with_distance(float distance, float friction = 0.3f) {
    ClothSettings settings;
    settings.air_damping = 0;
    settings.self_collision = {
        .method = SelfCollisionMethod::avoidance, .distance = distance, .friction = friction};
    return settings;
}

/// The least distance between a vertex of the first half of the mesh and one of the second [m].
float least_gap(const ClothView& view) {
    const std::size_t half = view.vertex_to_particle.size() / 2;
    float least = std::numeric_limits<float>::infinity();
    for (std::size_t a = 0; a < half; ++a)
        for (std::size_t b = half; b < 2 * half; ++b)
            least = std::min(least, (xyz(view.positions[view.vertex_to_particle[a]]) -
                                     xyz(view.positions[view.vertex_to_particle[b]]))
                                        .norm());
    return least;
}

TEST(Layers, ThatStartCloserThanTheDistanceArePushedApart) {
    for (const float gap : {0.0005f, 0.001f, 0.004f}) {
        World world = World::create(vacuum()).value();
        const ClothId id = world.add_cloth(two_layers(gap), with_distance(0.005f)).value();
        for (int step = 0; step < 60; ++step) world.step(h);
        EXPECT_GT(least_gap(world.cloth(id).value()), 0.99f * 0.005f) << gap;
    }
}

TEST(Layers, OfAFlatPatternThatStartFoldedArePushedApart) {
    // One piece, folded over in the middle when it starts. Near the fold the layers are near along the cloth.
    Mesh mesh =
        make_sheet({.rows = 2 * side, .columns = side, .u = {length, 0, 0}, .v = {0, 0, 2 * length}}).value();
    mesh.rows = mesh.columns = 0;
    for (const Vec3& p : mesh.positions) mesh.pattern.push_back({p.x, p.z});
    const float fold = -0.5f + length;
    for (Vec3& p : mesh.positions)
        if (p.z > fold) p = {p.x, p.y + 0.001f, 2 * fold - p.z};
    World world = World::create(vacuum()).value();
    const ClothId id = world.add_cloth(mesh, with_distance(0.01f)).value();
    for (int step = 0; step < 30; ++step) world.step(h);
    const ClothView view = world.cloth(id).value();
    float least = std::numeric_limits<float>::infinity();
    for (std::size_t a = 0; a < mesh.positions.size(); ++a) {
        for (std::size_t b = a + 1; b < mesh.positions.size(); ++b) {
            if (std::abs(mesh.pattern[a].y - mesh.pattern[b].y) < 0.05f) continue;
            least = std::min(least, (xyz(view.positions[view.vertex_to_particle[a]]) -
                                     xyz(view.positions[view.vertex_to_particle[b]]))
                                        .norm());
        }
    }
    EXPECT_GT(least, 0.6f * 0.01f);
}

TEST(Layers, WithoutADistanceAreKeptApartByThreeQuartersOfAnEdge) {
    World world = World::create(vacuum()).value();
    const ClothId id = world.add_cloth(two_layers(0.002f), with_distance(0)).value();
    const float distance = 0.75f * world.cloth_info(id).value().mean_edge;
    EXPECT_GT(distance, 0.7f * spacing);
    for (int step = 0; step < 60; ++step) world.step(h);
    EXPECT_GT(least_gap(world.cloth(id).value()), 0.98f * distance);
}

TEST(Layers, FineClothAtRestStaysAtRestWhateverTheDistance) {
    for (const float edges : {0.75f, 2.1f, 3.3f, 6.5f}) {
        for (const bool is_grid : {true, false}) {
            Mesh mesh = square();
            if (!is_grid) mesh.rows = mesh.columns = 0;
            World world = World::create(vacuum()).value();
            const ClothId id = world.add_cloth(mesh, with_distance(edges * spacing)).value();
            for (int step = 0; step < 10; ++step) EXPECT_EQ(world.step(h).self_contacts, 0u) << edges;
            const ClothView view = world.cloth(id).value();
            for (std::size_t v = 0; v < mesh.positions.size(); ++v)
                EXPECT_LT(
                    (xyz(view.positions[view.vertex_to_particle[v]]) - to_vector(mesh.positions[v])).norm(),
                    1e-5f)
                    << edges;
        }
    }
}

TEST(Layers, ANewDistanceHoldsFromTheNextStepOn) {
    World world = World::create(vacuum()).value();
    const ClothId id = world.add_cloth(two_layers(0.001f), with_distance(0.002f)).value();
    for (int step = 0; step < 30; ++step) world.step(h);
    EXPECT_TRUE(world.set_cloth_settings(id, with_distance(2.5f * spacing)));
    for (int step = 0; step < 120; ++step) world.step(h);
    EXPECT_GT(least_gap(world.cloth(id).value()), 0.9f * 2.5f * spacing);
}

TEST(Layers, AreNotReportedOnceSelfCollisionIsOff) {
    World world = World::create(vacuum()).value();
    ClothSettings settings = with_distance(0.005f);
    const ClothId id = world.add_cloth(two_layers(0.001f), settings).value();
    EXPECT_GT(world.step(h).self_contacts, 100u);
    settings.self_collision.method = SelfCollisionMethod::off;
    ASSERT_TRUE(world.set_cloth_settings(id, settings));
    EXPECT_EQ(world.step(h).self_contacts, 0u);
    EXPECT_EQ(world.report().peak_self_contacts, 0u);
}

TEST(Layers, ADistanceOfVeryManyEdgesIsRefusedByName) {
    World world = World::create(vacuum()).value();
    const auto refused = world.add_cloth(square(64), with_distance(0.5f * length));
    ASSERT_FALSE(refused.ok());
    EXPECT_NE(refused.error().message.find("SelfCollision::distance is 0.11"), std::string::npos)
        << refused.error().message;

    const ClothId id = world.add_cloth(square(64), {}).value();
    EXPECT_FALSE(world.set_cloth_settings(id, with_distance(0.5f * length)).ok());
    EXPECT_EQ(world.cloth_settings(id).value().self_collision.method, SelfCollisionMethod::off);
}

/// How far a layer that lies on a pinned one has gone along a slope in a second [m].
float slid(float slope, float friction, int substeps) {
    WorldSettings settings = vacuum({9.81f * slope, -9.81f, 0});
    settings.substeps = substeps;
    World world = World::create(settings).value();
    const float distance = 0.6f * spacing;
    const ClothId id =
        world.add_cloth(two_layers(1.001f * distance), with_distance(distance, friction)).value();
    for (std::uint32_t v = 0; v < side * side; ++v) EXPECT_TRUE(world.pin(id, v));
    const std::uint32_t middle = side * side + side * side / 2 + side / 2;
    const auto x = [&] {
        const ClothView view = world.cloth(id).value();
        return view.positions[view.vertex_to_particle[middle]].x;
    };
    const float start = x();
    for (int step = 0; step < 60; ++step) world.step(h);
    return x() - start;
}

TEST(Layers, ALayerRestsOnAnotherBelowTheFrictionAngle) {
    for (const int substeps : {1, 4}) {
        EXPECT_NEAR(slid(0.1f, 0.5f, substeps), 0, 3e-3f) << substeps;
        EXPECT_GT(slid(0.5f, 0, substeps), 0.01f) << substeps;
    }
}

}  // namespace
}  // namespace weft::test
