#pragma once
// Springs as the linear system of an implicit step.

#include <bit>
#include <memory>
#include <optional>

#include "cloth/equation/implicit_system.h"
#include "cloth/fabric/spring_forces.h"
#include "cloth/fabric/springs/spring_matrix.h"

namespace weft {

/// The parts of a SpringSystem that are constant as long as its fabric's membrane is.
struct SavedSprings {
    Stencil stencil;
    SharedBuffer<std::uint32_t> places;  ///< SpringMatrix::group_places
    /// SpringMatrix::isotropic, a bit for each diagonal.
    std::uint32_t isotropic = 0;
    Fabric membrane{.areal_density = -1};  ///< the fabric of the springs; none yet
    SpringTable table;
    Rings rings;
    Diagonals diagonals;  ///< not saved: the model determines them

    /// Calls visit(list) and visit.value(number) for all that is saved.
    template <class Self, class Visit>
    static void for_each_list(Self& self, Visit& visit) {
        visit.value(self.stencil.nodes);
        visit.value(self.isotropic);
        visit.value(self.membrane.warp);
        visit.value(self.membrane.weft);
        visit.value(self.membrane.shear);
        visit.value(self.membrane.stiffening);
        visit.value(self.membrane.areal_density);
        Stencil::for_each_list(self.stencil, visit);
        visit(self.places);
        SpringTable::for_each_list(self.table, visit);
        Rings::for_each_list(self.rings, visit);
    }
    /// Whether lists that were read have the sizes and indices that this model needs.
    [[nodiscard]] bool is_sound(const ClothModel& model, bool stiffens) const;
    [[nodiscard]] std::size_t entries() const noexcept {
        return diagonals.empty() ? stencil.neighbours.size() : diagonals.entries();
    }
    /// See SpringMatrix::spring_places(). Precondition: the diagonals are known.
    [[nodiscard]] std::size_t spring_places() const noexcept {
        const std::uint32_t along = ~isotropic & ((1u << diagonals.count) - 1);
        return diagonals.entries() / diagonals.count * static_cast<std::size_t>(std::popcount(along));
    }
};

/// A sheet's diagonals; empty for a general mesh, and for a large sheet of so few rows that threads would
/// have nothing to share.
[[nodiscard]] Diagonals diagonals_of(const ClothModel& model);

/// Row i:  D_i dv_i - sum_j A_ij dv_j = b_i,  D_i = r_i I + G_i + sum_j A_ij,  A_ij = gamma^2 K_ij + gamma c
/// n n^T = a I + d d^T.
class SpringSystem final : public ImplicitSystem {
  public:
    /// With `stiffens`, the system serves fabrics that stiffen as well as others.
    explicit SpringSystem(const ClothModel& model, bool stiffens = false);
    /// Makes a system of saved lists, without scratch of its own.
    SpringSystem(const ClothModel& model, SavedSprings&& saved);
    [[nodiscard]] std::optional<SavedSprings> springs() const override;
    [[nodiscard]] std::unique_ptr<ImplicitSystem> clone(const ClothModel& model) const override;
    void make_own(const Fabric& fabric) override;
    void prepare(const Fabric& fabric) noexcept override;
    void lay_out(Scratch& scratch) override;

    void linearise(Parallel& parallel, const StepEquation& equation, std::span<const Vec4> velocities,
                   LinearisedAbout about) override;
    void residual(Parallel& parallel, const StepEquation& equation, std::span<const Vec4> velocities,
                  std::span<Vec4> residual) override;
    void subtract_first_step(Parallel& parallel, std::span<const Vec4> b, float step, std::span<Vec4> x,
                             std::span<Vec4> remainder) override;
    void relax_corrected(Parallel& parallel, std::span<const Vec4> b, float step, std::span<Vec4> x,
                         const Correction& correction, std::span<Vec4> next) override;
    [[nodiscard]] const Stencil& stencil() const noexcept override { return matrix_.stencil; }
    [[nodiscard]] Neighbours neighbours_of(std::uint32_t i) const noexcept override {
        const std::uint32_t begin = model_->spring_offsets[i];
        return {model_->neighbours.data() + begin, model_->spring_offsets[i + 1] - begin, 1};
    }
    [[nodiscard]] const ContactRows* contacts() const noexcept override { return matrix_.contacts; }
    [[nodiscard]] std::uint32_t entry_between(std::uint32_t i, std::uint32_t j) const override;
    [[nodiscard]] std::size_t entries() const noexcept override { return matrix_.entries(); }
    void spring_blocks(Parallel& parallel, std::span<const std::uint32_t> slots,
                       std::span<Vec4> blocks) override;
    [[nodiscard]] float constant_block(std::uint32_t i, std::uint32_t j) const override;
    [[nodiscard]] float constant_scale() const noexcept override { return constant_scale_; }
    [[nodiscard]] std::size_t bytes() const noexcept override;

  protected:
    Products multiply_coupled_rows(const BlockRange& range, const DottedWith& with, const Vec4* x,
                                   Vec4* product, GridWindow* window) const override;
    Products multiply_rows(const BlockRange& range, const DottedWith& with, const Vec4* x, Vec4* product,
                           GridWindow* window) const override;
    void subtract_product_rows(const BlockRange& range, const Vec4* b, const Vec4* x, Vec4* remainder,
                               GridWindow* window) const override;
    void precondition_rows(const BlockRange& range, const Vec4* b, float step, Vec4* x) const override;
    void relax_rows(const BlockRange& range, const Vec4* b, const Vec4* x, Relaxation relaxation, Vec4* next,
                    GridWindow* window) const override;

  private:
    [[nodiscard]] bool has_membrane_of(const Fabric& fabric) const noexcept;
    [[nodiscard]] SpringState state_at(Parallel& parallel, const StepEquation& equation,
                                       std::span<const Vec4> velocities, LinearisedAbout about);

    const ClothModel* model_;
    SpringMatrix matrix_;
    Fabric membrane_{.areal_density = -1};  // the fabric of the springs; none yet
    SpringTable table_;                     // of a grid
    Rings rings_;                           // of any other mesh
    float constant_scale_ = 0;
    float coupling_ = 0;            // gamma^2 of the last linearisation about an iterate, on meshes; else 0
    ScratchArray<Vec4> positions_;  // x_base + gamma v, for rings; a grid computes these as it reads
};

}  // namespace weft
