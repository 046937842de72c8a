// The dress that ships.

#include <map>
#include <set>

#include <gtest/gtest.h>

#include "demo/character/garment/fitting.h"
#include "demo/character/garment/garment_mesh.h"
#include "demo/character/motion/generated_walk.h"

namespace weft::demo {
namespace {

struct Dressed {
    Skeleton skeleton = plain_skeleton();
    Body body = Body::create(skeleton).value();
    Pose pose;
    std::vector<TaperedCapsule> capsules;
    Dressed() {
        place_joints(skeleton, body.stance(skeleton, Fit().arms), pose);
        body.place(pose, 1, capsules);
    }
    [[nodiscard]] float distance(const Vector3& point) const {
        float least = 1;
        for (const TaperedCapsule& capsule : capsules)
            least = std::min(least, distance_to(capsule, point).distance);
        return least;
    }
};

TEST(Dress, IsATubeRoundTheBody) {
    const Dressed dressed;
    for (const std::uint32_t wanted : {300u, 1000u, 3100u}) {
        const Garment dress = make_dress(dressed.body, dressed.pose, wanted);
        EXPECT_NEAR(static_cast<double>(dress.mesh.positions.size()), wanted, 0.05 * wanted);
        EXPECT_EQ(count_openings(dress.mesh), 2u);
        std::map<std::pair<std::uint32_t, std::uint32_t>, int> edges;
        for (const Triangle& t : dress.mesh.triangles) {
            for (std::size_t c = 0; c < 3; ++c) ++edges[{t[c], t[(c + 1) % 3]}];
            const auto at = [&](std::size_t c) { return to_vector(dress.mesh.positions[t[c]]); };
            const Vector3 middle = (at(0) + at(1) + at(2)) / 3;
            const Vector3 normal = (at(1) - at(0)).cross(at(2) - at(0));
            const Vector3 outwards(middle.x(), 0, middle.z());
            EXPECT_GT(normal.dot(outwards), 0) << "its front is outside";
        }
        for (const auto& [edge, count] : edges)
            EXPECT_EQ(count, 1) << "each side of an edge has one triangle";
    }
}

TEST(Dress, FitsWithNothingInsideTheBody) {
    const Dressed dressed;
    Garment dress = make_dress(dressed.body, dressed.pose);
    const Mesh before = dress.mesh;
    float nearest = 1;
    for (const Triangle& t : dress.mesh.triangles) {
        const auto at = [&](std::size_t c) { return to_vector(dress.mesh.positions[t[c]]); };
        nearest = std::min({nearest, dressed.distance(at(0)), dressed.distance((at(0) + at(1) + at(2)) / 3)});
    }
    EXPECT_GT(nearest, 0.001f);
    const auto fitted = fit(dressed.skeleton, dressed.body, dress);
    ASSERT_TRUE(fitted.ok()) << fitted.error().message;
    EXPECT_EQ(fitted->inside, 0u);
    EXPECT_EQ(fitted->held.size(), dress.fixed.size());
    for (std::size_t i = 0; i < dress.fixed.size(); ++i)
        EXPECT_LT((to_vector(fitted->held[i]) - to_vector(before.positions[dress.fixed[i]])).norm(), 1e-6f)
            << "it stands ready";
}

TEST(Dress, IsHeldByABodiceDownToTheWaist) {
    const Dressed dressed;
    const Garment dress = make_dress(dressed.body, dressed.pose);
    const std::set<std::uint32_t> fixed(dress.fixed.begin(), dress.fixed.end());
    EXPECT_GT(fixed.size(), dress.mesh.positions.size() / 5);
    EXPECT_LT(fixed.size(), dress.mesh.positions.size() / 2);
    float lowest_fixed = 9, highest_free = 0;
    for (std::uint32_t v = 0; v < dress.mesh.positions.size(); ++v) {
        const float y = dress.mesh.positions[v].y;
        if (fixed.contains(v))
            lowest_fixed = std::min(lowest_fixed, y);
        else
            highest_free = std::max(highest_free, y);
    }
    EXPECT_GT(lowest_fixed, highest_free);
    EXPECT_GT(lowest_fixed, dressed.pose.positions[0].y()) << "above the hips";
}

TEST(Fitting, RefusesAGarmentFarFromTheBody) {
    const Dressed dressed;
    Garment dress = make_dress(dressed.body, dressed.pose, 300);
    dress.stands_ready = false;
    dress.from_waist = true;
    for (Vec3& p : dress.mesh.positions) p = {6 * p.x, p.y, 6 * p.z};
    const auto fitted = fit(dressed.skeleton, dressed.body, dress);
    ASSERT_FALSE(fitted.ok());
    EXPECT_NE(fitted.error().message.find("does not fit"), std::string::npos) << fitted.error().message;
}

TEST(Fitting, BringsAGarmentToTheBodyAndGrowsInto) {
    const Dressed dressed;
    Garment dress = make_dress(dressed.body, dressed.pose, 600);
    dress.stands_ready = false;
    dress.fixed = highest_opening(dress.mesh);
    for (Vec3& p : dress.mesh.positions) p = {0.9f * p.x + 4, p.y - 7, 0.9f * p.z + 2};
    const auto fitted = fit(dressed.skeleton, dressed.body, dress);
    ASSERT_TRUE(fitted.ok()) << fitted.error().message;
    EXPECT_GT(fitted->inside, 10u);
    EXPECT_GT(fitted->deepest, 0.002f);
    std::vector<TaperedCapsule> capsules;
    Pose pose;
    place_joints(dressed.skeleton, dressed.body.stance(dressed.skeleton, fitted->arms), pose);
    dressed.body.place(pose, fitted->girth, capsules);
    for (const Vec3& held : fitted->held) {
        float least = 1;
        for (const TaperedCapsule& capsule : capsules)
            least = std::min(least, distance_to(capsule, to_vector(held)).distance);
        EXPECT_NEAR(least, 0.007f, 0.003f);
    }
    EXPECT_LT(growth_at(0, 1), 0.5f);
    EXPECT_EQ(growth_at(1, 1), 1);
    EXPECT_EQ(growth_at(0, 0), 1);
    EXPECT_GT(growth_at(0.6, 1), growth_at(0.4, 1));
}

}  // namespace
}  // namespace weft::demo
