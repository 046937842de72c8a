#pragma once
// What a World holds, and what its host can do to it between steps.

#include <chrono>
#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

#include "cloth/budget/allotment.h"
#include "cloth/contact/contact_log.h"
#include "cloth/contact/group_finder.h"
#include "cloth/instance/cloth.h"
#include "cloth/instance/group.h"
#include "cloth/simulation/body_stage.h"
#include "cloth/simulation/schedule.h"
#include "cloth/solver/stages.h"
#include "collision/colliders/collider_contacts.h"
#include "collision/shapes/held_shape.h"
#include "engine/profiling/profiler.h"
#include "engine/slot_map.h"
#include "engine/threads/parallel_blocks.h"
#include "weft/world.h"

namespace weft {

[[nodiscard]] BodyPose pose_of(const BodyState& state);

[[nodiscard]] inline std::int64_t steady_nanoseconds() noexcept {
    return std::chrono::steady_clock::now().time_since_epoch() / std::chrono::nanoseconds(1);
}

/// What pins do that the host has not moved when their cloth goes to what holds it: they hold it back, or go
/// along.
enum class StillPins : std::uint8_t { stay, go_along };

/// Settings are validated before they get here. Calls that can run out of memory change nothing then.
struct Simulation {
    explicit Simulation(const WorldSettings& settings);
    void apply(const WorldSettings& settings);

    /// Makes or frees what so many colliders need.
    void expect_colliders(std::size_t count);
    /// Takes a cloth over, with what no step may make.
    ClothId add(std::unique_ptr<Cloth>&& cloth);
    /// Has `next` in the cloth's place.
    void replace(ClothId id, std::unique_ptr<Cloth>&& next);
    /// Gives a new cloth its bounds, its normals and what it needs of air and colliders, so that it can be
    /// drawn before its first step.
    void prepare(Cloth& cloth);
    /// Takes over what follows from a cloth's state, which was restored: see Cloth::commit_restore.
    void state_has_changed(Cloth& cloth);

    /// The frame: see step.cpp. Precondition: dt is in [least_step, greatest_step].
    void step(float dt);

    WorldSettings settings;
    Parallel parallel;
    Profiler profiler;
    SlotMap<ClothId, std::unique_ptr<Cloth>> cloths{new_first_generation()};
    /// What World::cloth last gave out, by the index of ids, and one more: emptied when a cloth is removed.
    std::vector<std::unique_ptr<ClothView>> views;
    WorldState state{SlotMap<ColliderId, ColliderSlot>(new_first_generation())};
    /// Only calls of the host change them.
    SlotMap<ShapeId, std::unique_ptr<HeldShape>> shapes{new_first_generation()};
    StepReport report;

    /// The shape that it is an instance of; null: it is none, or of one that is not there.
    [[nodiscard]] const HeldShape* held_by(const Collider& collider) const noexcept;
    /// Of the last step; nothing of a cloth that it did not take.
    [[nodiscard]] ClothReport report_of(const Cloth& cloth) const;
    /// Of the last step.
    [[nodiscard]] std::span<const Contact> contacts() const noexcept { return contact_reports.list(); }
    void clear_contacts() noexcept { contact_reports.clear(); }

    /// Takes validated settings of a cloth over.
    void apply(Cloth& cloth, const ClothSettings& changed);
    void set_map(Cloth& cloth, Map map, AlignedBuffer<float>&& values);
    /// Sees to what the cloth needs in a frame: room for the colliders as it sees them.
    void set_frame(Cloth& cloth, const Transform& pose);
    /// Teleports a cloth; or all, with all else. What is moved is checked beforehand.
    void move(Cloth& cloth, const RigidMotion& by);
    /// The rigid motion that brings a cloth to what holds it: pins, bodies, and the skin that limits are
    /// measured from. None if it is there. Error: a vertex would be out of reach.
    [[nodiscard]] Result<std::optional<RigidMotion>> motion_to_holds(Cloth& cloth, const SkinState& skin,
                                                                     StillPins pins);
    /// Teleports it by that, then each held particle to its place.
    void go_to_holds(Cloth& cloth, const RigidMotion& by, StillPins pins);
    void shift_origin(const Vec3& to);
    /// Frees what the rest does not need.
    void cloth_has_gone() noexcept;

