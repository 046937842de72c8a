#pragma once
// What a World holds, and the frame: how all of it advances by one step.

#include <chrono>
#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

#include "cloth/frame/advance/schedule.h"
#include "cloth/frame/bodies/body_stage.h"
#include "cloth/frame/budget/allotment.h"
#include "cloth/frame/cloth.h"
#include "cloth/frame/contact/contact_log.h"
#include "cloth/frame/contact/islands.h"
#include "cloth/frame/group.h"
#include "cloth/solvers/stages.h"
#include "collision/colliders/collider_contacts.h"
#include "collision/shapes/held_shape.h"
#include "engine/profiling/profiler.h"
#include "engine/slot_map.h"
#include "engine/threads/parallel_blocks.h"
#include "weft/world.h"

namespace weft {

/// What a thread has to itself while it works on a cloth.
struct Worker {
    Parallel& parallel;                    ///< of all threads, or of this one alone
    std::vector<ColliderMotion>& motions;  ///< one per collider, over the present substep
    ContactLog& contacts;                  ///< to be reported
    std::byte* scratch = nullptr;          ///< of the group that it works on
};

/// One of the equal parts that a step is cut into.
struct Substep {
    int index, count;  ///< of how many in the step
    float h;           ///< [s]

    /// One of `parts` of this one.
    [[nodiscard]] Substep part(int k, int parts, float step) const {
        const int of_all = count * parts;
        return {index * parts + k, of_all, step / static_cast<float>(of_all)};
    }
    /// So many times as long.
    [[nodiscard]] Substep times(float longer) const { return {index, count, longer * h}; }
    [[nodiscard]] bool is_first() const { return index == 0; }
    [[nodiscard]] bool is_last() const { return index + 1 == count; }
    /// Where it begins and ends, as parts of the step.
    [[nodiscard]] float begin() const { return static_cast<float>(index) / static_cast<float>(count); }
    [[nodiscard]] float end() const { return static_cast<float>(index + 1) / static_cast<float>(count); }
};

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
    /// The frame. Precondition: dt is in [least_step, greatest_step].
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
    [[nodiscard]] std::span<const Contact> contacts() const noexcept { return contact_reports_.list(); }
    void clear_contacts() noexcept { contact_reports_.clear(); }

    /// Takes validated settings of a cloth over.
    void apply(Cloth& cloth, const ClothSettings& changed);
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
        return bodies_ ? std::span<const BodyImpulse>(bodies_->impulses) : std::span<const BodyImpulse>();
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
    [[nodiscard]] std::size_t bytes_to_spare() const noexcept;

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

  private:
    using Motions = std::vector<std::vector<ColliderMotion>>;
    [[nodiscard]] static Motions make_motions(int threads, std::size_t colliders);

    /// Makes room for one cloth more, so that no step needs to.
    void reserve_cloth();
    /// Memory that the steps of all cloths share.
    struct Room {
        ScratchMemory scratch;  ///< none: there is enough
        std::unique_ptr<ImpactZones> zones;
        std::size_t zone_particles = 0;
    };
    /// Makes what there is too little of when a cloth comes, or changes, with these settings and this mesh of
    /// features. May throw.
    [[nodiscard]] Room make_room(const Cloth* changed, const SelfCollision& of,
                                 const ContactMesh* mesh) const;
    void take(Room&& room) noexcept;
    void begin(float dt);
    void choose_present(float dt);
    void wake_disturbed(bool is_gusty);
    void find_disturbed(float dt);
    void choose_details();
    void choose_rungs();
    void choose_rates();
    void spread_long_steps();
    void begin_stride(Worker& worker, Cloth& cloth);
    void glide(Worker& worker, Cloth& cloth);
    [[nodiscard]] bool can_stride(const Cloth& cloth) const;
    void learn_costs();
    void reserve_budget(std::size_t count);
    void sleep_and_wake(float dt);
    static void count_still_time(Cloth& cloth, float dt);
    void step_together(float dt);
    void step_each(float dt);
    void expect(Cloth& cloth, float h) const;
    void meet();
    bool pass_ways_on();
    [[nodiscard]] Bounds own_space(const Cloth& cloth) const;
    template <class Work>
    void for_each_group(const Schedule& schedule, const Work& work);
    static void share_out_time(const Schedule::Group& group, std::int64_t nanoseconds);
    template <class Work>
    void for_each_cloth(const Work& work);

