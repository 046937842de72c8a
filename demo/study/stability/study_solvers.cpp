#include "demo/study/stability/study_solvers.h"

#include <algorithm>
#include <limits>
#include <vector>

namespace weft::study {

ExplicitEulerSolver::ExplicitEulerSolver(const ClothModel& model, const ClothSettings& settings)
    : forces_(model, settings),
      pending_(model.particle_count),
      velocities_(model.particle_count),
      next_(model.particle_count) {}

SolveResult ExplicitEulerSolver::solve(const SolverStep& step) {
    for (std::size_t i = 0; i < velocities_.size(); ++i) {
        velocities_[i] = to_vec4(xyz(step.equation.velocities[i]) + xyz(pending_[i]), 0);
    }
    std::ranges::copy(velocities_.span(), step.velocities.begin());
    StepEquation present = step.equation;
    present.velocities = velocities_.span();
    present.base_velocities = velocities_.span();
    const SolveResult result = forces_.solve({.parallel = step.parallel,
                                              .profiler = step.profiler,
                                              .model = step.model,
                                              .settings = step.settings,
                                              .equation = present,
                                              .velocities = next_.span()});
    for (std::size_t i = 0; i < velocities_.size(); ++i)
        pending_[i] = to_vec4(xyz(next_[i]) - xyz(velocities_[i]), 0);
    return result;
}

std::size_t ExplicitEulerSolver::bytes() const noexcept {
    return forces_.bytes() + pending_.bytes() + velocities_.bytes() + next_.bytes();
}

namespace {

std::vector<ParticlePair> pairs_of(const ClothModel& model) {
    std::vector<ParticlePair> pairs;
    for (std::uint32_t i = 0; i < model.particle_count; ++i) {
        for (std::uint32_t e = model.spring_offsets[i]; e < model.spring_offsets[i + 1]; ++e)
            if (model.neighbours[e] > i) pairs.push_back({i, model.neighbours[e]});
    }
    return pairs;
}

/// A spring's block a I + d d^T, with a in w.
Eigen::Matrix3d block_of(const Vec4& spring) {
    const Eigen::Vector3d d = xyz(spring).cast<double>();
    return static_cast<double>(spring.w) * Eigen::Matrix3d::Identity() + d * d.transpose();
}

}  // namespace

CholeskySolver::CholeskySolver(const ClothModel& model, const ClothSettings& settings)
    : LinearSolver(model, settings),
      matrix_(model.particle_count, pairs_of(model)),
      exact_solve_(model.particle_count, std::numeric_limits<std::uint32_t>::max()) {}

bool CholeskySolver::solve_linear(const SolverStep& step, ImplicitSystem& system, std::span<Vec4> dv) {
    const std::span<const Vec4> b = system.right_side().span();
    fill_matrix(step, system);
    Eigen::VectorXd right_side(3 * static_cast<Eigen::Index>(b.size())), change;
    for (std::uint32_t i = 0; i < b.size(); ++i)
        right_side.segment<3>(3 * static_cast<Eigen::Index>(i)) = xyz(b[i]).cast<double>();
    exact_solve_.solve(matrix_, right_side, 0, {}, change);
    for (std::uint32_t i = 0; i < b.size(); ++i) {
        const Eigen::Vector3d change_i = change.segment<3>(3 * static_cast<Eigen::Index>(i));
        dv[i] = to_vec4(change_i.cast<float>(), 0);
    }
    return true;
}

// Rows of pinned particles become those of the identity. The blocks in them, which may hold anything, are not
// read.
void CholeskySolver::fill_matrix(const SolverStep& step, ImplicitSystem& system) {
    const std::span<const Vec4> b = system.right_side().span();
    const AlignedBuffer<Vec4> springs = system.all_spring_blocks(step.parallel);
    const auto is_free = [&](std::uint32_t i) { return b[i].w > 0; };
    matrix_.set_zero();
    std::size_t pair = 0;
    for (std::uint32_t i = 0; i < b.size(); ++i) {
        const double row_sum = is_free(i) ? static_cast<double>(b[i].w) : 1.0;
        Eigen::Matrix3d diagonal = row_sum * Eigen::Matrix3d::Identity();
        if (is_free(i) && touches(system.contacts(), i)) diagonal += system.contacts()->block(i).full();
        for (std::uint32_t e = step.model.spring_offsets[i]; e < step.model.spring_offsets[i + 1]; ++e) {
            const std::uint32_t j = step.model.neighbours[e];
            if (is_free(i)) {
                const Eigen::Matrix3d block = block_of(springs[system.entry_between(i, j)]);
                diagonal += block;
                if (j > i && is_free(j)) matrix_.add_pair(pair, -block);
            }
            if (j > i) ++pair;
        }
        matrix_.add_diagonal(i, diagonal);
    }
}

}  // namespace weft::study
