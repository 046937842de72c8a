#pragma once
// Skeletons, joint angles and poses; motions, and recordings from BVH files. +Y is up, +Z ahead, +X to the
// left [m].

#include <cstddef>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "engine/vector.h"
#include "weft/error.h"

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

/// Sources of motion: a recording, a formula, or a tracker that writes to a pipe.
class Motion {
  public:
    virtual ~Motion() = default;
    [[nodiscard]] virtual const Skeleton& skeleton() const = 0;
    /// Writes the joints' angles `time` seconds after the start, any number >= 0. Call this once a step.
    virtual void evaluate(double time, JointAngles& angles) = 0;
};

/// A motion with a transition from standing still.
class Performance {
  public:
    /// The stance lasts for `wait` seconds and blends into the motion within `blend_in` more. The motion runs
    /// at `speed` times its own speed, from its own time `ahead` [s] on.
    Performance(std::unique_ptr<Motion> motion, JointAngles stance, double wait, double blend_in,
                double speed, double ahead = 0);

    [[nodiscard]] const Skeleton& skeleton() const { return motion_->skeleton(); }
    [[nodiscard]] const JointAngles& stance() const { return stance_; }
    /// Angles `time` seconds after the start, stance included. The reference is valid until the next call.
    [[nodiscard]] const JointAngles& at(double time);

  private:
    std::unique_ptr<Motion> motion_;
    JointAngles stance_, moved_, blended_;
    double wait_, blend_in_, speed_, ahead_;
};

/// A motion as it was recorded: a pose for each frame.
struct Recording {
    Skeleton skeleton;
    double frame_time = 1.0 / 60;  ///< [s]
    std::vector<JointAngles> frames;
};

/// Reads hierarchy and motion: any number of channels in any order, rotations in the order in which the file
/// names them, lengths in metres. Lengths that would make somebody of more than ten metres are taken for
/// centimetres. Position channels of other joints than the root are ignored: bones keep their lengths.
/// Errors name the file, the line and the value: a file that cannot be read or ends too soon, another word
/// than must stand there, a number that is none or not finite, joints or frames too many (1024; 10^6; 2^25
/// their product), a bone or a place of the root of more than 10^5 m.
[[nodiscard]] Result<Recording> read_bvh(const std::filesystem::path& file);

/// Repeats a recording on the spot: its mean horizontal velocity is subtracted, as on a treadmill. The loop
/// closes where the recording is most like its beginning. The end is blended into the beginning there, so
/// that nothing jumps.
class RecordedMotion final : public Motion {
  public:
    /// Precondition: the recording has a frame.
    explicit RecordedMotion(Recording recording);

    [[nodiscard]] const Skeleton& skeleton() const override { return recording_.skeleton; }
    void evaluate(double time, JointAngles& angles) override;

    [[nodiscard]] double period() const;                          ///< after which the motion repeats [s]
    [[nodiscard]] Vector3 velocity() const { return velocity_; }  ///< subtracted, horizontal [m/s]

  private:
    [[nodiscard]] double unlikeness(std::size_t shift, double most) const;
    void find_round();
    void stand_on_the_spot();
    /// Interpolates between frames; the first is frame 0.
    void sample(double frame, JointAngles& angles) const;

    Recording recording_;
    std::size_t round_ = 0;   // period in frames
    std::size_t shared_ = 0;  // frames at the beginning that the end blends into
    Vector3 velocity_ = Vector3::Zero();
    JointAngles tail_;
};

}  // namespace weft::demo
