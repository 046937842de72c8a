#pragma once
// A cloth in a World: its rest model, its state, and the memory that its steps need. Calls of the host make
// and free that memory; no step does.

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

/// Memory for the air at the particles.
struct AirBuffers {
    AlignedBuffer<Vec4> forces;      ///< see ExternalForces; empty without air
    AlignedBuffer<Vec4> velocities;  ///< of the gusty air [m/s]; empty without gusts
};

/// Of a block's particles the one deepest in a trigger.
struct DeepestInTrigger {
    float gap = std::numeric_limits<float>::infinity();  ///< less the thickness; below 0 if there is one [m]
    std::uint32_t particle = 0;
};

/// Memory for what is reported of contacts.
struct ImpulseBuffers {
    AlignedBuffer<Vec4> of_colliders, missing;
    AlignedBuffer<DeepestInTrigger> in_triggers;
};

/// Memory for colliders and features in the equation of an implicit solver.
struct ContactBuffers {
    ContactBuffers(std::uint32_t particles, bool with_pairs)
        : contacts(particles, with_pairs), held(particles) {}

    Contacts contacts;
    HeldContacts held;
};

/// Memory for what is met within a step.
struct ColliderBuffers {
    AlignedBuffer<Vec4> part_start;
    std::optional<WholeTriangles> whole;
};

/// What a cloth gives a body while it takes it along [N s, N m s].
struct CollectedShare {
    Vector6 in_part = Vector6::Zero(), sum = Vector6::Zero();
    Vector6 by_stops = Vector6::Zero();  ///< what of in_part BDF2 is not to give again
    bool is_known = false;               ///< in_part is: the cloth has been solved in this part
};

/// Memory for features that meet.
struct FeatureBuffers {
    /// `made`: a mesh of features, if the cloth has none.
    FeatureBuffers(std::shared_ptr<const ContactMesh>&& made, std::uint32_t particles)
        : mesh(std::move(made)), tangles(particles) {}

    std::shared_ptr<const ContactMesh> mesh;
    AlignedBuffer<TangleMemory> tangles;
};

/// Where a cloth with features will be in a substep, as far as can be told.
struct ExpectedWay {
    Bounds box{};
    float length = 0;    ///< of the way of its fastest particle [m]
    float longest = 0;   ///< of its group, if it is the first of several [m]
    float grown_by = 0;  ///< the box, for what others may pass on [m]
};

/// Copies of what a host reads, while a step that was begun writes over it.
struct ShownCloth {
    explicit ShownCloth(std::uint32_t particles)
        : positions(particles), previous_positions(particles), velocities(particles), normals(particles) {}
    AlignedBuffer<Vec4> positions, previous_positions, velocities, normals;
    Bounds bounds;

    [[nodiscard]] std::size_t bytes() const noexcept { return 4 * positions.bytes(); }
};

/// Whether a cloth with these settings has features in contact.
[[nodiscard]] inline bool has_features(const SelfCollision& settings) {
    return settings.enabled && settings.method != SelfCollisionMethod::avoidance;
}
/// Whether these are resolved by impact zones, and so not in its equation.
[[nodiscard]] inline bool has_zones(const SelfCollision& settings) {
    return settings.enabled && settings.method == SelfCollisionMethod::impact_zones;
}

/// Whether colliders are in the equation, if its solver can have them there.
[[nodiscard]] inline bool meets_in_equation(const ClothSettings& settings) {
    return settings.collider_response == ColliderResponse::contact && settings.collider_mask != 0;
}

/// Error: too much of the cloth is within SelfCollision::distance along it. Else apply() refuses it; where
/// nothing can be thrown this is asked before, else it is passed over.
[[nodiscard]] Result<void> validate_neighbours(const ClothModel& model, const ClothSettings& settings);

/// What can run out of memory comes in two parts: the first makes what is needed, the second takes it over
/// and cannot fail. apply(), pin() and unpin() are both: where they throw, nothing has changed.
struct Cloth {
    Cloth(ClothModel cooked, const ClothSettings& settings, const Progress& progress = {});
    /// From what was read. Of use to be copied alone: most of what changes has no memory.
    Cloth(ClothModel cooked, const ClothSettings& settings, SavedCloth&& saved);
    /// Another one, in the state that the first is in: what is constant is shared. Precondition: that is in
    /// no World, and from now on does not change.
    Cloth(const Cloth& cooked);

