#pragma once
// Settings of cloths and Worlds. Every field says its unit, its range and its effect; the defaults work.

#include <array>
#include <cstdint>
#include <string_view>

#include "weft/collider.h"
#include "weft/error.h"
#include "weft/executor.h"
#include "weft/export.h"
#include "weft/filling.h"
#include "weft/methods.h"
#include "weft/self_collision.h"
#include "weft/types.h"

namespace weft {

/// The material, by parameters that do not depend on the mesh or its resolution. A cloth of springs has them
/// within 3 %.
///
/// Poisson's ratio is 0 on general meshes; on a sheet the springs make it about shear / warp. A sheet's
/// diagonal springs set a lower bound to the stiffness along its axes: with cells of 1 : 2 and more, keep
/// shear below a fifth of warp and weft.
struct Fabric {
    float areal_density = 0.2f;  ///< [kg/m^2], 1e-4 to 1e4
    /// Membrane stiffness along the pattern's first axis, a sheet's rows: tension per width over strain
    /// [N/m], 0 to 1e9. A general mesh without a pattern has its warp upwards.
    float warp = 400.0f;
    float weft = 400.0f;   ///< along the pattern's second axis, a sheet's columns [N/m], 0 to 1e9
    float shear = 100.0f;  ///< in-plane shear stiffness [N/m], 0 to 1e9
    /// Flexural rigidity along the warp: moment per width over curvature [N m], 0 to 1e4. Springs rest flat,
    /// whatever shape the cloth starts in; FiniteElements::dihedral rests in that shape. A step of dt limits
    /// it to what floats resolve beside the mass, some 1e7 areal_density cell^4 / dt^2: less than set where
    /// cells are below 0.2 mm, or for boards.
    float bending = 2e-5f;
    /// Flexural rigidity along the weft over that along the warp, 0.01 to 100. Twist has their geometric
    /// mean, so that cloth rolled up at 45 degrees to both has the square of the mean of their roots. A new
    /// value for a cloth in a World cooks its bending again: some microseconds a particle.
    float bending_ratio = 1;
    /// Stress from the rate of strain over that from strain [s], 0 to 100: the time in which stretch, shear
    /// and bend creep back after a load is gone. Motion at f Hz has the loss factor 2 pi f damping. The time
    /// step adds numerical damping: at f, backward Euler with steps of h has a loss factor of 2 pi f h, BDF2
    /// of (2 pi f h)^3 / 2. From about 0.1 s on, cloth needs more Multilevel::passes to hang right while it
    /// moves: six at 1 s.
    float damping = 2e-4f;
    /// Growth of stiffness with strain [1 per strain], 0 to 1000. Along an axis of stiffness K the tension
    /// per width is K e (1 + stiffening e) at strain e, so that warp and weft are those near rest. Beyond a
    /// strain of 1/6, where the measurements of Wang et al. 2011 end, the curve continues along its tangent.
    /// Compression and shear stay linear; damping follows the slope. Measured: wovens 2 to 4, knits 1.5 to
    /// 116 (fabrics.h). warp and weft times 1 + stiffening / 3 must not pass 1e9 N/m. 0: none, at no cost.
    /// Only springs with implicit methods and SymplecticEuler have it: Xpbd, Fibres and FiniteElements refuse
    /// it.
    float stiffening = 0;

    /// Returns a fabric of fabrics.h, such as "denim". Error: no fabric of that name, with the names there
    /// are.
    [[nodiscard]] WEFT_API static Result<Fabric> named(std::string_view name);

