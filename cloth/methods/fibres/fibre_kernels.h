#pragma once
// The two set solvers, on 16 fibres side by side.

#include <cstdint>

#include "cloth/methods/fibres/fibre_sets.h"
#include "weft/types.h"

namespace weft {

/// One group of a set's fibres, and the data of its constraints.
struct FibreGroup {
    static constexpr std::uint32_t scratch_rows =
        6;  ///< rows of 16 floats that LDL^T needs per row of springs

    std::uint32_t rows;              ///< of springs
    const std::uint32_t* particles;  ///< rows + 1 rows of 16
    const float* weights;            ///< the particles' inverse masses [1/kg], likewise
    const float* rest_lengths;       ///< rows rows of 16 [m]
    const float* compliances;        ///< likewise, XPBD's alpha~ = 1 / (k h^2) [1/kg]; above 0
    float* multipliers;              ///< likewise [kg m]; 0 at the start of a step
    float* scratch;                  ///< scratch_rows * rows rows
    float gamma;                     ///< damping / h, see sweep_springs
    const Vec4* start;
    Vec4* moved;
};

/// Solves the springs one by one along the fibre, each from where the one before has left its particle.
void solve_by_gauss_seidel(const FibreGroup& group);

/// Solves all springs of the fibre at once, linearised.
void solve_by_ldlt(const FibreGroup& group);

}  // namespace weft
