// Motions go on for ever, and nothing in them jumps.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "demo/character/body/body.h"
#include "demo/character/motion/generated_walk.h"
#include "demo/character/motion/motion.h"
#include "tests/demo/character/temporary_file.h"
#include "tests/demo/garments.h"

namespace weft::demo {

namespace {

/// Greatest speed and change of speed of any joint, seen at short steps over `seconds`.
struct Roughness {
    float speed = 0, acceleration = 0;
};
Roughness roughness(Motion& motion, double begin, double seconds) {
    constexpr double step = 1.0 / 60;
    Roughness found;
    JointAngles angles;
    std::vector<Vector3> before, velocity;
    Pose pose;
    for (double t = begin; t < begin + seconds; t += step) {
        motion.evaluate(t, angles);
        place_joints(motion.skeleton(), angles, pose);
        std::vector<Vector3> now;
        for (std::size_t j = 0; j < pose.positions.size() && !before.empty(); ++j) {
            now.push_back((pose.positions[j] - before[j]) / static_cast<float>(step));
            found.speed = std::max(found.speed, now.back().norm());
            if (velocity.empty()) continue;
            found.acceleration =
                std::max(found.acceleration, (now.back() - velocity[j]).norm() / static_cast<float>(step));
        }
        before = pose.positions;
        velocity = now;
    }
    return found;
}

/// Somebody of three joints who swings a limb with a period of 40 frames while they walk off along x.
Recording swinging(std::size_t frames) {
    Recording recording;
    recording.skeleton.joints = {{"a", -1, Vector3::Zero()}, {"b", 0, {0, -1, 0}}, {"", 1, {0, -1, 0}}};
    for (std::size_t f = 0; f < frames; ++f) {
        JointAngles angles = JointAngles::at_rest(recording.skeleton);
        const float phase = 2 * std::numbers::pi_v<float> * static_cast<float>(f) / 40;
        angles.rotations[1] = Quaternion(Eigen::AngleAxisf(0.5f * std::sin(phase), Vector3::UnitX()));
        angles.root = {0.02f * static_cast<float>(f), 1 + 0.01f * std::cos(2 * phase), 3};
        recording.frames.push_back(angles);
    }
    return recording;
}

TEST(RecordedMotion, GoesRoundAfterWholePeriods) {
    RecordedMotion motion(swinging(130));
    const double periods = motion.period() / (40.0 / 60);
    EXPECT_NEAR(periods, std::round(periods), 1e-9) << motion.period();
    EXPECT_NEAR(motion.velocity().x(), 1.2f, 1e-3f);
    JointAngles early, late;
    for (const double t : {0.0, 0.31, 0.9}) {
        motion.evaluate(t, early);
        motion.evaluate(t + 3 * motion.period(), late);
        EXPECT_LT(early.rotations[1].angularDistance(late.rotations[1]), 1e-3f);
        EXPECT_LT((early.root - late.root).norm(), 1e-3f);
        EXPECT_LT(std::abs(early.root.x()), 0.05f) << "it stays on the spot";
        EXPECT_NEAR(early.rotations[1].angularDistance(Quaternion::Identity()),
                    std::abs(0.5 * std::sin(2 * std::numbers::pi * t * 1.5)), 0.01);
    }
}

TEST(RecordedMotion, DoesNotJumpWhereItsEndIsFarFromItsBeginning) {
    for (const std::size_t frames : {70u, 93u, 131u}) {
        RecordedMotion motion(swinging(frames));
        const Roughness all = roughness(motion, 0, 4);
        // The swing itself has 0.5 * 2 m * 9.4 /s = 9.4 m/s; a jump of a limb would be 60 m/s and more.
        EXPECT_LT(all.speed, 14) << frames;
        EXPECT_LT(all.acceleration, 330) << frames;
    }
}

TEST(RecordedMotion, OfOneFrameStandsStill) {
    RecordedMotion motion(swinging(1));
    EXPECT_EQ(roughness(motion, 0, 1).speed, 0);
}

class RealMotion : public testing::TestWithParam<const char*> {};

TEST_P(RealMotion, IsAsSmoothAtItsEndsAsWithin) {
    WEFT_NEEDS_DATA();
    auto recording = read_bvh(data_folder() / "motion" / (std::string(GetParam()) + ".bvh"));
    ASSERT_TRUE(recording.ok()) << recording.error().message;
    EXPECT_TRUE(Body::create(recording->skeleton).ok());
    RecordedMotion motion(std::move(*recording));
    const Roughness within = roughness(motion, 0.3, motion.period() - 0.35);
    const Roughness across = roughness(motion, motion.period() - 0.1, 0.45);
    EXPECT_LT(across.speed, 1.3f * within.speed);
    EXPECT_LT(across.acceleration, 1.3f * within.acceleration);
    EXPECT_GT(motion.velocity().z(), 0.8f) << "they go ahead";
    JointAngles angles;
    for (double t = 0; t < 2 * motion.period(); t += 0.05) {
        motion.evaluate(t, angles);
        EXPECT_LT(std::hypot(angles.root.x(), angles.root.z()), 0.25f) << t;
    }
}

INSTANTIATE_TEST_SUITE_P(Files, RealMotion, testing::Values("walk", "run"),
                         [](const auto& file) { return std::string(file.param); });

TEST(GeneratedWalk, Walks) {
    GeneratedWalk walk;
    const auto joints = find_body_joints(walk.skeleton());
    ASSERT_TRUE(joints.ok()) << joints.error().message;
    EXPECT_LT(roughness(walk, 0, 2.2).acceleration, 90);
    JointAngles angles, later;
    Pose pose;
    float left_ahead = 0, right_ahead = 0;
    for (double t = 0; t < GeneratedWalk::period; t += 0.02) {
        walk.evaluate(t, angles);
        walk.evaluate(t + 7 * GeneratedWalk::period, later);
        place_joints(walk.skeleton(), angles, pose);
        const auto at = [&](Part part) { return pose.positions[(*joints)[part]]; };
        EXPECT_LT((angles.root - later.root).norm(), 1e-4f);
        const float lowest = std::ranges::min(pose.positions, {}, [](const Vector3& p) { return p.y(); }).y();
        EXPECT_NEAR(lowest, 0.035f, 1e-5f);
        // A knee is before the line from hip to ankle.
        for (const auto& [hip, knee, ankle] :
             {std::array{Part::left_thigh, Part::left_shin, Part::left_foot},
              std::array{Part::right_thigh, Part::right_shin, Part::right_foot}})
            EXPECT_GT((2 * at(knee) - at(hip) - at(ankle)).z(), -0.03f) << t;
        left_ahead = std::max(left_ahead, at(Part::left_foot).z() - at(Part::right_foot).z());
        right_ahead = std::max(right_ahead, at(Part::right_foot).z() - at(Part::left_foot).z());
        // Arms go against the legs.
        const float legs = at(Part::left_foot).z() - at(Part::right_foot).z();
        const float arms = at(Part::left_hand).z() - at(Part::right_hand).z();
        if (std::abs(legs) > 0.4f) {
            EXPECT_LT(legs * arms, 0) << t;
        }
    }
    EXPECT_GT(left_ahead, 0.45f);
    EXPECT_NEAR(left_ahead, right_ahead, 0.03f);
}

TEST(Performance, GoesFromStandingIntoTheMotion) {
    auto walk = std::make_unique<GeneratedWalk>();
    const Skeleton skeleton = walk->skeleton();
    JointAngles stance = JointAngles::at_rest(skeleton);
    stance.root.y() = 0.9f;
    Performance performance(std::move(walk), stance, 0.5, 1.0, 2.0);
    EXPECT_EQ(performance.at(0.3).root, stance.root);
    EXPECT_EQ(performance.at(0.5).rotations[7].coeffs(), stance.rotations[7].coeffs());

    GeneratedWalk own;
    JointAngles expected;
    own.evaluate(2 * 1.6, expected);
    const JointAngles& after = performance.at(0.5 + 1.6);
    for (std::size_t j = 0; j < skeleton.size(); ++j)
        EXPECT_LT(after.rotations[j].angularDistance(expected.rotations[j]), 1e-3f);

    own.evaluate(2 * 0.5, expected);
    const JointAngles& half = performance.at(0.5 + 0.5);
    EXPECT_NEAR(half.rotations[7].angularDistance(stance.rotations[7]),
                half.rotations[7].angularDistance(expected.rotations[7]), 1e-3f);
}

// Recorded motion from BVH files.

const std::string two_joints = R"(HIERARCHY
ROOT Hips
{
  OFFSET 0 0 0
  CHANNELS 6 Xposition Yposition Zposition Zrotation Xrotation Yrotation
  JOINT Knee
  {
    OFFSET 0 -0.5 0.1
    CHANNELS 3 Yrotation Zrotation Xrotation
    End Site
    {
      OFFSET 0 -0.4 0
    }
  }
}
MOTION
Frames: 2
Frame Time: 0.02
1 2 3 10 20 30 40 50 60
4 5 6 0 0 0 0 0 0
)";

Quaternion about(const Vector3& axis, float degrees) {
    return Quaternion(Eigen::AngleAxisf(degrees * std::numbers::pi_v<float> / 180, axis));
}

TEST(Bvh, TurnsInTheOrderOfTheChannels) {
    const TemporaryFile file("order.bvh", two_joints);
    const auto recording = read_bvh(file.path());
    ASSERT_TRUE(recording.ok()) << recording.error().message;
    ASSERT_EQ(recording->skeleton.size(), 3u);
    EXPECT_EQ(recording->skeleton.joints[1].name, "Knee");
    EXPECT_TRUE(recording->skeleton.joints[2].name.empty());
    EXPECT_EQ(recording->frame_time, 0.02);
    ASSERT_EQ(recording->frames.size(), 2u);

    const Vector3 x = Vector3::UnitX(), y = Vector3::UnitY(), z = Vector3::UnitZ();
    const Quaternion hips = about(z, 10) * about(x, 20) * about(y, 30);
    const Quaternion knee = hips * about(y, 40) * about(z, 50) * about(x, 60);
    Pose pose;
    place_joints(recording->skeleton, recording->frames[0], pose);
    EXPECT_LT((pose.positions[0] - Vector3(1, 2, 3)).norm(), 1e-6f);
    EXPECT_LT((pose.positions[1] - (Vector3(1, 2, 3) + hips * Vector3(0, -0.5f, 0.1f))).norm(), 1e-5f);
    EXPECT_LT((pose.positions[2] - pose.positions[1] - knee * Vector3(0, -0.4f, 0)).norm(), 1e-5f);
    place_joints(recording->skeleton, recording->frames[1], pose);
    EXPECT_LT((pose.positions[2] - Vector3(4, 4.1f, 6.1f)).norm(), 1e-5f);
}

TEST(Bvh, TakesLengthsOfGiantsForCentimetres) {
    std::string text = two_joints;
    text.replace(text.find("0 -0.5 0.1"), 10, "0 -50 10");
    const TemporaryFile file("centimetres.bvh", text);
    const auto recording = read_bvh(file.path());
    ASSERT_TRUE(recording.ok()) << recording.error().message;
    EXPECT_NEAR(recording->skeleton.joints[1].offset.y(), -0.5f, 1e-6f);
    EXPECT_NEAR(recording->frames[0].root.z(), 0.03f, 1e-6f);
}

struct Fault {
    const char *from, *to;
    std::vector<const char*> named;
};

TEST(Bvh, ErrorsNameTheLineAndTheValue) {
    const std::vector<Fault> faults{
        {"HIERARCHY", "HIERARCH", {":1:", "\"HIERARCH\"", "\"HIERARCHY\""}},
        {"OFFSET 0 -0.5 0.1", "OFFSET 0 up 0.1", {":8:", "\"up\"", "an offset"}},
        {"CHANNELS 3", "CHANNELS 7", {":9:", "\"7\"", "0 to 6"}},
        {"CHANNELS 3", "CHANNELS 2.5", {":9:", "\"2.5\""}},
        {"Yrotation Zrotation Xrotation",
         "Yrotation Wrotation Xrotation",
         {":9:", "\"Wrotation\"", "Xposition"}},
        {"End Site", "Limb Site", {":10:", "\"Limb\"", "\"JOINT\""}},
        {"Frames: 2", "Frames: 0", {":17:", "\"0\"", "1 to"}},
        {"0.02", "-1", {":18:", "\"-1\""}},
        {"40 50 60", "40 nan 60", {":19:", "\"nan\"", "frame 1's Zrotation of Knee"}},
        {"4 5 6 0 0 0 0 0 0", "4 5 6 0 0 0 0 0", {":21:", "the file ends", "frame 2's Xrotation of Knee"}},
        {"Frames: 2", "Frames: 3", {"the file ends", "frame 3's Xposition of Hips"}},
    };
    for (const Fault& fault : faults) {
        std::string text = two_joints;
        text.replace(text.find(fault.from), std::string(fault.from).size(), fault.to);
        const TemporaryFile file("fault.bvh", text);
        const auto recording = read_bvh(file.path());
        ASSERT_FALSE(recording.ok()) << fault.to;
        EXPECT_EQ(recording.error().code, ErrorCode::malformed_file);
        for (const char* name : fault.named)
            EXPECT_NE(recording.error().message.find(name), std::string::npos)
                << name << " in " << recording.error().message;
    }
    const auto missing = read_bvh("no/such.bvh");
    ASSERT_FALSE(missing.ok());
    EXPECT_EQ(missing.error().code, ErrorCode::file_not_found);
    EXPECT_NE(missing.error().message.find("no/such.bvh"), std::string::npos);
}

TEST(Bvh, RefusesHierarchiesWithoutEnd) {
    std::string text = "HIERARCHY\nROOT a\n{ OFFSET 0 0 0 CHANNELS 0\n";
    for (int i = 0; i < 2000; ++i) text += "JOINT b { OFFSET 0 1 0 CHANNELS 0\n";
    const TemporaryFile file("deep.bvh", text);
    const auto recording = read_bvh(file.path());
    ASSERT_FALSE(recording.ok());
    EXPECT_NE(recording.error().message.find("1024"), std::string::npos) << recording.error().message;
}

}  // namespace

}  // namespace weft::demo
