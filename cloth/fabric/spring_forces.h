#pragma once
// Forces of springs and their derivatives: loops over a block of particles at a time, with the widest
// vectors that the machine has. springs.h defines the force of one spring.

#include <cstdint>
#include <span>

#include "cloth/equation/implicit_system.h"
#include "cloth/equation/step_equation.h"
#include "cloth/fabric/springs/rings.h"
#include "cloth/fabric/springs/spring_matrix.h"
#include "cloth/fabric/springs/spring_table.h"

namespace weft {

/// The springs, and the state of the cloth at which they are evaluated. Vectors are as in ImplicitSystem.
struct SpringState {
    const StepEquation& equation;
    const SpringMatrix& matrix;
    const SpringTable& table;               ///< of a grid
    const Rings& rings;                     ///< of any other mesh
    std::span<const float> bending_excess;  ///< see ClothModel
    std::span<const Vec4> positions;        ///< w inverse mass
    std::span<const Vec4> velocities;
    float time_ahead = 0;  ///< grids evaluate at positions + time_ahead x velocities [s]
};

/// Computes the rows of W and b of one block of a grid; see ImplicitSystem::linearise.
void linearise_block(const SpringState& state, LinearisedAbout about, const BlockRange& range,
                     GridWindow& window, SpringMatrix& matrix, Vec4* right_side);
void residual_block(const SpringState& state, const BlockRange& range, GridWindow& window, Vec4* residual);

/// The same for rings, which store what a coupled product needs of the linearisation.
void linearise_rings(const SpringState& state, LinearisedAbout about, const BlockRange& range, Rings& rings,
                     SpringMatrix& matrix, Vec4* right_side);
void residual_of_rings(const SpringState& state, const BlockRange& range, Vec4* residual);
/// Like multiply_block(), with the coupling of triangles' sides in that linearisation, times
/// `elastic` [s^2].
Products multiply_rings(const SpringMatrix& matrix, const Rings& rings, float elastic,
                        const BlockRange& range, const DottedWith& with, const Vec4* x, Vec4* product);

}  // namespace weft
