#include "cloth/equation/contacts.h"

#include <algorithm>

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "cloth/equation/contacts.cpp"
#include "hwy/foreach_target.h"  // before highway.h
#include "hwy/highway.h"

#include "cloth/equation/external_row-inl.h"
#include "cloth/equation/sparse/stencil-inl.h"
#include "collision/colliders/block_lanes-inl.h"
#include "engine/simd/symmetric3-inl.h"

#ifndef WEFT_CLOTH_EQUATION_CONTACTS_TYPES
#define WEFT_CLOTH_EQUATION_CONTACTS_TYPES
namespace weft {

/// Arguments of the kernel for one block.
struct ContactBlock {
    const NearSurfaces& near;
    const Vec4* velocities;  // from the block's first particle on
    float gamma;
    Vector3 fall;            // gravity's fall that the velocities lack as yet [m]
    float hold;              // particles that pressed and end nearer than this are in contact [m]
    float stick_per_spring;  // damper over spring, where nothing slides
    float per_mass;          // the spring's stiffness is gamma^-2 (per_mass m + least) [N/m]
    float least;             // [kg]
    float* blocks;
    Vec4* impulses;
    Vec4* normals;
    const float* rubbed;
    Vec4* loads;             // see HeldContacts
    const float* of_bodies;  // per particle: what a body adds to its spring [kg]; null: no bodies
};

struct PressedGroup {
    const float* blocks;
    const Vec4* velocities;
    const Vec4* impulses;
    Vec4* normals;
    float* rubbed;
};

}  // namespace weft
#endif

