#pragma once
// A cloth in a World: its rest model, its state, and the memory that its steps need. Calls of the host
// allocate and free that memory; no step does.

#include <cstddef>
#include <cstdint>
#include <functional>
#include <limits>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "cloth/air/surface.h"
#include "cloth/budget/budgeted.h"
#include "cloth/contact/feature_contact.h"
#include "cloth/equation/contacts.h"
#include "cloth/equation/filling_row.h"
#include "cloth/instance/cloth_side_buffers.h"
#include "cloth/limits/limit.h"
#include "cloth/limits/worn_limits.h"
#include "cloth/mesh/cook.h"
#include "cloth/motion/history.h"
#include "cloth/motion/moving_frame.h"
#include "cloth/motion/rigid_motion.h"
#include "cloth/motion/survey.h"
#include "cloth/solver/solver.h"
#include "cloth/state/state.h"
#include "collision/particles/rest_neighbours.h"
#include "collision/particles/self_contacts.h"
#include "collision/thin/whole_triangles.h"
#include "engine/memory/aligned_buffer.h"
#include "weft/cloth_id.h"
#include "weft/settings.h"
#include "weft/world.h"

namespace weft {

struct SavedCloth;

/// Buffers for the air at the particles.
struct AirBuffers {
    AlignedBuffer<Vec4> forces;      ///< see ExternalForces; empty without air
    AlignedBuffer<Vec4> velocities;  ///< of the gusty air [m/s]; empty without gusts
};

/// The particle of a block that is deepest in a trigger.
struct DeepestInTrigger {
    float gap = std::numeric_limits<float>::infinity();  ///< distance less thickness; below 0: inside [m]
    std::uint32_t particle = 0;
};

/// Buffers for reported contacts; see the members of Cloth that take them.
struct ImpulseBuffers {
    AlignedBuffer<Vec4> of_colliders, missing;
    AlignedBuffer<DeepestInTrigger> in_triggers;
};

/// Buffers for colliders and features in the equation of an implicit solver.
struct ContactBuffers {
    ContactBuffers(std::uint32_t particles, bool with_pairs)
        : contacts(particles, with_pairs), held(particles) {}

    Contacts contacts;
    HeldContacts held;
};

/// Buffers for colliders within a step.
struct ColliderBuffers {
    AlignedBuffer<Vec4> part_start;
    std::optional<WholeTriangles> whole;
};

/// Impulse and angular impulse from a cloth to a body in a substep, and in its present part [N s, N m s].
struct CollectedShare {
    Vector6 in_part = Vector6::Zero(), sum = Vector6::Zero();
    Vector6 by_stops = Vector6::Zero();  ///< share of in_part that BDF2 must not repeat
    bool is_known = false;               ///< in_part is final: the cloth has been solved in this part
};

/// Buffers for features in contact.
struct FeatureBuffers {
    /// `made`: a mesh of features if the cloth has none, else null.
    FeatureBuffers(std::shared_ptr<const ContactMesh>&& made, std::uint32_t particles)
        : mesh(std::move(made)), tangles(particles) {}

    std::shared_ptr<const ContactMesh> mesh;
    AlignedBuffer<TangleMemory> tangles;
};

/// The seams of a cloth, and what they need.
struct SeamBuffers {
    std::vector<SeamRows*> seams;
    std::optional<ContactBuffers> contacts;
    std::size_t scratch_bytes = 0;
};

/// Predicted motion of a cloth with features in a substep.
struct ExpectedWay {
    Bounds box{};        ///< swept range of its particles, enlarged by the contact radius
    float length = 0;    ///< path of its fastest particle, colliders' push included [m]
    float longest = 0;   ///< greatest length in its group, if it is the first of several cloths [m]
    float grown_by = 0;  ///< margin by which the box has grown for motion that others pass on [m]
};

/// Copies of the buffers that a host reads, for the time in which a step that was begun overwrites them.
struct ShownCloth {
    explicit ShownCloth(std::uint32_t particles)
        : positions(particles), previous_positions(particles), velocities(particles), normals(particles) {}
    AlignedBuffer<Vec4> positions, previous_positions, velocities, normals;
    Bounds bounds;

