#pragma once
// Position based dynamics (Mueller, Heidelberger, Hennix, Ratcliff 2007) with fibres and sets, as in PhysX 3
// (T.-Y. Kim, 2011): chains of constraints, each solved as a whole. Compliance is as in XPBD, so that
// stiffness has its physical meaning.

#include "cloth/methods/fibres/fibre_kernels.h"
#include "cloth/methods/fibres/fibre_sets.h"
#include "cloth/methods/positional/displacements.h"
#include "cloth/methods/positional/occurrences.h"
#include "cloth/solver/solver.h"
#include "cloth/solver/step_residual.h"

namespace weft {

class FibresSolver final : public Solver {
  public:
    FibresSolver(const ClothModel& model, const ClothSettings& settings, std::span<const Vec4> positions);

    SolveResult solve(const SolverStep& step) override;
    /// Whether the set solvers are the same: memory depends on them, not on the iterations.
    [[nodiscard]] bool serves(const ClothSettings& settings) const override;
    void prepare(const ClothSettings& settings) noexcept override {
        if (h_ > 0) find_compliances(settings.fabric, h_);
    }
    void inverse_mass_changed(std::uint32_t particle, std::span<const Vec4> positions) noexcept override;
    void inverse_masses_changed(std::span<const Vec4> positions) noexcept override;
    [[nodiscard]] bool is_implicit() const noexcept override { return false; }
    [[nodiscard]] std::size_t bytes() const noexcept override;

  private:
    void find_compliances(const Fabric& fabric, float h) noexcept;
    void solve_set(const SolverStep& step, const FibreSet& set);

    const ClothModel& model_;
    Fibres method_;  // the method that memory was made for
    FibreSets sets_;
    Occurrences occurrences_;             // in sets_.particles
    Fabric fabric_{.areal_density = -1};  // of the compliances; none yet
    float h_ = 0;
    AlignedBuffer<float> stiffness_;    // by half-edge [N/m]
    AlignedBuffer<float> compliances_;  // like sets_.rest_lengths
    Displacements displacements_;
    AlignedBuffer<float> weights_;      // inverse masses, like sets_.particles
    AlignedBuffer<float> multipliers_;  // like sets_.rest_lengths
    AlignedBuffer<float> scratch_;      // for the largest set that is factorised
    StepResidual residual_;
};

}  // namespace weft