    BodyId add_body(const BodySlot& slot);
    void remove_body(BodyId id);
    /// Colliders that bodies carry are where these are.
    void place_carried_colliders() noexcept;
    [[nodiscard]] std::span<const BodyImpulse> body_impulses() const noexcept {
        return body_stage ? std::span<const BodyImpulse>(body_stage->impulses)
                          : std::span<const BodyImpulse>();
    }
    void clear_body_impulses() noexcept;

    // Of a World with a budget.
    std::vector<RungOfCloth> choices;  ///< that the last step changed
    bool has_given_choices = false;    ///< who replays makes them; the step makes none
    /// By which costs are measured [ns].
    std::int64_t (*clock)() noexcept = steady_nanoseconds;
    /// Instead of it, where time is to be known: what the step took of a cloth [ns].
    std::int64_t (*cost_of)(const Cloth& cloth) = nullptr;

    /// Bytes that steps have and no cloth counts as its own.
    [[nodiscard]] std::size_t bytes_to_spare() const;
    /// All that they have in common.
    [[nodiscard]] std::size_t common_bytes() const noexcept {
        return scratch.bytes() + (zones ? zones->bytes() : 0);
    }

    /// Wakes all cloths; those near a collider; those that may touch a cloth. A cloth that is awake stays so
    /// for a while.
    void wake_all() noexcept;
    void wake_near(const Collider& collider) noexcept;
    void wake_near(const Cloth& gone) noexcept;
    /// The same in two calls, around a change of the cloth that may fail.
    void mark_near(const Cloth& changing) noexcept;
    void wake_marked() noexcept;

    /// The air's velocities at points [m/s]; both have room for whole groups of 16.
    void find_air(Parallel& threads, std::span<const Vec4> points, std::span<Vec4> velocities) const;

    [[nodiscard]] bool reports_contacts() const { return settings.contact_reports > 0; }
    [[nodiscard]] bool air_is_on() const { return settings.wind.air_density > 0; }
    [[nodiscard]] auto timed(Stage stage) { return profiler.time(static_cast<std::uint32_t>(stage)); }
    static void update_normals(Parallel& loops, Cloth& cloth);
    /// A body's place in the order of ids.
    [[nodiscard]] std::size_t number_of(BodyId id) const;
    void prepare_for_bodies(Cloth& cloth) const;

    /// Memory that the steps of all cloths share.
    struct Room {
        ScratchMemory scratch;  ///< none: there is enough
        std::unique_ptr<ImpactZones> zones;
        std::size_t zone_particles = 0;
    };
    /// A cloth that comes, or takes another's place, with so much scratch and this mesh of features.
    struct Newcomer {
        const Cloth* in_place_of;
        std::size_t scratch_bytes;
        const SelfCollision& of;
        const ContactMesh* mesh;
    };
    /// What all cloths take of that memory, whichever of them are solved together.
    struct RoomTaken {
        std::size_t in_groups = 0,
                    grouped = 0;   ///< bytes of those that may form groups, and how many these are
        std::size_t alone = 0;     ///< of others, whose memory those that come later use again
        std::size_t by_zones = 0;  ///< particles
    };
    [[nodiscard]] RoomTaken room_taken(const Newcomer* newcomer, int threads) const;
    /// Makes what there is too little of. May throw.
    [[nodiscard]] Room make_room(const Newcomer* newcomer, int threads) const;
    void take(Room&& room) noexcept;

    // What a step finds; nothing of it is needed by the next, but for what a budget has learnt.
    std::vector<Cloth*> present;      ///< the cloths that the step takes, in the order of their ids
    std::size_t featured_cloths = 0;  ///< of these
    std::vector<float> still_for;     ///< of each of these, of its group [s]
    std::vector<Bounds> boxes;        ///< likewise, in which groups are looked for
    GroupFinder group_finder;
    Schedule each_cloth, groups;  ///< each cloth for itself; those that may touch together
    std::vector<std::vector<ColliderMotion>> motions;  ///< of colliders, one list for each thread
    std::vector<ColliderId> collider_ids;              ///< by index; only where contacts are reported
    ContactReports contact_reports;
    std::unique_ptr<BodyStage> body_stage;  ///< null: there are no bodies
    ScratchMemory scratch;                  ///< of all cloths, one part for each thread
    std::unique_ptr<ImpactZones> zones;     ///< null: no cloth needs any
    std::size_t zone_particles = 0;         ///< that they have memory for
    Parallel serial{1};
    Allotment allotment;
    Headroom headroom;
    std::int64_t began = 0;  ///< the step, by the clock
    float overhead = 1;      ///< of the step's time over that of its cloths, threads included
};

}  // namespace weft
