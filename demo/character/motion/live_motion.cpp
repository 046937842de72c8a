#include "demo/character/motion/live_motion.h"

#include <fcntl.h>
#include <unistd.h>

#include <charconv>
#include <cmath>
#include <numbers>

#include "cloth/mesh/obj/words.h"
#include "demo/character/motion/generated_walk.h"

namespace weft::demo {
namespace {

constexpr double following = 0.05;  // time constant [s]
constexpr float farthest = 1000;    // greatest coordinate of a joint [m]
constexpr std::size_t longest_line = 4096;

/// The axes of a trunk whose left side is along `left`, and which stands along `up`.
Matrix3 trunk_axes(const Vector3& left, const Vector3& up) {
    Matrix3 axes;
    axes.col(1) = up.normalized();
    axes.col(2) = left.cross(up).normalized();
    axes.col(0) = axes.col(1).cross(axes.col(2));
    return axes;
}

}  // namespace

LiveMotion::LiveMotion()
    : skeleton_(plain_skeleton()),
      joints_(find_body_joints(skeleton_).value()),
      newest_(JointAngles::at_rest(skeleton_)),
      shown_(newest_) {
    for (const bool left : {true, false}) {  // arms hang until a frame arrives
        const float lowered = (left ? -1.2f : 1.2f);
        newest_.rotations[joints_[left ? Part::left_arm : Part::right_arm]] =
            Quaternion(Eigen::AngleAxisf(lowered, Vector3::UnitZ()));
    }
    Pose pose;
    put_on_ground(skeleton_, 0.03f, newest_, pose);
    shown_ = newest_;
}

LiveMotion::~LiveMotion() {
    if (pipe_ >= 0) close(pipe_);
}

Result<std::unique_ptr<LiveMotion>> LiveMotion::open(const std::filesystem::path& pipe) {
    auto motion = std::make_unique<LiveMotion>();
    motion->pipe_ = ::open(pipe.c_str(), O_RDONLY | O_NONBLOCK | O_CLOEXEC);
    if (motion->pipe_ < 0)
        return Error{ErrorCode::file_not_found, pipe.string() + ": cannot be opened; name a pipe (mkfifo)"};
    return motion;
}

void LiveMotion::take(std::string_view text) {
    for (const char c : text) {
        if (c != '\n') {
            if (unfinished_.size() < longest_line) unfinished_ += c;
            continue;
        }
        take_line(unfinished_);
        unfinished_.clear();
    }
}

void LiveMotion::take_line(std::string_view line) {
    std::string_view rest = line;
    const std::string_view name = take_word(rest);
    if (name.empty()) return;
    if (name == "frame" && take_word(rest).empty()) return end_frame();
    const auto joint = skeleton_.find(name);
    Vector3 where = Vector3::Zero();
    bool sound = joint.has_value();
    for (int axis = 0; axis < 3 && sound; ++axis) {
        const std::string_view word = take_word(rest);
        const auto [end, code] = std::from_chars(word.data(), word.data() + word.size(), where[axis]);
        sound = code == std::errc{} && end == word.data() + word.size() && std::abs(where[axis]) <= farthest;
    }
    if (sound && take_word(rest).empty()) {
        seen_[*joint] = where;
        return;
    }
    ++refused_;
    last_refused_ = line.substr(0, 80);
}

/// Turns a joint by the line between two joints and the line from hips to neck, where all four are seen.
void LiveMotion::turn_trunk(std::size_t joint, std::size_t left, std::size_t right, const Pose& rest) {
    const std::size_t hips = joints_[Part::hips], neck = joints_[Part::neck];
    for (const std::size_t needed : {hips, neck, left, right}) {
        if (!seen(needed)) return;
    }
    const Vector3 side = seen_[left] - seen_[right], up = seen_[neck] - seen_[hips];
    if (!(side.cross(up).norm() > 1e-4f)) return;
    const Matrix3 at_rest =
        trunk_axes(rest.positions[left] - rest.positions[right], rest.positions[neck] - rest.positions[hips]);
    const Quaternion turned(Matrix3(trunk_axes(side, up) * at_rest.transpose()));
    Pose pose;
    newest_.rotations[joint] = Quaternion::Identity();
    place_joints(skeleton_, newest_, pose);
    newest_.rotations[joint] = pose.rotations[joint].conjugate() * turned;
}

void LiveMotion::turn_limbs() {
    using enum Part;
    for (const auto& [from, to] : {std::pair(neck, head),
                                   {left_arm, left_forearm},
                                   {left_forearm, left_hand},
                                   {left_thigh, left_shin},
                                   {left_shin, left_foot},
                                   {left_foot, left_toes},
                                   {right_arm, right_forearm},
                                   {right_forearm, right_hand},
                                   {right_thigh, right_shin},
                                   {right_shin, right_foot},
                                   {right_foot, right_toes}}) {
        const std::size_t a = joints_[from], b = joints_[to];
        if (!seen(a) || !seen(b)) continue;
        const Vector3 way = seen_[b] - seen_[a];
        if (way.norm() > 1e-4f) point_bone(skeleton_, a, b, way, newest_);
    }
}

void LiveMotion::end_frame() {
    Pose rest;
    place_joints(skeleton_, JointAngles::at_rest(skeleton_), rest);
    turn_trunk(joints_[Part::hips], joints_[Part::left_thigh], joints_[Part::right_thigh], rest);
    turn_trunk(joints_[Part::chest], joints_[Part::left_arm], joints_[Part::right_arm], rest);
    turn_limbs();
    const std::size_t thigh = joints_[Part::left_thigh], shin = joints_[Part::left_shin];
    const std::size_t hips = joints_[Part::hips];
    if (scale_ == 0 && seen(thigh) && seen(shin)) {
        const float tracked = (seen_[thigh] - seen_[shin]).norm();
        if (tracked > 0.05f) scale_ = (rest.positions[thigh] - rest.positions[shin]).norm() / tracked;
    }
    if (seen(hips)) {
        newest_.root = seen_[hips];
        if (scale_ > 0) newest_.root.y() *= scale_;
    }
    seen_.clear();
    ++frames_;
}

void LiveMotion::evaluate(double time, JointAngles& angles) {
    std::array<char, 4096> bytes;
    for (ssize_t got = 1; pipe_ >= 0 && got > 0;) {
        got = read(pipe_, bytes.data(), bytes.size());
        if (got > 0) take({bytes.data(), static_cast<std::size_t>(got)});
    }
    const double part = 1 - std::exp(-std::max(0.0, time - shown_at_) / following);
    shown_at_ = time;
    blend(shown_, newest_, static_cast<float>(part), shown_);
    angles = shown_;
}

}  // namespace weft::demo