HWY_BEFORE_NAMESPACE();
namespace weft::HWY_NAMESPACE {
namespace {

/// The lanes, from `i` on, squeezed between colliders: they move along with the surface.
HWY_INLINE auto goes_along(const ContactBlock& block, std::uint32_t i) {
    return hn::Gt(load_lanes(&block.near.motions.w[i]), set(0.5f * held_fast));
}

HWY_INLINE Lanes spring_of(const ContactBlock& block, std::uint32_t i) {
    const Lanes mass = hn::Div(set(1), load_lanes(&block.near.points.w[i]));
    const Lanes spring = hn::MulAdd(set(block.per_mass), mass, set(block.least));
    return block.of_bodies != nullptr ? hn::Add(spring, hn::Load(Tag(), block.of_bodies + i)) : spring;
}

/// The last step's load, turned to the present normal: friction across it, w the load along it.
HWY_INLINE Lanes4 load_of(const ContactBlock& block, std::uint32_t i) {
    const Lanes3 before = xyz(load_rows(block.normals + i)), n = xyz(load_lanes(block.near.surfaces, i));
    const Lanes4 load = load_rows(block.loads + i);
    const Lanes3 across = xyz(load) - dot(xyz(load), n) * n;
    return {across.x, across.y, across.z, hn::Mul(load.w, hn::Max(dot(before, n), set(0)))};
}

/// Distance to the surface, which is raised by as much as the spring yields under the load.
HWY_INLINE Lanes gap_of(const ContactBlock& block, std::uint32_t i, const Lanes& load) {
    const Lanes raised = hn::Div(hn::Mul(set(block.gamma), load), spring_of(block, i));
    return hn::Sub(load_lanes(&block.near.surfaces.w[i]), raised);
}

/// The lanes, from `i` on, that press or are going to.
HWY_INLINE auto in_contact(const ContactBlock& block, std::uint32_t i, const Lanes& gap) {
    const Lanes zero = set(0), w = load_lanes(&block.near.points.w[i]);
    const Lanes4 surface = load_lanes(block.near.surfaces, i);
    const auto falls_in = hn::Lt(hn::Add(gap, dot(set(block.fall), xyz(surface))), zero);
    const auto did_press = hn::Gt(load_rows(block.normals + i).w, zero);
    const auto is_held = hn::And(did_press, hn::Lt(surface.w, set(block.hold)));
    const auto presses = hn::Or(hn::Or(falls_in, is_held), goes_along(block, i));
    return hn::And(presses, hn::Gt(w, zero));
}

void linearise_part(const ContactBlock& block, std::uint32_t i, float* blocks) {
    const Lanes zero = set(0);
    const Lanes4 surface = load_lanes(block.near.surfaces, i), motion = load_lanes(block.near.motions, i);
    const Lanes4 loads = load_of(block, i);
    const Lanes load = loads.w, gap = gap_of(block, i, load);
    const auto contact = in_contact(block, i, gap);
    const Lanes stored = load_rows(block.normals + i).w;
    const Lanes3 n = xyz(surface), v = xyz(load_rows(block.velocities + i));

    const Lanes mass = hn::Div(set(1), load_lanes(&block.near.points.w[i]));
    const Lanes spring = spring_of(block, i);
    // A particle that did not press before is not drawn to the surface.
    const Lanes depth = hn::Neg(hn::IfThenElse(hn::Gt(stored, zero), gap, hn::Min(gap, zero)));
    const Lanes3 relative = v - xyz(motion);
    const auto along = goes_along(block, i);
    const Lanes pressed = hn::IfThenElse(along, hn::Neg(hn::Mul(spring, dot(relative, n))),
                                         hn::Mul(hn::Div(spring, set(block.gamma)), depth));

    // The spring yields to the impulse beyond the load; collide() bears a small part of it, under friction.
    const Lanes yields = hn::Max(hn::Sub(stored, load), zero);
    const Lanes limit = hn::Mul(motion.w, hn::MulAdd(yields, hn::Div(mass, spring), stored));
    const Lanes stick = hn::Mul(set(block.stick_per_spring), spring);
    const Lanes3 sliding = relative - dot(relative, n) * n;
    // Friction is what bore the load in the last step, less the damper of what slides on: what sticks comes
    // to rest under any load.
    const Lanes3 sticking = keep_where(hn::Not(along), xyz(loads)) - stick * sliding;
    const Lanes wanted = hn::Sqrt(dot(sticking, sticking));
    // If the damper took more than the limit, its correction is applied twice: sliding from rest then gathers
    // speed sooner.
    const Lanes took = load_lanes(block.rubbed + i);
    const Lanes again =
        hn::IfThenElse(hn::Gt(took, limit), hn::Max(hn::Div(limit, took), set(0.25f)), set(1));
    // NaN, after a failed step, counts as an infinite limit.
    const auto slides = hn::AndNot(along, hn::Lt(limit, wanted));
    const Lanes share = hn::IfThenElse(slides, hn::Mul(again, hn::Div(limit, wanted)), set(1));
    const Lanes damper = hn::Mul(share, stick);

    SymmetricLanes g = add_square(zero_symmetric(), n);
    g = keep_where(contact, add_identity(hn::Sub(spring, damper) * g, damper));
    store_symmetric(g, blocks);
    store_rows(keep_where(contact, g * v + (pressed * n + share * sticking)), zero, block.impulses + i);
    store_rows(keep_where(contact, n), hn::IfThenElseZero(contact, stored), block.normals + i);
    store_rows(keep_where(contact, xyz(loads)), hn::IfThenElseZero(contact, load), block.loads + i);
}

/// Makes the rows of one group if any of its lanes is in contact; returns whether.
bool linearise_group(const ContactBlock& block, std::uint32_t first) {
    bool touching = false;
    for (std::uint32_t i = first; i < first + Stencil::lanes; i += part_lanes)
        touching =
            touching || !hn::AllFalse(Tag(), in_contact(block, i, gap_of(block, i, load_of(block, i).w)));
    if (!touching) return false;
    for (std::uint32_t i = first; i < first + Stencil::lanes; i += part_lanes)
        linearise_part(block, i, block.blocks + std::size_t{6} * first + i % Stencil::lanes);
    return true;
}

/// Stores the impulses at these velocities, along the normals and across them.
void press_group(const PressedGroup& group) {
    for (std::uint32_t i = 0; i < Stencil::lanes; i += part_lanes) {
        const Lanes3 n = xyz(load_rows(group.normals + i));
        const Lanes3 v = xyz(load_rows(group.velocities + i));
        const Lanes3 at_rest = xyz(load_rows(group.impulses + i));
        const Lanes3 impulse = at_rest - load_symmetric(group.blocks + i) * v;
        const Lanes pressed = dot(impulse, n);
        const Lanes3 rubbed = impulse - pressed * n;
        hn::Store(hn::Sqrt(dot(rubbed, rubbed)), Tag(), group.rubbed + i);
        store_rows(n, hn::IfThenElseZero(hn::Gt(pressed, set(0)), pressed), group.normals + i);
    }
}

}  // namespace
}  // namespace weft::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace weft {

