// A body of capsules from a skeleton's proportions.

#include "demo/character/body/body.h"

#include <cmath>
#include <set>

#include <gtest/gtest.h>

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

}  // namespace
}  // namespace weft::demo
