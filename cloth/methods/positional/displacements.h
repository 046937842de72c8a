#pragma once
// Particles in positional methods: their positions at the start of the step, and their displacements since.
// Positions alone would round these away: at 64 substeps a particle moves some ten thousandths of its
// coordinate, and its velocity is that over h.

#include "cloth/methods/positional/bending_step.h"
#include "cloth/solver/solver.h"
#include "engine/memory/aligned_buffer.h"

namespace weft {

class Displacements {
  public:
    /// `stand_ins`: particles behind the last one, each at its own place, for unused lanes.
    Displacements(const ClothModel& model, std::uint32_t stand_ins);

    /// Moves all particles as if nothing but external forces and bending acted.
    void predict(const SolverStep& step);
    /// Sets the step's velocities to the displacements over h.
    void find_velocities(const SolverStep& step) const;

    [[nodiscard]] std::span<const Vec4> start() const { return start_.span(); }
    [[nodiscard]] std::span<Vec4> moved() { return moved_.span(); }
    [[nodiscard]] std::size_t bytes() const noexcept {
        return start_.bytes() + moved_.bytes() + bending_.bytes();
    }

  private:
    BendingStep bending_;
    AlignedBuffer<Vec4> start_, moved_;  // [m], w 0
};

}  // namespace weft
