// Which borders push a vertex that is over a face, and which edges push where faces are as near.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <span>
#include <utility>
#include <vector>

#include "cloth/contact/feature_contact.h"
#include "tests/collision/contact/contact_reference.h"
#include "tests/laid_out.h"

namespace weft::test::borders_and_faces {
namespace {

constexpr float h = 0.01f, gamma = 0.01f, edge = 0.02f;

struct Surface {
    std::vector<Vec4> points;
    std::vector<ContactMesh::Triangle> triangles;
};

/// A triangle that points down. Its first corner, the tip, is 4 mm above the plane y = 0.
Surface tip() {
    return {{{0, 0.004f, 0, 1}, {-0.5f, 1, 0.1f, 1}, {0.5f, 1, -0.1f, 1}}, {{0, 1, 2}}};
}
/// Two triangles in the plane y = 0, whose common side is 3 mm from what is below the tip.
Surface floor() {
    return {{{0.003f, 0, -1, 1}, {0.003f, 0, 1, 1}, {-1, 0, 0, 1}, {1, 0, 0, 1}}, {{0, 1, 2}, {1, 0, 3}}};
}
/// A triangle lies at this height on the side x > 0. Its border along z is `aside` from the tip's plane x =
/// 0.
Surface ledge(float height, float aside) {
    return {{{aside, height, -1, 1}, {aside, height, 1, 1}, {1, height, 0, 1}}, {{0, 1, 2}}};
}

/// Two triangles that make a roof of this slope, whose ridge is along x at y = 0; or, turned round, a valley
/// 4 mm above it whose lowest line is along z.
Surface roof(float slope) {
    constexpr float half = 0.02f, wide = 0.03f;
    const float low = -slope * wide;
    return {{{-half, 0, 0, 1}, {half, 0, 0, 1}, {0, low, wide, 1}, {0, low, -wide, 1}},
            {{0, 1, 2}, {1, 0, 3}}};
}
Surface valley(float slope) {
    Surface surface = roof(slope);
    for (Vec4& p : surface.points) p = {p.z, 0.004f - p.y, p.x, 1};
    return surface;
}
/// Small faces 2 mm below the ends of a roof's ridge, and 2 mm above those of a valley's line.
Surface behind_ridges() {
    Surface surface;
    const auto add = [&](float x, float y, float z) { surface.points.push_back({x, y, z, 1}); };
    for (const float end : {-1.0f, 1.0f}) {
        for (const auto& [out, aside] : {std::pair(0.0196f, -5e-4f), {0.0196f, 5e-4f}, {0.021f, 0.0f}})
            add(end * out, -0.002f, aside);
        for (const auto& [out, aside] : {std::pair(0.0196f, -5e-4f), {0.0196f, 5e-4f}, {0.021f, 0.0f}})
            add(aside, 0.006f, end * out);
    }
    for (std::uint32_t k = 0; k < 12; k += 3) surface.triangles.push_back({k, k + 1, k + 2});
    return surface;
}
/// A flat sheet of 8 x 8 particles at this height, turned about the normal.
Surface sheet(float height, float turn) {
    constexpr std::uint32_t side = 8;
    Surface surface;
    for (std::uint32_t i = 0; i < side * side; ++i) {
        const float u = edge * (static_cast<float>(i % side) - 3.5f),
                    v = edge * (static_cast<float>(i / side) - 3.5f);
        surface.points.push_back(
            {std::cos(turn) * u - std::sin(turn) * v, height, std::sin(turn) * u + std::cos(turn) * v, 1});
    }
    surface.triangles = grid_triangles(side, side);
    return surface;
}

struct Pushed {
    int tip = 0;                     ///< pairs of the first surface's first point with triangles
    int ridges = 0;                  ///< pairs of the first two points of each surface, as edges
    int of_faces = 0, of_edges = 0;  ///< pairs with all corners near the middle
};

/// The pairs that push, in a first substep of surfaces that stand still.
Pushed pushed(const std::vector<Surface>& surfaces) {
    std::vector<ContactMesh> meshes;
    for (const Surface& surface : surfaces) meshes.emplace_back(surface.points, surface.triangles);
    std::vector<ContactCloth> bodies;
    for (const ContactMesh& mesh : meshes) bodies.push_back({.mesh = &mesh, .radius = 0.02f, .floor = 1e-4f});
    LaidOut<FeatureContact> space{std::span<const ContactCloth>(bodies), static_cast<ImpactZones*>(nullptr)};
    Parallel parallel(1);
    const std::vector<Vec4> still(64);
    for (std::size_t k = 0; k < surfaces.size(); ++k)
        space.place(parallel, k, surfaces[k].points,
                    {.velocities = std::span(still).first(surfaces[k].points.size()), .h = h});
    bool is_crowd = false;
    space.detect(parallel, is_crowd);
    for (std::size_t k = 0; k < surfaces.size(); ++k) space.set_base(parallel, k, surfaces[k].points);
    space.make_rows(parallel, gamma);
    space.rows().linearise(parallel);
    const auto is_inside = [&](std::uint32_t corner) {
        std::size_t body = surfaces.size() - 1;
        while (corner < space.first(body)) --body;
        const Vec4& at = surfaces[body].points[corner - space.first(body)];
        return std::hypot(at.x, at.z) < 2 * edge;
    };
    Pushed count;
    space.rows().for_each_active([&](const PairRows::ActivePair& active) {
        const std::span<const std::uint32_t> corners = active.pair.corners;
        count.tip += corners[0] == space.first(0) && corners[1] >= space.first(1);
        const auto is_of_ridge = [&](std::uint32_t corner) {
            return corner - space.first(0) < 2 || (surfaces.size() > 1 && corner - space.first(1) < 2);
        };
        count.ridges += std::ranges::all_of(corners, is_of_ridge);
        if (std::ranges::all_of(corners, is_inside))
            ++(active.shape.weights.x < 1 ? count.of_edges : count.of_faces);
    });
    return count;
}
int pushes_on_tip(const std::vector<Surface>& surfaces) {
    return pushed(surfaces).tip;
}

TEST(BordersAndFaces, WhatIsOverAFaceIsNotPushedAsideByItsBorders) {
    EXPECT_EQ(pushes_on_tip({tip(), floor()}), 1);
    EXPECT_EQ(pushes_on_tip({tip(), ledge(0, 0.003f)}), 1) << "beside a border, and over no face";
}

TEST(BordersAndFaces, BordersThatAreNearerOrOnTheOtherSidePush) {
    EXPECT_EQ(pushes_on_tip({tip(), floor(), ledge(0.002f, 0.001f)}), 2) << "between the two";
    EXPECT_EQ(pushes_on_tip({tip(), floor(), ledge(0.008f, 0.003f)}), 2) << "above the tip";
    EXPECT_EQ(pushes_on_tip({tip(), floor(), ledge(0.001f, 0.006f)}), 1) << "farther than the face";
}

TEST(BordersAndFaces, EdgesLeaveTheirForceToFacesAsNear) {
    for (const float turn : {0.1f, 0.7f, 1.4f}) {
        const Pushed flat = pushed({sheet(0, 0), sheet(0.004f, turn)});
        EXPECT_GT(flat.of_faces, 10) << turn;
        EXPECT_EQ(flat.of_edges, 0) << turn;
        const Pushed between = pushed({sheet(0, 0), sheet(0.004f, turn), sheet(0.009f, 0.3f)});
        EXPECT_GT(between.of_faces, 20) << turn << ": each side of the middle one is pushed";
        EXPECT_EQ(between.of_edges, 0) << turn;
    }
}

TEST(BordersAndFaces, EdgesPushWhereNoFaceIsAsNear) {
    EXPECT_EQ(pushed({roof(2), valley(2)}).ridges, 1) << "no face is near";
    EXPECT_EQ(pushed({roof(0.2f), valley(0.2f)}).ridges, 1) << "faces at the ends are farther";
    EXPECT_EQ(pushed({roof(2), valley(2), behind_ridges()}).ridges, 1) << "faces are near on the other side";
}

}  // namespace
}  // namespace weft::test::borders_and_faces