HWY_EXPORT(linearise_group);
HWY_EXPORT(press_group);

namespace {

// A particle's own weight presses it a fiftieth of a free step's fall into the collider. Part 3 of
// tests/bench/MEASUREMENTS.md says why these are neither softer nor stiffer.
constexpr float spring_per_mass = 50.0f, spring_per_fabric = 0.005f;
// A body that lies on n particles sinks in by 50 / n free steps' falls. With the springs above alone a heavy
// body would come through light cloth; springs that stiffen under load would give it energy.
constexpr double spring_per_body = 0.02;
constexpr float stick_per_spring = 10;  // with stiffer ones cloth begins to slide later (part 16)

// An attached particle's spring is as stiff as the fabric beside it, and the particle is put back afterwards.
// Part 16 of tests/bench/MEASUREMENTS.md has stiffer springs.
constexpr float attached_per_mass = 200, attached_per_fabric = 1;

/// visit(i) for each particle from `begin`, a multiple of 16, to `end` whose group touches.
template <class Visit>
void for_each_touching(const HeldContacts& held, std::uint32_t begin, std::size_t end, const Visit& visit) {
    for (std::uint32_t start = begin; start < end; start += Stencil::lanes) {
        if (held.touching[start / Stencil::lanes] == 0) continue;
        for (std::uint32_t i = start; i < std::min<std::size_t>(start + Stencil::lanes, end); ++i) visit(i);
    }
}

float stiffness_of(const ClothSettings& settings) {
    return std::max(settings.fabric.warp, settings.fabric.weft);
}

}  // namespace

Contacts::Contacts(std::uint32_t particles, bool with_pairs) {
    const std::size_t entries = std::size_t{6} * Stencil::whole_groups(particles);
    rows_.blocks = AlignedBuffer<float>(entries);
    rows_.impulses = AlignedBuffer<Vec4>(particles);
    if (!with_pairs) return;
    rows_.in_relaxation = AlignedBuffer<float>(entries);
    of_colliders_ = AlignedBuffer<Vec4>(particles);
    touching_ = AlignedBuffer<std::uint32_t>(Stencil::whole_groups(particles) / Stencil::lanes);
}

