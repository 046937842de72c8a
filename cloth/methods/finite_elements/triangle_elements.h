#pragma once
// All triangles of a cloth as finite elements. Each writes its forces and stiffness to its own memory, with
// the widest vectors that the machine has; particles gather from there.

#include <array>
#include <cstdint>

#include "cloth/equation/sparse/stencil.h"
#include "cloth/mesh/cook.h"
#include "engine/memory/scratch.h"
#include "engine/memory/shared_buffer.h"
#include "engine/threads/parallel_blocks.h"
#include "weft/settings.h"

namespace weft {

/// Rest shapes and results, in groups of 16 triangles.
struct TriangleElements {
    explicit TriangleElements(const ClothModel& model);
    void lay_out(Scratch& scratch);

    /// Rows per triangle: for each side, from corner k to the next, the three rows of that block of Stiffness
    /// and the force on corner k [N]. The first row's w is what that block has along the triangle's normal.
    static constexpr std::uint32_t rows_per_side = 4, rows = 3 * rows_per_side;

    std::uint32_t count;
    std::array<SharedBuffer<std::uint32_t>, 3> corners;  ///< particles
    std::array<SharedBuffer<float>, 5> rest;             ///< the members of RestTriangle, in its order
    ScratchArray<Vec4> results;                          ///< per group 16 of each row; last a group of zeros

    /// Index of a side's first row in the results; its other rows follow, every 16.
    [[nodiscard]] static std::uint32_t side(std::uint32_t triangle, std::uint32_t corner) noexcept {
        return (triangle / Stencil::lanes * rows + corner * rows_per_side) * Stencil::lanes +
               triangle % Stencil::lanes;
    }
    [[nodiscard]] static std::uint32_t triangle_of(std::uint32_t side) noexcept {
        return side / (rows * Stencil::lanes) * Stencil::lanes + side % Stencil::lanes;
    }
    [[nodiscard]] std::uint32_t zero_side() const noexcept {
        return side((count + Stencil::lanes - 1) / Stencil::lanes * Stencil::lanes, 0);
    }
    [[nodiscard]] float area(std::uint32_t triangle) const noexcept { return rest[4][triangle]; }
    [[nodiscard]] std::size_t bytes() const noexcept;
};

/// C11, C22, C12 and G of triangle_fem-inl.h, by Young's moduli and Poisson's ratio.
struct MembraneModuli {
    float warp, weft, coupling, shear;  ///< [N/m]
};
[[nodiscard]] MembraneModuli membrane_moduli(const Fabric& fabric, float poisson);

/// Input of compute_triangles() for one block.
struct TrianglePass {
    MembraneModuli moduli;
    const Vec4* positions;
    const Vec4* velocities;  ///< null: no viscous stress
    float viscosity;         ///< viscous stress is this [s] times the moduli, times the strain's rate
    bool stiffness;          ///< blocks too: elastic x Hessian + viscous x its part that is not geometric
    float elastic, viscous;
};

/// Fills the results of a block of triangles. Forces are exact gradients; stiffness is semi-definite.
void compute_triangles(TriangleElements& elements, const BlockRange& range, const TrianglePass& pass);

}  // namespace weft
