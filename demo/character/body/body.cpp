#include "demo/character/body/body.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>

#include "demo/character/motion/generated_walk.h"

namespace weft::demo {

namespace {

SurfaceDistance from_ball(const Vector3& point, const Vector3& centre, float radius) {
    const Vector3 away = point - centre;
    const float distance = away.norm();
    return {distance - radius, distance > 0 ? Vector3(away / distance) : Vector3::UnitY()};
}

}  // namespace

RoundCone::RoundCone(const Vector3& a, const Vector3& b, float radius_a, float radius_b)
    : a_(a), b_(b), radius_a_(radius_a), radius_b_(radius_b) {
    const Vector3 axis = b - a;
    length_ = axis.norm();
    const float shrink = radius_a - radius_b;
    is_ball_ = length_ <= std::abs(shrink);
    if (is_ball_) return;
    along_ = axis / length_;
    sine_ = shrink / length_;
    cosine_ = std::sqrt(1 - sine_ * sine_);
}

SurfaceDistance RoundCone::distance_to(const Vector3& point) const {
    if (is_ball_)
        return radius_a_ > radius_b_ ? from_ball(point, a_, radius_a_) : from_ball(point, b_, radius_b_);
    const Vector3 from_a = point - a_;
    const float x = from_a.dot(along_);
    const Vector3 across = from_a - x * along_;
    const float y = across.norm();
    const float t =
        (x - y * sine_ / cosine_) / length_;  // where the cone's normal through the point meets the axis
    if (t <= 0) return from_ball(point, a_, radius_a_);
    if (t >= 1) return from_ball(point, b_, radius_b_);
    const Vector3 out = y > 0 ? Vector3(across / y) : along_.unitOrthogonal();
    const Vector3 normal = cosine_ * out + sine_ * along_;
    return {normal.dot(from_a) - radius_a_, normal};
}

namespace {

// Radii over the length of the bone, or of the leg, that they go with: a slender woman's girths over 2 pi.
constexpr float thigh_top = 0.185f, knee = 0.125f, calf_top = 0.125f, ankle = 0.085f, toe = 0.28f;
constexpr float arm_top = 0.155f, elbow = 0.125f, wrist = 0.085f, shoulder = 0.058f, neck_radius = 0.056f;
constexpr float pelvis_radius = 0.118f, waist_radius = 0.100f, chest_radius = 0.116f, head_radius = 0.105f;

/// Builds limbs from where the joints are at rest.
class LimbMaker {
  public:
    LimbMaker(const Skeleton& skeleton, const BodyJoints& joints) : skeleton_(skeleton), joints_(joints) {
        place_joints(skeleton, JointAngles::at_rest(skeleton), rest_);
        leg_ = bone(Part::left_thigh, Part::left_shin) + bone(Part::left_shin, Part::left_foot);
    }

    [[nodiscard]] std::vector<Limb> all() {
        add_torso();
        add_head();
        for (const bool left : {true, false}) add_side(left);
        return limbs_;
    }
    [[nodiscard]] float bone(Part from, Part to) const { return (at(to) - at(from)).norm(); }

  private:
    [[nodiscard]] Vector3 at(Part part) const { return rest_.positions[joints_[part]]; }
    [[nodiscard]] Limb::End end(std::size_t joint, const Vector3& where, float radius) const {
        return {joint, where - rest_.positions[joint], radius};
    }
    void add(LimbKind kind, const Limb::End& a, const Limb::End& b) { limbs_.push_back({a, b, kind}); }

    /// Adds two columns, from the hips to the waist and on to the shoulders. Their distance is in proportion
    /// to the widths of hips and shoulders.
    void add_torso() {
        const Vector3 low = 0.4f * at(Part::hips) + 0.3f * (at(Part::left_thigh) + at(Part::right_thigh));
        const Vector3 waist = at(Part::hips) + 0.33f * (at(Part::neck) - at(Part::hips));
        const Vector3 high = at(Part::hips) + 0.82f * (at(Part::neck) - at(Part::hips));
        const float hips = 0.5f * (at(Part::left_thigh) - at(Part::right_thigh)).norm();
        const float shoulders = 0.5f * (at(Part::left_arm) - at(Part::right_arm)).norm();
        for (const float side : {1.0f, -1.0f}) {
            const auto out = [&](float x) { return Vector3(side * x, 0, 0); };
            const Limb::End bottom = end(joints_[Part::hips], low + out(0.62f * hips), pelvis_radius * leg_);
            const Limb::End middle = end(joints_.spine, waist + out(0.42f * hips), waist_radius * leg_);
            const Limb::End top =
                end(joints_[Part::chest], high + out(0.29f * shoulders), chest_radius * leg_);
            add(LimbKind::trunk, bottom, middle);
            add(LimbKind::trunk, middle, top);
        }
    }

