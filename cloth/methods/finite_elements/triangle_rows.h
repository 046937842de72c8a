#pragma once
// The matrix's rows from elements: each particle gathers from its triangles, a block of particles at a time,
// with the widest vectors that the machine has.

#include <array>
#include <cstdint>
#include <span>

#include "cloth/equation/implicit_system.h"
#include "cloth/equation/step_equation.h"
#include "cloth/methods/finite_elements/element_rows.h"
#include "cloth/methods/finite_elements/triangle_elements.h"
#include "cloth/methods/finite_elements/triangle_matrix.h"

namespace weft {

/// The sources of an edge's blocks: edge (i, j) is a side of one or two triangles, and block (i, j) is their
/// sum. A side that runs from i to j gives its block and the force on i; one that runs from j to i gives the
/// transposed block.
struct TriangleSources {
    TriangleSources(const ClothModel& model, const TriangleElements& elements, const Stencil& stencil,
                    const ElementRows& rows);

    struct Source {
        SharedBuffer<std::uint32_t>
            sides;  ///< per entry of the stencil: TriangleElements::side, or zero_side
        SharedBuffer<float>
            runs_along;  ///< 1 where the triangle runs from the particle to the neighbour, else 0
    };
    std::array<Source, 2> sources;

    /// Rest area of the triangles that an edge's two ends share [m^2]; 0 where they share none.
    [[nodiscard]] float shared_area(const TriangleElements& elements, std::uint32_t entry) const;
    [[nodiscard]] std::size_t bytes() const noexcept;
};

/// Terms of consistent mass and dihedral bending in the rows of elements; empty without both.
struct RowAdditions {
    AlignedBuffer<Vec4> impulses;    ///< added to b [kg m/s]
    AlignedBuffer<float> diagonals;  ///< added to relaxation's diagonal: per group 16 xx, yy, zz, xy, xz, yz

    [[nodiscard]] std::size_t bytes() const noexcept { return impulses.bytes() + diagonals.bytes(); }
};

/// The elements' results, and the state of the cloth that they belong to. Vectors as in ImplicitSystem.
struct TriangleState {
    const StepEquation& equation;
    const TriangleElements& elements;
    const TriangleSources& sources;
    const RowAdditions& additions;    ///< if not empty, blocks are added to those in the matrix
    std::span<const Vec4> positions;  ///< w inverse mass
    std::span<const Vec4> velocities;
    std::span<const float> quadratic;  ///< the diagonal of quadratic bending of rigidity 1 [1/m^2], or empty
};

/// Makes the rows of W and b of one block; see ImplicitSystem::linearise.
void linearise_block(const TriangleState& state, LinearisedAbout about, const BlockRange& range,
                     TriangleMatrix& matrix, Vec4* right_side);
void residual_block(const TriangleState& state, const BlockRange& range, const TriangleMatrix& matrix,
                    Vec4* residual);

}  // namespace weft
