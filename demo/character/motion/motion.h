#pragma once
// Sources of motion: a recording, a formula, or a tracker that writes to a pipe.

#include <memory>

#include "demo/character/motion/bvh.h"
#include "demo/character/motion/skeleton.h"

namespace weft::demo {

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