    void add_head() {
        const Vector3 top = farthest(joints_[Part::head]);
        add(LimbKind::neck, end(joints_[Part::neck], at(Part::neck), 1.1f * neck_radius * leg_),
            end(joints_[Part::head], at(Part::head), neck_radius * leg_));
        Vector3 up = top - at(Part::head);
        if (up.norm() < 0.5f * head_radius * leg_) up = {0, 2 * head_radius * leg_, 0};  // no joint above
        const Vector3 crown = at(Part::head) + std::max(0.0f, 1 - head_radius * leg_ / up.norm()) * up;
        add(LimbKind::head, end(joints_[Part::head], at(Part::head) + 0.25f * up, 0.8f * head_radius * leg_),
            end(joints_[Part::head], crown, head_radius * leg_));
    }

    void add_side(bool left) {
        const auto part = [&](Part of_left) {
            const int to_right = static_cast<int>(Part::right_arm) - static_cast<int>(Part::left_arm);
            return left ? of_left : static_cast<Part>(static_cast<int>(of_left) + to_right);
        };
        const Part arm = part(Part::left_arm), forearm = part(Part::left_forearm),
                   hand = part(Part::left_hand);
        const Part thigh = part(Part::left_thigh), shin = part(Part::left_shin), foot = part(Part::left_foot);
        const auto bone_of = [&](LimbKind kind, Part from, Part to, float radius_a, float radius_b) {
            add(kind, end(joints_[from], at(from), radius_a), end(joints_[from], at(to), radius_b));
        };
        const float upper_arm = bone(arm, forearm), calf = bone(shin, foot);
        add(LimbKind::shoulder,
            end(joints_[Part::chest], 0.75f * at(Part::neck) + 0.25f * at(arm), shoulder * leg_),
            end(joints_[arm], at(arm), shoulder * leg_));
        bone_of(LimbKind::arm, arm, forearm, arm_top * upper_arm, elbow * upper_arm);
        bone_of(LimbKind::forearm, forearm, hand, elbow * upper_arm, wrist * upper_arm);
        const Vector3 tip = at(hand) + 0.75f * (farthest(joints_[hand]) - at(hand));
        add(LimbKind::hand, end(joints_[hand], at(hand), 1.1f * wrist * upper_arm),
            end(joints_[hand], tip, 1.1f * wrist * upper_arm));
        bone_of(LimbKind::thigh, thigh, shin, thigh_top * bone(thigh, shin), knee * bone(thigh, shin));
        bone_of(LimbKind::shin, shin, foot, calf_top * calf, ankle * calf);
        const Vector3 toes = joints_.has_toes(left) ? at(part(Part::left_toes)) : toes_of(foot);
        const float ball = toe * (toes - at(foot)).norm();
        add(LimbKind::sole, end(joints_[foot], heel_of(at(foot), toes, ball), 0.95f * ball),
            end(joints_[foot], toes, ball));
        add(LimbKind::foot, end(joints_[foot], at(foot), ankle * calf), end(joints_[foot], toes, ball));
    }

    /// The heel is behind the ankle, and on the ground where the ball of the foot is.
    [[nodiscard]] static Vector3 heel_of(const Vector3& foot, const Vector3& toes, float ball) {
        Vector3 back = foot - toes;
        back.y() = 0;
        const Vector3 heel = foot + 0.12f * back;
        return {heel.x(), toes.y() - 0.05f * ball, heel.z()};
    }

    /// Where toes begin on a rig without them: at the foot's end, or else ahead of the ankle and below it, in
    /// proportion to the leg.
    [[nodiscard]] Vector3 toes_of(Part foot) const {
        const Vector3 found = farthest(joints_[foot]);
        if ((found - at(foot)).norm() > 0.05f * leg_) return found;
        const Vector3 to_left = at(Part::left_thigh) - at(Part::right_thigh);
        const Vector3 ahead = to_left.cross(Vector3::UnitY()).stableNormalized();
        return at(foot) + leg_ * (0.14f * ahead - 0.05f * Vector3::UnitY());
    }

