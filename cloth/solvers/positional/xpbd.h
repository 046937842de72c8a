#pragma once
// Extended position based dynamics (Macklin, Mueller, Chentanez 2016): springs as constraints of compliance 1
// / k, solved by Gauss-Seidel in colours. With one iteration a step and many substeps it is the method of
// Macklin et al. 2019.

#include <array>

#include "cloth/solvers/positional/colouring.h"
#include "cloth/solvers/positional/displacements.h"
#include "cloth/solvers/positional/occurrences.h"
#include "cloth/solvers/positional/xpbd_kernel.h"
#include "cloth/solvers/solver.h"

namespace weft {

class XpbdSolver final : public Solver {
  public:
    XpbdSolver(const CookedCloth& model, std::span<const Vec4> positions);

    SolveResult solve(const SolverStep& step) override;
    [[nodiscard]] bool serves(const ClothSettings& settings) const override {
        return std::holds_alternative<Xpbd>(settings.method);
    }
    void inverse_mass_changed(std::uint32_t particle, std::span<const Vec4> positions) noexcept override;
    void inverse_masses_changed(std::span<const Vec4> positions) noexcept override;
    [[nodiscard]] bool is_implicit() const noexcept override { return false; }
    [[nodiscard]] std::size_t bytes() const noexcept override;

  private:
    /// What the springs' responses are made of, but for their particles' inverse masses.
    struct Stiffness {
        std::array<float, 3> kappa{};  // by SpringKind: k h^2, the inverse of XPBD's alpha~ [kg]
        float gamma = 0;               // damping / h
        friend bool operator==(const Stiffness&, const Stiffness&) = default;
    };
    void find_responses(const Stiffness& stiffness);
    void find_response(std::uint32_t spring) noexcept;

    const CookedCloth& model_;
    SpringColours colours_;
    Occurrences firsts_, seconds_;  // of particles among the springs' ends
    XpbdSprings springs_;
    Displacements displacements_;
    Stiffness stiffness_;  // that the responses are for
};

}  // namespace weft