    void move_pins(Cloth& cloth, float dt) const;
    void plan_carries(float dt);
    void see_colliders(Worker& worker, std::span<Cloth* const> set, const Substep& substep) const;
    void fill_motions(std::vector<ColliderMotion>& motions, std::uint32_t mask, const Substep& substep,
                      const Carried* carried) const;
    /// Then those that bodies carry, which move with them.
    void add_carried_motions(std::vector<ColliderMotion>& motions, std::uint32_t mask,
                             const Substep& substep) const;
    [[nodiscard]] static std::vector<ColliderMotion>& colliders_of(const Worker& worker, Cloth& cloth) {
        return cloth.carried ? cloth.seen_colliders : worker.motions;
    }
    void hold_worn(Worker& worker, Cloth& cloth);
    void end_worn(Worker& worker, Cloth& cloth);
    void predict(Worker& worker, Cloth& cloth, float dt, const Substep& substep);
    void solve(Worker& worker, std::span<Cloth* const> cloths, float dt, const Substep& substep);
    [[nodiscard]] int parts_of(Worker& worker, std::span<Cloth* const> cloths, const Substep& substep);
    void solve_part(Worker& worker, Group& group, Scratch scratch, std::span<Cloth* const> cloths,
                    const Substep& part);
    /// The places among a group's cloths where its sets of one and its set of first order end.
    struct SetEnds {
        std::size_t alone, first_order;
    };
    [[nodiscard]] SetEnds order_by_sets(Group& group, std::span<Cloth* const> cloths, float h) const;
    void solve_set(Worker& worker, Group& group, std::span<Cloth* const> set, const Substep& part);
    void make_equations(Worker& worker, Group& group, std::span<Cloth* const> set, const Substep& part,
                        float gamma);
    void settle(Worker& worker, Cloth& cloth, const Substep& part);
    void find_features(Worker& worker, FeatureContact& space, std::span<Cloth* const> cloths, float h);
    /// By its pins, its skin or its frame.
    [[nodiscard]] static bool is_moved_by_host(const Cloth& cloth);
    void settle_features(Worker& worker, FeatureContact& space, std::span<Cloth* const> cloths,
                         const Substep& substep);
    void keep_in_own_space(Worker& worker, FeatureContact& space, std::span<Cloth* const> cloths) const;
    [[nodiscard]] bool is_taken_out_of_own_space(Worker& worker, FeatureContact& space, std::size_t body,
                                                 const Cloth& cloth) const;
    void guard(Worker& worker, Cloth& cloth);
    void finish(Worker& worker, Cloth& cloth);

    [[nodiscard]] bool is_near_bodies(const Cloth& cloth, float dt) const;
    [[nodiscard]] std::size_t number_of(BodyId id) const;
    void prepare_for_bodies(Cloth& cloth) const;
    void begin_bodies(const Substep& substep);
    void limit_bodies();
    void load_bodies();
    template <class Visit>
    void for_each_body_near(const Cloth& cloth, float h, const Visit& visit) const;
    void find_cloths_of_bodies(float h);
    void take_bodies(std::span<Cloth* const> cloths, float h);
    void start_part_of_bodies(std::span<Cloth* const> cloths, float h, float gamma);
    void carry_bodies(Cloth& cloth, StepEquation& equation);
    void collect_from_equation(Cloth& cloth, const StepEquation& equation);
    void collect_change(Cloth& cloth, std::uint32_t body, std::uint32_t particle, const Vector3& change);
    [[nodiscard]] std::uint32_t collide_with_bodies(Worker& worker, Cloth& cloth, float h,
                                                    std::span<const Vec4> starts);
    void place_attached(std::span<Cloth* const> cloths);
    void join_attached(std::span<Cloth* const> cloths, std::uint32_t number);
    void finish_part_of_bodies(std::span<Cloth* const> cloths);
    void end_part_of_bodies(std::span<Cloth* const> cloths);
    void leave_bodies(std::span<Cloth* const> cloths);
    void end_bodies(const Substep& substep);
    void feel_wind(Worker& worker, Cloth& cloth);
    void air_forces(Worker& worker, Cloth& cloth, bool has_moved);
    [[nodiscard]] StepEquation equation_of(Worker& worker, Cloth& cloth, float h, const Bdf& bdf);
    [[nodiscard]] bool is_residual_due(const Cloth& cloth) const;
    static void take_result(Worker& worker, Cloth& cloth, const StepEquation& equation,
                            const SolveResult& result, bool has_residual);
    void advance(Worker& worker, Cloth& cloth, const StepEquation& equation, bool is_first);
    void bounce(Worker& worker, Cloth& cloth, const StepEquation& equation) const;
    [[nodiscard]] int parts_to_meet(Worker& worker, Cloth& cloth, const Substep& substep);
    static void keep_part_start(Worker& worker, Cloth& cloth);
    void hold_within_limits(Worker& worker, Cloth& cloth);
    void avoid_self_collision(Worker& worker, Cloth& cloth, float h);
    void collide_with_colliders(Worker& worker, Cloth& cloth, const Substep& part);
    /// Over a substep of that length; `starts`: as weft::collide() has them. Returns the particles that
    /// touch.
    [[nodiscard]] std::uint32_t collide(Worker& worker, Cloth& cloth, float h, std::span<const Vec4> starts);
    void hand_back(Worker& worker, const FeatureContact& space, std::size_t body, Cloth& cloth, float h);
    void keep_common_motion_out(Worker& worker, FeatureContact& space, std::span<Cloth* const> cloths,
                                float h) const;
    [[nodiscard]] static bool is_taken_into_colliders(Worker& worker, const FeatureContact& space,
                                                      std::size_t body, Cloth& cloth, float h);
    void keep_out_of_colliders(Worker& worker, Cloth& cloth, float h);
    [[nodiscard]] static std::span<const ColliderMotion> colliders_in_equation(const Worker& worker,
                                                                               Cloth& cloth);
    /// Begins the cloth's contacts in an equation, if it has any.
    static void begin_contacts(const Worker& worker, Cloth& cloth, const Substep& part);
    void reserve_collider_ids(bool reported);
    static void update_normals(Parallel& loops, Cloth& cloth);
    void add_to_report(const ClothReport& cloth);

