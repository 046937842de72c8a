#pragma once
// The interface of a method, as a step calls it.

#include <memory>
#include <span>

#include "cloth/air/surface.h"
#include "cloth/equation/step_equation.h"
#include "cloth/mesh/cook.h"
#include "cloth/solver/stages.h"
#include "engine/memory/scratch.h"
#include "engine/profiling/profiler.h"
#include "engine/threads/parallel_blocks.h"
#include "weft/settings.h"

namespace weft {

class Multigrid;

/// One step of one cloth, for its solver. `settings.method` holds the alternative that the solver was made
/// for.
struct SolverStep {
    Parallel& parallel;
    Profiler& profiler;
    const ClothModel& model;
    const ClothSettings& settings;
    const StepEquation& equation;
    /// The force in the equation: methods that linearise more than once take it anew.
    AirForce air{};
    std::span<Vec4>
        velocities;  ///< the result: at the end of the step, w 0; another buffer than the equation's

    bool wants_residual = true;  ///< false: none is measured, and 0 is returned

    [[nodiscard]] auto timed(Stage stage) const { return profiler.time(static_cast<std::uint32_t>(stage)); }
};

struct SolveResult {
    float residual = 0;     ///< see StepResidual, which measures every method alike
    bool ok = true;         ///< false: no solution was found, and the velocities may hold anything
    bool unsolved = false;  ///< more of the equation is left than the method tolerates
};

/// Levels that a cloth has in common with what is sewn to it; null: none.
struct CommonLevels {
    std::shared_ptr<Multigrid> levels;
    std::uint32_t part = 0;  ///< the cloth's number among theirs
    std::size_t bytes = 0;   ///< of the levels, with their vectors; counted by the first cloth
};

/// Owns the state of its method that lasts from substep to substep. Everything else lies in scratch, so that
/// cloths that are solved one after the other share it.
class Solver {
  public:
    Solver() = default;
    virtual ~Solver() = default;
    Solver& operator=(const Solver&) = delete;
    /// A solver for another cloth of this model, with its copy of the model, before its first step. Constant
    /// parts are shared. Null: nothing is shared, and the caller makes a new solver.
    [[nodiscard]] virtual std::unique_ptr<Solver> clone(const ClothModel& /*model*/) const { return nullptr; }
    /// Allocates its own copy of the shared memory that prepare() writes. May run out of memory.
    virtual void make_own(const ClothSettings& /*settings*/) {}
    /// Lays out the arrays that solve() fills and that are unused after the substep. `pairs`: the most pairs
    /// in which the cloth touches itself.
    virtual void lay_out(Scratch& /*scratch*/, std::size_t /*pairs*/) { own_scratch_.free(); }
    /// lay_out() in memory of its own, for a solver outside any World.
    void lay_out_alone(std::size_t pairs = 0) { own_scratch_.lay_out(*this, pairs); }
    /// Fills the step's velocities. Pinned particles keep theirs. Precondition: the solver is laid out.
    virtual SolveResult solve(const SolverStep& step) = 0;
    /// Whether make_solver() would make the same solver from these settings. solve() reads all other settings
    /// at each step. The study's solvers are made otherwise and return false.
    [[nodiscard]] virtual bool serves(const ClothSettings& /*settings*/) const { return false; }
    /// Makes room, so that up to `count` particles can be pinned at a time without taking memory. May throw.
    virtual void reserve_pins(std::size_t /*count*/) {}
    /// Computes what depends on these settings, so that no step has to. Precondition: it serves them.
    virtual void prepare(const ClothSettings& /*settings*/) noexcept {}
    /// A particle's inverse mass, in w of `positions`, has changed: it was pinned (0) or let go.
    virtual void inverse_mass_changed(std::uint32_t /*particle*/,
                                      std::span<const Vec4> /*positions*/) noexcept {}
    /// As inverse_mass_changed(), for any number of particles.
    virtual void inverse_masses_changed(std::span<const Vec4> /*positions*/) noexcept {}
    /// Whether the method solves the whole equation, in any time scheme. Other methods read only h, positions
    /// and velocities from it.
    [[nodiscard]] virtual bool is_implicit() const noexcept { return true; }
    /// Whether the solved equation includes features that touch: see MultilevelSolver::solve().
    [[nodiscard]] virtual bool joins() const noexcept { return false; }
    /// Allocates what the cloth's contact with itself needs, for so many pairs; 0: frees it. May throw.
    virtual void reserve_pairs(std::size_t /*count*/) {}
    /// The solver's coarse levels; null: it has none.
    [[nodiscard]] virtual const Multigrid* multigrid() const noexcept { return nullptr; }
    /// Bytes without scratch.
    [[nodiscard]] virtual std::size_t bytes() const noexcept = 0;

  protected:
    Solver(const Solver&) = default;

  private:
    OwnScratch own_scratch_;
};

}  // namespace weft
