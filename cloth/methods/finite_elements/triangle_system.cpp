#include "cloth/methods/finite_elements/triangle_system.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "cloth/fabric/spring_system.h"
#include "cloth/mesh/rest/bending.h"
#include "cloth/mesh/rest/slivers.h"

namespace weft {

namespace {

constexpr std::uint32_t block_floats = 9;
constexpr std::uint32_t no_block = ~std::uint32_t{0};

/// A block as it lies in the matrix, every 16 floats.
template <class Block>
using InMatrix = Eigen::Map<Block, 0, Eigen::Stride<3 * Stencil::lanes, Stencil::lanes>>;
using RowMajor3 = Eigen::Matrix<float, 3, 3, Eigen::RowMajor>;

InMatrix<RowMajor3> block_at(TriangleMatrix& matrix, std::uint32_t entry) {
    return InMatrix<RowMajor3>(&matrix.blocks[lane_index(entry, 0, block_floats)]);
}

/// The factor of bending's Hessian in W [s^2]. All of bending is damped.
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

/// Sets the rows' blocks of a block of particles to 0.
void clear_rows(const BlockRange& range, TriangleMatrix& matrix) {
    const auto first_of = [&](std::uint32_t group) {
        return std::size_t{matrix.stencil.group_slots[group]} * block_floats * Stencil::lanes;
    };
    const std::size_t begin = first_of(range.begin / Stencil::lanes);
    const std::size_t end = first_of((range.end + Stencil::lanes - 1) / Stencil::lanes);
    std::ranges::fill(matrix.blocks.span().subspan(begin, end - begin), 0.0f);
}

/// Bending elements that keep the part of their stiffness that the membranes of their slivers keep: a step
/// leaves what bends at much stiffer slivers unsolved, and free cloth would begin to fall crooked.
Bending softened_bending(const ClothModel& model) {
    Bending bending = bending_elements(model);
    std::vector<float> left(bending.hinges.size(), 1.0f);
    for (std::uint32_t s = 0; s < bending.of_sides.size(); ++s)
        if (const std::uint32_t hinge = bending.of_sides[s]; hinge != Bending::no_hinge)
            left[hinge] =
                std::min(left[hinge], static_cast<float>(element_stiffness_left(rest_sides(model, s / 3))));
    for (std::size_t k = 0; k < left.size(); ++k) bending.hinges[k].weight *= left[k];
    for (HingePair& pair : bending.pairs) pair.weight *= std::sqrt(left[pair.first] * left[pair.second]);
    return bending;
}

}  // namespace

TriangleSystem::TriangleSystem(const ClothModel& model, const ClothSettings& settings)
    : TriangleSystem(model, settings, settings.fabric.bending > 0 ? softened_bending(model) : Bending()) {}

TriangleSystem::TriangleSystem(const ClothModel& model, const ClothSettings& settings, const Bending& bending)
    : TriangleSystem(
          model, settings, bending,
          ElementRows::of_triangles(model, settings.finite_elements.dihedral ? std::span(bending.hinges)
                                                                             : std::span<const Hinge>())) {}

TriangleSystem::TriangleSystem(const ClothModel& model, const ClothSettings& settings, const Bending& bending,
                               const ElementRows& rows)
    : ImplicitSystem(model.particle_count),
      model_(&model),
      elements_(model),
      matrix_(Stencil(rows.offsets, rows.neighbours)),
      sources_(model, elements_, matrix_.stencil, rows) {
    const bool has_hinges = !bending.hinges.empty();
    if (has_hinges && settings.finite_elements.dihedral) store_dihedral_bending(bending, rows);
    if (has_hinges && !settings.finite_elements.dihedral) store_quadratic_bending(bending, rows);
    if (hinges_ || settings.finite_elements.consistent_mass) {
        additions_.impulses = AlignedBuffer<Vec4>(model.particle_count);
        additions_.diagonals =
            AlignedBuffer<float>(std::size_t{6} * Stencil::lanes * matrix_.stencil.groups());
    }
    lay_out_alone();
}

std::optional<SavedSprings> TriangleSystem::springs() const {
    return std::nullopt;
}

void TriangleSystem::lay_out(Scratch& scratch) {
    ImplicitSystem::lay_out(scratch);
    elements_.lay_out(scratch);
    matrix_.lay_out(scratch);
    scratch.take(positions_, model_->particle_count);
}

std::unique_ptr<ImplicitSystem> TriangleSystem::clone(const ClothModel& model) const {
    auto made = std::make_unique<TriangleSystem>(*this);
    made->model_ = &model;
    made->matrix_.contacts = nullptr;
    return made;
}

void TriangleSystem::store_dihedral_bending(const Bending& bending, const ElementRows& rows) {
    hinges_.emplace(bending, model_->particle_count, [&](std::uint32_t i, std::uint32_t j) {
        return matrix_.stencil.entry(i, rows.half_edge(i, j));
    });
}

void TriangleSystem::store_quadratic_bending(const Bending& bending, const ElementRows& triangles) {
    const ElementRows rows = ElementRows::of_quadratic_bending(*model_, bending);
    matrix_.scalar_stencil = Stencil(rows.offsets, rows.neighbours);
    matrix_.scalars = AlignedBuffer<float>(matrix_.scalar_stencil.neighbours.size());
    quadratic_ = SharedBuffer<float>(model_->particle_count);
    for_each_quadratic_term(bending, [&](std::uint32_t i, std::uint32_t j, float k) {
        matrix_.scalars[matrix_.scalar_stencil.entry(i, rows.half_edge(i, j))] -= k;
        quadratic_[i] -= k;  // rows of the Hessian sum to 0
    });
    block_entries_ = SharedBuffer<std::uint32_t>(matrix_.scalars.size());
    std::ranges::fill(block_entries_.span(), no_block);
    for (std::uint32_t i = 0; i < model_->particle_count; ++i)
        for (std::size_t e = triangles.offsets[i]; e < triangles.offsets[i + 1]; ++e)
            block_entries_[matrix_.scalar_stencil.entry(i, rows.half_edge(i, triangles.neighbours[e]))] =
                matrix_.stencil.entry(i, e);
}

void TriangleSystem::compute_elements(Parallel& parallel, const StepEquation& equation,
                                      std::span<const Vec4> velocities, bool viscous, bool stiffness) {
    const FiniteElements& settings = equation.settings.finite_elements;
    const float gamma = equation.gamma, damping = viscous ? equation.settings.fabric.damping : 0.0f;
    const TrianglePass triangles{.moduli = membrane_moduli(equation.settings.fabric, settings.poisson),
                                 .positions = positions_.data(),
                                 .velocities = damping > 0 ? velocities.data() : nullptr,
                                 .viscosity = damping,
                                 .stiffness = stiffness,
                                 .elastic = gamma * gamma,
                                 .viscous = gamma * equation.settings.fabric.damping};
    parallel.ranges(elements_.count,
                    [&](const BlockRange& range) { compute_triangles(elements_, range, triangles); });
    if (hinges_)
        hinges_->compute(parallel, {.rigidity = equation.rigidity,
                                    .positions = positions_.span(),
                                    .velocities = damping > 0 ? velocities : std::span<const Vec4>(),
                                    .viscosity = damping});
}

void TriangleSystem::make_additions(Parallel& parallel, const StepEquation& equation,
                                    std::span<const Vec4> velocities, bool linearised,
                                    LinearisedAbout about) {
    if (additions_.impulses.size() == 0) return;
    parallel.ranges(model_->particle_count, [&](const BlockRange& range) {
        if (linearised) clear_rows(range, matrix_);
        for (std::uint32_t i = range.begin; i < range.end; ++i) {
            additions_.impulses[i] = {};
            if (hinges_) add_bending(equation, i, linearised);
            if (equation.settings.finite_elements.consistent_mass)
                add_consistent_mass(equation, velocities, i, linearised, about);
        }
    });
}

void TriangleSystem::add_bending(const StepEquation& equation, std::uint32_t i, bool linearised) {
    Vector3 force = Vector3::Zero();
    Matrix3 own_block = Matrix3::Zero();
    for (const HingeElements::Corner& corner : hinges_->corners(i)) {
        const Vector3 own = hinges_->gradient(corner.hinge, corner.corner);
        force += hinges_->moment(corner.hinge) * own;
        if (!linearised) continue;
        const Vector3 scaled = bending_factor_ * hinges_->stiffness(corner.hinge) * own;
        own_block += scaled * own.transpose();
        for (std::uint32_t other = 0; other < 3; ++other)
            block_at(matrix_, corner.entries[other]) -=
                scaled * hinges_->gradient(corner.hinge, (corner.corner + other + 1) % 4).transpose();
    }
    additions_.impulses[i] = to_vec4(equation.gamma * force, 0);
    if (!linearised) return;
    // Half of the bound 4 diag(K_e) of an element of four particles: see TriangleSystem.
    const Matrix3 d = 2.0f * own_block;
    const float values[] = {d(0, 0), d(1, 1), d(2, 2), d(0, 1), d(0, 2), d(1, 2)};
    for (std::uint32_t k = 0; k < 6; ++k) additions_.diagonals[lane_index(i, k, 6)] = values[k];
}

// A triangle's consistent mass matrix has a twelfth of its mass for each two corners, and less on the
// diagonal than the lumped matrix, so that rows sum to the same. About the base M (v_base - v) is 0, and the
// impulse cancels the block's part in gamma J v.
void TriangleSystem::add_consistent_mass(const StepEquation& equation, std::span<const Vec4> velocities,
                                         std::uint32_t i, bool linearised, LinearisedAbout about) {
    const float base_part = about == LinearisedAbout::base ? 0.0f : 1.0f;
    const auto change = [&](std::uint32_t j) -> Vector3 {
        return xyz(equation.base_velocities[j]) - base_part * xyz(velocities[j]);
    };
    Vector3 impulse = Vector3::Zero();
    for_each_entry(matrix_.stencil, i, [&](std::uint32_t entry) {
        const float mass =
            equation.settings.fabric.areal_density * sources_.shared_area(elements_, entry) / 12;
        impulse += mass * (change(matrix_.stencil.neighbours[entry]) - change(i));
        if (linearised) block_at(matrix_, entry).diagonal().array() -= mass;
    });
    set_xyz(additions_.impulses[i], xyz(additions_.impulses[i]) + impulse);
}

TriangleState TriangleSystem::state_at(const StepEquation& equation, std::span<const Vec4> velocities) const {
    return {.equation = equation,
            .elements = elements_,
            .sources = sources_,
            .additions = additions_,
            .positions = positions_.span(),
            .velocities = velocities,
            .quadratic = quadratic_.span()};
}

// About the base, b = gamma (f + gamma J v + C v), with the elastic force alone in f; about the iterate, C v
// is in f.
void TriangleSystem::linearise(Parallel& parallel, const StepEquation& equation,
                               std::span<const Vec4> velocities, LinearisedAbout about) {
    place(parallel, equation, velocities, about);
    compute_elements(parallel, equation, velocities, about == LinearisedAbout::iterate, true);
    bending_factor_ = bending_factor(equation);
    make_additions(parallel, equation, velocities, true, about);
    if (quadratic_.size() > 0) matrix_.scale = bending_factor_ * equation.rigidity;
    matrix_.contacts = begin_contacts(equation);
    const TriangleState state = state_at(equation, velocities);
    parallel.ranges(model_->particle_count, [&](const BlockRange& range) {
        linearise_contacts(equation, velocities, range);
        linearise_block(state, about, range, matrix_, right_side_.data());
    });
}

void TriangleSystem::residual(Parallel& parallel, const StepEquation& equation,
                              std::span<const Vec4> velocities, std::span<Vec4> residual) {
    place(parallel, equation, velocities, LinearisedAbout::iterate);
    compute_elements(parallel, equation, velocities, true, false);
    make_additions(parallel, equation, velocities, false, LinearisedAbout::iterate);
    const TriangleState state = state_at(equation, velocities);
    parallel.ranges(model_->particle_count,
                    [&](const BlockRange& range) { residual_block(state, range, matrix_, residual.data()); });
}

void TriangleSystem::place(Parallel& parallel, const StepEquation& equation, std::span<const Vec4> velocities,
                           LinearisedAbout about) {
    const float gamma = about == LinearisedAbout::base ? 0.0f : equation.gamma;
    parallel.ranges(model_->particle_count, [&](const BlockRange& range) {
        for (std::uint32_t i = range.begin; i < range.end; ++i) {
            const Vec4& base = equation.base_positions[i];
            positions_[i] = to_vec4(xyz(base) + gamma * xyz(velocities[i]), base.w);
        }
    });
}

Products TriangleSystem::multiply_rows(const BlockRange& range, const DottedWith& with, const Vec4* x,
                                       Vec4* product, GridWindow* /*window*/) const {
    return multiply_block(matrix_, range, with, x, product);
}

void TriangleSystem::subtract_product_rows(const BlockRange& range, const Vec4* b, const Vec4* x,
                                           Vec4* remainder, GridWindow* /*window*/) const {
    subtract_product_block(matrix_, range, b, x, remainder);
}

void TriangleSystem::precondition_rows(const BlockRange& range, const Vec4* b, float step, Vec4* x) const {
    precondition_block(matrix_, range, b, step, x);
}

void TriangleSystem::relax_rows(const BlockRange& range, const Vec4* b, const Vec4* x, Relaxation relaxation,
                                Vec4* next, GridWindow* /*window*/) const {
    relax_block(matrix_, range, b, x, relaxation, next);
}

// A spring takes from its block the stiffness along the edge, and across the edge the tension, which is what
// the block has along its triangles' normals. It leaves out how the triangles couple their edges: in a spring
// that part would resist rotation in the plane and, shared out evenly across the edge, out of the plane.
void TriangleSystem::spring_blocks(Parallel& parallel, std::span<const std::uint32_t> slots,
                                   std::span<Vec4> blocks) {
    const Stencil& all = stencil();
    parallel.ranges(static_cast<std::uint32_t>(slots.size()), [&](const BlockRange& range) {
        for (std::uint32_t k = range.begin * Stencil::lanes; k < range.end * Stencil::lanes; ++k) {
            const std::uint32_t slot = slots[k / Stencil::lanes], lane = k % Stencil::lanes;
            const std::uint32_t entry = slot * Stencil::lanes + lane, i = all.node_of(slot, lane);
            const std::uint32_t own = block_entries_.empty() ? entry : block_entries_[entry];
            Vector3 along = Vector3::Zero();
            float across = 0;
            if (own != no_block) {
                const Vector3 edge = xyz(positions_[all.neighbours[entry]]) - xyz(positions_[i]);
                const Vector3 n = edge.stableNormalized();
                along = std::sqrt(std::max(n.dot(block_at(matrix_, own) * n), 0.0f)) * n;
                for (const TriangleSources::Source& source : sources_.sources)
                    across += std::max(elements_.results[source.sides[own]].w, 0.0f);
            }
            if (hinges_) across += bending_between(i, entry);
            if (!block_entries_.empty()) across += matrix_.scale * matrix_.scalars[entry];
            blocks[k] = to_vec4(along, across);
        }
    });
}

float TriangleSystem::bending_between(std::uint32_t i, std::uint32_t entry) const {
    float sum = 0;
    for (const HingeElements::Corner& corner : hinges_->corners(i))
        for (std::uint32_t other = 0; other < 3; ++other)
            if (corner.entries[other] == entry)
                sum -= bending_factor_ * hinges_->stiffness(corner.hinge) *
                       hinges_->gradient(corner.hinge, corner.corner)
                           .dot(hinges_->gradient(corner.hinge, (corner.corner + other + 1) % 4));
    return sum;
}

std::size_t TriangleSystem::bytes() const noexcept {
    return elements_.bytes() + matrix_.bytes() + sources_.bytes() + additions_.bytes() + quadratic_.bytes() +
           block_entries_.bytes() + (hinges_ ? hinges_->bytes() : 0);
}

}  // namespace weft