    /// Position of the joint's descendant that is farthest from it; its own position without descendants.
    [[nodiscard]] Vector3 farthest(std::size_t joint) const {
        Vector3 found = rest_.positions[joint];
        std::vector<bool> below(skeleton_.size(), false);
        below[joint] = true;
        for (std::size_t j = joint + 1; j < skeleton_.size(); ++j) {
            const int parent = skeleton_.joints[j].parent;
            if (parent < 0 || !below[static_cast<std::size_t>(parent)]) continue;
            below[j] = true;
            const Vector3& p = rest_.positions[j];
            if ((p - rest_.positions[joint]).norm() > (found - rest_.positions[joint]).norm()) found = p;
        }
        return found;
    }

    const Skeleton& skeleton_;
    const BodyJoints& joints_;
    Pose rest_;
    float leg_ = 0;  // [m]
    std::vector<Limb> limbs_;
};

}  // namespace

Result<Body> Body::create(const Skeleton& skeleton) {
    const auto joints = find_body_joints(skeleton);
    if (!joints) return joints.error();
    LimbMaker maker(skeleton, *joints);
    constexpr std::array<std::pair<Part, Part>, 13> bones{{{Part::hips, Part::neck},
                                                           {Part::left_arm, Part::right_arm},
                                                           {Part::left_thigh, Part::right_thigh},
                                                           {Part::left_arm, Part::left_forearm},
                                                           {Part::left_forearm, Part::left_hand},
                                                           {Part::left_thigh, Part::left_shin},
                                                           {Part::left_shin, Part::left_foot},
                                                           {Part::left_foot, Part::left_toes},
                                                           {Part::right_arm, Part::right_forearm},
                                                           {Part::right_forearm, Part::right_hand},
                                                           {Part::right_thigh, Part::right_shin},
                                                           {Part::right_shin, Part::right_foot},
                                                           {Part::right_foot, Part::right_toes}}};
    for (const auto& [from, to] : bones) {
        if ((*joints)[from] == (*joints)[to]) continue;  // a foot without toes
        const float length = maker.bone(from, to);
        if (length >= 0.01f && length <= 10) continue;
        return Error{ErrorCode::malformed_file, "the joints " + skeleton.joints[(*joints)[from]].name +
                                                    " and " + skeleton.joints[(*joints)[to]].name + " are " +
                                                    std::to_string(length) +
                                                    " m apart; a body needs 0.01 to 10"};
    }
    return Body(*joints, maker.all());
}

TaperedCapsule Body::placed(std::size_t limb, const Pose& pose, float growth) const {
    const auto& [a, b, kind] = limbs_[limb];
    return {.a = to_vec3(pose.at(a.joint, a.local)),
            .b = to_vec3(pose.at(b.joint, b.local)),
            .radius_a = growth * a.radius,
            .radius_b = growth * b.radius};
}

void Body::place(const Pose& pose, float growth, std::vector<TaperedCapsule>& capsules) const {
    capsules.resize(limbs_.size());
    for (std::size_t limb = 0; limb < limbs_.size(); ++limb) capsules[limb] = placed(limb, pose, growth);
}

JointAngles Body::stance(const Skeleton& skeleton, float arms, float apart) const {
    JointAngles angles = JointAngles::at_rest(skeleton);
    const float lowered = arms * std::numbers::pi_v<float> / 180;
    for (const bool left : {true, false}) {
        const float side = left ? 1.0f : -1.0f;
        const std::size_t thigh = joints_[left ? Part::left_thigh : Part::right_thigh];
        const std::size_t shin = joints_[left ? Part::left_shin : Part::right_shin];
        const std::size_t foot = joints_[left ? Part::left_foot : Part::right_foot];
        const std::size_t arm = joints_[left ? Part::left_arm : Part::right_arm];
        const std::size_t forearm = joints_[left ? Part::left_forearm : Part::right_forearm];
        const std::size_t hand = joints_[left ? Part::left_hand : Part::right_hand];
        const Vector3 down(apart * side, -1, 0), out(side * std::cos(lowered), -std::sin(lowered), 0);
        point_bone(skeleton, thigh, shin, down, angles);
        point_bone(skeleton, shin, foot, down, angles);
        point_bone(skeleton, arm, forearm, out, angles);
        point_bone(skeleton, forearm, hand, out, angles);
        // Feet stay as they are at rest.
        Pose pose;
        place_joints(skeleton, angles, pose);
        angles.rotations[foot] = pose.rotations[foot].conjugate();
    }
    Pose pose;
    put_on_ground(skeleton, 0.03f, angles, pose);
    return angles;
}

SurfaceDistance distance_to(const TaperedCapsule& capsule, const Vector3& point) {
    return RoundCone(capsule).distance_to(point);
}

}  // namespace weft::demo
