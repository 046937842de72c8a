#pragma once
// A recording that repeats for ever.

#include "demo/character/motion/bvh.h"
#include "demo/character/motion/motion.h"

namespace weft::demo {

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
