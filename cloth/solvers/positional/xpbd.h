#pragma once
// Extended position based dynamics (Macklin, Mueller, Chentanez 2016): springs as constraints of compliance 1
// / k, solved by Gauss-Seidel in colours. With one iteration a step and many substeps it is the method of
// Macklin et al. 2019.

#include "cloth/solvers/positional/colouring.h"
#include "cloth/solvers/positional/displacements.h"
#include "cloth/solvers/positional/xpbd_kernel.h"
#include "cloth/solvers/solver.h"

namespace weft {

class XpbdSolver final : public Solver {
  public:
    XpbdSolver(const CookedCloth& model, const ClothSettings& settings);

    float solve(const SolverStep& step) override;
    void prepare(const CookedCloth& model, const ClothSettings& settings,
                 std::span<const Vec4> positions) override;
    [[nodiscard]] bool is_implicit() const noexcept override { return false; }
    [[nodiscard]] std::size_t bytes() const noexcept override;

  private:
    /// Makes what depends on h, where it is another than before.
    void find_responses(const CookedCloth& model, const Fabric& fabric, float h);

    SpringColours colours_;
    XpbdSprings springs_;
    Displacements displacements_;
    float h_ = 0;  // that the responses are for; 0: none
};

}  // namespace weft
