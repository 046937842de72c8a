#pragma once
// Forces of springs and their derivatives: the loops over particles, a block at a time, with the widest
// vectors that the machine has. springs.h states what one spring does.

#include <algorithm>
#include <array>
#include <cstdint>
#include <span>

#include "cloth/system/implicit_system.h"
#include "cloth/system/springs/spring_matrix.h"
#include "cloth/system/step_equation.h"

namespace weft {

/// The SpringKind of each entry of the matrix.
struct SpringKinds {
    static constexpr std::uint8_t none = 3;  ///< where it is padded; behind the last SpringKind
    static constexpr std::uint8_t mixed = 4;

    /// All none. Fill of_entries, then call sum_up().
    explicit SpringKinds(std::size_t entries);
    void sum_up();
    [[nodiscard]] std::size_t bytes() const noexcept { return of_entries.bytes() + of_slots.bytes(); }

    AlignedBuffer<std::uint8_t> of_entries;  ///< SpringKind, or none
    AlignedBuffer<std::uint8_t> of_slots;    ///< that of all 16 entries, or mixed
};

/// Stiffness by SpringKind, padded to a table that registers of any width can look up.
struct SpringStiffness {
    explicit SpringStiffness(const std::array<float, 3>& of_kind) { std::ranges::copy(of_kind, values); }

    [[nodiscard]] SpringStiffness times(float factor) const {
        return SpringStiffness({factor * values[0], factor * values[1], factor * values[2]});
    }

    alignas(64) float values[Stencil::lanes] = {};
};

/// The springs, and the state of the cloth that they are looked at in. Vectors as in ImplicitSystem.
struct SpringState {
    const StepEquation& equation;
    const SpringMatrix& matrix;
    std::span<const float> rest_lengths;  ///< per entry
    const SpringKinds& kinds;
    SpringStiffness stiffness;        ///< [N/m]
    std::span<const Vec4> positions;  ///< w inverse mass
    std::span<const Vec4> velocities;
    float time_ahead = 0;  ///< meant are positions + time_ahead x velocities [s]; 0 without a window
};

/// The rows of W and b of one block; see ImplicitSystem::linearise.
/// Invariant: `window` is null but for matrices with diagonals.
void linearise_block(const SpringState& state, LinearisedAbout about, const BlockRange& range,
                     GridWindow* window, SpringMatrix& matrix, Vec4* right_side);
void residual_block(const SpringState& state, const BlockRange& range, GridWindow* window, Vec4* residual);

}  // namespace weft
