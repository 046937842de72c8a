#pragma once
// The passes of the multilevel method over a group of cloths that are one equation.

#include <array>
#include <cstdint>
#include <span>

#include "cloth/equation/implicit_system.h"
#include "cloth/solver/levels/multigrid.h"
#include "cloth/solver/passes/momentum.h"
#include "cloth/solver/solver.h"
#include "cloth/solver/step_residual.h"
#include "engine/memory/scratch.h"

namespace weft {

/// Sums over particles: weighted velocities in the first three, the weights in the last.
struct VelocitySums {
    std::array<double, 4> pinned{}, moving{};

    friend VelocitySums operator+(VelocitySums l, const VelocitySums& r) {
        for (std::size_t k = 0; k < 4; ++k) {
            l.pinned[k] += r.pinned[k];
            l.moving[k] += r.moving[k];
        }
        return l;
    }
};

/// Vectors of one cloth: one Vec4 a particle, w 0; where the particle is pinned, all is 0.
struct PassVectors {
    void lay_out(Scratch& scratch, std::uint32_t particles) {
        scratch.take(motion, particles);
        scratch.take(partials, block_count(particles));
    }
    /// Lays out the vectors that come into use once the levels are built.
    void lay_out_later(Scratch& scratch, std::uint32_t particles) {
        for (auto* vector : later()) scratch.take(*vector, particles);
    }
    void begin_later() noexcept {
        for (auto* vector : later()) vector->clear_padding();
    }

    [[nodiscard]] std::array<ScratchArray<Vec4>*, 5> later() noexcept {
        return {&change, &correction, &of_motion, &of_change, &of_correction};
    }

    ScratchArray<Vec4> motion;      ///< velocity in the group's frame [m/s]
    ScratchArray<Vec4> change;      ///< last change of velocity [m/s]
    ScratchArray<Vec4> correction;  ///< by a multigrid cycle, from the residual of these two [m/s]
    ScratchArray<Vec4> of_motion, of_change, of_correction;  ///< W times each [kg m/s]
    ScratchArray<VelocitySums> partials;                     ///< by block
    Products products;                                       ///< of the last multiplication
};

/// A cloth of a group: its step, and what its solver owns.
struct PassMember {
    const SolverStep& step;
    ImplicitSystem& system;
    Multigrid& levels;   ///< its own, or those that it has in common with the cloths that are sewn to it
    std::uint32_t part;  ///< its number among the levels' cloths
    PassVectors& vectors;
    FreePieces& pieces;
    StepResidual& residual;
    double mass;  ///< [kg]
};

/// Writes the member's motion: its velocities, relative to the group's frame.
void write_motion(const PassMember& member, Parallel& threads, const Vec4& frame);

/// Solves the steps of cloths that touch as one equation. Precondition: gamma, pairs, bodies and threads are
/// the same in all. The first member's settings give the number of passes. Each member's residual is written
/// to `residuals`, unless these are empty; the result's is the greatest.
SolveResult solve_by_passes(std::span<const PassMember> members, std::span<float> residuals);

}  // namespace weft
