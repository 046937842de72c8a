#pragma once
// Two methods on one scene, side by side, and the distance of each from a finely computed reference.

#include <vector>

#include "demo/scene_simulation.h"

namespace weft::demo {

/// The quantity that is equal for both.
enum class Fairness {
    same_steps,  ///< both take the substeps that are set
    same_time,   ///< the other takes as many substeps as fit into the shown one's time
};

/// The number of substeps that take `shown` milliseconds, where `substeps` take `other`; 1 to 64.
[[nodiscard]] int balanced_substeps(int substeps, float shown, float other);

class Comparison {
  public:
    /// Starts the other and the reference, for a scene that has just begun. Errors: the scene cannot be built
    /// again, or refuses the method.
    [[nodiscard]] static Result<Comparison> start(Simulation& shown, const Method& other, Fairness fairness);

    /// Call this after the shown one's step of dt [s].
    void step(const Simulation& shown, float dt);

    struct Side {
        float milliseconds = 0;         ///< of a step, mean over the last second
        float usual = 0, farthest = 0;  ///< distance of particles from the reference: rms and most [mm]
        int substeps = 1;               ///< of the cloth, in each substep of the world
    };
    [[nodiscard]] const Side& shown() const { return shown_; }
    [[nodiscard]] const Side& other() const { return other_; }
    [[nodiscard]] const Simulation& other_simulation() const { return simulations_[0]; }
    [[nodiscard]] const Method& method() const { return method_; }

  private:
    void balance();
    static void measure(const Simulation& of, const Simulation& exact, Side& side);

    std::vector<Simulation> simulations_;  // the other, the exact one
    Method method_;
    Fairness fairness_ = Fairness::same_steps;
    Side shown_, other_;
    int steps_ = 0;
};

}  // namespace weft::demo
