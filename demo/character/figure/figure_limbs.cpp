#include "demo/character/figure/figure_limbs.h"

#include "engine/least_turn.h"

namespace weft::demo {
namespace {

bool is_upper(LimbKind kind) {
    return kind == LimbKind::arm || kind == LimbKind::thigh;
}
bool is_lower(LimbKind kind) {
    return kind == LimbKind::forearm || kind == LimbKind::shin;
}

/// The part of a rotation that turns about a direction.
Quaternion twist_about(const Quaternion& rotation, const Vector3& way) {
    const float along = rotation.vec().dot(way);
    const Quaternion twist(rotation.w(), along * way.x(), along * way.y(), along * way.z());
    return twist.norm() > 1e-6f ? twist.normalized() : Quaternion::Identity();
}

}  // namespace

FigureRig::FigureRig(const Body& body, const Skeleton& skeleton)
    : hips_(body.joints()[Part::hips]), chest_(body.joints()[Part::chest]) {
    Pose rest;
    place_joints(skeleton, JointAngles::at_rest(skeleton), rest);
    for (const Limb& limb : body.limbs()) {
        const Vector3 axis = rest.at(limb.b.joint, limb.b.local) - rest.at(limb.a.joint, limb.a.local);
        sources_.push_back({limb.kind, limb.a.joint, limb.b.joint, axis.stableNormalized()});
    }
}

/// Axes that the limb's own follow by the least turn: those of the trunk, or of the limb before it.
Quaternion FigureRig::base_of(std::size_t limb, const Pose& pose, std::span<const Quaternion> own) const {
    const LimbKind kind = sources_[limb].kind;
    if (is_lower(kind)) return own[limb - 1];
    return pose.rotations[kind == LimbKind::thigh ? hips_ : chest_];
}

void FigureRig::place(const Pose& pose, std::span<const TaperedCapsule> capsules,
                      std::vector<FigureLimb>& to) const {
    to.clear();
    std::vector<Quaternion> own(sources_.size());
    for (std::size_t limb = 0; limb < sources_.size(); ++limb) {
        const auto& [kind, joint_a, joint_b, rest_way] = sources_[limb];
        const Vector3 a = to_vector(capsules[limb].a), b = to_vector(capsules[limb].b);
        Quaternion at_b = pose.rotations[kind == LimbKind::shoulder ? joint_a : joint_b];
        own[limb] = pose.rotations[joint_a];
        if (is_upper(kind) || is_lower(kind)) {
            const Quaternion base = base_of(limb, pose, own);
            own[limb] = at_b = (least_turn(base * rest_way, b - a) * base).normalized();
            if (is_lower(kind)) {
                const Quaternion& end = pose.rotations[sources_[limb + 1].joint_a];
                at_b = own[limb] * twist_about(own[limb].conjugate() * end, rest_way);
            }
        }
        to.push_back({kind, a, b, capsules[limb].radius_a, capsules[limb].radius_b,
                      own[limb].toRotationMatrix(), at_b.toRotationMatrix(),
                      kind == LimbKind::hand ? flat_hand : Vector3(Vector3::Ones())});
    }
}

}  // namespace weft::demo
