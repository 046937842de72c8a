#include "cloth/solver/passes/momentum.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include <Eigen/Geometry>

#include "cloth/equation/contacts.h"
#include "cloth/equation/pairs/pair_rows.h"
#include "cloth/equation/seam_rows.h"
#include "engine/small_matrices.h"

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

PieceSums::Motion& operator+=(PieceSums::Motion& l, const PieceSums::Motion& r) {
    l.first += r.first;
    l.momentum += r.momentum;
    l.energy += r.energy;
    l.spread += r.spread;
    return l;
}

PieceSums::Motion motion_of(double m, const Eigen::Vector3d& d, const Eigen::Vector3d& v) {
    return {m * d, m * v, 0.5 * m * v.squaredNorm(), m * d * v.transpose()};
}

/// Sum m d v^T about the centre of mass.
Eigen::Matrix3d about_centre(const PieceSums::Motion& of, double mass) {
    return of.spread - of.first * of.momentum.transpose() / mass;
}

/// Sum m d x v, of sum m d v^T.
Eigen::Vector3d angular_momentum(const Eigen::Matrix3d& spread) {
    return {spread(1, 2) - spread(2, 1), spread(2, 0) - spread(0, 2), spread(0, 1) - spread(1, 0)};
}

/// A free particle's part in the sums of its piece.
PieceSums sums_of(const StepEquation& equation, std::span<const Vec4> velocities, const Vector3& origin,
                  std::uint32_t i) {
    const ExternalRow row = external_row(equation, i);
    const auto in_doubles = [](const Vector3& v) { return v.cast<double>(); };
    const double m = 1 / static_cast<double>(equation.positions[i].w), r = static_cast<double>(row.row_sum);
    const Eigen::Vector3d d = place(equation, velocities, origin, i), v = in_doubles(xyz(velocities[i])),
                          q = in_doubles(row.free_velocity) - v,
                          force = (r * q - m * (in_doubles(xyz(equation.base_velocities[i])) - v)) /
                                  static_cast<double>(equation.gamma),
                          impulse = static_cast<double>(equation.h) * force;
    return {.row_sum = r,
            .first = r * d,
            .second = r * d * d.transpose(),
            .missing = r * q,
            .mass = m,
            .start = motion_of(m, in_doubles(xyz(equation.positions[i]) - origin),
                               in_doubles(xyz(equation.velocities[i]))),
            .end = motion_of(m, d, v),
            .impulse = impulse,
            .turning = d.cross(impulse)};
}

}  // namespace

void PieceSums::add(const PieceSums& more) {
    row_sum += more.row_sum;
    first += more.first;
    second += more.second;
    missing += more.missing;
    mass += more.mass;
    start += more.start;
    end += more.end;
    impulse += more.impulse;
    turning += more.turning;
}

// The piece ends with the angular momentum that it has at the start, about the centre of mass, and what
// external forces add. (The bases of BDF2 would go on with less: they turn by themselves in a step.) A spin s
// changes it by J s + gamma sum m (s x d) x v, since places change too: linear in s, of which all is exact. J
// is the inertia. An axis across which the piece has no extent has no spin. No direction counts as easier to
// turn than by half its inertia: places that turn by a radian a step are beyond what a step resolves.
//
// A turn that takes more energy than the step has lost takes it from the piece's motion within itself: limp
// cloth that crumples in a vacuum would gain energy.
RigidChange::RigidChange(const PieceSums& sums, float gamma) {
    if (!(sums.row_sum > 0)) return;
    constexpr double thin = 1e-9;  // of the largest moment
    const Eigen::Vector3d centre = sums.first / sums.row_sum;
    const Eigen::Matrix3d second = sums.second - sums.row_sum * centre * centre.transpose(),
                          start = about_centre(sums.start, sums.mass),
                          end = about_centre(sums.end, sums.mass);
    Eigen::Vector3d lacks =
        angular_momentum(start - end) + sums.turning - sums.end.first.cross(sums.impulse) / sums.mass;
    const SymmetricAxes inertia = symmetric_axes(second.trace() * Eigen::Matrix3d::Identity() - second);
    const Eigen::Vector3d& moments = inertia.values;
    const Eigen::Vector3d roots =
        (moments.array() > thin * moments[2]).select(moments.cwiseSqrt().cwiseInverse(), 0);
    const Eigen::Matrix3d to_axes = inertia.vectors * roots.asDiagonal();
    const Eigen::Vector3d turning = to_axes.transpose() * angular_momentum(end);  // over the moments' roots
    const Eigen::Vector3d turn = to_axes * turning, drift = sums.end.momentum / sums.mass;
    const double takes =
        0.5 * ((turning + to_axes.transpose() * lacks).squaredNorm() - turning.squaredNorm());
    const double excess = takes - std::max(0.0, sums.start.energy - sums.end.energy);
    const double within = sums.end.energy - 0.5 * (sums.end.momentum.dot(drift) + turning.squaredNorm());
    if (excess > 0 && within > 0) share = std::sqrt(std::max(0.0, 1 - excess / within));
    const Eigen::Matrix3d of_motion_within = end + second.colwise().cross(turn).transpose();
    lacks += static_cast<double>(gamma) * (1 - share) *
             (of_motion_within.trace() * turn - of_motion_within * turn);

    const Eigen::Matrix3d by_places = end - end.trace() * Eigen::Matrix3d::Identity();
    const Eigen::Matrix3d response =
        Eigen::Matrix3d::Identity() + static_cast<double>(gamma) * to_axes.transpose() * by_places * to_axes;
    const SymmetricAxes squared = symmetric_axes(response.transpose() * response);
    const Eigen::Vector3d ease = squared.values.cwiseMax(0.25).cwiseInverse();
    spin = (1 - share) * turn + to_axes * squared.vectors * ease.asDiagonal() * squared.vectors.transpose() *
                                    response.transpose() * to_axes.transpose() * lacks;
    velocity = sums.missing / sums.row_sum + (1 - share) * drift - spin.cross(centre);
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
    const auto end = equation.first + static_cast<std::uint32_t>(component_of_.size());
    const auto mark = [&](const PairRows::AtParticle& at) {
        pieces_[component_of_[at.particle - equation.first]].touches = true;
    };
    if (equation.pairs != nullptr) equation.pairs->for_each_particle(equation.first, end, mark);
    for (const SeamRows* seam : equation.seams) seam->for_each_particle(equation.first, end, mark);
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
        for (const std::uint32_t i : particles) piece.sums.add(sums_of(equation, velocities, origin, i));
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
        const RigidChange change = piece.touches ? of_touching : RigidChange(piece.sums, equation.gamma);
        if (change.velocity.isZero(0) && change.spin.isZero(0)) continue;
        for (const std::uint32_t i : particles_of(c)) {
            const Eigen::Vector3d v = xyz(velocities[i]).cast<double>(),
                                  rigid = change.velocity +
                                          change.spin.cross(place(equation, velocities, origin, i));
            velocities[i] = to_vec4((change.share * v + rigid).cast<float>(), 0);
        }
    }
}

std::size_t FreePieces::bytes() const noexcept {
    return component_of_.size() * sizeof(std::uint32_t) + pieces_.size() * sizeof(Piece);
}

}  // namespace weft
