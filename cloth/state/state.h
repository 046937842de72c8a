#pragma once
// All state that changes from step to step. Everything else follows from the mesh and the settings, or is
// made anew in each step: a World whose state is restored continues with the same bytes.

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <utility>
#include <variant>
#include <vector>

#include "cloth/state/held_contacts.h"
#include "cloth/state/seam_state.h"
#include "cloth/state/skin_state.h"
#include "collision/contact/crossings/tangles.h"
#include "engine/memory/aligned_buffer.h"
#include "engine/slot_map.h"
#include "engine/vector.h"
#include "weft/body.h"
#include "weft/collider.h"
#include "weft/transform.h"
#include "weft/types.h"

namespace weft {

/// A pinned particle and its target position at the end of the next step [m].
struct Pin {
    std::uint32_t particle;
    Vector3 target;
};

/// The last step, as BDF2 extrapolates it. Empty with other time schemes.
struct StepRecord {
    float h = 0;                           ///< length of the step [s]; 0: no step to go on from
    AlignedBuffer<Vec4> displacements;     ///< [m]
    AlignedBuffer<Vec4> velocity_changes;  ///< [m/s]
    AlignedBuffer<Vec4> arrivals;          ///< positions at its end [m]

    StepRecord() = default;
    explicit StepRecord(std::uint32_t particles)
        : displacements(particles), velocity_changes(particles), arrivals(particles) {}
    StepRecord(std::uint32_t particles, Unmade later)
        : displacements(particles, later), velocity_changes(particles, later), arrivals(particles, later) {}
    [[nodiscard]] std::size_t bytes() const noexcept {
        return displacements.bytes() + velocity_changes.bytes() + arrivals.bytes();
    }
};

/// Stillness of a cloth, which decides when it falls asleep.
struct Rest {
    float still_for = 0;  ///< time for which no particle has been fast [s]
    std::uint32_t asleep = 0;
};

/// The level of detail at which the budget has a cloth stepped.
struct DetailState {
    std::uint32_t rung = 0;  ///< see budget/ladder.h
    std::uint32_t rate = 1;  ///< length of the cloth's last step, in steps of the World
    std::uint32_t left = 0;  ///< steps of the World that remain until the end of that step
    /// Long steps begin where the World's step number modulo the rate is this; no_phase: none begin.
    std::uint32_t phase = no_phase;
    static constexpr std::uint32_t no_phase = ~0u;
    std::uint32_t since = 0;  ///< the World's step in which its rung changed

    void go_to(std::uint32_t other, std::uint32_t step) noexcept {
        rung = other;
        since = step;
    }
};

/// Pose of a cloth's reference frame, its target at the end of the next step, and its origin's last motion.
struct FrameState {
    Transform pose, target;
    Vec3 velocity{}, velocity_change{};  ///< of the origin [m/s]; the change in the last step's last part
};

/// Impulse and angular impulse from a cloth to a body [N s, N m s].
struct BodyShare {
    std::array<float, 6> last{};  ///< in the last substep
    std::array<float, 6> echo{};  ///< in its last equation; the next one repeats 1 / Bdf::divisor of it
};

/// State of one cloth. Loose and pinned particles have inverse mass 0.
struct ClothState {
    AlignedBuffer<Vec4> positions;           ///< x y z [m], w inverse mass [1/kg]
    AlignedBuffer<Vec4> previous_positions;  ///< at the start of the step [m], w inverse mass [1/kg]
    AlignedBuffer<Vec4> velocities;          ///< x y z [m/s], w 0
    AlignedBuffer<Vec4> normals;             ///< x y z of unit length, w 0
    std::vector<Pin> pins;                   ///< in ascending order of particles
    std::optional<FrameState> frame;         ///< only of a cloth in a reference frame
    SkinState skin;
    StepRecord record;  ///< only with BDF2
    HeldContacts held;  ///< only of implicit solvers, with colliders, worn limits or features
    AlignedBuffer<TangleMemory> tangles;  ///< only with features in contact
    std::vector<BodyShare> shares;        ///< one per body, in the order of ids
    /// Not 0: features may cross, until a search finds that none does.
    std::uint32_t may_cross = 0;
    std::optional<Rest> rest;           ///< only where it may fall asleep
    std::optional<DetailState> detail;  ///< only with a budget
    AlignedBuffer<Vec4> ahead;          ///< only with a budget: positions at the end of a long step [m]
    std::uint32_t halved = 0;           ///< steps still to be taken in halves, since contact cut much of late
    static constexpr std::uint32_t most_halved = 10;

    ClothState() = default;
    explicit ClothState(std::uint32_t particles)
        : positions(particles), previous_positions(particles), velocities(particles), normals(particles) {}
    /// A prototype, only to be copied: velocities and normals have a size but no memory.
    ClothState(std::uint32_t particles, Unmade later)
        : positions(particles),
          previous_positions(particles),
          velocities(particles, later),
          normals(particles, later) {}