    [[nodiscard]] std::size_t bytes() const noexcept { return 4 * positions.bytes(); }
};

/// Whether a cloth with these settings has features in contact.
[[nodiscard]] inline bool has_features(const SelfCollision& settings) {
    return meets_cloth(settings.method);
}
/// How avoidance searches; nothing by other methods.
[[nodiscard]] inline std::optional<SelfCollisionSearch> search_of(SelfCollisionMethod method) {
    switch (method) {
        case SelfCollisionMethod::avoidance:
            return SelfCollisionSearch::exact;
        case SelfCollisionMethod::avoidance_by_shifted_grids:
            return SelfCollisionSearch::shifted_grids;
        case SelfCollisionMethod::avoidance_by_sorted_sweep:
            return SelfCollisionSearch::sorted_sweep;
        default:
            return std::nullopt;
    }
}
/// Whether impact zones resolve these features, which then are not in the equation.
[[nodiscard]] inline bool has_zones(const SelfCollision& settings) {
    return settings.method == SelfCollisionMethod::impact_zones;
}

/// Whether colliders are in the equation, provided that the solver is implicit.
[[nodiscard]] inline bool meets_in_equation(const ClothSettings& settings) {
    return settings.collider_response == ColliderResponse::contact && settings.collider_mask != 0;
}

/// Error: too much of the cloth is within SelfCollision::distance along it. Does nothing in builds with
/// exceptions, in which apply() throws that error.
[[nodiscard]] Result<void> validate_neighbours(const ClothModel& model, const ClothSettings& settings);
/// Error: the mesh is not closed, is wound inwards, or encloses nothing that a filling could go by.
[[nodiscard]] Result<void> validate_filling(const ClothModel& model, const ClothSettings& settings);

/// Changes that may run out of memory come in two parts: make_...() allocates, take_...() stores the result
/// and cannot fail. apply(), pin() and unpin() do both: if they throw, nothing has changed.
struct Cloth {
    Cloth(ClothModel cooked, const ClothSettings& settings, const Progress& progress = {});
    /// From a cooked file. A prototype, only to be copied: most of its state has no memory.
    Cloth(ClothModel cooked, const ClothSettings& settings, SavedCloth&& saved);
    /// A copy in the same state, which shares the constant data. Precondition: `cooked` is in no World, and
    /// does not change from now on.
    Cloth(const Cloth& cooked);

    /// Callback with the bytes of scratch that steps will take, before anything has changed. It may throw;
    /// empty: the cloth is in no World.
    using MakeRoom = std::function<void(std::size_t bytes)>;
    /// Applies validated settings.
    void apply(const ClothSettings& changed, const MakeRoom& make_room = {});
    /// Pins particles where they are. Particles that are pinned already keep their targets.
    void pin(std::span<const std::uint32_t> particles);
    void pin(std::uint32_t particle) { pin(std::span(&particle, 1)); }
    /// Unpins particles; free ones stay free.
    void unpin(std::span<const std::uint32_t> particles);
    void unpin(std::uint32_t particle) { unpin(std::span(&particle, 1)); }
    /// Attaches particles to a body, at their present places relative to it.
    void attach(BodyId body, const BodyPose& pose, std::span<const std::uint32_t> particles);
    void detach(std::span<const std::uint32_t> particles);
    /// Moves pinned particles to their targets, at the end of a step.
    void place_pins() noexcept {
        for (const Pin& pin : state.pins) set_xyz(state.positions[pin.particle], pin.target);
    }
    /// Pins these particles, ascending, and no others.
    void pin_only(std::span<const std::uint32_t> particles);
    /// Null if the particle is not pinned.
    [[nodiscard]] Pin* find_pin(std::uint32_t particle);

    /// Empty if no contacts are reported.
    [[nodiscard]] ImpulseBuffers make_impulses(bool reported) const;
    void take_impulses(ImpulseBuffers&& made) noexcept {
        collider_impulses = std::move(made.of_colliders);
        missing_impulses = std::move(made.missing);
        in_triggers = std::move(made.in_triggers);
    }

    [[nodiscard]] AirBuffers make_air(bool on, bool air_varies) const;
    void take_air(AirBuffers&& made) noexcept { air = std::move(made); }
    /// None if the cloth needs no such buffers, or has them already.
    [[nodiscard]] std::optional<ContactBuffers> make_contacts(bool any_colliders) const {
        return make_contacts(any_colliders, settings, *solver);
    }
    void take_contacts(std::optional<ContactBuffers>&& made, bool any_colliders) noexcept;
    /// Empty without colliders.
    [[nodiscard]] ColliderBuffers make_collider_buffers(bool any_colliders) const;
    void take_collider_buffers(ColliderBuffers&& made) noexcept {
        part_start = std::move(made.part_start);
        whole = std::move(made.whole);
    }

