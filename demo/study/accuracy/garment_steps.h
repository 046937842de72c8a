#pragma once
// One step of a garment from states of a reference run. Trajectories of garments branch wherever cloth
// buckles, even between two ways to converge. So solvers are judged by their results for the same step.

#include <vector>

#include "demo/study/reference/states.h"
#include "demo/study/reference/step_functional.h"

namespace weft::study {

class GarmentSteps {
  public:
    /// Frames of the run after which the steps are taken: falling, swinging, all but still.
    static constexpr std::array frames{15, 30, 60};

    GarmentSteps(const StudyScene& garment, ReferenceStore& store, int threads);

    /// The error of a method in one of the steps.
    struct Judgement {
        double rms;         ///< distance from the converged step [m]
        double energy_gap;  ///< how much of the functional's descent from the inertial start to the converged
                            ///< step is missing: 0 converged, 1 nothing solved
    };

    [[nodiscard]] const StudyScene& garment() const { return garment_; }
    [[nodiscard]] std::size_t size() const { return steps_.size(); }
    /// The garment in the state from which the step starts.
    [[nodiscard]] const StudyScene& start(std::size_t step) const { return steps_[step].start; }
    [[nodiscard]] Judgement judge(std::size_t step, const Cloth& after) const;

  private:
    struct Step {
        StudyScene start;
        StepFunctional functional;
        Flat start_positions;
        Positions solution;
        std::vector<DampedState> damped;  // at the solution
        double solved, inertial;          // the functional at the solution and at the inertial start
    };
    [[nodiscard]] Step make_step(const Positions& before, const Positions& now, int threads) const;
    [[nodiscard]] Flat velocities_to(const Step& step, const Positions& positions) const;

    StudyScene garment_;
    std::vector<Step> steps_;
};

}  // namespace weft::study