void Contacts::linearise(const StepEquation& equation, std::span<const Vec4> velocities,
                         const BlockRange& range) {
    const bool is_first = passes_ == 1;
    if (!is_first) press(range, velocities);
    const float gamma = equation.gamma;
    const std::uint32_t size = range.end - range.begin;
    const std::span<const Vec4> v = velocities.subspan(range.begin, size);
    NearSurfaces surfaces;
    const std::span<std::int32_t> pressed = body_buffers_ != nullptr
                                                ? body_buffers_->pressed.span().subspan(range.begin, size)
                                                : std::span<std::int32_t>();
    bool near =
        find_near_surfaces(colliders_, side_.part(range.begin, size), equation.h, reach,
                           equation.positions.subspan(range.begin, size),
                           equation.base_positions.subspan(range.begin, size), gamma, v, surfaces, pressed);
    if (near && equation.bodies != nullptr) find_squeezed(equation, velocities, range, surfaces, pressed);
    if (own_ != nullptr) {
        near = own_->adjust(range, reach, near, surfaces);
        for (std::uint32_t i = 0; i < pressed.size(); ++i)
            if (own_->holds(range.begin + i)) pressed[i] = BodyBuffers::none;
    }
    alignas(64) std::array<float, block_size> of_bodies;
    for (std::uint32_t i = 0; body_buffers_ != nullptr && i < block_size; ++i) {
        const std::int32_t body = i < size ? pressed[i] : -1;
        const double inverse_mass = body >= 0 ? bodies_[static_cast<std::size_t>(body)].inverse_mass : 0;
        of_bodies[i] = inverse_mass > 0 ? static_cast<float>(spring_per_body / inverse_mass) : 0.0f;
    }
    const ContactBlock block{.near = surfaces,
                             .velocities = v.data(),
                             .gamma = gamma,
                             .fall = (is_first ? gamma * gamma : 0.0f) * equation.external.gravity,
                             .hold = is_first ? reach : 0.0f,
                             .stick_per_spring = stick_per_spring,
                             .per_mass = spring_per_mass,
                             .least = spring_per_fabric * gamma * gamma * stiffness_of(equation.settings),
                             .blocks = rows_.blocks.data() + std::size_t{6} * range.begin,
                             .impulses = of_colliders().data() + range.begin,
                             .normals = held_->normals.data() + range.begin,
                             .rubbed = held_->rubbed.data() + range.begin,
                             .loads = held_->loads.data() + range.begin,
                             .of_bodies = body_buffers_ != nullptr ? of_bodies.data() : nullptr};
    for (std::uint32_t i = range.begin; i < range.end; i += Stencil::lanes) {
        std::uint32_t& touching = held_->touching[i / Stencil::lanes];
        const bool touches = near && HWY_DYNAMIC_DISPATCH(linearise_group)(block, i - range.begin);
        if (touching != 0 && !touches) {
            std::fill_n(held_->normals.data() + i, Stencil::lanes, Vec4{});
            std::fill_n(held_->rubbed.data() + i, Stencil::lanes, 0.0f);
            std::fill_n(held_->loads.data() + i, Stencil::lanes, Vec4{});
        }
        touching = touches ? 1 : 0;
    }
    if (!attached_.empty()) attach_block(equation, velocities, range);
    if (has_pairs()) add_pairs(range);
}

// An attached particle: an isotropic spring to its place on the body overwrites the collider's row.
void Contacts::attach_block(const StepEquation& equation, std::span<const Vec4> velocities,
                            const BlockRange& range) {
    const float gamma = equation.gamma;
    const float of_fabric = attached_per_fabric * gamma * gamma * stiffness_of(equation.settings);
    auto at = std::ranges::lower_bound(attached_, range.begin, {}, &Attachment::particle);
    for (; at != attached_.end() && at->particle < range.end; ++at) {
        const std::uint32_t i = at->particle, group = i / Stencil::lanes, start = group * Stencil::lanes;
        const float w = equation.positions[i].w;
        if (!(w > 0)) continue;
        if (held_->touching[group] == 0) {
            held_->touching[group] = 1;
            std::fill_n(rows_.blocks.data() + std::size_t{6} * start, 6 * Stencil::lanes, 0.0f);
            std::fill_n(of_colliders().data() + start, Stencil::lanes, Vec4{});
        }
        const float spring = attached_per_mass / w + of_fabric;
        const Vector3 v = xyz(velocities[i]);
        const Vector3 away = bodies_[at->body].end * at->own - (xyz(equation.base_positions[i]) + gamma * v);
        for (std::uint32_t k = 0; k < 6; ++k) rows_.blocks[lane_index(i, k, 6)] = k < 3 ? spring : 0;
        of_colliders()[i] = to_vec4(spring * v + spring / gamma * away, 0);
        held_->normals[i] = {};
        held_->rubbed[i] = 0;
        body_buffers_->pressed[i] = BodyBuffers::none;
    }
}

