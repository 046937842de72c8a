// What the multilevel method does to components that nothing holds, and that features of cloth push.

#include "cloth/solvers/multigrid/multilevel.h"

#include <algorithm>

#include "cloth/system/pair_rows.h"

namespace weft {

void MultilevelSolver::weigh_pieces(const SolverStep& step) {
    const StepEquation& equation = step.equation;
    std::ranges::fill(pieces_, Piece{});
    const auto particles = static_cast<std::uint32_t>(component_of_.size());
    equation.pairs->for_each_particle(equation.first, equation.first + particles,
                                      [&](const PairRows::AtParticle& at) {
                                          pieces_[component_of_[at.particle - equation.first]].touches = true;
                                      });
    for (std::uint32_t i = 0; i < particles; ++i) {
        Piece& piece = pieces_[component_of_[i]];
        piece.is_held |= equation.positions[i].w == 0 || equation.contacts->is_held(i);
        if (piece.is_held) continue;
        const ExternalRow row = external_row(equation, i);
        piece.missing += (row.row_sum * (row.free_velocity - xyz(step.velocities[i]))).cast<double>();
        piece.inertia += static_cast<double>(row.row_sum);
    }
}

Vector3 MultilevelSolver::shift_of(const Piece& piece) {
    if (piece.is_held || !(piece.inertia > 0)) return Vector3::Zero();
    return (piece.missing / piece.inertia).cast<float>();
}

void MultilevelSolver::move_free_pieces(const SolverStep& step, const Vector3& of_touching) {
    for (std::uint32_t i = 0; i < component_of_.size(); ++i) {
        const Piece& piece = pieces_[component_of_[i]];
        const Vector3 shift = piece.touches ? of_touching : shift_of(piece);
        if (shift.isZero(0)) continue;
        step.velocities[i] = to_vec4(xyz(step.velocities[i]) + shift, 0);
    }
}

void MultilevelSolver::reserve_pairs(std::size_t count) {
    if (count == 0) {
        multigrid_->reserve_pairs(0);
        component_of_ = {};
        pieces_ = {};
        return;
    }
    if (!component_of_.empty()) return;
    multigrid_->reserve_pairs(count);
    const std::span<const std::uint32_t> offsets = model_->component_offsets;
    const auto loose = static_cast<std::uint32_t>(offsets.size() - 1);
    HookedVector<std::uint32_t> component_of(model_->particle_count, loose);
    for (std::uint32_t c = 0; c + 1 < offsets.size(); ++c)
        for (std::uint32_t k = offsets[c]; k < offsets[c + 1]; ++k)
            component_of[model_->component_particles[k]] = c;
    pieces_.assign(offsets.size(), Piece{});
    component_of_ = std::move(component_of);
}

}  // namespace weft
