#pragma once
// The matrix of finite elements, whose blocks may be any 3x3 matrices, and the loops over its rows.

#include <cstdint>
#include <utility>

#include "cloth/equation/contacts.h"
#include "cloth/equation/implicit_system.h"
#include "engine/memory/scratch.h"
#include "engine/memory/shared_buffer.h"
#include "engine/threads/parallel_blocks.h"

namespace weft {

/// W by rows, in groups of 16 particles: (W x)_i = (r_i + G_i) x_i + sum_j A_ij (x_i - x_j) + scale sum_j
/// a_ij (x_i - x_j), blocks A over one stencil and numbers a, which never change, over another.
struct TriangleMatrix {
    explicit TriangleMatrix(Stencil neighbours) : stencil(std::move(neighbours)) {}
    void lay_out(Scratch& scratch);

    Stencil stencil;
    ScratchArray<float> blocks;  ///< per slot 9 times 16 entries of A, by rows
    Stencil scalar_stencil;
    SharedBuffer<float> scalars;            ///< a, per entry of the scalar stencil
    float scale = 0;                        ///< 0: no scalars
    ScratchArray<float> row_sums;           ///< r_i [kg]; 0 for pinned particles, whose rows count as 0
    const ContactRows* contacts = nullptr;  ///< G; null: there are no colliders
    ScratchArray<float> inverse_diagonal;   ///< per group 16 xx, yy, zz, xy, xz, yz; 0 for pinned particles

    [[nodiscard]] std::size_t bytes() const noexcept {
        return stencil.bytes() + scalar_stencil.bytes() + scalars.bytes();
    }
};

/// ImplicitSystem's functions of the same names, for one block. They return its shares.
Products multiply_block(const TriangleMatrix& matrix, const BlockRange& range, const DottedWith& with,
                        const Vec4* x, Vec4* product);
void subtract_product_block(const TriangleMatrix& matrix, const BlockRange& range, const Vec4* b,
                            const Vec4* x, Vec4* remainder);
void relax_block(const TriangleMatrix& matrix, const BlockRange& range, const Vec4* b, const Vec4* x,
                 Relaxation relaxation, Vec4* next);
void precondition_block(const TriangleMatrix& matrix, const BlockRange& range, const Vec4* b, float step,
                        Vec4* x);

}  // namespace weft
