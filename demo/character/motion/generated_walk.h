#pragma once
// A walk that needs no file.

#include "demo/character/motion/motion.h"

namespace weft::demo {

/// Somebody of 1.65 m, standing with arms stretched out to the sides.
[[nodiscard]] Skeleton plain_skeleton();

/// On the spot, ahead along +Z, with the joints of plain_skeleton(). Each angle is a constant and a wave or
/// two, after the curves of level walking in D. Winter, "Biomechanics and motor control of human movement",
/// 1991; the height is what puts the lower foot on the ground.
class GeneratedWalk final : public Motion {
  public:
    GeneratedWalk();
    [[nodiscard]] const Skeleton& skeleton() const override { return skeleton_; }
    void evaluate(double time, JointAngles& angles) override;

    static constexpr double period = 1.1;  ///< two steps [s]

  private:
    Skeleton skeleton_;
    Pose pose_;
};

/// Lifts or lowers the root so that the lowest joint is `sole` above y = 0 [m].
void put_on_ground(const Skeleton& skeleton, float sole, JointAngles& angles, Pose& pose);

}  // namespace weft::demo
