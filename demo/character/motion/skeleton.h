#pragma once
// Joints and how they are turned: what motions say and bodies follow. +Y is up, +Z ahead, +X to the left [m].

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

    /// Upper and lower case, and what is neither letter nor digit, do not count; nor does what stands before
    /// a colon.
    [[nodiscard]] std::optional<std::size_t> find(std::string_view name) const;
    [[nodiscard]] std::size_t size() const { return joints.size(); }
};

/// What a motion says of one moment.
struct JointAngles {
    Vector3 root = Vector3::Zero();     ///< where the first joint is [m]
    std::vector<Quaternion> rotations;  ///< of each joint, relative to its parent

    [[nodiscard]] static JointAngles at_rest(const Skeleton& skeleton);
};

/// Where the joints are.
struct Pose {
    std::vector<Vector3> positions;     ///< [m]
    std::vector<Quaternion> rotations;  ///< from the axes at rest

    [[nodiscard]] Vector3 at(std::size_t joint, const Vector3& local) const {
        return positions[joint] + rotations[joint] * local;
    }
};

/// Writes where `angles` put the joints. Takes no memory where `pose` has as many.
void place_joints(const Skeleton& skeleton, const JointAngles& angles, Pose& pose);

/// Turns `joint`, its parents being turned as they are, by the least by which the bone from it to `child`
/// points along `way`.
void point_bone(const Skeleton& skeleton, std::size_t joint, std::size_t child, const Vector3& way,
                JointAngles& angles);

/// `to` = a moved towards b by `part` of the way, each joint the shorter way round.
void blend(const JointAngles& a, const JointAngles& b, float part, JointAngles& to);

/// Goes from 0 to 1 as x does, without a jump in speed at either end; 0 before, 1 after.
[[nodiscard]] float smooth_step(double x);

}  // namespace weft::demo
