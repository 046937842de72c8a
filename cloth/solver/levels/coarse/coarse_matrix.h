#pragma once
// The matrix of a coarse level and the loops over it, with the widest vectors that the machine has.

#include <cstdint>
#include <utility>

#include "cloth/equation/contacts.h"
#include "cloth/equation/implicit_system.h"
#include "cloth/equation/sparse/stencil.h"
#include "cloth/solver/levels/coarse/galerkin.h"
#include "engine/memory/scratch.h"
#include "engine/memory/shared_buffer.h"
#include "engine/simd/symmetric3.h"
#include "engine/threads/parallel_blocks.h"

namespace weft {

/// Symmetric blocks as two rows each.
struct SymmetricRows {
    ScratchArray<Vec4> diagonal;      ///< xx yy zz, w 0
    ScratchArray<Vec4> off_diagonal;  ///< xy xz yz, w 0

    void lay_out(Scratch& scratch, std::size_t blocks) {
        scratch.take(diagonal, blocks);
        scratch.take(off_diagonal, blocks);
    }
    [[nodiscard]] Symmetric3 operator[](std::size_t i) const {
        const Vec4 &d = diagonal[i], &o = off_diagonal[i];
        return {.xx = d.x, .yy = d.y, .zz = d.z, .xy = o.x, .xz = o.y, .yz = o.z};
    }
    void set(std::size_t i, const Symmetric3& block) {
        diagonal[i] = {block.xx, block.yy, block.zz, 0};
        off_diagonal[i] = {block.xy, block.xz, block.yz, 0};
    }
};

/// Row I:  G_I x_I + sum_J A_IJ (x_I - x_J).  Symmetric blocks are stored as xx, yy, zz, xy, xz, yz.
struct CoarseMatrix {
    static constexpr std::uint32_t arrays = 6;

    CoarseMatrix() = default;
    CoarseMatrix(const SpringGraph& graph, const CoarseLinks& links);
    /// Takes over saved lists.
    CoarseMatrix(Stencil of_level, SharedBuffer<std::uint32_t> rows)
        : stencil(std::move(of_level)), link_rows(std::move(rows)) {}
    /// Lays out the sums of which the matrix is made, and the matrix.
    void lay_out_sums(Scratch& scratch, const GalerkinLists& lists);
    void lay_out_matrix(Scratch& scratch);

    Stencil stencil;                        ///< without entries
    ScratchArray<float> coefficients;       ///< A_IJ per slot: 16 of each entry
    ScratchArray<float> ground;             ///< G_I per group: 16 of each entry
    ScratchArray<float> inverse_diagonal;   ///< laid out as ground; 0 for nodes without inertia
    SymmetricRows ground_rows;              ///< sum: G_I by node
    SymmetricRows links;                    ///< sum: A_IJ by place in the lists; last a block of zeros
    SharedBuffer<std::uint32_t> link_rows;  ///< by entry: its link's number in `links`

    /// The place of the link between two nodes; that of the zeros, if they have none.
    [[nodiscard]] std::uint32_t place_between(const Link& link, const GalerkinLists& lists) const noexcept;
    [[nodiscard]] std::size_t bytes() const noexcept { return stencil.bytes() + link_rows.bytes(); }
};

/// The ground of a block of particles, r_i I + G_i, as rows. Without contacts the off-diagonal rows are not
/// written.
void ground_rows_block(const BlockRange& range, const Vec4* right_side, const ContactRows* contacts,
                       Vec4* diagonal, Vec4* off_diagonal);
/// Sums a block of the lists' places from the finest level's springs, d d^T + a I given as (d, a), and from
/// constants by place times `scale`.
void sum_springs_block(const GalerkinLists& lists, const BlockRange& range, const Vec4* springs,
                       const double* constants, float scale, SymmetricRows& sums);
/// Sums a block of the lists' places from a finer coarse level's links.
void sum_links_block(const GalerkinLists& lists, const BlockRange& range, const SymmetricRows& links,
                     SymmetricRows& sums);
/// Makes a block's coefficients and inverse diagonal from links and ground.
void finish_block(const BlockRange& range, CoarseMatrix& matrix);

/// Loops over a block of rows, as ImplicitSystem's functions of the same names.
void subtract_product_block(const CoarseMatrix& matrix, const BlockRange& range, const Vec4* b, const Vec4* x,
                            Vec4* remainder);
void relax_block(const CoarseMatrix& matrix, const BlockRange& range, const Vec4* b, const Vec4* x,
                 Relaxation relaxation, Vec4* next);
void precondition_block(const CoarseMatrix& matrix, const BlockRange& range, const Vec4* b, float step,
                        Vec4* x);

}  // namespace weft
