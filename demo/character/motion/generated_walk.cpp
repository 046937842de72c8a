#include "demo/character/motion/generated_walk.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace weft::demo {
namespace {

constexpr float sole_height = 0.035f;  // height of the lowest joint while a foot is on the ground [m]

// Joints of plain_skeleton(), by number.
enum PlainJoint : std::size_t {
    hips,
    spine,
    chest,
    neck,
    head,
    left_collar = 6,
    left_leg = 11,
    right_collar = 16,
    right_leg = 21
};
// After a collar: arm, forearm, hand, end. After a leg: shin, foot, toes, end.

Quaternion turned(float degrees, const Vector3& axis) {
    return Quaternion(Eigen::AngleAxisf(degrees * std::numbers::pi_v<float> / 180, axis));
}

/// side: 1 left, -1 right.
void add_limbs(Skeleton& skeleton, const std::string& name, float side) {
    std::vector<Joint>& joints = skeleton.joints;
    const auto add = [&](const char* joint, int parent, float x, float y, float z) {
        joints.push_back({*joint == '\0' ? std::string() : name + joint, parent, {side * x, y, z}});
        return static_cast<int>(joints.size()) - 1;
    };
    const int collar = add("Collar", chest, 0.02f, 0.10f, 0);
    const int arm = add("Arm", collar, 0.155f, 0.03f, -0.01f);
    const int forearm = add("ForeArm", arm, 0.27f, 0, 0);
    const int hand = add("Hand", forearm, 0.245f, 0, 0);
    add("", hand, 0.16f, 0, 0);
    const int thigh = add("UpLeg", hips, 0.092f, -0.09f, 0);
    const int shin = add("Leg", thigh, 0, -0.42f, 0);
    const int foot = add("Foot", shin, 0, -0.40f, -0.01f);
    const int toes = add("Toes", foot, 0, -0.045f, 0.12f);
    add("", toes, 0, 0, 0.06f);
}

}  // namespace

Skeleton plain_skeleton() {
    Skeleton skeleton;
    skeleton.joints = {{"Hips", -1, {0, 0, 0}},
                       {"Spine", hips, {0, 0.11f, 0}},
                       {"Chest", spine, {0, 0.13f, 0}},
                       {"Neck", chest, {0, 0.14f, -0.01f}},
                       {"Head", neck, {0, 0.10f, 0.015f}},
                       {"", head, {0, 0.17f, 0}}};
    add_limbs(skeleton, "Left", 1);
    add_limbs(skeleton, "Right", -1);
    return skeleton;
}

void put_on_ground(const Skeleton& skeleton, float sole, JointAngles& angles, Pose& pose) {
    place_joints(skeleton, angles, pose);
    const auto lowest = std::ranges::min(pose.positions, {}, [](const Vector3& p) { return p.y(); });
    angles.root.y() += sole - lowest.y();
}

GeneratedWalk::GeneratedWalk(const Gait& gait) : gait_(gait), skeleton_(plain_skeleton()) {}

void GeneratedWalk::evaluate(double time, JointAngles& angles) {
    const double phase = 2 * std::numbers::pi * std::fmod(time / gait_.period, 1.0);
    const auto wave = [&](double amplitude, double times, double shift) {
        return static_cast<float>(amplitude * std::cos(times * phase - shift));
    };
    const Vector3 x = Vector3::UnitX(), y = Vector3::UnitY(), z = Vector3::UnitZ();
    angles = JointAngles::at_rest(skeleton_);
    const auto turn = [&](std::size_t joint, const Quaternion& by) { angles.rotations[joint] = by; };
    turn(hips, turned(wave(5, 1, 0.3), y) * turned(wave(3, 1, -1.2), z) * turned(gait_.lean, x));
    turn(spine, turned(wave(-6, 1, 0.3), y) * turned(wave(-2, 1, -1.2), z));
    turn(chest, turned(wave(-6, 1, 0.3), y) * turned(-2, x));
    turn(neck, turned(wave(5, 1, 0.3), y));
    for (const double side : {1.0, -1.0}) {
        const double half = side > 0 ? 0 : std::numbers::pi;  // the right leg is half a period behind
        const std::size_t collar = side > 0 ? left_collar : right_collar,
                          leg = side > 0 ? left_leg : right_leg;
        const auto s = static_cast<float>(side);
        // The foot comes forward while the knee is bent; the heel is set down at phase 0.
        const float hip =
            static_cast<float>(gait_.hip) + wave(gait_.hip_wave, 1, half) + wave(2, 2, 2 * half + 0.6);
        const float swing = 0.5f + wave(0.5, 1, half - 1.25);
        const float knee = static_cast<float>(gait_.knee) +
                           static_cast<float>(gait_.knee_wave) * swing * swing * swing +
                           wave(5, 2, 2 * half - 0.9);
        turn(leg, turned(-hip, x) * turned(2 * s, z));
        turn(leg + 1, turned(knee, x));
        turn(leg + 2, turned(hip - knee + wave(gait_.ankle_wave, 1, half + 2.6) + 2, x));
        const float forward = static_cast<float>(gait_.arm) - wave(gait_.arm_wave, 1, half);
        turn(collar + 1, turned(-forward, x) * turned(-gait_.arm_down * s, z));
        turn(collar + 2, turned(-(static_cast<float>(gait_.elbow) - wave(gait_.elbow_wave, 1, half)) * s, y));
    }
    angles.root = {wave(0.015, 1, -1.4), 0, 0};
    put_on_ground(skeleton_, sole_height, angles, pose_);
    if (gait_.flight > 0)
        angles.root.y() += static_cast<float>(0.5 * gait_.flight) + wave(0.5 * gait_.flight, 2, 1.9);
}

}  // namespace weft::demo
