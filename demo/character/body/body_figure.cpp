#include "demo/character/body/body_figure.h"

namespace weft::demo {
namespace {

constexpr float arms_of_stance = 45, legs_of_stance = 0.25f;  // as Body::stance() takes them

/// A stance with hips, knees and elbows bent by an angle [rad].
JointAngles bent(const Body& body, const Skeleton& skeleton, float bend) {
    JointAngles angles = body.stance(skeleton, 75);
    const auto turn = [&](Part part, float by, const Vector3& axis) {
        Quaternion& joint = angles.rotations[body.joints()[part]];
        joint = joint * Quaternion(Eigen::AngleAxisf(by, axis));
    };
    for (const Part thigh : {Part::left_thigh, Part::right_thigh}) turn(thigh, -bend, Vector3::UnitX());
    for (const Part shin : {Part::left_shin, Part::right_shin}) turn(shin, bend, Vector3::UnitX());
    turn(Part::left_forearm, -bend, Vector3::UnitY());
    turn(Part::right_forearm, bend, Vector3::UnitY());
    return angles;
}

}  // namespace

BodyFigure::BodyFigure(const Body& body, const Skeleton& skeleton, float cell) : rig_(body, skeleton) {
    Pose pose;
    std::vector<TaperedCapsule> capsules;
    std::vector<FigureLimb> limbs;
    const auto limbs_of = [&](const JointAngles& angles) -> const std::vector<FigureLimb>& {
        place_joints(skeleton, angles, pose);
        body.place(pose, 1, capsules);
        rig_.place(pose, capsules, limbs);
        return limbs;
    };
    figure_ = Figure(limbs_of(body.stance(skeleton, arms_of_stance, legs_of_stance)), cell);
    for (const float bend : {0.0f, 0.6f, 1.2f}) figure_.keep_within(limbs_of(bent(body, skeleton, bend)));
}

void BodyFigure::place(const Pose& pose, std::span<const TaperedCapsule> capsules, std::span<Vec3> to) const {
    std::vector<FigureLimb> limbs;
    rig_.place(pose, capsules, limbs);
    figure_.place(limbs, to);
}

}  // namespace weft::demo
