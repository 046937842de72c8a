#include "cloth/solver/passes/momentum.h"

#include <algorithm>
#include <utility>

#include <Eigen/Eigenvalues>

#include "cloth/equation/contacts.h"
#include "cloth/equation/pair_rows.h"

namespace weft {

namespace {

/// A particle's place at the end of the step, from the origin.
Eigen::Vector3d place(const StepEquation& equation, std::span<const Vec4> velocities, const Vector3& origin,
                      std::uint32_t i) {
    return (xyz(equation.base_positions[i]) - origin + equation.gamma * xyz(velocities[i])).cast<double>();
}

bool is_held(const StepEquation& equation, std::uint32_t i) {
    return equation.positions[i].w == 0 || (equation.contacts != nullptr && equation.contacts->is_held(i));
}

}  // namespace

void PieceSums::add(double r, const Eigen::Vector3d& d, const Eigen::Vector3d& q) {
    mass += r;
    first += r * d;
    second += r * d * d.transpose();
    missing += r * q;
    torque += d.cross(r * q);
}

void PieceSums::add(const PieceSums& more) {
    mass += more.mass;
    first += more.first;
    second += more.second;
    missing += more.missing;
    torque += more.torque;
}

// About the centre of mass, where translation and rotation part. What has no extent across an axis cannot be
// turned about it.
RigidChange::RigidChange(const PieceSums& sums) {
    if (!(sums.mass > 0)) return;
    constexpr double thin = 1e-9;  // of the largest moment
    const Eigen::Vector3d centre = sums.first / sums.mass;
    const Eigen::Matrix3d spread = sums.second - sums.mass * centre * centre.transpose();
    const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> moments(
        spread.trace() * Eigen::Matrix3d::Identity() - spread);
    const Eigen::Vector3d turned =
        moments.eigenvectors().transpose() * (sums.torque - centre.cross(sums.missing));
    Eigen::Vector3d rate = Eigen::Vector3d::Zero();
    for (int k = 0; k < 3; ++k)
        if (moments.eigenvalues()[k] > thin * moments.eigenvalues()[2])
            rate[k] = turned[k] / moments.eigenvalues()[k];
    spin = moments.eigenvectors() * rate;
    velocity = sums.missing / sums.mass - spin.cross(centre);
}

void FreePieces::reserve_pairs(std::size_t count) {
    if (count == 0) {
        component_of_ = {};
        return;
    }
    if (!component_of_.empty()) return;
    HookedVector<std::uint32_t> component_of(model_->particle_count);
    for (std::size_t c = 0; c < pieces_.size(); ++c)
        for (const std::uint32_t i : particles_of(c)) component_of[i] = static_cast<std::uint32_t>(c);
    component_of_ = std::move(component_of);
}

FreePieces::FreePieces(const ClothModel& model)
    : model_(&model), pieces_(model.component_offsets.size() - 1) {}

std::span<const std::uint32_t> FreePieces::particles_of(std::size_t component) const {
    const std::uint32_t begin = model_->component_offsets[component];
    return {model_->component_particles.data() + begin, model_->component_offsets[component + 1] - begin};
}

void FreePieces::mark_touching(const StepEquation& equation) {
    if (equation.pairs == nullptr) return;
    const auto end = equation.first + static_cast<std::uint32_t>(component_of_.size());
    equation.pairs->for_each_particle(equation.first, end, [&](const PairRows::AtParticle& at) {
        pieces_[component_of_[at.particle - equation.first]].touches = true;
    });
}

void FreePieces::weigh(const StepEquation& equation, std::span<const Vec4> velocities,
                       const Vector3& origin) {
    std::ranges::fill(pieces_, Piece{});
    mark_touching(equation);
    for (std::size_t c = 0; c < pieces_.size(); ++c) {
        Piece& piece = pieces_[c];
        const std::span<const std::uint32_t> particles = particles_of(c);
        piece.is_held = std::ranges::any_of(particles, [&](std::uint32_t i) { return is_held(equation, i); });
        if (piece.is_held) continue;
        for (const std::uint32_t i : particles) {
            const ExternalRow row = external_row(equation, i);
            piece.sums.add(static_cast<double>(row.row_sum), place(equation, velocities, origin, i),
                           (row.free_velocity - xyz(velocities[i])).cast<double>());
        }
    }
}

bool FreePieces::add_touching(PieceSums& sums) const {
    bool any_held = false;
    for (const Piece& piece : pieces_) {
        if (!piece.touches) continue;
        any_held |= piece.is_held;
        sums.add(piece.sums);
    }
    return any_held;
}

void FreePieces::move(const StepEquation& equation, const RigidChange& of_touching, const Vector3& origin,
                      std::span<Vec4> velocities) const {
    for (std::size_t c = 0; c < pieces_.size(); ++c) {
        const Piece& piece = pieces_[c];
        if (piece.is_held) continue;
        const RigidChange change = piece.touches ? of_touching : RigidChange(piece.sums);
        if (change.velocity.isZero(0) && change.spin.isZero(0)) continue;
        for (const std::uint32_t i : particles_of(c)) {
            const Eigen::Vector3d more =
                change.velocity + change.spin.cross(place(equation, velocities, origin, i));
            velocities[i] = to_vec4(xyz(velocities[i]) + more.cast<float>(), 0);
        }
    }
}

std::size_t FreePieces::bytes() const noexcept {
    return component_of_.size() * sizeof(std::uint32_t) + pieces_.size() * sizeof(Piece);
}

}  // namespace weft
