#pragma once
// Skeletons, joint angles and poses. +Y is up, +Z ahead, +X to the left [m].

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "engine/vector.h"

namespace weft::demo {

using Quaternion = Eigen::Quaternionf;

struct Joint {
    std::string name;                  ///< empty: the end of a limb
    int parent = -1;                   ///< an earlier joint; -1: this is the first, the root
    Vector3 offset = Vector3::Zero();  ///< from its parent, while nothing is turned [m]
};

struct Skeleton {
    std::vector<Joint> joints;

    /// Finds a joint by its name. Case, characters other than letters and digits, and a prefix up to a colon
    /// are ignored.
    [[nodiscard]] std::optional<std::size_t> find(std::string_view name) const;
    [[nodiscard]] std::size_t size() const { return joints.size(); }
};

/// A motion at one moment.
struct JointAngles {
    Vector3 root = Vector3::Zero();     ///< position of the first joint [m]
    std::vector<Quaternion> rotations;  ///< of each joint, relative to its parent

    [[nodiscard]] static JointAngles at_rest(const Skeleton& skeleton);
};

/// Positions and rotations of all joints in space.
struct Pose {
    std::vector<Vector3> positions;     ///< [m]
    std::vector<Quaternion> rotations;  ///< from the axes at rest

    [[nodiscard]] Vector3 at(std::size_t joint, const Vector3& local) const {
        return positions[joint] + rotations[joint] * local;
    }
};

/// Writes the pose of these angles (forward kinematics). Allocates nothing where `pose` has as many joints.
void place_joints(const Skeleton& skeleton, const JointAngles& angles, Pose& pose);

/// Gives `joint` the least rotation from rest by which the bone from it to `child` points along `way`. Its
/// parents keep their rotations.
void point_bone(const Skeleton& skeleton, std::size_t joint, std::size_t child, const Vector3& way,
                JointAngles& angles);

/// `to` = a moved towards b by `part` of the way, each joint the shorter way round.
void blend(const JointAngles& a, const JointAngles& b, float part, JointAngles& to);

/// Smooth step 3 x^2 - 2 x^3: 0 for x below 0, 1 above 1, with no slope at either end.
[[nodiscard]] float smooth_step(double x);

}  // namespace weft::demo
