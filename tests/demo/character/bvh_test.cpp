// Recorded motion from BVH files.

#include "demo/character/motion/bvh.h"

#include <numbers>

#include "tests/demo/character/temporary_file.h"

namespace weft::demo {
namespace {

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
