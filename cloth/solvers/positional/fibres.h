#pragma once
// Position based dynamics (Mueller, Heidelberger, Hennix, Ratcliff 2007) with fibres and sets, as in PhysX 3
// (T.-Y. Kim, 2011): chains of constraints, each solved as a whole. Compliance as in XPBD, so that a
// stiffness means something.

#include "cloth/solvers/positional/displacements.h"
#include "cloth/solvers/positional/fibre_kernels.h"
#include "cloth/solvers/positional/fibre_sets.h"
#include "cloth/solvers/solver.h"

namespace weft {

class FibresSolver final : public Solver {
  public:
    FibresSolver(const CookedCloth& model, const ClothSettings& settings);

    float solve(const SolverStep& step) override;
    void prepare(const CookedCloth& model, const ClothSettings& settings,
                 std::span<const Vec4> positions) override;
    [[nodiscard]] bool is_implicit() const noexcept override { return false; }
    [[nodiscard]] std::size_t bytes() const noexcept override;

  private:
    void solve_set(const SolverStep& step, const FibreSet& set);

    FibreSets sets_;
    Displacements displacements_;
    AlignedBuffer<float> weights_;      // like sets_.particles
    AlignedBuffer<float> multipliers_;  // like sets_.rest_lengths
    AlignedBuffer<float> scratch_;      // for the largest set that is factorised
};

}  // namespace weft
