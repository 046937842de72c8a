#pragma once
// One coarse level: its operator, summed anew from the finer level's, and the vectors of a cycle.

#include <span>

#include "cloth/equation/sparse/transfers.h"
#include "cloth/solver/levels/coarse/coarse_matrix.h"
#include "cloth/solver/levels/coarse/coarse_pairs.h"
#include "cloth/solver/levels/coarse/coarsening.h"
#include "cloth/solver/levels/coarse/component_solver.h"
#include "cloth/solver/levels/coarse/galerkin.h"
#include "engine/memory/scratch.h"
#include "engine/threads/parallel_blocks.h"

namespace weft {

class CoarseLevel {
  public:
    /// The links, the graph and its components describe the springs between this level's nodes. The
    /// interpolation leads from here to the finer level. Moves the links' lists.
    CoarseLevel(CoarseLinks& links, Interpolation interpolation, const SpringGraph& graph,
                const Components& components);
    /// The level's constant part.
    struct Constants {
        GalerkinLists lists;
        Interpolation interpolation;
        Stencil stencil;
        SharedBuffer<std::uint32_t> link_rows;
        SmallComponents small_components;
    };
    explicit CoarseLevel(Constants constants);
    [[nodiscard]] Constants constant_part() const;
    /// Lays out, in this order, rows of contact, for so many of the finer level; the sums that finish() reads
    /// last; what finish() and the cycles write, the last two in place of what is no longer in use.
    void lay_out_pairs(Scratch& scratch, std::size_t finer_pair_rows) {
        pairs_.lay_out(scratch, finer_pair_rows, nodes());
    }
    void lay_out_sums(Scratch& scratch) { matrix_.lay_out_sums(scratch, lists_); }
    void lay_out_cycle(Scratch& scratch);

    /// Sums the links from the finest level's springs d d^T + a I, given as (d, a) by the index that the
    /// lists name, and from the constants by place times `constant_scale`.
    void sum_links(Parallel& parallel, std::span<const Vec4> springs, std::span<const double> constants,
                   float constant_scale);
    /// Restricts the finer level's ground to this level. Without `off_diagonal` those entries are 0.
    void sum_ground(Parallel& parallel, std::span<const Vec4> diagonal, std::span<const Vec4> off_diagonal);
    /// Sums links and ground from a finer coarse level.
    void sum(Parallel& parallel, const CoarseLevel& finer);
    /// Adds the rows' diagonal bound to the ground. finish() and later calls replace it by the rows.
    void add_bound_of_pairs();
    /// Makes the matrix from links and ground, and factorises its small components.
    void finish(Parallel& parallel);

    /// remainder = b - W x.
    void subtract_product(Parallel& parallel, std::span<Vec4> remainder) const;
    /// x = step D^-1 b.
    void relax_from_zero(Parallel& parallel, float step);
    /// One step of relaxation on x, as ImplicitSystem::relax(). before() keeps the previous iterate, and may
    /// be overwritten between steps without momentum.
    void relax(Parallel& parallel, Relaxation relaxation);
    /// x = W^-1 b at the nodes of small components.
    void solve_small_components(Parallel& parallel);
    /// Whether all nodes are in small components.
    [[nodiscard]] bool has_small_components_only() const noexcept {
        return small_components_.nodes() == nodes();
    }

    [[nodiscard]] std::uint32_t nodes() const noexcept { return matrix_.stencil.nodes; }
    [[nodiscard]] const Interpolation& interpolation() const noexcept { return interpolation_; }
    [[nodiscard]] const GalerkinLists& lists() const noexcept { return lists_; }
    [[nodiscard]] const CoarseMatrix& matrix() const noexcept { return matrix_; }
    [[nodiscard]] CoarseMatrix& matrix() noexcept { return matrix_; }
    [[nodiscard]] std::span<Vec4> b() noexcept { return b_.span(); }
    [[nodiscard]] std::span<Vec4> x() noexcept { return x_.span(); }
    [[nodiscard]] std::span<Vec4> before() noexcept { return before_.span(); }
    /// Rows of the cloth's contact with itself.
    [[nodiscard]] CoarsePairs& pairs() noexcept { return pairs_; }
    [[nodiscard]] const CoarsePairs& pairs() const noexcept { return pairs_; }
    [[nodiscard]] std::size_t bytes() const noexcept;

  private:
    /// b, corrected at x by the rows of contact less their bound.
    [[nodiscard]] std::span<const Vec4> corrected_b() const;

    GalerkinLists lists_;
    Interpolation interpolation_;
    CoarseMatrix matrix_;
    ComponentSolver small_components_;
    CoarsePairs pairs_;
    ScratchArray<Vec4> b_, x_, before_;
    mutable ScratchArray<Vec4> corrected_;
};

}  // namespace weft