void Contacts::find_pushes(const StepEquation& equation, std::span<const Vec4> velocities) {
    std::vector<BodyPush>& pushes = body_buffers_->pushes;
    pushes.clear();
    for_each_touching(*held_, 0, velocities.size(), [&](std::uint32_t i) {
        if (body_buffers_->pressed[i] < 0 || !presses_collider(i)) return;
        const auto body = static_cast<std::uint32_t>(body_buffers_->pressed[i]);
        const Vector3 v = xyz(velocities[i]), there = xyz(equation.base_positions[i]) + equation.gamma * v;
        pushes.push_back({i, body, there - bodies_[body].end.position, v});
    });
    // The spring pulls at the place of attachment, even where other cloth keeps the particle away from it.
    for (const Attachment& attached : attached_)
        if (equation.positions[attached.particle].w > 0)
            pushes.push_back({attached.particle, attached.body,
                              bodies_[attached.body].end.rotation * attached.own,
                              xyz(velocities[attached.particle])});
}

// Colliders' impulses are kept apart, because press() reads from them how hard particles press.
void Contacts::add_pairs(const BlockRange& range) {
    for (std::uint32_t i = range.begin; i < range.end; i += Stencil::lanes) {
        const std::uint32_t group = i / Stencil::lanes;
        touching_[group] = held_->touching[group];
        if (touching_[group] == 0) continue;
        std::copy_n(of_colliders_.data() + i, Stencil::lanes, rows_.impulses.data() + i);
        std::fill_n(rows_.in_relaxation.data() + std::size_t{6} * i, 6 * Stencil::lanes, 0.0f);
    }
    const auto add = [&](const PairRows::AtParticle& at) {
        const std::uint32_t i = at.particle - first_, group = i / Stencil::lanes;
        const std::uint32_t start = group * Stencil::lanes;
        if (touching_[group] == 0) {
            touching_[group] = 1;
            std::fill_n(rows_.blocks.data() + std::size_t{6} * start, 6 * Stencil::lanes, 0.0f);
            std::fill_n(rows_.in_relaxation.data() + std::size_t{6} * start, 6 * Stencil::lanes, 0.0f);
            std::fill_n(rows_.impulses.data() + start, Stencil::lanes, Vec4{});
        }
        const Symmetric3& d = at.diagonal;
        const std::array<float, 6> entries{d.xx, d.yy, d.zz, d.xy, d.xz, d.yz};
        for (std::uint32_t k = 0; k < 6; ++k) rows_.in_relaxation[lane_index(i, k, 6)] += entries[k];
        rows_.impulses[i] = to_vec4(xyz(rows_.impulses[i]) + at.impulse, 0);
    };
    if (pairs_ != nullptr && !pairs_->empty())
        pairs_->for_each_particle(first_ + range.begin, first_ + range.end, add);
    for (const SeamRows* seam : seams_)
        seam->for_each_particle(first_ + range.begin, first_ + range.end, add);
}

std::uint32_t Contacts::pressing() const noexcept {
    std::uint32_t count = 0;
    for_each_touching(*held_, 0, held_->normals.size(),
                      [&](std::uint32_t i) { count += presses_collider(i) ? 1 : 0; });
    return count;
}

void Contacts::finish(Parallel& parallel, const StepEquation& equation, std::span<const Vec4> velocities) {
    parallel.ranges(static_cast<std::uint32_t>(velocities.size()), [&](const BlockRange& range) {
        press(range, velocities);
        keep_loads(equation, velocities, range);
    });
}

void Contacts::bounce(Parallel& parallel, const StepEquation& equation, std::span<Vec4> velocities) {
    const auto bounces = [](const ColliderMotion& motion) { return motion.end.restitution > 0; };
    if (!(side_.restitution > 0) && std::ranges::none_of(colliders_, bounces)) return;
    parallel.ranges(static_cast<std::uint32_t>(velocities.size()),
                    [&](const BlockRange& range) { bounce_block(equation, range, velocities); });
}