    /// Is told how much scratch steps then take, before anything has changed, and may throw; empty: of no
    /// World.
    using MakeRoom = std::function<void(std::size_t bytes)>;
    /// Takes validated settings over.
    void apply(const ClothSettings& changed, const MakeRoom& make_room = {});
    /// Holds particles where they are. Those that are pinned already stay so.
    void pin(std::span<const std::uint32_t> particles);
    void pin(std::uint32_t particle) { pin(std::span(&particle, 1)); }
    /// Lets particles go; free ones stay free.
    void unpin(std::span<const std::uint32_t> particles);
    void unpin(std::uint32_t particle) { unpin(std::span(&particle, 1)); }
    /// Particles go with a body, from where it and they are.
    void attach(BodyId body, const BodyPose& pose, std::span<const std::uint32_t> particles);
    void detach(std::span<const std::uint32_t> particles);
    /// Puts pinned particles where they are to be when the step ends.
    void place_pins() noexcept {
        for (const Pin& pin : state.pins) set_xyz(state.positions[pin.particle], pin.target);
    }
    /// Of these particles, ascending, and no others.
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
    /// None if the cloth needs no such buffers, or has them.
    [[nodiscard]] std::optional<ContactBuffers> make_contacts(bool any_colliders) const {
        return make_contacts(any_colliders, settings, *solver);
    }
    void take_contacts(std::optional<ContactBuffers>&& made, bool any_colliders) noexcept;
    /// Empty without any.
    [[nodiscard]] ColliderBuffers make_collider_buffers(bool any_colliders) const;
    void take_collider_buffers(ColliderBuffers&& made) noexcept {
        part_start = std::move(made.part_start);
        whole = std::move(made.whole);
    }

    /// A cloth that takes the place of another, `sources` naming for each of its particles the one there. Its
    /// maps first: what they change a World prepares for. Then, once it did, all that it has as state. Either
    /// may run out of memory; then it is of no use.
    void take_maps(const Cloth& before, std::span<const std::uint32_t> sources);
    void go_on_from(const Cloth& before, std::span<const std::uint32_t> sources, std::size_t colliders);

    /// Before a state of this cloth that was saved is copied over its own: makes what the saved pins need.
    /// May run out of memory; then nothing has changed.
    void prepare_restore(std::span<const Pin> pins);
    /// After that: takes over what follows from the state.
    void commit_restore();
    /// Puts the cloth back to where the step began, at rest.
    void restore_start_of_step();

    void set_enabled(bool on) noexcept;
    [[nodiscard]] bool is_asleep() const noexcept;
    [[nodiscard]] float still_for() const noexcept;  ///< [s]
    void wake() noexcept;                            ///< or, if it is awake, keeps it so for a while
    void fall_asleep() noexcept;
    /// Without velocities, and drawn where it is.
    void stand_still() noexcept;
    /// Colliders meet the cloth so. The buffers that this points to are written when settings or maps change.
    [[nodiscard]] ClothSide side(float least_bounce = 0) const noexcept {
        return {.thickness = side_buffers.thickness.span(),
                .friction = side_buffers.friction.span(),
                .most_thickness = settings.thickness,
                .restitution = settings.restitution,
                .mask = settings.collider_mask,
                .least_bounce = least_bounce};
    }
    /// Takes a checked map over, or none; see worn/maps.cpp.
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
    /// As it is met by features. Precondition: it has features.
    [[nodiscard]] ContactCloth as_body() const;
    /// Makes the mesh of its features, if it has none.
    void make_contact_mesh();
    /// Frees it, unless it is in use.
    void drop_contact_mesh() noexcept;

    ClothId id{};  ///< in its World, from its first step on
    ClothModel model;
    ClothSettings settings;
    ClothState state;
    std::unique_ptr<Solver> solver;  ///< for the present settings and pins
    /// Scratch of a part of a substep [m/s]: what the solver found, w 0; once the cloth has moved, its
    /// velocities as they were before a stage that tells what it gave.
    AlignedBuffer<Vec4> scratch_velocities;
    std::optional<History> history;  ///< only with BDF2
    /// Lays out what a substep makes anew, but for features.
    void lay_out(Scratch& scratch);
    /// Another solver than that of its settings, for studies. Precondition: it is in no World.
    void take_solver(std::unique_ptr<Solver>&& made);
    WornLimits worn;  ///< leashes and backstops
    ClothSideBuffers side_buffers;
    float bending_per_area = 0;                     ///< see find_bending_per_area() [1/m^4]
    AlignedBuffer<float> areas_without_map;         ///< the model's, where a map of masses has changed them
    Limits limits;                                  ///< attached to the present pins
    std::optional<SelfContacts> self_contacts;      ///< only with self-collision on
    std::optional<RestNeighbours> rest_neighbours;  ///< likewise
    std::optional<Contacts> contacts;  ///< only with colliders or features, and if the solver is implicit
    std::shared_ptr<const ContactMesh> contact_mesh;
    bool shares_contact_mesh = false;  ///< it is the CookedCloth's
    ExpectedWay expected;              ///< with features: where it will be in the present substep
    std::uint32_t group = 0;        ///< that it is solved with then: the place of its first cloth in the step
    std::size_t scratch_bytes = 0;  ///< bytes that its steps take of the World's

