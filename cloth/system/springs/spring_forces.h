#pragma once
// Forces of springs and their derivatives: the loops over particles, a block at a time, with the widest
// vectors that the machine has. springs.h states what one spring does.

#include <cstdint>
#include <span>

#include "cloth/system/implicit_system.h"
#include "cloth/system/springs/coupling.h"
#include "cloth/system/springs/spring_matrix.h"
#include "cloth/system/springs/spring_table.h"
#include "cloth/system/step_equation.h"

namespace weft {

/// The springs, and the state of the cloth that they are looked at in. Vectors as in ImplicitSystem.
struct SpringState {
    const StepEquation& equation;
    const SpringMatrix& matrix;
    const SpringTable& table;
    const MembraneCoupling& coupling;       ///< computed at the positions meant; empty: there is none
    std::span<const float> bending_excess;  ///< see ClothModel
    std::span<const Vec4> positions;        ///< w inverse mass
    std::span<const Vec4> velocities;
    float time_ahead = 0;  ///< meant are positions + time_ahead x velocities [s]; 0 without a window
};

/// The rows of W and b of one block; see ImplicitSystem::linearise.
/// Invariant: `window` is null but for matrices with diagonals.
void linearise_block(const SpringState& state, LinearisedAbout about, const BlockRange& range,
                     GridWindow* window, SpringMatrix& matrix, Vec4* right_side);
void residual_block(const SpringState& state, const BlockRange& range, GridWindow* window, Vec4* residual);

}  // namespace weft
