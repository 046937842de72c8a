// Strains by vertex: what a sheet that is stretched, turned or folded by a known amount has.

#include <gtest/gtest.h>

#include <array>
#include <span>
#include <vector>

#include "tests/cloth/fixtures.h"
#include "tests/cloth/meshes.h"

namespace weft::test {
namespace {

using Strains = std::vector<std::array<float, 2>>;

Strains strains_of(const World& world, ClothId cloth) {
    Strains strains(world.cloth(cloth)->vertex_to_particle.size());
    EXPECT_TRUE(
        world.write_vertices(cloth, {.strains = {.bytes = std::as_writable_bytes(std::span(strains))}}));
    return strains;
}

/// The strains of a mesh whose vertices are put where `place` says.
template <class Place>
Strains strains_when(const Mesh& mesh, const Place& place) {
    World world = World::create({}).value();
    const ClothId cloth = world.add_cloth(mesh).value();
    std::vector<Vec3> pose;
    for (const Vec3& x : mesh.positions) pose.push_back(to_vec3(Vector3(place(to_vector(x)))));
    EXPECT_TRUE(world.reset_cloth(cloth, pose));
    return strains_of(world, cloth);
}

void expect_all(const Strains& strains, float warp, float weft) {
    for (const auto& [along_warp, along_weft] : strains) {
        EXPECT_NEAR(along_warp, warp, 2e-5f);
        EXPECT_NEAR(along_weft, weft, 2e-5f);
    }
}

/// A sheet whose rows, and so its warp, run along x.
Mesh level_sheet() {
    return make_sheet({.rows = 7, .columns = 9, .origin = {}, .u = {1, 0, 0}, .v = {0, 0, 0.8f}}).value();
}

TEST(Strains, AreThoseOfTheStretchAlongEachThread) {
    const auto stretched = [](const Vector3& x) { return Vector3(1.2f * x.x(), x.y(), 0.95f * x.z()); };
    expect_all(strains_when(level_sheet(), stretched), 0.2f, -0.05f);
    const Eigen::AngleAxisf turn(1.1f, Vector3(1, 2, -1).normalized());
    expect_all(strains_when(level_sheet(), [&](const Vector3& x) { return Vector3(turn * stretched(x)); }),
               0.2f, -0.05f);
}

TEST(Strains, OfClothThatIsTurnedOrFoldedAreNone) {
    const Eigen::AngleAxisf turn(2.3f, Vector3(-1, 0.3f, 1).normalized());
    expect_all(
        strains_when(level_sheet(), [&](const Vector3& x) { return Vector3(turn * x + Vector3(20, 3, 0)); }),
        0, 0);
    // Folded along its middle, a row of vertices.
    expect_all(strains_when(level_sheet(),
                            [](const Vector3& x) { return Vector3(x.x(), std::abs(x.z() - 0.4f), 0.2f); }),
               0, 0);
}

// Sheared, threads of the warp stay as long as they are, and those of the weft grow.
TEST(Strains, OfShearAreThoseOfTheThreads) {
    const float shear = 0.3f;
    expect_all(strains_when(level_sheet(),
                            [&](const Vector3& x) { return Vector3(x.x() + shear * x.z(), x.y(), x.z()); }),
               0, std::sqrt(1 + shear * shear) - 1);
}

// A pattern says which way the warp runs, and how long cloth is at rest.
TEST(Strains, OfAPatternAreMeasuredFromIt) {
    Mesh mesh = level_sheet();
    mesh.rows = mesh.columns = 0;
    for (const Vec3& x : mesh.positions) mesh.pattern.push_back({x.z / 0.9f, x.x / 1.1f});
    expect_all(strains_when(mesh, [](const Vector3& x) { return x; }), -0.1f, 0.1f);
}

// Between its stretched and its slack half, a vertex has the mean.
TEST(Strains, AreTheMeanOfTheTrianglesRound) {
    const Strains strains = strains_when(level_sheet(), [](const Vector3& x) {
        return Vector3(std::max(x.x() - 0.5f, 0.0f) * 0.4f + x.x(), 0, x.z());
    });
    for (std::size_t v = 0; v < strains.size(); ++v) {
        const std::size_t column = v % 9;
        EXPECT_NEAR(strains[v][0],
                    column < 4   ? 0
                    : column > 4 ? 0.4f
                                 : 0.2f,
                    column == 4 ? 0.08f : 1e-4f)
            << v;
    }
}

// Cloth that hangs has a strain of the weight below over its stiffness.
TEST(Strains, OfAHungStripAreItsWeightOverItsStiffness) {
    World world = World::create(vacuum(downwards)).value();
    ClothSettings settings;
    settings.fabric.areal_density = 0.4f;
    settings.fabric.warp = settings.fabric.weft = 100;
    settings.fabric.shear = 0;
    settings.air_damping = 5;
    const Mesh mesh =
        make_sheet({.rows = 21, .columns = 5, .origin = {0, 2, 0}, .u = {0.2f, 0, 0}, .v = {0, -1, 0}})
            .value();
    const ClothId cloth = world.add_cloth(mesh, settings).value();
    ASSERT_TRUE(world.pin(cloth, std::vector<std::uint32_t>{0, 1, 2, 3, 4}));
    for (int k = 0; k < 400; ++k) world.step(h);
    const Strains strains = strains_of(world, cloth);
    for (std::size_t row = 1; row < 20; ++row) {
        const float below = 1 - static_cast<float>(row) / 20;
        EXPECT_NEAR(strains[5 * row + 2][1], 0.4f * 9.81f * below / 100, 2e-3f) << "row " << row;
        EXPECT_NEAR(strains[5 * row + 2][0], 0, 2e-3f);
    }
}

TEST(Strains, NeedRoom) {
    World world = World::create({}).value();
    const ClothId cloth = world.add_cloth(level_sheet()).value();
    Strains few(10);
    const auto answer =
        world.write_vertices(cloth, {.strains = {.bytes = std::as_writable_bytes(std::span(few))}});
    ASSERT_FALSE(answer);
    EXPECT_NE(answer.error().message.find("VertexStreams::strains has 80 bytes; 63 vertices take 504"),
              std::string::npos)
        << answer.error().message;
}

}  // namespace
}  // namespace weft::test
