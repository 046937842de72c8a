#pragma once
// Triangle finite elements, with bending, as the linear system of an implicit step.

#include <algorithm>
#include <optional>

#include "cloth/equation/implicit_system.h"
#include "cloth/methods/finite_elements/element_rows.h"
#include "cloth/methods/finite_elements/hinge_elements.h"
#include "cloth/methods/finite_elements/triangle_elements.h"
#include "cloth/methods/finite_elements/triangle_matrix.h"
#include "cloth/methods/finite_elements/triangle_rows.h"

namespace weft {

/// W = M + gamma^2 K + gamma C. K is the elements' Hessian, made positive semi-definite element by element. C
/// is the damping times the part of K that resists strain; it leaves the part that resists rotation out, so
/// that cloth can turn undamped.
///
/// Elements of p particles have K_e <= p diag(K_e): p = 3 for triangles, 4 for hinges, 6 for hinges of one
/// triangle together. The diagonal that relaxation divides by is half of that sum, so that 2 D - W is
/// positive definite, as it is for springs.
class TriangleSystem final : public ImplicitSystem {
  public:
    TriangleSystem(const ClothModel& model, const ClothSettings& settings);

    [[nodiscard]] std::unique_ptr<ImplicitSystem> clone(const ClothModel& model) const override;
    [[nodiscard]] std::optional<SavedSprings> springs() const override;
    void lay_out(Scratch& scratch) override;
    void linearise(Parallel& parallel, const StepEquation& equation, std::span<const Vec4> velocities,
                   LinearisedAbout about) override;
    void residual(Parallel& parallel, const StepEquation& equation, std::span<const Vec4> velocities,
                  std::span<Vec4> residual) override;
    [[nodiscard]] const Stencil& stencil() const noexcept override {
        return block_entries_.empty() ? matrix_.stencil : matrix_.scalar_stencil;
    }
    [[nodiscard]] const ContactRows* contacts() const noexcept override { return matrix_.contacts; }
    void spring_blocks(Parallel& parallel, std::span<const std::uint32_t> slots,
                       std::span<Vec4> blocks) override;
    [[nodiscard]] std::size_t bytes() const noexcept override;

  protected:
    Products multiply_rows(const BlockRange& range, const DottedWith& with, const Vec4* x, Vec4* product,
                           GridWindow* window) const override;
    void subtract_product_rows(const BlockRange& range, const Vec4* b, const Vec4* x, Vec4* remainder,
                               GridWindow* window) const override;
    void precondition_rows(const BlockRange& range, const Vec4* b, float step, Vec4* x) const override;
    void relax_rows(const BlockRange& range, const Vec4* b, const Vec4* x, Relaxation relaxation, Vec4* next,
                    GridWindow* window) const override;

  private:
    TriangleSystem(const ClothModel& model, const ClothSettings& settings, const Bending& bending);
    TriangleSystem(const ClothModel& model, const ClothSettings& settings, const Bending& bending,
                   const ElementRows& rows);
    void store_quadratic_bending(const Bending& bending, const ElementRows& triangles);
    void store_dihedral_bending(const Bending& bending, const ElementRows& rows);

    /// Sets the elements' positions to x_base, or to x_base + gamma v.
    void place(Parallel& parallel, const StepEquation& equation, std::span<const Vec4> velocities,
               LinearisedAbout about);
    /// Fills the elements' results: forces, with the viscous ones if `viscous`, and blocks if `stiffness`.
    void compute_elements(Parallel& parallel, const StepEquation& equation, std::span<const Vec4> velocities,
                          bool viscous, bool stiffness);
    [[nodiscard]] TriangleState state_at(const StepEquation& equation,
                                         std::span<const Vec4> velocities) const;

    /// Fills the additions with dihedral bending and consistent mass, where the cloth has them; when
    /// linearised, adds these to the blocks, too.
    void make_additions(Parallel& parallel, const StepEquation& equation, std::span<const Vec4> velocities,
                        bool linearised, LinearisedAbout about);
    void add_bending(const StepEquation& equation, std::uint32_t i, bool linearised);
    /// The factor of the identity that is nearest to dihedral bending's block of an entry of particle i.
    [[nodiscard]] float bending_between(std::uint32_t i, std::uint32_t entry) const;
    void add_consistent_mass(const StepEquation& equation, std::span<const Vec4> velocities, std::uint32_t i,
                             bool linearised, LinearisedAbout about);

    const ClothModel* model_;
    TriangleElements elements_;
    TriangleMatrix matrix_;
    TriangleSources sources_;
    RowAdditions additions_;
    SharedBuffer<float> quadratic_;  // see TriangleState
    /// By entry of the scalar stencil, which has all neighbours: the block between them, or no_block.
    SharedBuffer<std::uint32_t> block_entries_;
    float bending_factor_ = 0;             // of the last linearisation, see bending_factor()
    std::optional<HingeElements> hinges_;  // only with dihedral bending
    ScratchArray<Vec4> positions_;         // of the last linearise() or residual()
};

}  // namespace weft
