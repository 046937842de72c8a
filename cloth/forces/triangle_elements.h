#pragma once
// All triangles of a cloth as finite elements: forces and stiffness of each into its own memory, with the
// widest vectors that the machine has. Particles gather them from there.

#include <array>
#include <cstdint>

#include "cloth/cook.h"
#include "engine/aligned_buffer.h"
#include "engine/parallel_blocks.h"
#include "weft/settings.h"

namespace weft {

/// Rest shapes and results, in groups of 16 triangles.
struct TriangleElements {
    explicit TriangleElements(const CookedCloth& model);

    /// Rows per triangle: the force on each corner [N]; then three rows each of the blocks from corner 0 to
    /// 1, 1 to 2 and 2 to 0, as in Stiffness.
    static constexpr std::uint32_t rows = 3 + 3 * 3;

    std::uint32_t count;
    std::array<AlignedBuffer<std::uint32_t>, 3> corners;  ///< particles
    std::array<AlignedBuffer<float>, 5> rest;             ///< the members of RestTriangle, in its order
    AlignedBuffer<Vec4> results;                          ///< per group 16 of each row

    [[nodiscard]] const Vec4* result(std::uint32_t triangle, std::uint32_t row) const noexcept {
        return &results[(std::size_t{triangle / 16} * rows + row) * 16 + triangle % 16];
    }
    [[nodiscard]] float area(std::uint32_t triangle) const noexcept { return rest[4][triangle]; }
    [[nodiscard]] std::size_t bytes() const noexcept;
};

/// C11, C22, C12 and G of triangle_fem-inl.h, by Young's moduli and Poisson's ratio.
struct MembraneModuli {
    float warp, weft, coupling, shear;  ///< [N/m]
};
[[nodiscard]] MembraneModuli membrane_moduli(const FiniteElements& settings);

/// What is asked of the triangles of one block.
struct TrianglePass {
    MembraneModuli moduli;
    const Vec4* positions;
    const Vec4* velocities;  ///< null: no viscous stress
    float viscosity;         ///< viscous stress is this [s] times the moduli, times the strain's rate
    bool stiffness;          ///< blocks too, as elastic x Hessian + viscous x what of it is not geometric
    float elastic, viscous;
};

/// Fills the results of a block of triangles. Forces are exact gradients; stiffness is semi-definite.
void compute_triangles(TriangleElements& elements, const BlockRange& range, const TrianglePass& pass);

}  // namespace weft
