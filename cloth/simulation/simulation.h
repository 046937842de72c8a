#pragma once
// The data of a World, and the calls that change it between steps.

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
#include "cloth/simulation/garment.h"
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

/// Treatment of pins that the host has not moved, when their cloth is teleported to what holds it: they keep
/// their targets and hold it back, or go along.
enum class StillPins : std::uint8_t { stay, go_along };

/// Settings are validated before they get here. Calls that can run out of memory change nothing then.
struct Simulation {
    explicit Simulation(const WorldSettings& settings);
    void apply(const WorldSettings& settings);

    /// Allocates what so many colliders need, or frees it where there are neither colliders nor bodies.
    void expect_colliders(std::size_t count);
    /// Adds a cloth, and reserves the memory that steps need for it.
    ClothId add(std::unique_ptr<Cloth>&& cloth);
    /// Replaces a cloth by `next`, under the same id.
    void replace(ClothId id, std::unique_ptr<Cloth>&& next);
    /// Gives a new cloth its bounds, its normals and what it needs of air and colliders, so that it can be
    /// drawn before its first step.
    void prepare(Cloth& cloth);
    /// Updates what follows from a cloth's state, after it was restored: see Cloth::commit_restore.
    void state_has_changed(Cloth& cloth);

    /// Takes a step: see step.cpp. Precondition: dt is in [least_step, greatest_step].
    void step(float dt);

    WorldSettings settings;
    Parallel parallel;
    Profiler profiler;
    SlotMap<ClothId, std::unique_ptr<Cloth>> cloths{new_first_generation()};
    /// Views that World::cloth last returned, by index of ids, and one more; emptied when a cloth is removed.
    std::vector<std::unique_ptr<ClothView>> views;
    /// Rows of the seams of `state`, by index of ids; null for those that were removed.
    std::vector<std::unique_ptr<SeamRows>> seam_rows;
    std::vector<Garment> garments;  ///< in the order of `state.levels`
    WorldState state{SlotMap<ColliderId, ColliderSlot>(new_first_generation())};
    /// Shapes that colliders are instances of. Only calls of the host change them.
    SlotMap<ShapeId, std::unique_ptr<HeldShape>> shapes{new_first_generation()};
    StepReport report;

    /// The shape that a collider is an instance of; null: it is no instance, or the shape was removed.
    [[nodiscard]] const HeldShape* held_by(const Collider& collider) const noexcept;
    /// Report of the last step; without results for a cloth that it did not take.
    [[nodiscard]] ClothReport report_of(const Cloth& cloth) const;
    /// Contacts of the last step.
    [[nodiscard]] std::span<const Contact> contacts() const noexcept { return contact_reports.list(); }
    void clear_contacts() noexcept { contact_reports.clear(); }

    /// Applies validated settings of a cloth.
    void apply(Cloth& cloth, const ClothSettings& changed);
    void set_map(Cloth& cloth, Map map, AlignedBuffer<float>&& values);
    /// Sets the target of a cloth's frame. A first frame begins there, and reserves the cloth's own list of
    /// collider motions.
    void set_frame(Cloth& cloth, const Transform& pose);
    /// Teleports a cloth. Precondition: it stays within reach.
    void move(Cloth& cloth, const RigidMotion& by);
    /// Updates what follows from a cloth's positions, after a teleport.
    void has_been_moved(Cloth& cloth);
    /// The rigid motion that brings a cloth to what holds it: pins, bodies, and the skin that limits are
    /// measured from. None if it is there already. Error: a vertex would be out of reach.
    [[nodiscard]] Result<std::optional<RigidMotion>> motion_to_holds(Cloth& cloth, const SkinState& skin,
                                                                     StillPins pins);
    /// Teleports a cloth by that motion, then each held particle to its place.
    void go_to_holds(Cloth& cloth, const RigidMotion& by, StillPins pins);
    /// Puts a cloth at rest into a pose given by the mesh's vertices, with its pins, or all but those. The
    /// pose is within reach.
    void reset(Cloth& cloth, std::span<const Vec3> positions, StillPins pins = StillPins::go_along);
    /// The same in motion: with places at the start of the last step, and velocities, of the mesh's vertices.
    void resume(Cloth& cloth, std::span<const Vec3> positions, std::span<const Vec3> previous_positions,
                std::span<const Vec3> velocities, StillPins pins = StillPins::go_along);
    void shift_origin(const Vec3& to);
    /// Frees the memory that cloths share, if the last one was removed.
    void cloth_has_gone() noexcept;

    /// Adds a seam, whose cloths exist and can join. See seams.cpp.
    SeamId add_seam(SeamState&& seam);
    /// Precondition: the seams exist. A call that runs out of memory removes none.
    void remove_seams(std::span<const SeamId> seams);
    /// Wakes the cloths that seams join to a cloth.
    void wake_joined(const Cloth& cloth) noexcept;
    [[nodiscard]] SeamInfo info_of(SeamId id) const;

    // Garments of several meshes. See garments.cpp.
    /// Adds a cloth as the coarsest level, switched off. Precondition: it can be one. Error: its vertices are
    /// out of the other level's reach, or the other way round.
    [[nodiscard]] Result<void> add_level(ClothId finest, ClothId coarser, float reach);
    /// Takes a cloth, and all coarser ones, out of its garment, if it is in one.
    void drop_level(Cloth& cloth) noexcept;
    /// Has another level of a garment take over from the present one.
    void set_level(Garment& garment, std::uint32_t level, std::uint32_t rung);
    /// Has the next finer level take over from a cloth that is stepped, if there is one.
    void refine_from(const Cloth& cloth);
    /// Has levels take over by the budget's choices of this step, after it.
    void take_chosen_levels();
    /// Switches on the levels of a restored state in place of others.
    void enable_restored_levels() noexcept;

