#pragma once
// A recording that goes on for ever.

#include "demo/character/motion/bvh.h"
#include "demo/character/motion/motion.h"

namespace weft::demo {

/// Plays a recording round and round, on the spot: the way that it covers on the whole is taken out, as on a
/// treadmill. It goes round where it is most like its beginning, and there the end goes over into the
/// beginning, so that nothing jumps.
class RecordedMotion final : public Motion {
  public:
    /// Precondition: the recording has a frame.
    explicit RecordedMotion(Recording recording);

    [[nodiscard]] const Skeleton& skeleton() const override { return recording_.skeleton; }
    void evaluate(double time, JointAngles& angles) override;

    [[nodiscard]] double period() const;                          ///< after which it is where it was [s]
    [[nodiscard]] Vector3 velocity() const { return velocity_; }  ///< that was taken out, level [m/s]

  private:
    [[nodiscard]] double unlikeness(std::size_t shift, double most) const;
    void find_round();
    void stand_on_the_spot();
    /// Between frames, counted from the first.
    void sample(double frame, JointAngles& angles) const;

    Recording recording_;
    std::size_t round_ = 0;   // frames after which it goes round
    std::size_t shared_ = 0;  // frames at the beginning that the end goes over into
    Vector3 velocity_ = Vector3::Zero();
    JointAngles tail_;
};

}  // namespace weft::demo