    /// Whether these settings need other levels: another system, other springs, or room for contact.
    [[nodiscard]] bool has_other_levels(const ClothSettings& changed) const {
        return !solver->serves(changed) || changed.fabric.bending_ratio != settings.fabric.bending_ratio ||
               weft::has_features(changed.self_collision) != has_features();
    }
    /// The buffers for these seams in place of its own, in the order of ids. Precondition: can_join().
    [[nodiscard]] SeamBuffers make_seams(std::vector<SeamRows*>&& list);
    void take_seams(SeamBuffers&& made) noexcept;
    void drop_seam(const SeamRows* gone) noexcept;
    /// Whether its method and its contact allow it in an equation with other cloths.
    [[nodiscard]] bool can_join() const noexcept {
        return solver->joins() && !has_zones(settings.self_collision);
    }

    /// Make this cloth the successor of another, `sources` naming for each particle its source there. First
    /// take_maps() copies the maps, since a World prepares for what they change; after that go_on_from()
    /// copies the state. Either may run out of memory; the cloth is then of no use.
    void take_maps(const Cloth& before, std::span<const std::uint32_t> sources);
    void go_on_from(const Cloth& before, std::span<const std::uint32_t> sources, std::size_t colliders);

    /// Allocates what the pins of a saved state need, before that state overwrites the cloth's own. May run
    /// out of memory; then nothing has changed.
    void prepare_restore(std::span<const Pin> pins);
    /// Updates what follows from the state, after it was overwritten.
    void commit_restore();
    /// Erases what contact with colliders, bodies and cloth has left in the state.
    void erase_contact_memory() noexcept;
    /// Returns the cloth to the start of the step, at rest.
    void restore_start_of_step();

    void set_enabled(bool on) noexcept;
    [[nodiscard]] bool is_asleep() const noexcept;
    [[nodiscard]] float still_for() const noexcept;  ///< [s]
    void wake() noexcept;                            ///< a cloth that is awake stays so for a while
    void fall_asleep() noexcept;
    /// Clears velocities, and ends the renderer's blend at the present positions.
    void stand_still() noexcept;
    /// The cloth's surface for colliders. Its spans are of buffers that change with settings and maps.
    [[nodiscard]] ClothSide side(float least_bounce = 0) const noexcept {
        return {.thickness = side_buffers.thickness.span(),
                .friction = side_buffers.friction.span(),
                .most_thickness = settings.thickness,
                .restitution = settings.restitution,
                .mask = settings.collider_mask,
                .least_bounce = least_bounce,
                .masks = side_buffers.masks.span(),
                .normals = settings.back_friction_ratio == 1 ? std::span<const Vec4>() : state.normals.span(),
                .back_friction = settings.back_friction_ratio};
    }
    /// Sets a checked map; empty values remove it. See instance/maps.cpp.
    void set_map(Map map, AlignedBuffer<float>&& values, const MakeRoom& make_room = {});

    /// Mass of a free particle [kg]; 0 for loose ones.
    [[nodiscard]] float mass(std::uint32_t particle) const {
        return settings.fabric.areal_density * model.rest_area[particle];
    }
    /// Least distance between particles that self-collision is to keep [m].
    [[nodiscard]] float distance_of(const SelfCollision& self_collision) const;
    /// Counts of the mesh, mass and memory.
    [[nodiscard]] ClothInfo info() const;
    /// Whether the cloth meets itself and others by features.
    [[nodiscard]] bool has_features() const noexcept { return state.tangles.size() > 0; }
    /// Bytes that its steps take of the World's memory for impact zones.
    [[nodiscard]] std::size_t zone_bytes() const noexcept;
    /// The cloth as a body in contact. Precondition: it has features.
    [[nodiscard]] ContactCloth as_body() const;
    /// Makes the mesh of its features, if it has none.
    void make_contact_mesh();
    /// Frees that mesh, unless it is in use.
    void drop_contact_mesh() noexcept;

