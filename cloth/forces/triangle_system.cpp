#include "cloth/forces/triangle_system.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <utility>

#include "cloth/forces/bending.h"
#include "cloth/implicit/symmetric3.h"

namespace weft {

namespace {

constexpr std::uint32_t block_floats = 9;

/// A block as it lies in the matrix, every 16 floats.
using Lane = Eigen::Map<Eigen::Matrix<float, 3, 3, Eigen::RowMajor>, 0,
                        Eigen::Stride<3 * Stencil::lanes, Stencil::lanes>>;
using ConstLane = Eigen::Map<const Eigen::Matrix<float, 3, 3, Eigen::RowMajor>, 0,
                             Eigen::Stride<3 * Stencil::lanes, Stencil::lanes>>;

Lane lane(TriangleMatrix& matrix, std::uint32_t entry) {
    return Lane(&matrix.blocks[lane_index(entry, 0, block_floats)]);
}

/// Three rows of an element's result.
Matrix3 result_block(const Vec4* rows) {
    Matrix3 block;
    for (std::uint32_t k = 0; k < 3; ++k) block.row(k) = xyz(rows[k * Stencil::lanes]);
    return block;
}

Symmetric3 symmetric(const Matrix3& m) {
    return {m(0, 0), m(1, 1), m(2, 2), m(0, 1), m(0, 2), m(1, 2)};
}

/// The block of two neighbours in the mass matrix of a triangle [kg].
float shared_mass(const StepEquation& equation, float area) {
    return equation.settings.fabric.areal_density * area / 12;
}

/// What the Hessian of bending, all of which is damped, is multiplied by in W [s^2].
float bending_factor(const StepEquation& equation) {
    return equation.gamma * (equation.gamma + equation.settings.fabric.damping);
}

/// body(entry) for the stencil's entries of particle i.
template <class Body>
void for_each_entry(const Stencil& stencil, std::uint32_t i, const Body& body) {
    const std::uint32_t group = i / Stencil::lanes;
    for (std::uint32_t s = stencil.group_slots[group]; s < stencil.group_slots[group + 1]; ++s)
        body(s * Stencil::lanes + i % Stencil::lanes);
}

}  // namespace

TriangleSystem::TriangleSystem(const CookedCloth& model, const ClothSettings& settings)
    : TriangleSystem(model, settings,
                     settings.finite_elements.bending > 0 ? bending_elements(model) : Bending()) {}

TriangleSystem::TriangleSystem(const CookedCloth& model, const ClothSettings& settings,
                               const Bending& bending)
    : TriangleSystem(
          model, settings, bending,
          ElementRows::of_triangles(model, settings.finite_elements.dihedral ? std::span(bending.hinges)
                                                                             : std::span<const Hinge>())) {}

TriangleSystem::TriangleSystem(const CookedCloth& model, const ClothSettings& settings,
                               const Bending& bending, const ElementRows& rows)
    : ImplicitSystem(model.particle_count),
      model_(model),
      elements_(model),
      matrix_(Stencil(rows.offsets, rows.neighbours)),
      corners_(model.corner_triangles.size()),
      positions_(model.particle_count) {
    store_corners(rows);
    if (!bending.hinges.empty() && settings.finite_elements.dihedral)
        hinges_.emplace(bending, model.particle_count, [&](std::uint32_t i, std::uint32_t j) {
            return matrix_.stencil.entries[rows.half_edge(i, j)];
        });
    else if (!bending.hinges.empty())
        store_quadratic_bending(bending);
    if (std::holds_alternative<Multilevel>(settings.method))
        spring_blocks_ = AlignedBuffer<float>(4 * matrix_.stencil.neighbours.size());
}

void TriangleSystem::store_corners(const ElementRows& rows) {
    for (std::uint32_t i = 0; i < model_.particle_count; ++i) {
        for (std::uint32_t c = model_.corner_offsets[i]; c < model_.corner_offsets[i + 1]; ++c) {
            const std::uint32_t t = model_.corner_triangles[c];
            const Triangle& of = model_.triangles[t];
            const auto k = static_cast<std::uint32_t>(std::ranges::find(of, i) - of.begin());
            const auto entry = [&](std::uint32_t corner) {
                return matrix_.stencil.entries[rows.half_edge(i, of[corner % 3])];
            };
            corners_[c] = {t, k, {entry(k + 1), entry(k + 2)}};
        }
    }
}

void TriangleSystem::store_quadratic_bending(const Bending& bending) {
    const ElementRows rows = ElementRows::of_quadratic_bending(model_, bending);
    matrix_.scalar_stencil = Stencil(rows.offsets, rows.neighbours);
    matrix_.scalars = AlignedBuffer<float>(matrix_.scalar_stencil.neighbours.size());
    quadratic_ = AlignedBuffer<float>(model_.particle_count);
    for_each_quadratic_term(bending, [&](std::uint32_t i, std::uint32_t j, float k) {
        matrix_.scalars[matrix_.scalar_stencil.entries[rows.half_edge(i, j)]] -= k;
        quadratic_[i] -= k;  // rows of the Hessian sum to 0
    });
}

std::span<const TriangleSystem::Corner> TriangleSystem::corners(std::uint32_t particle) const {
    const std::uint32_t begin = model_.corner_offsets[particle];
    return corners_.span().subspan(begin, model_.corner_offsets[particle + 1] - begin);
}

void TriangleSystem::compute_elements(Parallel& parallel, const StepEquation& equation,
                                      std::span<const Vec4> velocities, bool viscous, bool stiffness) {
    const FiniteElements& settings = equation.settings.finite_elements;
    const float gamma = equation.gamma, damping = viscous ? equation.settings.fabric.damping : 0.0f;
    const TrianglePass triangles{.moduli = membrane_moduli(settings),
                                 .positions = positions_.data(),
                                 .velocities = damping > 0 ? velocities.data() : nullptr,
                                 .viscosity = damping,
                                 .stiffness = stiffness,
                                 .elastic = gamma * gamma,
                                 .viscous = gamma * equation.settings.fabric.damping};
    parallel.ranges(elements_.count,
                    [&](const BlockRange& range) { compute_triangles(elements_, range, triangles); });
    if (hinges_)
        hinges_->compute(parallel, {.rigidity = settings.bending,
                                    .positions = positions_.span(),
                                    .velocities = damping > 0 ? velocities : std::span<const Vec4>(),
                                    .viscosity = damping});
}

Vector3 TriangleSystem::gathered_force(const StepEquation& equation, std::span<const Vec4> velocities,
                                       float damping, std::uint32_t i) const {
    Vector3 force = Vector3::Zero();
    for (const Corner& corner : corners(i)) force += xyz(*elements_.result(corner.triangle, corner.corner));
    if (hinges_)
        for (const HingeElements::Corner& corner : hinges_->corners(i))
            force += hinges_->moment(corner.hinge) * hinges_->gradient(corner.hinge, corner.corner);
    if (quadratic_.size() > 0) {
        const float rigidity = equation.settings.finite_elements.bending;
        const Vector3 at = xyz(positions_[i]) + damping * xyz(velocities[i]);
        for_each_entry(matrix_.scalar_stencil, i, [&](std::uint32_t entry) {
            const std::uint32_t j = matrix_.scalar_stencil.neighbours[entry];
            force +=
                rigidity * matrix_.scalars[entry] * (xyz(positions_[j]) + damping * xyz(velocities[j]) - at);
        });
    }
    return force;
}

Vector3 TriangleSystem::consistent_impulse(const StepEquation& equation, std::span<const Vec4> velocities,
                                           std::uint32_t i) const {
    const auto change = [&](std::uint32_t j) -> Vector3 {
        return xyz(equation.base_velocities[j]) - xyz(velocities[j]);
    };
    Vector3 impulse = Vector3::Zero();
    for (const Corner& corner : corners(i)) {
        const float mass = shared_mass(equation, elements_.area(corner.triangle));
        for (const std::uint32_t entry : corner.entries)
            impulse += mass * (change(matrix_.stencil.neighbours[entry]) - change(i));
    }
    return impulse;
}

void TriangleSystem::clear_rows(const BlockRange& range) {
    const auto first_of = [&](std::uint32_t group) {
        return std::size_t{matrix_.stencil.group_slots[group]} * block_floats * Stencil::lanes;
    };
    const std::uint32_t end = (range.end + Stencil::lanes - 1) / Stencil::lanes;
    std::ranges::fill(matrix_.blocks.span().subspan(first_of(range.begin / Stencil::lanes),
                                                    first_of(end) - first_of(range.begin / Stencil::lanes)),
                      0.0f);
}

Matrix3 TriangleSystem::gather_blocks(const StepEquation& equation, std::uint32_t i) {
    Matrix3 membrane = Matrix3::Zero(), bending = Matrix3::Zero();
    for (const Corner& corner : corners(i)) {
        const std::uint32_t k = corner.corner;
        const Matrix3 to_next = result_block(elements_.result(corner.triangle, 3 + 3 * k));
        const Matrix3 to_last =
            result_block(elements_.result(corner.triangle, 3 + 3 * ((k + 2) % 3))).transpose();
        lane(matrix_, corner.entries[0]) += to_next;
        lane(matrix_, corner.entries[1]) += to_last;
        membrane += to_next + to_last;
    }
    const float factor = bending_factor(equation);
    if (hinges_) {
        for (const HingeElements::Corner& corner : hinges_->corners(i)) {
            const Vector3 own = hinges_->gradient(corner.hinge, corner.corner);
            const Vector3 scaled = factor * hinges_->stiffness(corner.hinge) * own;
            for (std::uint32_t other = 0; other < 3; ++other)
                lane(matrix_, corner.entries[other]) -=
                    scaled * hinges_->gradient(corner.hinge, (corner.corner + other + 1) % 4).transpose();
            bending += scaled * own.transpose();
        }
    }
    if (quadratic_.size() > 0)
        bending.diagonal().array() +=
            1.5f * factor * equation.settings.finite_elements.bending * quadratic_[i];
    return 1.5f * membrane + 2.0f * bending;
}

void TriangleSystem::subtract_consistent_mass(const StepEquation& equation, std::uint32_t i) {
    for (const Corner& corner : corners(i))
        for (const std::uint32_t entry : corner.entries)
            lane(matrix_, entry).diagonal().array() -= shared_mass(equation, elements_.area(corner.triangle));
}

Vector3 TriangleSystem::relative_impulse(std::span<const Vec4> velocities, std::uint32_t i) const {
    Vector3 impulse = Vector3::Zero();
    for_each_entry(matrix_.stencil, i, [&](std::uint32_t entry) {
        const ConstLane block(&matrix_.blocks[lane_index(entry, 0, block_floats)]);
        impulse += block * (xyz(velocities[matrix_.stencil.neighbours[entry]]) - xyz(velocities[i]));
    });
    if (matrix_.scale != 0)
        for_each_entry(matrix_.scalar_stencil, i, [&](std::uint32_t entry) {
            const std::uint32_t j = matrix_.scalar_stencil.neighbours[entry];
            impulse += matrix_.scale * matrix_.scalars[entry] * (xyz(velocities[j]) - xyz(velocities[i]));
        });
    return impulse;
}

// About the base, b = gamma (f + gamma J v + C v), with the elastic force alone in f; about the iterate, C v
// is in f.
void TriangleSystem::linearise(Parallel& parallel, const StepEquation& equation,
                               std::span<const Vec4> velocities, LinearisedAbout about) {
    const bool about_base = about == LinearisedAbout::base;
    const float gamma = equation.gamma, damping = about_base ? 0.0f : equation.settings.fabric.damping;
    const bool consistent = equation.settings.finite_elements.consistent_mass;
    place(parallel, equation, velocities, about);
    compute_elements(parallel, equation, velocities, !about_base, true);
    if (quadratic_.size() > 0)
        matrix_.scale = bending_factor(equation) * equation.settings.finite_elements.bending;

    parallel.ranges(model_.particle_count, [&](const BlockRange& range) {
        clear_rows(range);
        for (std::uint32_t i = range.begin; i < range.end; ++i) {
            right_side_[i] = {};
            matrix_.set_diagonal(i, 0, {});
            if (positions_[i].w == 0) continue;
            const ExternalRow row = external_row(equation, 1.0f / positions_[i].w, xyz(velocities[i]), i);
            Symmetric3 diagonal = symmetric(gather_blocks(equation, i));
            diagonal.add(row.row_sum, Vector3::Zero());
            Vector3 b = row.impulse + gamma * (row.force + gathered_force(equation, velocities, damping, i));
            if (about_base) b += relative_impulse(velocities, i);
            if (consistent) {
                subtract_consistent_mass(equation, i);
                b += consistent_impulse(equation, velocities, i);
            }
            right_side_[i] = to_vec4(b, row.row_sum);
            matrix_.set_diagonal(i, row.row_sum, inverse(diagonal, row.row_sum));
        }
    });
}

void TriangleSystem::residual(Parallel& parallel, const StepEquation& equation,
                              std::span<const Vec4> velocities, std::span<Vec4> residual) {
    const float damping = equation.settings.fabric.damping;
    place(parallel, equation, velocities, LinearisedAbout::iterate);
    compute_elements(parallel, equation, velocities, true, false);
    parallel.ranges(model_.particle_count, [&](const BlockRange& range) {
        for (std::uint32_t i = range.begin; i < range.end; ++i) {
            residual[i] = {};
            if (positions_[i].w == 0) continue;
            const ExternalRow row = external_row(equation, 1.0f / positions_[i].w, xyz(velocities[i]), i);
            Vector3 b =
                row.impulse + equation.gamma * (row.force + gathered_force(equation, velocities, damping, i));
            if (equation.settings.finite_elements.consistent_mass)
                b += consistent_impulse(equation, velocities, i);
            residual[i] = to_vec4(b, 0);
        }
    });
}

void TriangleSystem::place(Parallel& parallel, const StepEquation& equation, std::span<const Vec4> velocities,
                           LinearisedAbout about) {
    const float gamma = about == LinearisedAbout::base ? 0.0f : equation.gamma;
    parallel.ranges(model_.particle_count, [&](const BlockRange& range) {
        for (std::uint32_t i = range.begin; i < range.end; ++i) {
            const Vec4& base = equation.base_positions[i];
            positions_[i] = to_vec4(xyz(base) + gamma * xyz(velocities[i]), base.w);
        }
    });
}

double TriangleSystem::multiply(Parallel& parallel, std::span<const Vec4> x, std::span<Vec4> product) {
    return parallel.reduce(
        model_.particle_count, partial_sums_.span(), 0.0,
        [&](const BlockRange& range) { return multiply_block(matrix_, range, x.data(), product.data()); },
        std::plus<>{});
}

void TriangleSystem::relax(Parallel& parallel, std::span<const Vec4> b, std::span<const Vec4> x,
                           Relaxation relaxation, std::span<Vec4> next) {
    parallel.ranges(model_.particle_count, [&](const BlockRange& range) {
        relax_block(matrix_, range, b.data(), x.data(), relaxation, next.data());
    });
}

void TriangleSystem::precondition(Parallel& parallel, std::span<const Vec4> b, float step,
                                  std::span<Vec4> x) {
    parallel.ranges(model_.particle_count, [&](const BlockRange& range) {
        precondition_block(matrix_, range, b.data(), step, x.data());
    });
}

// A block with the eigenvalue b along the edge n and on average a across it is nearest to a I + (b - a) n
// n^T, if b >= a
// >= 0. Otherwise what is positive of it resists in all directions alike.
SpringBlocks TriangleSystem::spring_blocks(Parallel& parallel) {
    parallel.ranges(model_.particle_count, [&](const BlockRange& range) {
        for (std::uint32_t i = range.begin; i < range.end; ++i) {
            for_each_entry(matrix_.stencil, i, [&](std::uint32_t entry) {
                const ConstLane block(&matrix_.blocks[lane_index(entry, 0, block_floats)]);
                const Vector3 edge = xyz(positions_[matrix_.stencil.neighbours[entry]]) - xyz(positions_[i]);
                const Vector3 n = edge.stableNormalized();
                const float trace = std::max(block.trace(), 0.0f);
                const float along = std::clamp(n.dot(block * n), trace / 3, trace);
                const float across = 0.5f * (trace - along);
                const Vector3 d = std::sqrt(along - across) * n;
                const float values[] = {across, d.x(), d.y(), d.z()};
                for (std::uint32_t k = 0; k < 4; ++k) spring_blocks_[lane_index(entry, k, 4)] = values[k];
            });
        }
    });
    return {matrix_.stencil, spring_blocks_.span()};
}

std::size_t TriangleSystem::bytes() const noexcept {
    return ImplicitSystem::bytes() + elements_.bytes() + matrix_.bytes() + corners_.bytes() +
           quadratic_.bytes() + (hinges_ ? hinges_->bytes() : 0) + spring_blocks_.bytes() +
           positions_.bytes();
}

}  // namespace weft
