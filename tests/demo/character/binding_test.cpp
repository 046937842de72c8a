// What a skeleton carries along.

#include "demo/character/body/binding.h"

#include <limits>

#include <gtest/gtest.h>

#include "demo/character/motion/generated_walk.h"

namespace weft::demo {
namespace {

struct Bound {
    Skeleton skeleton = plain_skeleton();
    Body body = Body::create(skeleton).value();
    JointAngles stance = body.stance(skeleton, 45);
    Pose pose;
    Bound() { place_joints(skeleton, stance, pose); }
    [[nodiscard]] Vec3 beside(Part part, const Vector3& by) const {
        return to_vec3(pose.positions[body.joints()[part]] + by);
    }
};

TEST(Binding, LeavesPointsWhereTheyAreAndGoesAlongWithAll) {
    const Bound bound;
    const std::vector<Vec3> points{
        bound.beside(Part::hips, {0.12f, 0.05f, 0.1f}), bound.beside(Part::chest, {0, 0, 0.14f}),
        bound.beside(Part::left_forearm, {0, 0.05f, 0}), bound.beside(Part::right_shin, {0.3f, 0, 0.2f})};
    const Quaternion turn(Eigen::AngleAxisf(0.7f, Vector3(1, 2, -1).normalized()));
    JointAngles moved = bound.stance;
    moved.rotations[0] = turn * moved.rotations[0];
    moved.root = Vector3(3, 1, 2);
    Pose pose;
    place_joints(bound.skeleton, moved, pose);
    for (const Blending blending : {Blending::rigid, Blending::linear_blend}) {
        const Binding binding = Binding::to_nearest(bound.body, bound.pose, points, blending);
        std::vector<Vec3> placed(points.size());
        binding.place(bound.pose, placed);
        for (std::size_t i = 0; i < points.size(); ++i)
            EXPECT_LT((to_vector(placed[i]) - to_vector(points[i])).norm(), 1e-5f);
        binding.place(pose, placed);
        for (std::size_t i = 0; i < points.size(); ++i) {
            const Vector3 expected = moved.root + turn * (to_vector(points[i]) - bound.stance.root);
            EXPECT_LT((to_vector(placed[i]) - expected).norm(), 1e-5f);
        }
    }
}

TEST(Binding, HoldsToTheNearestLimb) {
    const Bound bound;
    const std::vector<Vec3> points{to_vec3(0.5f * (to_vector(bound.beside(Part::left_shin, {0, 0, 0.06f})) +
                                                   to_vector(bound.beside(Part::left_foot, {0, 0, 0.06f}))))};
    JointAngles moved = bound.stance;
    const std::size_t shin = bound.body.joints()[Part::left_shin];
    const Quaternion bend(Eigen::AngleAxisf(1.0f, Vector3::UnitX()));
    moved.rotations[shin] = moved.rotations[shin] * bend;
    Pose pose;
    place_joints(bound.skeleton, moved, pose);
    std::vector<Vec3> placed(1);
    Binding::to_nearest(bound.body, bound.pose, points, Blending::rigid).place(pose, placed);
    const Vector3 local =
        bound.pose.rotations[shin].conjugate() * (to_vector(points[0]) - bound.pose.positions[shin]);
    EXPECT_LT((to_vector(placed[0]) - pose.at(shin, local)).norm(), 1e-5f);
    Binding::to_nearest(bound.body, bound.pose, points).place(pose, placed);
    EXPECT_LT((to_vector(placed[0]) - pose.at(shin, local)).norm(), 0.01f);
}

TEST(Binding, RefusesWeightsThatAreNoneWithTheirPoint) {
    const Bound bound;
    const std::vector<Vec3> points(2);
    const std::vector<std::uint32_t> joints{0, 0, 0, 0, 1, 0, 0, 0};
    const std::vector<float> weights{1, 0, 0, 0, 1, 0, 0, 0};
    EXPECT_TRUE(Binding::by_weights(bound.pose, points, joints, weights).ok());
    const auto refusal = [&](std::vector<std::uint32_t> j, std::vector<float> w) {
        const auto binding = Binding::by_weights(bound.pose, points, j, w);
        return binding.ok() ? std::string() : binding.error().message;
    };
    EXPECT_NE(refusal(joints, {1, 0, 0, 0}).find("4 weights for 2 points"), std::string::npos);
    EXPECT_NE(refusal({0, 0, 0, 0}, weights).find("4 joints"), std::string::npos);
    EXPECT_NE(refusal({0, 0, 0, 0, 99, 0, 0, 0}, weights).find("point 1 hangs on joint 99"),
              std::string::npos);
    EXPECT_NE(refusal(joints, {1, 0, 0, 0, -1, 2, 0, 0}).find("point 1 has a weight of -1"),
              std::string::npos);
    EXPECT_NE(refusal(joints, {0, 0, 0, 0, 1, 0, 0, 0}).find("point 0 has weights that sum to 0"),
              std::string::npos);
    const float nan = std::numeric_limits<float>::quiet_NaN();
    EXPECT_NE(refusal(joints, {1, 0, 0, 0, nan, 0, 0, 0}).find("point 1"), std::string::npos);
}

}  // namespace
}  // namespace weft::demo
