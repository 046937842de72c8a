// The drawn figure of a body: one closed surface within the limbs that cloth meets, which keeps its girth.

#include <gtest/gtest.h>

#include <algorithm>
#include <map>

#include "demo/character/figure/body_figure.h"
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

}  // namespace
}  // namespace weft::demo