    Surface surface;
    AirBuffers air;
    std::vector<Attachment> attached;       ///< ascending
    BodyBuffers body_buffers;               ///< empty without bodies
    /// In a part's solve, of which cloths and bodies that move freely together it is one: a number.
    std::size_t free_with = 0;
    std::vector<CollectedShare> collected;  ///< of each body, likewise
    bool meets_bodies = false;              ///< it may, in the present substep
    AlignedBuffer<Vec4> part_start;  ///< where the present of a step's parts began, if it is not the first
    std::optional<WholeTriangles> whole;  ///< only with colliders
    /// That colliders gave each particle in this step [N s]; only where contacts are reported. Before it 0.
    AlignedBuffer<Vec4> collider_impulses;
    /// What contact gave each particle in the equation of features, less what has been told of it; w what
    /// colliders gave along their normals [N s].
    AlignedBuffer<Vec4> missing_impulses;
    AlignedBuffer<DeepestInTrigger> in_triggers;  ///< by block; only where contacts are reported
    /// Of the impulse over a substep to that in its equation, where missing_impulses are to be told of; else
    /// 0.
    float impulse_ratio = 0;
    AlignedBuffer<std::uint32_t> partial_counts;
    AlignedBuffer<double> partial_sums;
    AlignedBuffer<Survey> partial_surveys;

    /// How its frame carries it before the present step; none without a frame, or at full inertia.
    std::optional<Carried> carried;
    std::vector<ColliderMotion> seen_colliders;  ///< as the cloth that is carried sees them

    // Of the present step; a step that is done leaves them for the report.
    bool solver_failed = false;           ///< in one of its substeps
    bool unsolved = false;                ///< beyond what its method tolerates, in one of them
    bool restored = false;                ///< by its guard
    bool pins_limited = false;            ///< they were to go faster than WorldSettings::max_speed
    float residual = 0;                   ///< as last measured
    Survey extent{};                      ///< of the state, as last surveyed
    SelfContactCounts self_counts;        ///< of its last substep
    FeatureCounts feature_counts;         ///< of its last substep; of a group, the first cloth has them
    bool is_in_crowd = false;             ///< see FeatureContact::detect(); of a group, likewise
    std::uint32_t contact_count = 0;      ///< to be reported
    std::uint32_t collider_contacts = 0;  ///< particles that met a collider in its last substep
    float pin_lag = 0;                    ///< of its farthest pin, which cloth has stopped [m]
    LimitLag limit_lag{};                 ///< of its worn limits, at the end
    bool is_disturbed = false;            ///< see Simulation::find_disturbed()
    bool was_stepped = false;             ///< by the last step; if not, it says nothing of the above
    std::int64_t nanoseconds = 0;         ///< that its threads took for it

    std::unique_ptr<Budgeted> budgeted;  ///< only with a budget
    /// As the present step takes it.
    [[nodiscard]] const ClothSettings& stepped_settings() const noexcept {
        return budgeted ? budgeted->settings : settings;
    }
    /// It takes no step of its own, but moves on to where its last one ended.
    [[nodiscard]] bool is_gliding() const noexcept { return state.detail && state.detail->left > 0; }
    /// How many of the World's steps its own is long.
    [[nodiscard]] float stride() const noexcept {
        return state.detail ? static_cast<float>(state.detail->rate) : 1.0f;
    }
    /// It goes no further to where its last step ended.
    void land() noexcept;
    /// How far the pin that is farthest from its target is from it [m].
    [[nodiscard]] float farthest_pin() const noexcept;
    /// Coefficients of its next step, or part of one, of h seconds.
    [[nodiscard]] Bdf bdf_of(float h, float least_gamma = 0) const {
        return bdf_after(history ? state.record.h : 0, h, least_gamma);
    }
    [[nodiscard]] BudgetBuffers make_budget(bool on) const;
    void take_budget(BudgetBuffers&& made) noexcept;

    std::unique_ptr<ShownCloth> shown;  ///< only where steps are taken apart

  private:
    /// For a model with the bending of these settings.
    void apply_to_model(const ClothSettings& changed, const MakeRoom& make_room);
    bool has_colliders_ = false;
    std::size_t shared_bytes_ = 0;  ///< with all others of one CookedCloth

    /// All that its steps take of the World's scratch with such settings of contact, and a mesh of features
    /// or none.
    [[nodiscard]] std::size_t scratch_of_steps(Solver& with, bool second_order, const SelfCollision& of,
                                               const ContactMesh* mesh) const;
    [[nodiscard]] std::size_t own_bytes() const;
    [[nodiscard]] bool is_second_order(const ClothSettings& of, const Solver& with) const;
    [[nodiscard]] std::optional<ContactBuffers> make_contacts(bool any_colliders, const ClothSettings& of,
                                                              const Solver& with) const;
    /// None if the cloth is to have no features, or has them.
    [[nodiscard]] std::optional<FeatureBuffers> make_features(const SelfCollision& of) const;
    void take_features(std::optional<FeatureBuffers>&& made, const SelfCollision& of) noexcept;
    [[nodiscard]] std::unique_ptr<Solver> solver_for(const ClothSettings& changed) const;
    void reserve_pairs(Solver& with) const;
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

/// Whether their layers let them.
[[nodiscard]] inline bool may_meet(const Cloth& a, const Cloth& b) {
    const SelfCollision &of_a = a.settings.self_collision, &of_b = b.settings.self_collision;
    return masks_allow(of_a.layers, of_a.mask, of_b.layers, of_b.mask);
}

}  // namespace weft