    friend bool operator==(const Fabric&, const Fabric&) = default;
};

/// Triangle finite elements of the same fabric, in place of the springs. Implicit methods and SymplecticEuler
/// support them; Xpbd and Fibres refuse them. Fabric::warp, weft and shear below 1e-4 N/m count as 1e-4.
struct FiniteElements {
    bool enabled = false;
    float poisson = 0.0f;   ///< lateral contraction under stretch, in [0, 0.5)
    bool dihedral = false;  ///< bending by angles from those at rest; false: quadratic, at rest flat
    /// Whether mass is consistent; false: lumped at the particles. SymplecticEuler refuses consistent mass.
    bool consistent_mass = false;
};

/// Long-range attachments (Kim, Chentanez, Mueller 2012): no particle is farther from the nearest pins than
/// the path along the cloth is long, whatever the solver has left unsolved.
struct Tethers {
    bool enabled = false;
    float slack = 1.0f;  ///< factor of the length along the cloth, 1 to 1000
};

/// Fractions of its frame's inertial accelerations that a cloth has, see World::set_frame: each from 0, none,
/// to 1, all. At 1 each a frame has no effect, and takes no time.
struct FrameInertia {
    float linear = 1;  ///< fraction of the acceleration of the frame's origin
    /// Fraction of Euler's and Coriolis' accelerations, which come from the frame's turning.
    float angular = 1;
    float centrifugal = 1;  ///< fraction of the centrifugal acceleration
};

/// Settings of a cloth. All of them can be changed between steps.
struct ClothSettings {
    Fabric fabric{};
    FiniteElements finite_elements{};
    Method method{};  ///< Multilevel unless another is set
    TimeScheme time_scheme = TimeScheme::of_method;
    /// Steps of the method within each of WorldSettings::substeps, 1 to 1024. One is enough for the default.
    /// Methods that are not implicit handle colliders after their step, and need 4 and more where cloth lies
    /// on them.
    int substeps = 1;
    Tethers tethers{};
    SelfCollision self_collision{};
    float air_damping = 0.2f;  ///< rate at which all velocities decay [1/s], 0 to 1e6
    float thickness = 0.005f;  ///< distance kept from colliders [m], 0 to 10
    float friction = 1.0f;     ///< multiplies the colliders' friction, 0 to 1000
    /// Friction of the cloth's back, against the normals, over that of its front, 0 to 1000: below 1 for a
    /// smooth lining. Only towards colliders and bodies.
    float back_friction_ratio = 1;
    /// Normal velocity of a particle after it hits a collider over that before, 0 to 1; the greater of this
    /// and the collider's own counts, see Collider::restitution.
    float restitution = 0;
    /// The cloth meets colliders that have one of these bits in Collider::layers. 0: none, at no cost.
    std::uint32_t collider_mask = ~0u;
    ColliderResponse collider_response = ColliderResponse::contact;
    /// Whether the cloth is simulated. False: no step moves it, nothing meets it, and it costs nothing; it
    /// may be pinned and set meanwhile. See World::set_enabled.
    bool enabled = true;
    /// Cloth falls asleep if for half a second no sixteen particles that follow one another have been faster
    /// than this, rms [m/s], 0 to 1000, and the mean of all velocities has not been above a quarter of it:
    /// one particle that trembles keeps nothing awake. It stands still, presses on nothing and costs next to
    /// nothing until a pin moves, a collider near it or under it moves, leaves or changes, awake cloth comes
    /// near, the wind, gravity or its settings change, or World::wake. Cloths that may touch sleep together.
    /// In gusts no cloth sleeps. 0: it never sleeps; so set it where cloth is to drift slowly, without
    /// weight, or where its contacts are read at rest.
    float sleep_speed = 0.02f;
    FrameInertia frame_inertia{};
    /// Weight of an error of its motion, 0 to 1e6, where WorldSettings::budget is not enough for all: such as
    /// 1 over the distance from the viewer [m]. 0: out of sight; the cloth gets the least time. See
    /// World::set_importance.
    float importance = 1;
    /// A frame that moves farther than this in one step teleports its cloth [m], 0 to 1e6; see
    /// World::set_frame. Set it above what the frame ever moves in a step. 0: it never does.
    float teleport_distance = 0;
    /// A frame that turns by more than this in one step teleports its cloth [rad], 0 to 3.2. From pi on, and
    /// with 0, it never does.
    float teleport_angle = 0;
    /// Factor of the World's gravity for this cloth, -10 to 10. 0: it floats.
    float gravity_scale = 1;
    /// Factor of the air's velocity for this cloth, 0 to 10: wind, gusts and sources. The air's force grows
    /// with the square of the velocity. 0: the air stands still for it, and slows it down.
    float wind_scale = 1;
    /// Factors of Wind::drag and Wind::lift for this cloth, 0 to 1000: below 1 for a loose weave, through
    /// which air passes. 0 and 0: the air does not act on it.
    float drag_scale = 1;
    float lift_scale = 1;
    /// Limit of its particles' speeds relative to its frame (World::set_frame), or to the World without one
    /// [m/s], 0 to 1e4: what a sprint or a turn may do to a cape. Pins keep their own speed. 0: only
    /// WorldSettings::max_speed limits, at no cost.
    float max_speed_in_frame = 0;
    /// What fills a closed mesh. The default, nothing, has no cost. A mesh that is not closed is refused. A
    /// cut that opens it (World::recut_cloth) bursts the cloth: the filling becomes FillingKind::none.
    Filling filling{};
    /// The host's own number of the cloth, by which World::restore_cloths() finds it in a save. 0: none.
    std::uint64_t key = 0;
};

/// Kinds of air sources.
enum class AirSourceKind : std::uint32_t {
    none,  ///< nothing, whatever its other values are
    /// A fan: a round free jet along `velocity`. It has half its speed at `radius` where it begins, widens by
    /// a tenth of its way and keeps its momentum (Pope 2000, "Turbulent flows", 5.1). Behind the fan there is
    /// none.
    jet,
    /// Air driven out of `position` on all sides, at |velocity| at `radius`. Beyond, it falls with the square
    /// of the distance (a source of constant volume); within, it falls towards the middle.
    blast,
    /// A ball that flies through the air: its speed within, the potential flow around it (Lamb 1932, section
    /// 96), and a wake behind it, which widens by the root of the way and keeps its momentum (Schlichting
    /// 1979, "Boundary-layer theory", IX).
    wake,
};

/// Air in motion at one place, added to the wind. It has no state of its own: set a fan once, a passing ball
/// or a fading blast before each step. Several add up; cloth and colliders do not deflect them.
struct AirSource {
    AirSourceKind kind = AirSourceKind::none;
    Vec3 position{};      ///< a fan's hub, a blast's or a ball's middle [m], each component up to 1e5
    Vec3 velocity{};      ///< [m/s], each component up to 1000
    float radius = 0.3f;  ///< [m], 1e-3 to 1e5
};

/// Kinds of shelters from the wind.
enum class AirShelterKind : std::uint32_t {
    none,  ///< nothing, whatever its other values are
    ball,  ///< a ball of `radius`
    box,   ///< a box of `half_extents`, turned by `rotation`
};

/// A place that keeps the wind and its gusts off, such as a room or the lee of a house. Sources blow within
/// as they do outside. Where several overlap, their factors multiply. It does not move with anything: set it
/// anew where it is a vehicle's.
struct AirShelter {
    AirShelterKind kind = AirShelterKind::none;  ///< its shape
    Vec3 position{};                             ///< the middle [m], each component up to 1e5
    Rotation rotation{};                         ///< of a box
    Vec3 half_extents{1, 1, 1};                  ///< of a box [m], each 1e-3 to 1e5
    float radius = 1;                            ///< of a ball [m], 1e-3 to 1e5
    float border = 0.5f;  ///< distance outside over which the wind rises to its whole [m], 1e-3 to 1e5
    float exposure = 0;   ///< factor of the wind within, 0 to 1
};

/// Moving air. Its force on each triangle follows from the air's velocity relative to it.
struct Wind {
    Vec3 velocity{};  ///< mean velocity [m/s], each component up to 1000
    float gust = 0;   ///< strength of the gusts relative to the mean speed, 0 to 100; 0.3 is a gusty day
    float gust_length = 0.8f;  ///< size of an eddy [m], 1e-3 to 1e5
    float air_density = 1.2f;  ///< [kg/m^3], 0 to 1e4; 0 switches all air forces on triangles off, at no cost
    float drag = 1.0f;         ///< drag coefficient of a triangle facing the wind, 0 to 1000
    float lift = 0.4f;         ///< lift coefficient, 0 to 1000
    std::uint32_t seed = 1;    ///< another seed, other gusts
    /// Local sources, in any order and with gaps. The first that is not `none` gives each cloth 16 bytes a
    /// particle, unless gusts have done so; each takes some 2 ns a particle and step. World::shift_origin
    /// moves them.
    std::array<AirSource, 8> sources{};
    /// Places out of the wind, in any order and with gaps. They take the memory that sources take, and the
    /// World's origin moves them as it does sources.
    std::array<AirShelter, 8> shelters{};
};

struct WorldSettings {
    Vec3 gravity{0, -9.81f, 0};  ///< [m/s^2], each component up to 1e4
    Wind wind{};
    /// Limit of particles' speeds after any stage of a step [m/s], 1e-3 to 1e4: a pin or a collider that
    /// jumps cannot shoot the cloth off.
    float max_speed = 100.0f;
    int substeps = 1;  ///< steps of the solver per World::step, 1 to 256
    /// Number of contacts that World::contacts() has room for, 0 to 2^20. 0: contacts are not reported, at no
    /// cost. Each takes 164 bytes, and 80 more for every thread but the first; besides, each particle takes
    /// 32 (ClothInfo::bytes).
    int contact_reports = 0;
    /// Threads of Weft's own arena, 1 to 256; 0: one per core. Results do not depend on their number.
    int threads = 0;
    /// Time that a step may take [ms], 0 to 1000; 0: no limit, at no cost. If a step would take longer,
    /// cloths are stepped at less detail than they are set to, the most important ones least so. Multilevel
    /// takes one pass. Cloth without contact of features, frame or skin takes every second step, of twice the
    /// length, through which it moves evenly, unless pins or colliders near it move or the World has bodies.
    /// Contact is never dropped. Garments with levels (World::add_level) then go to coarser meshes. Costs are
    /// measured, so that bytes depend on time: a recording holds the choices, and its replay gives the same
    /// bytes. The least detail of all cloths may take longer than the budget. Each cloth takes 16 bytes a
    /// particle more.
    float budget = 0;
    Executor executor{};  ///< the host's threads in place of Weft's, where `run` is set
};

}  // namespace weft
