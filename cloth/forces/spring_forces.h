#pragma once
// Forces of springs and their derivatives: the loops over particles, a block at a time, with the widest
// vectors that the machine has. springs.h states what one spring does.

#include <span>

#include "cloth/forces/spring_matrix.h"
#include "cloth/implicit/implicit_system.h"
#include "cloth/implicit/step_equation.h"

namespace weft {

/// The springs, and the state of the cloth that they are looked at in. Vectors as in ImplicitSystem.
struct SpringState {
    const StepEquation& equation;
    const Stencil& stencil;
    std::span<const float> rest_lengths,
        stiffness;                    ///< per entry of the stencil; stiffness 0 where it is padded
    std::span<const Vec4> positions;  ///< w inverse mass
    std::span<const Vec4> velocities;
};

/// The rows of W and b of one block; see ImplicitSystem::linearise.
void linearise_block(const SpringState& state, LinearisedAbout about, const BlockRange& range,
                     SpringMatrix& matrix, Vec4* right_side);
void residual_block(const SpringState& state, const BlockRange& range, Vec4* residual);

}  // namespace weft
