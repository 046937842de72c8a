#pragma once
// Forces of springs and their derivatives: the loops over particles, a block at a time, with the widest
// vectors that the machine has. springs.h states what one spring does.

#include <cstdint>
#include <span>

#include "cloth/equation/implicit_system.h"
#include "cloth/equation/step_equation.h"
#include "cloth/fabric/rings.h"
#include "cloth/fabric/spring_matrix.h"
#include "cloth/fabric/spring_table.h"

namespace weft {

/// The springs, and the state of the cloth that they are looked at in. Vectors as in ImplicitSystem.
struct SpringState {
    const StepEquation& equation;
    const SpringMatrix& matrix;
    const SpringTable& table;               ///< of a grid
    const Rings& rings;                     ///< of any other mesh
    std::span<const float> bending_excess;  ///< see ClothModel
    std::span<const Vec4> positions;        ///< w inverse mass
    std::span<const Vec4> velocities;
    float time_ahead = 0;  ///< of a grid: meant are positions + time_ahead x velocities [s]
};

/// The rows of W and b of one block; see ImplicitSystem::linearise. Of a grid.
void linearise_block(const SpringState& state, LinearisedAbout about, const BlockRange& range,
                     GridWindow& window, SpringMatrix& matrix, Vec4* right_side);
void residual_block(const SpringState& state, const BlockRange& range, GridWindow& window, Vec4* residual);

/// The same of rings, which take what a coupled product needs of the linearisation.
void linearise_rings(const SpringState& state, LinearisedAbout about, const BlockRange& range, Rings& rings,
                     SpringMatrix& matrix, Vec4* right_side);
void residual_of_rings(const SpringState& state, const BlockRange& range, Vec4* residual);
/// As multiply_block(), with what the sides of triangles do to one another in that linearisation, times
/// `elastic` [s^2].
Products multiply_rings(const SpringMatrix& matrix, const Rings& rings, float elastic,
                        const BlockRange& range, const DottedWith& with, const Vec4* x, Vec4* product);

}  // namespace weft
