// The drawn figure of a body: one closed surface within the limbs that cloth meets, which keeps its girth.

#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <set>

#include "demo/character/figure/figure.h"
#include "demo/character/garment/fitting.h"
#include "demo/character/garment/garment_mesh.h"
#include "demo/character/motion/generated_walk.h"

namespace weft::demo {

namespace {

float distance_from(const std::vector<TaperedCapsule>& limbs, const Vector3& point) {
    float least = 1;
    for (const TaperedCapsule& limb : limbs) least = std::min(least, distance_to(limb, point).distance);
    return least;
}

/// A figure in one pose of a motion after another.
class Posed {
  public:
    explicit Posed(const Gait& gait)
        : walk_(gait),
          body_(Body::create(walk_.skeleton()).value()),
          figure_(body_, walk_.skeleton(), 56),
          places_(figure_.figure().size()) {}

    void go_to(double time) {
        walk_.evaluate(time, angles_);
        pose();
    }
    void stand() {
        angles_ = body_.stance(walk_.skeleton(), 75);
        pose();
    }
    void turn(Part part, float by, const Vector3& axis) {
        Quaternion& joint = angles_.rotations[body_.joints()[part]];
        joint = joint * Quaternion(Eigen::AngleAxisf(by, axis));
        pose();
    }

    [[nodiscard]] const Figure& figure() const { return figure_.figure(); }
    [[nodiscard]] const std::vector<TaperedCapsule>& limbs() const { return limbs_; }
    [[nodiscard]] const TaperedCapsule& limb(LimbKind kind) const {
        const auto& all = body_.limbs();
        return limbs_[static_cast<std::size_t>(std::ranges::find(all, kind, &Limb::kind) - all.begin())];
    }
    [[nodiscard]] Vector3 place(std::uint32_t vertex) const { return to_vector(places_[vertex]); }
    [[nodiscard]] double volume() const {
        double volume = 0;
        for (const Triangle& t : figure().triangles())
            volume += static_cast<double>(place(t[0]).dot(place(t[1]).cross(place(t[2]))) / 6);
        return volume;
    }

  private:
    void pose() {
        place_joints(walk_.skeleton(), angles_, pose_);
        body_.place(pose_, 1, limbs_);
        figure_.place(pose_, limbs_, places_);
    }

    GeneratedWalk walk_;
    Body body_;
    BodyFigure figure_;
    JointAngles angles_;
    Pose pose_;
    std::vector<TaperedCapsule> limbs_;
    std::vector<Vec3> places_;
};

TEST(Figure, IsOneClosedSurfaceOfAFewThousandTriangles) {
    const Posed posed{Gait{}};
    const std::vector<Triangle>& triangles = posed.figure().triangles();
    EXPECT_GT(triangles.size(), 3000u);
    EXPECT_LT(triangles.size(), 15000u);
    std::map<std::pair<std::uint32_t, std::uint32_t>, int> sides;
    for (const Triangle& t : triangles)
        for (std::size_t c = 0; c < 3; ++c) ++sides[{t[c], t[(c + 1) % 3]}];
    for (const auto& [side, count] : sides) EXPECT_EQ((sides[{side.second, side.first}]), count);

    std::vector<std::uint32_t> piece(posed.figure().size(), ~0u);
    piece[0] = 0;
    for (bool grows = true; std::exchange(grows, false);)
        for (const Triangle& t : triangles)
            for (std::size_t c = 0; c < 3; ++c)
                if (piece[t[c]] == 0 && piece[t[(c + 1) % 3]] != 0) {
                    piece[t[(c + 1) % 3]] = 0;
                    grows = true;
                }
    EXPECT_EQ(std::ranges::count(piece, 0u), static_cast<std::ptrdiff_t>(piece.size())) << "one piece";
}

TEST(Figure, IsWithinTheLimbsThatClothMeets) {
    for (const Gait& gait : {Gait{}, running}) {
        Posed posed(gait);
        for (int k = 0; k < 20; ++k) {
            posed.go_to(gait.period * k / 20);
            float most = -1;
            for (const Triangle& t : posed.figure().triangles()) {
                const Vector3 a = posed.place(t[0]), b = posed.place(t[1]), c = posed.place(t[2]);
                for (const Vector3& p : {a, Vector3(0.5f * (a + b)), Vector3((a + b + c) / 3)})
                    most = std::max(most, distance_from(posed.limbs(), p));
            }
            EXPECT_LT(most, 1e-3f) << "[m] outside";
        }
    }
}

TEST(Figure, KeepsItsGirthWhereJointsBend) {
    Posed posed{Gait{}};
    posed.stand();
    const double straight = posed.volume();
    EXPECT_GT(straight, 0.025) << "[m^3], outside out";
    EXPECT_LT(straight, 0.06);
    posed.turn(Part::left_forearm, -1.6f, Vector3::UnitY());
    posed.turn(Part::right_shin, 1.6f, Vector3::UnitX());
    EXPECT_NEAR(posed.volume() / straight, 1, 0.02);
}

/// Skinning by rotations of joints alone makes a forearm as thin as a thread where its hand is turned round.
TEST(Figure, IsNotWrungByAHandThatTurns) {
    Posed posed{Gait{}};
    const auto thinnest = [&] {
        const TaperedCapsule& forearm = posed.limb(LimbKind::forearm);
        const Vector3 a = to_vector(forearm.a), axis = to_vector(forearm.b) - a;
        float least = 1;
        for (std::uint32_t v = 0; v < posed.figure().size(); ++v) {
            const Vector3 from_a = posed.place(v) - a;
            const float along = from_a.dot(axis) / axis.squaredNorm();
            const float radius = forearm.radius_a + along * (forearm.radius_b - forearm.radius_a);
            if (along > 0.2f && along < 0.8f)
                least = std::min(least, (from_a - along * axis).norm() / radius);
        }
        return least;
    };
    posed.stand();
    EXPECT_GT(thinnest(), 0.85f);
    posed.turn(Part::left_hand, 2.8f, Vector3::UnitX());
    EXPECT_GT(thinnest(), 0.85f);
}

// The dress that ships.

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
