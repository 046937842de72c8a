#include "demo/character/garment/garment_mesh.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <set>

#include "tests/demo/garments.h"

namespace weft::demo {
namespace {

constexpr std::uint32_t around = 12;

/// A tube along +Z from 0 to 1, radius 0.5, slit along one line of its pattern as sewn cloth is: the seam's
/// two sides are two vertices at one position.
Mesh tube() {
    Mesh mesh;
    for (std::uint32_t ring = 0; ring < 3; ++ring) {
        for (std::uint32_t i = 0; i <= around; ++i) {
            const float angle = 2 * 3.14159265f * static_cast<float>(i % around) / around;
            const float height = 0.5f * static_cast<float>(ring);
            mesh.positions.push_back({0.5f * std::cos(angle), 0.5f * std::sin(angle), height});
            mesh.pattern.push_back({2 * 3.14159265f * 0.5f * static_cast<float>(i) / around, height});
        }
    }
    const auto at = [](std::uint32_t ring, std::uint32_t i) { return ring * (around + 1) + i; };
    for (std::uint32_t ring = 0; ring < 2; ++ring) {
        for (std::uint32_t i = 0; i < around; ++i) {
            mesh.triangles.push_back({at(ring, i), at(ring, i + 1), at(ring + 1, i + 1)});
            mesh.triangles.push_back({at(ring, i), at(ring + 1, i + 1), at(ring + 1, i)});
        }
    }
    return mesh;
}

std::size_t distinct_positions(const Mesh& mesh) {
    std::set<std::array<float, 3>> positions;
    for (const Vec3& p : mesh.positions) positions.insert({p.x, p.y, p.z});
    return positions.size();
}

TEST(GarmentMesh, StandsOnItsLowestPoint) {
    Mesh mesh = tube();
    stand_upright(mesh, 0.3f);
    const auto height = [](const Vec3& p) { return p.y; };
    EXPECT_NEAR(std::ranges::min(mesh.positions, {}, height).y, 0.3f, 1e-6);
    EXPECT_NEAR(std::ranges::max(mesh.positions, {}, height).y, 1.3f, 1e-6);
    // The first vertex was at (0.5, 0, 0); rotation about +X keeps it on the +X side.
    EXPECT_NEAR(mesh.positions[0].x, 0.5f, 1e-6);
}

TEST(GarmentMesh, HangsByItsHighestOpeningOncePerPosition) {
    Mesh mesh = tube();
    stand_upright(mesh, 0);
    const std::vector<std::uint32_t> ring = highest_opening(mesh);
    EXPECT_EQ(ring.size(), around) << "the seam is one position, and no opening";
    for (const std::uint32_t vertex : ring) EXPECT_NEAR(mesh.positions[vertex].y, 1, 1e-6);
}

TEST(GarmentMesh, HangsAClosedMeshByItsTop) {
    Mesh tetrahedron;
    tetrahedron.positions = {{0, 0, 0}, {1, 0, 0}, {0, 0, 1}, {0, 1, 0}};
    tetrahedron.triangles = {{0, 1, 2}, {0, 2, 3}, {0, 3, 1}, {1, 3, 2}};
    EXPECT_EQ(highest_opening(tetrahedron), std::vector<std::uint32_t>{3});
}

TEST(GarmentMesh, RefinementQuartersTrianglesAndKeepsSeamsSewn) {
    const Mesh coarse = tube();
    const Mesh fine = refined(coarse);
    EXPECT_EQ(fine.triangles.size(), 4 * coarse.triangles.size());
    EXPECT_EQ(fine.pattern.size(), fine.positions.size());
    // A slit tube of 3 rings becomes one of 5 with twice the points; seams welded, each ring closes.
    EXPECT_EQ(distinct_positions(fine), 5u * 2u * around);
}

TEST(GarmentMesh, DropsAPatternThatIsNotInMetres) {
    Mesh metres = tube(), unit = tube();
    for (Vec2& p : unit.pattern) p = {0.1f * p.x, 0.1f * p.y};
    drop_unfit_pattern(metres);
    drop_unfit_pattern(unit);
    EXPECT_FALSE(metres.pattern.empty());
    EXPECT_TRUE(unit.pattern.empty());
}

}  // namespace
}  // namespace weft::demo
