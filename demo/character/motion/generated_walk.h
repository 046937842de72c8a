#pragma once
// A walk, and a run, that need no file.

#include "demo/character/motion/motion.h"

namespace weft::demo {

/// Skeleton of a person of 1.65 m. At rest the arms are stretched out to the sides.
[[nodiscard]] Skeleton plain_skeleton();

/// Joint angles of a gait [degrees]: means, and amplitudes of the waves about them.
struct Gait {
    double period = 1.1;  ///< two steps [s]
    float lean = 4;       ///< of the trunk, forwards
    double hip = 6, hip_wave = 21;
    double knee = 7, knee_wave = 52;  ///< flexion of the swinging leg
    double ankle_wave = 12;
    double arm = 4, arm_wave = 19;
    double elbow = 22, elbow_wave = 9;
    float arm_down = 76;
    double flight = 0;  ///< greatest height off the ground, twice a period [m]
};
/// A run at 3 m/s (Novacheck 1998, "The biomechanics of running").
inline constexpr Gait running{.period = 0.72,
                              .lean = 10,
                              .hip = 16,
                              .hip_wave = 33,
                              .knee = 20,
                              .knee_wave = 78,
                              .ankle_wave = 16,
                              .arm = -6,
                              .arm_wave = 32,
                              .elbow = 82,
                              .elbow_wave = 12,
                              .arm_down = 72,
                              .flight = 0.05};

/// A gait on the spot, facing +Z, with the joints of plain_skeleton(). Each angle is a constant and a wave or
/// two, after the curves of level walking in D. Winter, "Biomechanics and motor control of human movement",
/// 1991. The root's height puts the lower foot on the ground.
class GeneratedWalk final : public Motion {
  public:
    explicit GeneratedWalk(const Gait& gait = {});
    [[nodiscard]] const Skeleton& skeleton() const override { return skeleton_; }
    void evaluate(double time, JointAngles& angles) override;

    static constexpr double period = Gait{}.period;  ///< of the walk [s]

  private:
    Gait gait_;
    Skeleton skeleton_;
    Pose pose_;
};

/// Lifts or lowers the root so that the lowest joint is `sole` above y = 0 [m].
void put_on_ground(const Skeleton& skeleton, float sole, JointAngles& angles, Pose& pose);

}  // namespace weft::demo