    [[nodiscard]] std::uint32_t size() const noexcept { return static_cast<std::uint32_t>(positions.size()); }
    [[nodiscard]] std::size_t bytes() const noexcept {
        return positions.bytes() + previous_positions.bytes() + velocities.bytes() + normals.bytes() +
               ahead.bytes() + pins.capacity() * sizeof(Pin) + record.bytes() + held.bytes() + skin.bytes() +
               tangles.bytes() + shares.capacity() * sizeof(BodyShare);
    }
};

/// A collider at present, and its target at the end of the next step.
struct ColliderSlot {
    Collider current, target;
    BodyId body{};   ///< the body that it is attached to; null: none
    Collider own{};  ///< the attached collider in the body's frame
};

struct BodySlot {
    BodySettings settings;
    BodyState state;
};

/// State of a World besides its cloths.
struct WorldState {
    explicit WorldState(SlotMap<ColliderId, ColliderSlot>&& no_colliders)
        : colliders(std::move(no_colliders)) {}

    std::uint64_t steps = 0;            ///< taken since the World was made
    double time = 0;                    ///< simulated since then [s]
    std::array<double, 3> wind_path{};  ///< path of the mean wind since then [m]
    SlotMap<ColliderId, ColliderSlot> colliders;
    SlotMap<BodyId, BodySlot> bodies{new_first_generation()};
    SlotMap<SeamId, SeamState> seams{new_first_generation()};
    std::vector<std::uint32_t> levels;  ///< which mesh of each garment is stepped, 0 the finest
};

template <class Pins, class Visit>
void visit_pins(Pins& pins, const Visit& visit) {
    for (auto& pin : pins) {
        visit(std::span(&pin.particle, 1));
        visit(std::span(pin.target.data(), 3));
    }
}

/// Visits what bodies gave a cloth, if there are any bodies. A visitor with a member shares() for it gets it
/// in any case.
template <class Shares, class Visit>
void visit_shares(Shares& shares, const Visit& visit) {
    if constexpr (requires { visit.shares(std::span(shares)); })
        visit.shares(std::span(shares));
    else if (!shares.empty())
        visit(std::span(shares));
}

/// Calls visit(span) for every part of a state, in a fixed order: for hashing, saving and restoring. `State`
/// may be const.
template <class State, class Visit>
requires std::same_as<std::remove_const_t<State>, ClothState>
void for_each_part(State& state, const Visit& visit) {
    visit(state.positions.span());
    visit(state.previous_positions.span());
    visit(state.velocities.span());
    visit(state.normals.span());
    visit_pins(state.pins, visit);
    if (state.frame) visit(std::span(&*state.frame, 1));
    visit(std::span(&state.record.h, 1));
    visit(state.record.displacements.span());
    visit(state.record.velocity_changes.span());
    visit(state.record.arrivals.span());
    visit(state.held.normals.span());
    visit(state.held.rubbed.span());
    visit(state.held.loads.span());
    visit(state.held.touching.span());
    visit_shares(state.shares, visit);
    if (state.rest) visit(std::span(&*state.rest, 1));
    if (state.detail) {
        visit(std::span(&*state.detail, 1));
        visit(state.ahead.span());
    }
    if (state.skin.places.size() > 0) {
        visit(std::span(&state.skin.known, 1));
        for (auto* buffer :
             {&state.skin.places, &state.skin.target_places, &state.skin.normals, &state.skin.target_normals})
            visit(buffer->span());
    }
    if (state.tangles.size() == 0) return;
    visit(state.tangles.span());
    visit(std::span(&state.may_cross, 1));
    visit(std::span(&state.halved, 1));
}

/// Leaves out PlacedShape::shape: that id never changes, and differs between Worlds.
template <class Kind, class Visit>
void visit_shape(Kind& shape, const Visit& visit) {
    if constexpr (std::same_as<std::remove_const_t<Kind>, PlacedShape>) {
        visit(std::span(&shape.position, 1));
        visit(std::span(&shape.rotation, 1));
    } else {
        visit(std::span(&shape, 1));
    }
}

/// Visits a collider's surface settings other than friction. A visitor with skips_defaults gets none of them
/// if all have their defaults: so hashes stay what they were before these settings existed.
template <class Kind, class Visit>
void visit_surface(Kind& collider, const Visit& visit) {
    if constexpr (requires { Visit::skips_defaults; }) {
        const Collider plain;
        if (collider.thickness == plain.thickness && collider.restitution == plain.restitution &&
            collider.layers == plain.layers && collider.is_trigger == plain.is_trigger)
            return;
    }
    visit(std::span(&collider.thickness, 1));
    visit(std::span(&collider.restitution, 1));
    visit(std::span(&collider.layers, 1));
    visit(std::span(&collider.is_trigger, 1));
}

template <class State, class Visit>
requires std::same_as<std::remove_const_t<State>, WorldState>
void for_each_part(State& state, const Visit& visit) {
    visit(std::span(&state.steps, 1));
    visit(std::span(&state.time, 1));
    visit(std::span(state.wind_path));
    state.colliders.for_each([&](ColliderId, auto& slot) {
        for (auto* collider : {&slot.current, &slot.target}) {
            visit(std::span(&collider->friction, 1));
            visit_surface(*collider, visit);
            std::visit([&](auto& shape) { visit_shape(shape, visit); }, collider->shape);
        }
    });
    state.bodies.for_each([&](BodyId, auto& slot) { visit(std::span(&slot.state, 1)); });
    state.seams.for_each([&](SeamId, auto& seam) { visit(std::span(seam.holds)); });
    if (!state.levels.empty()) visit(std::span(state.levels));
}

}  // namespace weft
