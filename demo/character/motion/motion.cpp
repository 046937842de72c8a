#include "demo/character/motion/motion.h"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <limits>
#include <utility>

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

Performance::Performance(std::unique_ptr<Motion> motion, JointAngles stance, double wait, double blend_in,
                         double speed, double ahead)
    : motion_(std::move(motion)),
      stance_(std::move(stance)),
      moved_(stance_),
      blended_(stance_),
      wait_(wait),
      blend_in_(blend_in),
      speed_(speed),
      ahead_(ahead) {}

const JointAngles& Performance::at(double time) {
    const double since = time - wait_;
    if (since <= 0) return stance_;
    motion_->evaluate(ahead_ + speed_ * since, moved_);
    if (since >= blend_in_) return moved_;
    blend(stance_, moved_, smooth_step(since / blend_in_), blended_);
    return blended_;
}

namespace {

constexpr double longest_crossing = 0.25;  // blend of the end into the beginning [s]

}  // namespace

RecordedMotion::RecordedMotion(Recording recording) : recording_(std::move(recording)) {
    find_round();
    stand_on_the_spot();
}

/// Distance between the first frames and those that blend into them, if the motion repeats after `shift`
/// frames. The sum ends at `most`: a long recording with a short frame time has 10^9 pairs of poses.
double RecordedMotion::unlikeness(std::size_t shift, double most) const {
    double sum = 0;
    for (std::size_t frame = 0; frame < shared_ && sum < most; ++frame) {
        const JointAngles &a = recording_.frames[frame], &b = recording_.frames[frame + shift];
        for (std::size_t j = 0; j < a.rotations.size(); ++j)
            sum += 1 - std::abs(static_cast<double>(a.rotations[j].dot(b.rotations[j])));
    }
    return sum;
}

void RecordedMotion::find_round() {
    const std::size_t frames = recording_.frames.size();
    const auto crossing = static_cast<std::size_t>(std::lround(longest_crossing / recording_.frame_time));
    shared_ = std::min(std::max<std::size_t>(crossing, 1), frames / 4);
    round_ = frames - shared_;
    if (shared_ == 0) return;
    double least = unlikeness(round_, std::numeric_limits<double>::infinity());
    for (std::size_t shift = round_; shift-- > frames / 2;) {
        const double found = unlikeness(shift, least);
        if (found < least) std::tie(least, round_) = std::pair(found, shift);
    }
}

void RecordedMotion::stand_on_the_spot() {
    std::vector<JointAngles>& frames = recording_.frames;
    const std::size_t last = std::min(round_, frames.size() - 1);
    Vector3 way = frames[last].root - frames[0].root;
    way.y() = 0;
    if (last > 0) velocity_ = way / static_cast<float>(static_cast<double>(last) * recording_.frame_time);
    Vector3 mean = Vector3::Zero();
    for (std::size_t frame = 0; frame < frames.size(); ++frame) {
        frames[frame].root -=
            static_cast<float>(static_cast<double>(frame) * recording_.frame_time) * velocity_;
        mean += frames[frame].root / static_cast<float>(frames.size());
    }
    for (JointAngles& frame : frames) frame.root -= Vector3(mean.x(), 0, mean.z());
}

double RecordedMotion::period() const {
    return static_cast<double>(round_) * recording_.frame_time;
}

void RecordedMotion::sample(double frame, JointAngles& angles) const {
    const auto last = static_cast<double>(recording_.frames.size() - 1);
    const double within = std::clamp(frame, 0.0, last);
    const auto first = static_cast<std::size_t>(within);
    const std::size_t second = std::min(first + 1, recording_.frames.size() - 1);
    blend(recording_.frames[first], recording_.frames[second],
          static_cast<float>(within - std::floor(within)), angles);
}

void RecordedMotion::evaluate(double time, JointAngles& angles) {
    const auto round = static_cast<double>(round_), shared = static_cast<double>(shared_);
    const double frame = std::fmod(time / recording_.frame_time, round);
    sample(frame, angles);
    if (frame >= shared) return;
    sample(frame + round, tail_);
    blend(tail_, angles, smooth_step(frame / shared), angles);
}

}  // namespace weft::demo
