#include "demo/character/motion/skeleton.h"

#include <algorithm>
#include <cctype>

#include "engine/least_turn.h"

namespace weft::demo {
namespace {

std::string plain_name(std::string_view name) {
    name.remove_prefix(std::min(name.size(), name.rfind(':') + 1));
    std::string plain;
    for (const char c : name) {
        const auto letter = static_cast<unsigned char>(c);
        if (std::isalnum(letter) != 0) plain += static_cast<char>(std::tolower(letter));
    }
    return plain;
}

}  // namespace

std::optional<std::size_t> Skeleton::find(std::string_view name) const {
    const std::string wanted = plain_name(name);
    for (std::size_t j = 0; j < joints.size(); ++j) {
        if (!joints[j].name.empty() && plain_name(joints[j].name) == wanted) return j;
    }
    return std::nullopt;
}

JointAngles JointAngles::at_rest(const Skeleton& skeleton) {
    return {.root = Vector3::Zero(),
            .rotations = std::vector<Quaternion>(skeleton.size(), Quaternion::Identity())};
}

void place_joints(const Skeleton& skeleton, const JointAngles& angles, Pose& pose) {
    pose.positions.resize(skeleton.size());
    pose.rotations.resize(skeleton.size());
    for (std::size_t j = 0; j < skeleton.size(); ++j) {
        const Joint& joint = skeleton.joints[j];
        if (joint.parent < 0) {
            pose.positions[j] = angles.root;
            pose.rotations[j] = angles.rotations[j];
            continue;
        }
        const auto parent = static_cast<std::size_t>(joint.parent);
        pose.positions[j] = pose.at(parent, joint.offset);
        pose.rotations[j] = (pose.rotations[parent] * angles.rotations[j]).normalized();
    }
}

void point_bone(const Skeleton& skeleton, std::size_t joint, std::size_t child, const Vector3& way,
                JointAngles& angles) {
    Pose pose;
    angles.rotations[joint] = Quaternion::Identity();
    place_joints(skeleton, angles, pose);
    const Vector3 bone = pose.positions[child] - pose.positions[joint];
    const Quaternion& own = pose.rotations[joint];
    angles.rotations[joint] = own.conjugate() * least_turn(bone, way) * own;
}

void blend(const JointAngles& a, const JointAngles& b, float part, JointAngles& to) {
    to.root = a.root + part * (b.root - a.root);
    to.rotations.resize(a.rotations.size());
    for (std::size_t j = 0; j < a.rotations.size(); ++j)
        to.rotations[j] = a.rotations[j].slerp(part, b.rotations[j]);
}

float smooth_step(double x) {
    const double in = std::clamp(x, 0.0, 1.0);
    return static_cast<float>(in * in * (3 - 2 * in));
}

}  // namespace weft::demo
