#pragma once
// The matrix of a coarse level and the loops over it, with the widest vectors that the machine has.

#include <cstdint>
#include <span>
#include <vector>

#include "cloth/implicit/galerkin.h"
#include "cloth/implicit/implicit_system.h"
#include "cloth/implicit/stencil.h"
#include "cloth/implicit/symmetric3.h"
#include "engine/aligned_buffer.h"
#include "engine/parallel_blocks.h"

namespace weft {

/// A symmetric block as two rows.
struct alignas(32) SplitBlock {
    Vec4 diagonal;      ///< xx yy zz, w 0
    Vec4 off_diagonal;  ///< xy yz zx, w anything
};

/// Row I:  G_I x_I + sum_J A_IJ (x_I - x_J).  Symmetric blocks are stored as xx, yy, zz, xy, xz, yz.
struct CoarseMatrix {
    static constexpr std::uint32_t arrays = 6;

    CoarseMatrix() = default;
    CoarseMatrix(const SpringGraph& graph, const std::vector<Link>& links);

    Stencil stencil;
    AlignedBuffer<float> coefficients;       ///< A_IJ per slot: 16 of each entry
    AlignedBuffer<float> ground;             ///< G_I per group: 16 of each entry
    AlignedBuffer<float> inverse_diagonal;   ///< likewise; 0 for nodes without inertia
    AlignedBuffer<SplitBlock> links;         ///< A_IJ by link, and a last one that is 0
    AlignedBuffer<std::uint32_t> link_rows;  ///< of each entry: twice its link's number, in `links` as rows

    [[nodiscard]] Symmetric3 ground_of(std::uint32_t node) const;
    void set_ground(std::uint32_t node, const Symmetric3& block);
    [[nodiscard]] std::size_t bytes() const noexcept;
};

/// Sums the links of a block from the finest level's springs, d d^T + a I given as (d, a).
void sum_springs_block(const GalerkinLists& lists, const BlockRange& range, const Vec4* springs,
                       CoarseMatrix& matrix);
/// Sums the links of a block from a finer coarse level's.
void sum_links_block(const GalerkinLists& lists, const BlockRange& range, const SplitBlock* links,
                     CoarseMatrix& matrix);
/// After links and ground: a block's coefficients, and the inverse of its diagonal.
void finish_block(const BlockRange& range, CoarseMatrix& matrix);

/// As ImplicitSystem's functions of the same name.
void subtract_product_block(const CoarseMatrix& matrix, const BlockRange& range, const Vec4* b, const Vec4* x,
                            Vec4* remainder);
void relax_block(const CoarseMatrix& matrix, const BlockRange& range, const Vec4* b, const Vec4* x,
                 Relaxation relaxation, Vec4* next);
void precondition_block(const CoarseMatrix& matrix, const BlockRange& range, const Vec4* b, float step,
                        Vec4* x);

}  // namespace weft
