#pragma once
// A method as the frame sees it.

#include <span>

#include "cloth/mesh/cook.h"
#include "cloth/solvers/stages.h"
#include "cloth/system/step_equation.h"
#include "engine/parallel_blocks.h"
#include "engine/profiler.h"
#include "weft/settings.h"

namespace weft {

/// One step of one cloth, for its solver. `settings.method` is the solver's own alternative.
struct SolverStep {
    Parallel& parallel;
    Profiler& profiler;
    const CookedCloth& model;
    const ClothSettings& settings;
    const StepEquation& equation;
    bool touches_collider;            ///< a component without pins that touches nothing falls freely
    std::span<Vec4> velocity_change;  ///< what the solver is to find, w 0

    [[nodiscard]] auto timed(Stage stage) const { return profiler.time(static_cast<std::uint32_t>(stage)); }
};

/// Owns all memory that its method needs; nothing of it grows in a step.
class Solver {
  public:
    virtual ~Solver() = default;
    /// Fills velocity_change; 0 for pinned particles. Returns what is left of the linear system,
    /// |D^-1 (b - W dv)| / |D^-1 b|, for methods that have one, else 0; not a number where it found no
    /// solution.
    virtual float solve(const SolverStep& step) = 0;
    /// Before the first step, and before any step that follows a change of pins or settings. May allocate.
    /// `positions` have inverse masses in w, 0 for pinned particles.
    virtual void prepare(const CookedCloth& /*model*/, const ClothSettings& /*settings*/,
                         std::span<const Vec4> /*positions*/) {}
    /// Whether it solves the equation in any time scheme; else it takes h, positions and velocities from it.
    [[nodiscard]] virtual bool is_implicit() const noexcept { return true; }
    [[nodiscard]] virtual std::size_t bytes() const noexcept = 0;
};

}  // namespace weft
