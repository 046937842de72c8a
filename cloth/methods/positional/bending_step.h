#pragma once
// Bending for positional methods: one step of Jacobi's iteration on backward Euler, element by element. It is
// stable at any rigidity, keeps momentum, keeps straight cloth straight, and improves as steps get shorter.

#include <span>
#include <vector>

#include "cloth/mesh/rest/linear_bending.h"
#include "cloth/methods/positional/occurrences.h"
#include "cloth/solver/solver.h"
#include "engine/memory/aligned_buffer.h"

namespace weft {

class BendingStep {
  public:
    explicit BendingStep(const ClothModel& model) : BendingStep(model, linear_bending(model)) {}
    /// Applies bending to the particles at start + moved: changes `moved`.
    void apply(const SolverStep& step, std::span<const Vec4> start, std::span<Vec4> moved);
    [[nodiscard]] std::size_t bytes() const noexcept {
        return elements_.bytes() + impulses_.bytes() + bounds_.bytes() + occurrences_.bytes();
    }

  private:
    BendingStep(const ClothModel& model, const std::vector<BendingElement>& elements);

    AlignedBuffer<BendingElement> elements_;
    AlignedBuffer<Vec4> impulses_;  // by element: the impulse over c B h^2 [1/m]
    AlignedBuffer<float> bounds_;   // by particle: D_i [1/m^2]
    Occurrences occurrences_;       // by particle: 4 element + corner
};

}  // namespace weft
