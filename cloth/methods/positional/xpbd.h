#pragma once
// Extended position based dynamics (Macklin, Mueller, Chentanez 2016): springs as constraints of compliance 1
// / k, solved by Gauss-Seidel in colours. With one iteration a step and many substeps it is the method of
// Macklin et al. 2019.

#include "cloth/methods/positional/colouring.h"
#include "cloth/methods/positional/displacements.h"
#include "cloth/methods/positional/occurrences.h"
#include "cloth/methods/positional/xpbd_kernel.h"
#include "cloth/solver/solver.h"
#include "cloth/solver/step_residual.h"

namespace weft {

class XpbdSolver final : public Solver {
  public:
    XpbdSolver(const ClothModel& model, std::span<const Vec4> positions);

    SolveResult solve(const SolverStep& step) override;
    [[nodiscard]] bool serves(const ClothSettings& settings) const override {
        return std::holds_alternative<Xpbd>(settings.method);
    }
    void prepare(const ClothSettings& settings) noexcept override {
        if (h_ > 0) find_responses(settings.fabric, h_);
    }
    void inverse_mass_changed(std::uint32_t particle, std::span<const Vec4> positions) noexcept override;
    void inverse_masses_changed(std::span<const Vec4> positions) noexcept override;
    [[nodiscard]] bool is_implicit() const noexcept override { return false; }
    [[nodiscard]] std::size_t bytes() const noexcept override;

  private:
    void find_responses(const Fabric& fabric, float h) noexcept;
    void find_response(std::uint32_t spring) noexcept;

    const ClothModel& model_;
    SpringColours colours_;
    Occurrences firsts_, seconds_;  // of particles among the springs' ends
    XpbdSprings springs_;
    Displacements displacements_;
    Fabric fabric_{.areal_density = -1};  // of the responses; none yet
    float h_ = 0;
    AlignedBuffer<float> stiffness_;  // by half-edge [N/m]
    StepResidual residual_;
};

}  // namespace weft
