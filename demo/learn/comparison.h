#pragma once
// Two methods on one scene, side by side, and the distance of each from a finely computed reference.

#include <vector>

#include "demo/scene_simulation.h"

namespace weft::demo {

/// The quantity that is equal for both.
enum class Fairness {
    same_steps,  ///< both take the substeps that are set
    same_time,   ///< the faster one takes more substeps, so that both cost the same
};

/// Substeps of the two, 1 to 64.
struct BothSubsteps {
    int shown = 1, other = 1;
    friend bool operator==(const BothSubsteps&, const BothSubsteps&) = default;
};
/// The substeps by which both take the same time, within a tenth where the shown one's are at most four times
/// `least`, else as nearly as can be. Times are those of one substep of each [ms], above 0.
[[nodiscard]] BothSubsteps balanced_substeps(int least, float shown, float other);

class Comparison {
  public:
    /// Starts the other and the reference, for a scene that has just begun. Errors: the scene cannot be built
    /// again, or refuses the method.
    [[nodiscard]] static Result<Comparison> start(Simulation& shown, const Method& other, Fairness fairness);

    /// Call this after the shown one's step of dt [s]. The others get its wind; with Fairness::same_time its
    /// own substeps may change.
    void step(Simulation& shown, float dt);
    /// Gives the shown one the substeps back that it had at the start.
    void end(Simulation& shown) const;

    struct Side {
        float milliseconds = 0;         ///< of a step, mean over the last second
        float usual = 0, farthest = 0;  ///< distance of particles from the reference: rms and most [mm]
        int substeps = 1;               ///< of the cloth, in each substep of the world
    };
    /// Time that the others' last step took, of the reference too [ms].
    [[nodiscard]] float milliseconds() const { return milliseconds_; }
    [[nodiscard]] const Side& shown() const { return shown_; }
    [[nodiscard]] const Side& other() const { return other_; }
    [[nodiscard]] const Simulation& other_simulation() const { return simulations_[0]; }
    /// The finely computed reference.
    [[nodiscard]] const Simulation& truth() const { return simulations_[1]; }
    [[nodiscard]] const Method& method() const { return method_; }

  private:
    void balance(Simulation& shown);
    static void measure(const Simulation& of, const Simulation& exact, Side& side);

    std::vector<Simulation> simulations_;  // the other, the exact one
    Method method_;
    Fairness fairness_ = Fairness::same_steps;
    Side shown_, other_;
    int own_substeps_ = 1, truth_substeps_ = 1;  // of the shown one and of the truth, at the start
    float milliseconds_ = 0;
    int steps_ = 0;
};

}  // namespace weft::demo
