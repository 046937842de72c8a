#pragma once
// A method as the frame sees it.

#include <memory>
#include <span>

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
    std::span<Vec4>
        velocities;  ///< the result: at the end of the step, w 0; another buffer than the equation's

    bool wants_residual = true;  ///< else none is measured, and 0 is returned

    [[nodiscard]] auto timed(Stage stage) const { return profiler.time(static_cast<std::uint32_t>(stage)); }
};

struct SolveResult {
    float residual = 0;     ///< see StepResidual, which measures every method alike
    bool ok = true;         ///< false: no solution was found, and the velocities may hold anything
    bool unsolved = false;  ///< more of the equation is left than the method tolerates
    /// So much is left beside the motion itself that the next step had better not go on with how this one
    /// changed each particle's velocity.
    bool is_rough = false;
};

/// Owns what of its method lasts from substep to substep. All else lies in scratch, so that cloths that are
/// solved one after the other share it.
class Solver {
  public:
    Solver() = default;
    virtual ~Solver() = default;
    Solver& operator=(const Solver&) = delete;
    /// The same for another cloth of this model, with its copy of the model, before its first step: what is
    /// constant is shared. Null: nothing is; make another.
    [[nodiscard]] virtual std::unique_ptr<Solver> clone(const ClothModel& /*model*/) const { return nullptr; }
    /// Takes the memory for what prepare() then writes and is shared as yet. May run out of it.
    virtual void make_own(const ClothSettings& /*settings*/) {}
    /// Lays out what solve() fills and nothing needs after the substep; for contact of the cloth with itself
    /// in up to so many pairs.
    virtual void lay_out(Scratch& /*scratch*/, std::size_t /*pairs*/) { own_scratch_.free(); }
    /// The same in memory of its own, for who is in no World.
    void lay_out_alone(std::size_t pairs = 0) { own_scratch_.lay_out(*this, pairs); }
    /// Fills the step's velocities. Pinned particles keep theirs. Precondition: it is laid out.
    virtual SolveResult solve(const SolverStep& step) = 0;
    /// Whether make_solver() would make the same solver from these settings. Settings that do not matter to
    /// it are read by solve() at each step. The study's solvers are made otherwise and return false.
    [[nodiscard]] virtual bool serves(const ClothSettings& /*settings*/) const { return false; }
    /// Makes room, so that up to `count` particles can be pinned at a time without taking memory. May throw.
    virtual void reserve_pins(std::size_t /*count*/) {}
    /// Makes what depends on these settings, which it serves, so that no step has to.
    virtual void prepare(const ClothSettings& /*settings*/) noexcept {}
    /// A particle's inverse mass, in w of `positions`, has changed: it was pinned (0) or let go.
    virtual void inverse_mass_changed(std::uint32_t /*particle*/,
                                      std::span<const Vec4> /*positions*/) noexcept {}
    /// As inverse_mass_changed(), for any number of particles.
    virtual void inverse_masses_changed(std::span<const Vec4> /*positions*/) noexcept {}
    /// Whether it solves the whole equation, in any time scheme. Other methods take only h, positions and
    /// velocities from it.
    [[nodiscard]] virtual bool is_implicit() const noexcept { return true; }
    /// Whether features that touch are in the equation that it solves: see MultilevelSolver::solve().
    [[nodiscard]] virtual bool joins() const noexcept { return false; }
    /// Makes what contact of the cloth with itself needs, with so many pairs. May throw. Of none: frees it.
    virtual void reserve_pairs(std::size_t /*count*/) {}
    /// Its coarse levels; null: it has none.
    [[nodiscard]] virtual const Multigrid* multigrid() const noexcept { return nullptr; }
    /// Besides scratch.
    [[nodiscard]] virtual std::size_t bytes() const noexcept = 0;

  protected:
    Solver(const Solver&) = default;

  private:
    OwnScratch own_scratch_;
};

}  // namespace weft