// Newton's law of restitution: the normal velocity after the substep is that before it, reversed and times
// the restitution. A bouncing particle presses no more: the next step neither draws it back nor extrapolates.
void Contacts::bounce_block(const StepEquation& equation, const BlockRange& range,
                            std::span<Vec4> velocities) {
    const std::uint32_t size = range.end - range.begin, group = range.begin / Stencil::lanes;
    const auto groups = held_->touching.span().subspan(group, (size + Stencil::lanes - 1) / Stencil::lanes);
    if (std::ranges::none_of(groups, [](std::uint32_t touching) { return touching != 0; })) return;
    NearSurfaces near;
    if (!find_bouncing_surfaces(colliders_, side_.part(range.begin, size), equation.h, reach,
                                equation.base_positions.subspan(range.begin, size), equation.gamma,
                                velocities.subspan(range.begin, size), near))
        return;
    for (std::uint32_t k = 0; k < size; ++k) {
        const std::uint32_t i = range.begin + k;
        Vec4& normal = held_->normals[i];
        if (!(normal.w > 0) || !(near.surfaces.w[k] < reach)) continue;
        // The body would not get the opposite impulse.
        if (body_buffers_ != nullptr && body_buffers_->pressed[i] >= 0) continue;
        const Vector3 n = xyz(normal), of_surface(near.motions.x[k], near.motions.y[k], near.motions.z[k]);
        const float before = n.dot(of_surface - xyz(equation.velocities[i]));
        const float wanted = before > side_.least_bounce ? near.motions.w[k] * before : 0.0f;
        const float more = wanted - n.dot(xyz(velocities[i]) - of_surface);
        if (!(wanted > 0 && more > 0)) continue;
        set_xyz(velocities[i], xyz(velocities[i]) + more * n);
        normal.w = 0;
        held_->loads[i] = {};
    }
}

/// A particle sticks while its row's damper is more than half of the full one; one that has just reached
/// Coulomb's limit still does. Particles that slide have less.
bool is_stuck(const Symmetric3& g, const Vector3& n) {
    const float spring = n.dot(g * n), dampers = g.xx + g.yy + g.zz - spring;
    return dampers > stick_per_spring * spring;
}

// Impacts end with the step, so the impulse that stopped the particle is no load, nor is the friction of what
// slides. Particles on bodies have no load, because the part that stopped the body is not known.
void Contacts::keep_loads(const StepEquation& equation, std::span<const Vec4> velocities,
                          const BlockRange& range) {
    for_each_touching(*held_, range.begin, range.end, [&](std::uint32_t i) {
        const Vec4& normal = held_->normals[i];
        const float w = equation.positions[i].w;
        const bool by_body = body_buffers_ != nullptr && body_buffers_->pressed[i] != BodyBuffers::none;
        held_->loads[i] = {};
        if (by_body || !(w > 0 && normal.w > 0)) return;
        const Vector3 n = xyz(normal), v = xyz(velocities[i]), given = of_colliders(i, v);
        const Vector3 stopped = (v - xyz(equation.base_velocities[i])) / w, rubbed = given - n.dot(given) * n;
        const float squared = is_stuck(rows_.block(i), n) ? rubbed.squaredNorm() : 0;
        const float share = squared > 0 ? std::clamp(1 - rubbed.dot(stopped) / squared, 0.0f, 1.0f) : 0;
        held_->loads[i] = to_vec4(share * rubbed, std::max(normal.w - std::max(n.dot(stopped), 0.0f), 0.0f));
    });
}

void Contacts::press(const BlockRange& range, std::span<const Vec4> velocities) {
    for (std::uint32_t i = range.begin; i < range.end; i += Stencil::lanes) {
        if (held_->touching[i / Stencil::lanes] == 0) continue;
        HWY_DYNAMIC_DISPATCH(press_group)
        ({.blocks = rows_.blocks.data() + std::size_t{6} * i,
          .velocities = velocities.data() + i,
          .impulses = of_colliders().data() + i,
          .normals = held_->normals.data() + i,
          .rubbed = held_->rubbed.data() + i});
    }
}

}  // namespace weft
#endif