    BodyId add_body(const BodySlot& slot);
    void remove_body(BodyId id);
    /// Moves attached colliders to the poses of their bodies.
    void place_carried_colliders() noexcept;
    [[nodiscard]] std::span<const BodyImpulse> body_impulses() const noexcept {
        return body_stage ? std::span<const BodyImpulse>(body_stage->impulses)
                          : std::span<const BodyImpulse>();
    }
    void clear_body_impulses() noexcept;

    // The budget.
    std::vector<RungOfCloth> choices;  ///< rungs that the last step changed
    bool has_given_choices = false;    ///< a replay sets the rungs, and steps choose none
    /// The clock that measures costs [ns].
    std::int64_t (*clock)() noexcept = steady_nanoseconds;
    /// Cost of a cloth in the step, in place of the clock, for tests that need known times [ns].
    std::int64_t (*cost_of)(const Cloth& cloth) = nullptr;

    /// Bytes of shared memory that no cloth counts as its own.
    [[nodiscard]] std::size_t bytes_to_spare() const;
    /// Bytes of the memory that all cloths share.
    [[nodiscard]] std::size_t common_bytes() const noexcept {
        return scratch.bytes() + (zones ? zones->bytes() : 0);
    }

    /// Wakes all cloths; those near a collider; those that may touch a cloth. A cloth that is awake stays so
    /// for a while.
    void wake_all() noexcept;
    void wake_near(const Collider& collider) noexcept;
    void wake_near(const Cloth& gone) noexcept;
    /// wake_near() of a cloth in two calls, around a change of that cloth that may fail.
    void mark_near(const Cloth& changing) noexcept;
    void wake_marked() noexcept;

    /// The air's velocities at points [m/s]; both spans are padded to whole groups of 16.
    void find_air(Parallel& threads, std::span<const Vec4> points, std::span<Vec4> velocities) const;

    [[nodiscard]] bool reports_contacts() const { return settings.contact_reports > 0; }
    /// Gravity as it acts on a cloth [m/s^2].
    [[nodiscard]] Vector3 gravity_on(const Cloth& cloth) const {
        return cloth.settings.gravity_scale * to_vector(settings.gravity);
    }
    [[nodiscard]] bool air_is_on() const { return settings.wind.air_density > 0; }
    [[nodiscard]] auto timed(Stage stage) { return profiler.time(static_cast<std::uint32_t>(stage)); }
    static void update_normals(Parallel& loops, Cloth& cloth);
    /// A body's place in the order of ids.
    [[nodiscard]] std::size_t number_of(BodyId id) const;
    void prepare_for_bodies(Cloth& cloth) const;

    /// Memory that the steps of all cloths share.
    struct Room {
        ScratchMemory scratch;  ///< empty: the present scratch is large enough
        std::unique_ptr<ImpactZones> zones;
        std::size_t zone_particles = 0;
    };
    /// A cloth that is added, or replaces another, with its scratch and its mesh of features.
    struct Newcomer {
        const Cloth* in_place_of;
        std::size_t scratch_bytes;
        const SelfCollision& of;
        const ContactMesh* mesh;
        bool is_joined = false;  ///< has seams
    };
    using Newcomers = std::span<const Newcomer>;
    /// The memory that all cloths need, whichever of them are solved together.
    struct RoomTaken {
        std::size_t in_groups = 0,
                    grouped = 0;   ///< bytes and number of the cloths that may form groups
        std::size_t alone = 0;     ///< bytes of the others, one cloth a thread at a time
        std::size_t by_zones = 0;  ///< particles of cloths by zones
    };
    [[nodiscard]] RoomTaken room_taken(Newcomers newcomers, int threads) const;
    /// Allocates what is too small at present. May throw.
    [[nodiscard]] Room make_room(Newcomers newcomers, int threads) const;
    void take(Room&& room) noexcept;

    // Working data of a step. The next step needs none of it, except what the budget has learnt.
    std::vector<Cloth*> present;      ///< the cloths that the step takes, in the order of their ids
    std::size_t featured_cloths = 0;  ///< number of present cloths that have features
    std::vector<float> still_for;     ///< least time of stillness in a group, at its first cloth [s]
    std::vector<Bounds> boxes;        ///< of present cloths, for the search for groups
    GroupFinder group_finder;
    Schedule each_cloth, groups;  ///< each cloth for itself; those that may touch together
    std::vector<std::vector<ColliderMotion>> motions;  ///< of colliders, one list for each thread
    std::vector<ColliderId> collider_ids;              ///< by index; only where contacts are reported
    ContactReports contact_reports;
    std::unique_ptr<BodyStage> body_stage;  ///< null: there are no bodies
    ScratchMemory scratch;                  ///< of all cloths, one part for each thread
    std::unique_ptr<ImpactZones> zones;     ///< null: no cloth needs any
    std::size_t zone_particles = 0;         ///< particles that the zones have memory for
    Parallel serial{1};
    Allotment allotment;
    Headroom headroom;
    std::int64_t began = 0;  ///< time at which the step began, by the clock [ns]
    float overhead = 1;      ///< ratio of the step's time to the sum of its cloths' times
};

}  // namespace weft
