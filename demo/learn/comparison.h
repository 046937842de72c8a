#pragma once
// Two ways of computing one scene, side by side, and how far each is from where the exact answer puts the
// cloth.

#include <vector>

#include "demo/scene_simulation.h"

namespace weft::demo {

/// What the two have in common.
enum class Fairness {
    same_steps,  ///< substeps are those that are set
    same_time,   ///< the other takes as many of its own as fit into the shown one's milliseconds
};

/// As many substeps as take `shown` milliseconds, where `substeps` take `other`; 1 to 64.
[[nodiscard]] int balanced_substeps(int substeps, float shown, float other);

class Comparison {
  public:
    /// Of a scene that has just begun: the other, and one that is computed so finely that it counts as exact.
    /// Errors: the scene cannot be built again, or refuses the method.
    [[nodiscard]] static Result<Comparison> start(Simulation& shown, const Method& other, Fairness fairness);

    /// After the shown one's step of dt [s].
    void step(const Simulation& shown, float dt);

    struct Side {
        float milliseconds = 0;         ///< of a step, as a mean over the last second
        float usual = 0, farthest = 0;  ///< of its particles from the exact one's: rms and most [mm]
        int substeps = 1;               ///< of the cloth, in each of the world's
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
