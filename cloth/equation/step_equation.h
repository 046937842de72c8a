#pragma once
// One implicit step as an equation for the velocities v at its end.

#include <cstdint>
#include <span>

#include "engine/threads/parallel_blocks.h"
#include "engine/vector.h"
#include "weft/settings.h"

namespace weft {

class BodyCoupling;
class Contacts;
class PairRows;

/// What acts on the particles besides the fabric.
struct ExternalForces {
    Vector3 gravity = Vector3::Zero();  ///< [m/s^2]
    float air_damping = 0;              ///< [1/s]
    std::span<const Vec4> air;          ///< per particle: force [N], w slope of drag [N s/m]; empty: no air
};

///     M (v - v_base) = gamma f(x_base + gamma v, v)
///
/// Backward Euler: gamma = h, the bases are the present positions and velocities. BDF2 (Curtiss and
/// Hirschfelder 1952) is the same equation with gamma = 2h/3, x_base = x_n + (x_n - x_n-1) / 3, v_base = v_n
/// + (v_n - v_n-1) / 3; after a step of another length with other coefficients, see Bdf. A pinned particle's
/// base is such that x_base + gamma v is where it will be. The air's force is that at `velocities`, with its
/// slope.
struct StepEquation {
    const ClothSettings& settings;
    float h;                               ///< [s]
    float gamma;                           ///< [s]
    float rigidity;                        ///< the fabric's, or what floats hold, see held_rigidity() [N m]
    std::span<const Vec4> positions;       ///< present, w inverse mass
    std::span<const Vec4> velocities;      ///< present
    std::span<const Vec4> base_positions;  ///< w inverse mass
    std::span<const Vec4> base_velocities;
    ExternalForces external;
    Contacts* contacts = nullptr;    ///< of the cloth with colliders and features, or null: there are none
    PairRows* pairs = nullptr;       ///< of features of all bodies that are solved together, or null
    std::uint32_t first = 0;         ///< the cloth's first particle among these bodies'
    BodyCoupling* bodies = nullptr;  ///< rigid ones that the cloth may move, or null
    std::span<const Vec4> velocity_changes{};  ///< that BDF2 goes on with; empty: none
    float divisor = 3;                         ///< of these in v_base
};

/// The fabric's rigidity, or the greatest beside which floats still know the particles' mass. Bending's rows
/// sum to 0 but for rounding, some 2^-24 gamma^2 rigidity bending_per_area of the areal density, see
/// find_bending_per_area(). Cells below a fifth of a millimetre reach it, and boards.
[[nodiscard]] inline float held_rigidity(const Fabric& fabric, float gamma, float bending_per_area) {
    constexpr float most = 2e8f;
    const float held = most * fabric.areal_density / (gamma * gamma * bending_per_area);
    return held < fabric.bending ? held : fabric.bending;
}

/// What acts on one particle besides fabric and contacts.
struct ExternalRow {
    Vector3 free_velocity;  ///< once external forces alone have acted, drag taken implicitly
    float row_sum;          ///< mass and drag [kg]; 0 for pinned particles, which keep their velocity
};
[[nodiscard]] ExternalRow external_row(const StepEquation& equation, std::uint32_t particle);

/// Velocities once external forces alone have acted for h, drag taken implicitly: where explicit and
/// positional methods begin. Pinned particles keep theirs. `predicted` may be the velocities.
void predict_velocities(Parallel& parallel, const StepEquation& equation, std::span<Vec4> predicted);

}  // namespace weft