    static void log_contact(ContactLog& log, Cloth& cloth, const Contact& contact);
    static void add_impulse(Cloth& cloth, std::uint32_t particle, const Vector3& impulse);
    static void add_impulses_of_equation(Worker& worker, Cloth& cloth, const StepEquation& equation);
    static void add_impulses_of_change(Worker& worker, Cloth& cloth, std::span<const Vec4> before);
    static void find_missing_impulses(const SolverStep& step, Cloth& cloth);
    static void share_out_impulses(FeatureContact& space, std::span<Cloth* const> cloths);
    static void log_pairs(Worker& worker, FeatureContact& space, std::span<Cloth* const> cloths);
    static void log_avoidance(Worker& worker, Cloth& cloth, float h);
    void find_touched_colliders(Worker& worker, Cloth& cloth) const;
    void log_colliders(Cloth& cloth);
    void log_trigger(Cloth& cloth, ColliderId id, const Collider& trigger);
    void log_triggers(Cloth& cloth);
    /// What comes slower does not bounce [m/s].
    [[nodiscard]] float least_bounce(float h) const;
    [[nodiscard]] ClothSide side_of_cloth(const Cloth& cloth, float h) const;
    void report_contacts();
    void end(float dt);

    [[nodiscard]] bool reports_contacts() const { return settings.contact_reports > 0; }
    [[nodiscard]] bool air_is_on() const { return settings.wind.air_density > 0; }
    [[nodiscard]] auto timed(Stage stage) { return profiler.time(static_cast<std::uint32_t>(stage)); }

    Parallel serial_{1};
    std::vector<Cloth*> present_;   // the cloths that a step takes, in the order of their ids
    std::vector<float> still_for_;  // of each of these, of its island
    Schedule each_, islands_;       // each cloth for itself; those that may touch together
    std::vector<Bounds> boxes_;
    Islands finder_;
    Motions motions_;  // one list for each thread
    ContactReports contact_reports_;
    Allotment allotment_;
    Headroom headroom_;
    std::int64_t began_ = 0;                // the present step, by the clock
    float overhead_ = 1;                    // of the step's time over that of its cloths, threads included
    std::unique_ptr<BodyStage> bodies_;     // null: there are none
    std::vector<ColliderId> collider_ids_;  // of a step, by index; only where contacts are reported

    std::size_t featured_cloths_ = 0;     // that the step takes
    ScratchMemory scratch_;               // of all cloths, group by group
    std::unique_ptr<ImpactZones> zones_;  // null: no cloth needs any
    std::size_t zone_particles_ = 0;      // that they have memory for
};

}  // namespace weft
