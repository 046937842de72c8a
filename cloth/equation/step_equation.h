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
class FillingRow;
class PairRows;
class SeamRows;

/// Forces on the particles besides the fabric's.
struct ExternalForces {
    Vector3 gravity = Vector3::Zero();  ///< [m/s^2]
    float air_damping = 0;              ///< [1/s]
    /// Per particle: the air's force [N] at the start's velocities, w slope of drag [N s/m], of a line
    /// through the force where it was taken last; empty: no air.
    std::span<const Vec4> air;
    FillingRow* filling = nullptr;  ///< of the cloth, or null; its force is that at its last linearisation
};

///     M (v - v_base) = gamma f(x_base + gamma v, v)
///
/// Backward Euler: gamma = h, the bases are the present positions and velocities. BDF2 (Curtiss and
/// Hirschfelder 1952) is the same equation with gamma = 2h/3, x_base = x_n + (x_n - x_n-1) / 3, v_base = v_n
/// + (v_n - v_n-1) / 3; after a step of another length with other coefficients, see Bdf. A pinned particle's
/// base is such that x_base + gamma v is where it will be. The air's force is linear in v, see
/// ExternalForces; methods that linearise more than once take it anew.
struct StepEquation {
    const ClothSettings& settings;
    float h;                               ///< [s]
    float gamma;                           ///< [s]
    float rigidity;                        ///< of bending, see held_rigidity() [N m]
    std::span<const Vec4> positions;       ///< present, w inverse mass
    std::span<const Vec4> velocities;      ///< present
    std::span<const Vec4> base_positions;  ///< w inverse mass
    std::span<const Vec4> base_velocities;
    ExternalForces external;
    Contacts* contacts = nullptr;    ///< of the cloth with colliders and features; null: none
    PairRows* pairs = nullptr;       ///< of features of all bodies that are solved together, or null
    std::uint32_t first = 0;         ///< the cloth's first particle among these bodies', and in seams
    BodyCoupling* bodies = nullptr;  ///< rigid bodies that the cloth may move, or null
    std::span<const Vec4> velocity_changes{};  ///< which BDF2 extrapolates; empty: none
    float divisor = 3;                         ///< of velocity_changes in v_base
    std::span<SeamRows* const> seams{};        ///< of the cloth
};

/// The fabric's rigidity, limited so that rounding does not hide the particles' mass. Bending's rows sum to 0
/// up to rounding, some 2^-24 gamma^2 rigidity bending_per_area of the areal density, see
/// find_bending_per_area(). Boards reach the limit, and cells below 0.2 mm.
[[nodiscard]] inline float held_rigidity(const Fabric& fabric, float gamma, float bending_per_area) {
    constexpr float most = 2e8f;
    const float held = most * fabric.areal_density / (gamma * gamma * bending_per_area);
    return held < fabric.bending ? held : fabric.bending;
}

/// External forces on one particle, without fabric and contacts.
struct ExternalRow {
    Vector3 free_velocity;  ///< under external forces alone, drag taken implicitly
    float row_sum;          ///< mass and drag [kg]; 0 for pinned particles, which keep their velocity
};
[[nodiscard]] ExternalRow external_row(const StepEquation& equation, std::uint32_t particle);

/// Velocities after h under external forces alone, drag taken implicitly: the start of explicit and
/// positional methods. Pinned particles keep theirs. `predicted` may be the velocities.
void predict_velocities(Parallel& parallel, const StepEquation& equation, std::span<Vec4> predicted);

}  // namespace weft