    ClothId id{};  ///< in its World; set by its first step
    /// The garment in whose meshes it is, and its number there: see simulation/garment.h.
    std::uint32_t garment = ~0u, level = 0;
    ClothModel model;
    ClothSettings settings;
    ClothState state;
    std::unique_ptr<Solver> solver;  ///< for the present settings and pins
    /// Scratch of a part of a substep [m/s]: the solved velocities, w 0; once the cloth has moved, its
    /// velocities before a stage whose impulses are reported.
    AlignedBuffer<Vec4> scratch_velocities;
    std::optional<History> history;  ///< only with BDF2
    /// Lays out the scratch arrays of a substep, except those of features.
    void lay_out(Scratch& scratch);
    /// Replaces the solver of its settings, for studies. Precondition: the cloth is in no World.
    void take_solver(std::unique_ptr<Solver>&& made);
    WornLimits worn;  ///< leashes and backstops
    ClothSideBuffers side_buffers;
    float bending_per_area = 0;                     ///< see find_bending_per_area() [1/m^4]
    AlignedBuffer<float> areas_without_map;         ///< rest areas before the mass map; empty without map
    Limits limits;                                  ///< attached to the present pins
    std::optional<SelfContacts> self_contacts;      ///< only with avoidance
    std::optional<RestNeighbours> rest_neighbours;  ///< only with self-collision on
    std::optional<Contacts> contacts;  ///< only of implicit solvers, with colliders, worn limits or features
    std::shared_ptr<const ContactMesh> contact_mesh;
    bool shares_contact_mesh = false;   ///< the mesh is the CookedCloth's
    ExpectedWay expected;               ///< only with features: motion in the present substep
    std::optional<FillingRow> filling;  ///< only of a cloth that has one
    /// Volume and pressure now.
    [[nodiscard]] FillingInfo filling_info() const;
    std::vector<SeamRows*> seams;            ///< by id; the World owns them
    CommonLevels sewn;                       ///< null, unless it has seams
    std::uint32_t place = 0;                 ///< among the cloths that the step takes; see join_seams()
    const StepEquation* equation = nullptr;  ///< while its set is solved
    std::uint32_t group = 0;        ///< in the present substep: place of the group's first cloth in the step
    std::size_t scratch_bytes = 0;  ///< bytes that its steps take of the World's scratch

    Surface surface;
    AirBuffers air;
    std::vector<Attachment> attached;  ///< ascending
    BodyBuffers body_buffers;          ///< empty without bodies
    /// Label, in a part's solve, of the free cloths and bodies that it moves together with.
    std::size_t free_with = 0;
    std::vector<CollectedShare> collected;  ///< one per body; empty without bodies
    bool meets_bodies = false;              ///< whether it may meet bodies in the present substep
    AlignedBuffer<Vec4> part_start;         ///< positions at the start of a step's part, except the first
    std::optional<WholeTriangles> whole;    ///< only with colliders
    /// Colliders' impulse per particle in this step [N s], 0 before it; only where contacts are reported.
    AlignedBuffer<Vec4> collider_impulses;
    /// Contact impulse per particle that no pair or collider has been credited with yet [N s]; w the impulse
    /// that was credited to colliders, along their normals [N s].
    AlignedBuffer<Vec4> missing_impulses;
    AlignedBuffer<DeepestInTrigger> in_triggers;  ///< by block; only where contacts are reported
    /// Ratio of a substep's impulse to that in its equation, while missing_impulses are to be credited; else
    /// 0.
    float impulse_ratio = 0;
    AlignedBuffer<std::uint32_t> partial_counts;
    AlignedBuffer<double> partial_sums;
    AlignedBuffer<Survey> partial_surveys;

    /// Transport by its frame before the present step; none without a frame, or at full inertia.
    std::optional<Carried> carried;
    /// Its teleport by its frame before the present step.
    std::optional<RigidMotion> jumped;
    /// Motion of its frame in the present step, by which ClothSettings::max_speed_in_frame is measured.
    ActingMotion acting;
    std::vector<ColliderMotion> seen_colliders;  ///< colliders' motions relative to the transported cloth
    /// Whether seen_colliders are its colliders in the present step.
    [[nodiscard]] bool sees_own_colliders() const noexcept { return carried || jumped; }

    // Results of the present step, kept for the report.
    bool solver_failed = false;           ///< in one of its substeps
    bool unsolved = false;                ///< more was left than its method tolerates, in one of them
    bool restored = false;                ///< guard() returned the cloth to the start of the step
    bool pins_limited = false;            ///< a pin's speed was clamped to WorldSettings::max_speed
    float residual = 0;                   ///< as last measured
    Survey extent{};                      ///< of the state, as last surveyed
    SelfContactCounts self_counts;        ///< of its last substep
    FeatureCounts feature_counts;         ///< of its last substep; only the first cloth of a group has them
    bool is_in_crowd = false;             ///< see FeatureContact::detect(); only of a group's first cloth
    std::uint32_t contact_count = 0;      ///< contacts to be reported
    std::uint32_t collider_contacts = 0;  ///< particles that met a collider in its last substep
    float pin_lag = 0;                    ///< distance of its farthest pin that cloth stopped [m]
    LimitLag limit_lag{};                 ///< of its worn limits, at the end
    bool is_disturbed = false;            ///< see find_disturbed() in stages/sleep.cpp
    bool was_stepped = false;             ///< by the last step; if not, the above is older
    std::int64_t nanoseconds = 0;         ///< time that its threads took for it

