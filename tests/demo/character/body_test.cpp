// A body of capsules from a skeleton's proportions.

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <map>
#include <set>

#include "demo/character/body/binding.h"
#include "demo/character/body/body.h"
#include "demo/character/body/skin.h"
#include "demo/character/character.h"
#include "demo/character/motion/generated_walk.h"

namespace weft::demo {

namespace {

TEST(BodyJoints, AreFoundByTheNamesOfThreeSources) {
    const auto renamed = [](const std::vector<std::pair<std::string, std::string>>& names) {
        Skeleton skeleton = plain_skeleton();
        for (Joint& joint : skeleton.joints) {
            for (const auto& [from, to] : names) {
                if (joint.name == from) joint.name = to;
            }
        }
        return skeleton;
    };
    const Skeleton mixamo = renamed({{"Hips", "mixamorig:Hips"},
                                     {"Chest", "mixamorig:Spine2"},
                                     {"Spine", "mixamorig:Spine"},
                                     {"LeftToes", "mixamorig:LeftToeBase"},
                                     {"RightToes", "RightToe_Base"}});
    const Skeleton cmu = renamed({{"Chest", "thorax"},
                                  {"Neck", "lowerneck"},
                                  {"LeftArm", "lhumerus"},
                                  {"LeftForeArm", "lradius"},
                                  {"LeftHand", "lwrist"},
                                  {"LeftUpLeg", "lfemur"},
                                  {"LeftLeg", "ltibia"},
                                  {"LeftFoot", "lfoot"},
                                  {"LeftToes", "ltoes"}});
    const auto plain = find_body_joints(plain_skeleton());
    ASSERT_TRUE(plain.ok()) << plain.error().message;
    for (const Skeleton& skeleton : {mixamo, cmu}) {
        const auto found = find_body_joints(skeleton);
        ASSERT_TRUE(found.ok()) << found.error().message;
        EXPECT_EQ(found->of_part, plain->of_part);
        EXPECT_EQ(found->spine, plain->spine);
    }
    EXPECT_EQ(plain_skeleton().joints[plain->spine].name, "Spine");
    EXPECT_EQ(std::set<std::size_t>(plain->of_part.begin(), plain->of_part.end()).size(),
              plain->of_part.size());
}

TEST(BodyJoints, FeetWithoutToesPointAhead) {
    const Body with_toes = Body::create(plain_skeleton()).value();
    for (const bool has_ends : {true, false}) {
        Skeleton skeleton = plain_skeleton();
        std::erase_if(skeleton.joints, [](const Joint& joint) { return joint.name == "RightToes"; });
        skeleton.joints.pop_back();  // the right toes' end, the last joint
        if (has_ends)
            skeleton.joints.push_back(
                {"", static_cast<int>(*skeleton.find("RightFoot")), {0, -0.06f, 0.13f}});
        const auto body = Body::create(skeleton);
        ASSERT_TRUE(body.ok()) << body.error().message;
        EXPECT_TRUE(body->joints().has_toes(true));
        EXPECT_FALSE(body->joints().has_toes(false));
        ASSERT_EQ(body->limbs().size(), with_toes.limbs().size());
        const Vector3 foot = body->limbs().back().b.local;  // the right foot's tip, from the ankle
        const Vector3 usual = with_toes.limbs().back().b.local;
        EXPECT_LT((foot - usual).norm(), 0.03f) << foot.transpose() << " beside " << usual.transpose();
        EXPECT_NEAR(body->limbs().back().b.radius, with_toes.limbs().back().b.radius, 0.01f);
    }
}

TEST(BodyJoints, ThatAreMissingAreNamed) {
    Skeleton skeleton = plain_skeleton();
    for (Joint& joint : skeleton.joints) {
        if (joint.name == "LeftLeg" || joint.name == "RightHand") joint.name = "nub";
    }
    const auto body = Body::create(skeleton);
    ASSERT_FALSE(body.ok());
    for (const char* name : {"ltibia", "leftleg", "rightknee", "righthand", "rwrist"})
        EXPECT_EQ(body.error().message.find(name) != std::string::npos, std::string(name) != "rightknee")
            << body.error().message;
}

TEST(Body, OfBonesWithoutLengthIsRefusedByName) {
    Skeleton skeleton = plain_skeleton();
    skeleton.joints[*skeleton.find("LeftFoot")].offset.setZero();
    const auto body = Body::create(skeleton);
    ASSERT_FALSE(body.ok());
    EXPECT_NE(body.error().message.find("LeftLeg and LeftFoot"), std::string::npos) << body.error().message;
}

TEST(Body, IsOnePieceAndTheSameOnBothSides) {
    const Skeleton skeleton = plain_skeleton();
    const auto body = Body::create(skeleton);
    ASSERT_TRUE(body.ok()) << body.error().message;
    Pose pose;
    place_joints(skeleton, body->stance(skeleton, 45), pose);
    std::vector<TaperedCapsule> capsules, smaller;
    body->place(pose, 1, capsules);
    body->place(pose, 0.5f, smaller);
    EXPECT_GE(capsules.size(), 15u);
    EXPECT_LE(capsules.size(), 22u);
    for (const TaperedCapsule& one : capsules) {
        int touching = 0, mirrored = 0;
        for (const TaperedCapsule& other : capsules) {
            const bool same = &one == &other;
            touching += !same && (distance_to(other, to_vector(one.a)).distance < 0 ||
                                  distance_to(other, to_vector(one.b)).distance < 0);
            const auto mirror = [](const Vec3& p) { return Vector3(-p.x, p.y, p.z); };
            mirrored +=
                (mirror(other.a) - to_vector(one.a)).norm() + (mirror(other.b) - to_vector(one.b)).norm() <
                    1e-4f &&
                std::abs(one.radius_a - other.radius_a) < 1e-5f;
        }
        EXPECT_GE(touching, 1);
        EXPECT_EQ(mirrored, 1);
    }
    for (std::size_t i = 0; i < capsules.size(); ++i)
        EXPECT_FLOAT_EQ(smaller[i].radius_a, 0.5f * capsules[i].radius_a);
}

// The skin of a body: closed, where its limbs are, and met by cloth.

float distance_from(const std::vector<TaperedCapsule>& limbs, const Vec3& point) {
    float least = 1;
    for (const TaperedCapsule& limb : limbs)
        least = std::min(least, distance_to(limb, to_vector(point)).distance);
    return least;
}

TEST(Skin, IsClosedAndWhereLimbsAre) {
    const Skeleton skeleton = plain_skeleton();
    const Body body = Body::create(skeleton).value();
    const Skin skin = Skin::round_limbs(body, skeleton, 0.9f);
    ASSERT_GT(skin.size(), 1000u);
    std::map<std::pair<std::uint32_t, std::uint32_t>, int> sides;
    for (const Triangle& t : skin.triangles())
        for (std::size_t c = 0; c < 3; ++c) ++sides[{t[c], t[(c + 1) % 3]}];
    for (const auto& [side, count] : sides) {
        EXPECT_EQ(count, 1);
        EXPECT_EQ(sides.count({side.second, side.first}), 1u) << "one triangle on each side of an edge";
    }
    std::vector<Vec3> places(skin.size());
    for (const auto& [arms, apart, within] : {std::tuple(30.0f, 0.25f, 2e-3f), {60.0f, 0.1f, 0.02f}}) {
        Pose pose;
        place_joints(skeleton, body.stance(skeleton, arms, apart), pose);
        std::vector<TaperedCapsule> limbs;
        body.place(pose, 0.9f, limbs);
        skin.place(pose, limbs, 1, places);
        for (const Vec3& p : places) EXPECT_NEAR(distance_from(limbs, p), 0, within);
        double volume = 0;
        for (const Triangle& t : skin.triangles())
            volume += static_cast<double>(
                to_vector(places[t[0]]).dot(to_vector(places[t[1]]).cross(to_vector(places[t[2]]))) / 6);
        EXPECT_GT(volume, 0.015) << "m^3, outside out";
        EXPECT_LT(volume, 0.08);
    }
}

TEST(Skin, CarriesADress) {
    CharacterSettings settings;
    settings.particles = 600;
    settings.surface = BodySurface::skin;
    settings.cloth.fabric.areal_density = 0.16f;
    auto made = Character::create(settings);
    ASSERT_TRUE(made.ok()) << made.error().message;
    auto world = World::create({.threads = 1});
    ASSERT_TRUE(made->enter(*world).ok());
    ASSERT_EQ(made->colliders().size(), 1u);
    for (int step = 0; step < 120; ++step) {
        made->before_step(*world, step / 60.0, 1.0f / 60);
        ASSERT_FALSE(has(world->step(1.0f / 60).flags, StepFlags::state_restored));
    }
    const ClothView& view = *world->cloth(made->cloth());
    EXPECT_GT(view.bounds.lower.y, 0.25f);
    std::size_t deep = 0;
    for (const Vec4& p : view.positions)
        deep += p.w > 0 && distance_from(made->capsules(), {p.x, p.y, p.z}) < -0.01f ? 1 : 0;
    EXPECT_LT(deep, view.positions.size() / 100) << "but for where limbs fold";
}

// Points that follow a skeleton.

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
