// Which borders push a vertex that is over a face.

#include <gtest/gtest.h>

#include <span>
#include <vector>

#include "cloth/contact/feature_contact.h"
#include "tests/laid_out.h"

namespace weft::test::borders_and_faces {
namespace {

constexpr float h = 0.01f, gamma = 0.01f;

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

/// How many pairs with triangles push the tip, which is the first surface's first point.
int pushes_on_tip(const std::vector<Surface>& surfaces) {
    std::vector<ContactMesh> meshes;
    for (const Surface& surface : surfaces) meshes.emplace_back(surface.points, surface.triangles);
    std::vector<ContactCloth> bodies;
    for (const ContactMesh& mesh : meshes) bodies.push_back({.mesh = &mesh, .radius = 0.02f, .floor = 1e-4f});
    LaidOut<FeatureContact> space{std::span<const ContactCloth>(bodies), static_cast<ImpactZones*>(nullptr)};
    Parallel parallel(1);
    const std::vector<Vec4> still(4);
    for (std::size_t k = 0; k < surfaces.size(); ++k)
        space.place(parallel, k, surfaces[k].points, {.velocities = still, .h = h});
    bool is_crowd = false;
    space.detect(parallel, is_crowd);
    for (std::size_t k = 0; k < surfaces.size(); ++k) space.set_base(parallel, k, surfaces[k].points);
    space.make_rows(parallel, gamma);
    space.rows().linearise(parallel);
    int count = 0;
    space.rows().for_each_active([&](const PairRows::ActivePair& active) {
        const std::span<const std::uint32_t> corners = active.pair.corners;
        count += corners[0] == space.first(0) && corners[1] >= space.first(1);
    });
    return count;
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

}  // namespace
}  // namespace weft::test::borders_and_faces