    std::unique_ptr<Budgeted> budgeted;  ///< only with a budget
    /// The settings of the present step, which a budget may have reduced.
    [[nodiscard]] const ClothSettings& stepped_settings() const noexcept {
        return budgeted ? budgeted->settings : settings;
    }
    /// Whether it interpolates towards the end of its last, long step, and takes none of its own.
    [[nodiscard]] bool is_gliding() const noexcept { return state.detail && state.detail->left > 0; }
    /// Length of its own step, in steps of the World.
    [[nodiscard]] float stride() const noexcept {
        return state.detail ? static_cast<float>(state.detail->rate) : 1.0f;
    }
    /// Ends the interpolation of a long step where the cloth is.
    void land() noexcept;
    /// Greatest distance of a pinned particle from its target [m].
    [[nodiscard]] float farthest_pin() const noexcept;
    /// Coefficients of its next step, or part of a step, of h seconds.
    [[nodiscard]] Bdf bdf_of(float h, float least_gamma = 0) const {
        return bdf_after(history ? state.record.h : 0, h, least_gamma);
    }
    [[nodiscard]] BudgetBuffers make_budget(bool on) const;
    void take_budget(BudgetBuffers&& made) noexcept;

    std::unique_ptr<ShownCloth> shown;  ///< only where steps are taken by begin_step() and end_step()

  private:
    /// apply() for a model that has these settings' bending ratio already.
    void apply_to_model(const ClothSettings& changed, const MakeRoom& make_room);
    bool has_colliders_ = false;
    std::size_t shared_bytes_ = 0;  ///< bytes shared with all copies of one CookedCloth

    /// Bytes that its steps take of the World's scratch, with these settings and this mesh of features, or
    /// null.
    [[nodiscard]] std::size_t scratch_of_steps(Solver& with, bool second_order, const ClothSettings& of,
                                               const ContactMesh* mesh) const;
    [[nodiscard]] std::optional<FillingRow> make_filling(const Filling& of) const;
    [[nodiscard]] std::size_t own_bytes() const;
    [[nodiscard]] bool is_second_order(const ClothSettings& of, const Solver& with) const;
    [[nodiscard]] std::optional<ContactBuffers> make_contacts(bool any_colliders, const ClothSettings& of,
                                                              const Solver& with) const;
    /// None if the cloth is to have no features, or has them already.
    [[nodiscard]] std::optional<FeatureBuffers> make_features(const SelfCollision& of) const;
    void take_features(std::optional<FeatureBuffers>&& made, const SelfCollision& of) noexcept;
    [[nodiscard]] std::unique_ptr<Solver> solver_for(const ClothSettings& changed) const;
    void reserve_pairs(Solver& with) const;
    /// Whether an equation of these settings has rows of pairs of features, or of stitches.
    [[nodiscard]] bool has_pair_rows(const ClothSettings& of, const Solver& with) const noexcept;
    /// Capacity for the pairs of features and the stitches that are in the equation.
    [[nodiscard]] std::size_t pairs_in_equation(const SelfCollision& of) const noexcept;
    void change_pins(std::vector<Pin>&& pins);
    void start_at_rest();
    void set_inverse_masses();
    void remake_solver(const MakeRoom& make_room);
    void set_masses(AlignedBuffer<float>&& values, const MakeRoom& make_room);
    void set_areas(SharedBuffer<float>&& areas, AlignedBuffer<float>&& without_map,
                   const MakeRoom& make_room);
    void take_areas(const Cloth& before, std::span<const std::uint32_t> sources);
    void take_pins(const Cloth& before, std::span<const std::uint32_t> sources);
    void take_contact(const ClothState& before, std::span<const std::uint32_t> sources);
    void take_rest(const Cloth& before, bool is_split);
    void part_copies(std::span<const std::uint32_t> sources);
    void set_stiffness(AlignedBuffer<float>&& values, const MakeRoom& make_room);
    [[nodiscard]] AlignedBuffer<float>& values_of(Map map) noexcept;
    void set_worn_map(Map map, AlignedBuffer<float>&& values);
    [[nodiscard]] float inverse_mass_when_free(std::uint32_t particle) const;
};

/// Whether the layers of two cloths let them collide.
[[nodiscard]] inline bool may_meet(const Cloth& a, const Cloth& b) {
    const SelfCollision &of_a = a.settings.self_collision, &of_b = b.settings.self_collision;
    return masks_allow(of_a.layers, of_a.mask, of_b.layers, of_b.mask);
}

}  // namespace weft
