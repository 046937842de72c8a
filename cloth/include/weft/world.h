#pragma once
// The World: cloths, colliders and wind, stepped together.

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <limits>
#include <memory>
#include <optional>
#include <span>
#include <string>

#include "weft/body.h"
#include "weft/cloth_id.h"
#include "weft/collider.h"
#include "weft/contact.h"
#include "weft/cooked_cloth.h"
#include "weft/cutting.h"
#include "weft/debug_draw.h"
#include "weft/error.h"
#include "weft/export.h"
#include "weft/maps.h"
#include "weft/mesh.h"
#include "weft/profile.h"
#include "weft/query.h"
#include "weft/recording.h"
#include "weft/report.h"
#include "weft/seam.h"
#include "weft/settings.h"
#include "weft/shapes.h"
#include "weft/transform.h"
#include "weft/types.h"
#include "weft/vertex_streams.h"

namespace weft {

/// A cloth's buffers, uncopied, in the layout in which they are uploaded. Take a new view after each step or
/// change. An old one stays readable until the cloth is removed or the World ends, whatever else is called,
/// but positions and previous_positions may have been swapped. Weft numbers the particles; vertex_to_particle
/// maps the mesh's own vertices to them: see World::write_vertices, too.
struct ClothView {
    std::span<const Vec4> positions{};  ///< x y z [m], w inverse mass [1/kg], 0 for pinned particles
    /// Positions at the start of the last step, for blending by FixedStepFrame::alpha.
    std::span<const Vec4> previous_positions{};
    std::span<const Vec4> velocities{};     ///< x y z [m/s]
    std::span<const Vec4> normals{};        ///< x y z, unit length, out of the front of the triangles
    std::span<const Triangle> triangles{};  ///< particle indices
    std::span<const std::uint32_t> vertex_to_particle{};
    std::span<const Vec2> texcoords{};  ///< texture coordinates of the mesh's vertices, or none
    /// `triangles` by the mesh's vertices, for an index buffer; a mesh that is no grid has them only with
    /// texture coordinates.
    std::span<const Triangle> vertex_triangles{};
    Bounds bounds{};  ///< bounding box of the positions
};

/// Output formats of World::describe().
enum class DescriptionFormat : std::uint8_t { text, json };

/// Steps cloths, colliders and wind together. Not thread-safe, but free of globals: one thread at a time per
/// World; Worlds are independent of each other.
class WEFT_API World {
  public:
    /// Error: a setting out of range.
    [[nodiscard]] static Result<World> create(const WorldSettings& settings = {});
    World(World&&) noexcept;
    World& operator=(World&&) noexcept;
    ~World();

    [[nodiscard]] const WorldSettings& settings() const noexcept;
    Result<void> set_settings(const WorldSettings& settings);
    /// Writes the air's velocity at points [m/s] for the next step: wind, gusts and sources. It serves what
    /// drifts besides cloth, such as leaves and smoke, and takes some 30 ns a point where there are gusts.
    /// Errors: not as many velocities as points; a point that is not finite or beyond 100 km.
    Result<void> sample_air(std::span<const Vec3> points, std::span<Vec3> velocities) const;

    /// Finds the first place where a ray meets cloth, from either side, as cloth lies after the last call:
    /// none, or a place within `reach` [m] of `from`. `direction` has any length. `only`: of this cloth
    /// alone; null: of all that are enabled. This call and the next two take no memory, and look at every
    /// triangle of cloth whose bounding box is in reach, 10 to 20 ns each. Errors: `from` beyond 100 km, a
    /// direction that is 0 or not finite, a reach that is not a number from 0, a stale id.
    [[nodiscard]] Result<std::optional<ClothPoint>> cast_ray(
        const Vec3& from, const Vec3& direction, float reach = std::numeric_limits<float>::infinity(),
        ClothId only = {}) const;
    /// Finds the place on cloth that is nearest to a point, within so many metres of it. Errors: as
    /// cast_ray().
    [[nodiscard]] Result<std::optional<ClothPoint>> closest_point(
        const Vec3& to, float within = std::numeric_limits<float>::infinity(), ClothId only = {}) const;
    /// Writes the triangles that a ball touches, by cloths and numbers, each by its place nearest to the
    /// ball's middle, as many as there is room for. Returns how many there are. Errors: as cast_ray().
    [[nodiscard]] Result<std::size_t> triangles_in_ball(const Vec3& center, float radius,
                                                        std::span<ClothPoint> to, ClothId only = {}) const;

    /// Makes particles, springs and solver memory from the mesh, as CookedCloth::create() does, for this
    /// cloth alone; the mesh is not kept.
    Result<ClothId> add_cloth(const Mesh& mesh, const ClothSettings& settings = {});
    /// Adds a cloth of `cooked`, with the settings of the cooking, moved by `place` from where its mesh lies.
    /// It equals a cloth added by the mesh, but copies its state alone, and shares what is constant. The
    /// CookedCloth need not outlive the call. Errors: the rotation is none, or a vertex would be out of the
    /// 100 km around the origin.
    Result<ClothId> add_cloth(const CookedCloth& cooked, const Transform& place = {});
    /// Returns the ClothInfo of such a cloth, without adding it. Takes as long as add_cloth, and the memory
    /// meanwhile.
    [[nodiscard]] Result<ClothInfo> measure_cloth(const Mesh& mesh, const ClothSettings& settings = {}) const;
    Result<void> remove_cloth(ClothId id);
    /// Replaces the cloth's mesh, as by one that was cut (cut_mesh). The cloth keeps its id, settings,
    /// positions and motion. Vertex v comes from vertex `from[v]` of the old mesh, and gets its place,
    /// velocity, pin, body, place on the skin and values of maps. Rest shape and mass are those of the new
    /// mesh. By contact, particles that come from one are moved apart by some 0.4 % of an edge, into their
    /// own triangles, or they would rub each other. Takes as long as add_cloth(); an unchanged mesh leaves
    /// the motion unchanged. The cloth's spans end as by remove_cloth(), a DrawnMesh has to be bound anew,
    /// and earlier saves cannot be restored. Errors: as add_cloth(); another length of `from` than the mesh
    /// has vertices, a vertex in it that the cloth does not have, vertices of one particle that come from
    /// several.
    ///
    /// A cloth with a filling bursts if its new mesh is not closed: ClothSettings::filling becomes
    /// FillingKind::none, a warning is logged, and filling_info() counts the open edges.
    Result<void> recut_cloth(ClothId id, const Mesh& mesh, std::span<const std::uint32_t> from);
    /// Volume and pressure of a cloth now. Takes some 10 ns a triangle.
    [[nodiscard]] Result<FillingInfo> filling_info(ClothId id) const;
    /// Writes the edges that are longer than at rest by more than this fraction, the most strained first, as
    /// many as there is room for. A sheet's edges are those along its threads. Returns how many were written.
    /// Error: a strain that is not a number from -1.
    [[nodiscard]] Result<std::uint32_t> strained_edges(ClothId id, float strain,
                                                       std::span<StrainedEdge> to) const;
    [[nodiscard]] Result<ClothSettings> cloth_settings(ClothId id) const;
    Result<void> set_cloth_settings(ClothId id, const ClothSettings& settings);
    /// Sets ClothSettings::enabled, at no cost: for cloth that is out of sight. Switched on, cloth begins
    /// from rest where it was left, or where its pins, bodies and skin are now, and is pushed out of what is
    /// there.
    Result<void> set_enabled(ClothId id, bool on);
    /// See ClothSettings::sleep_speed.
    [[nodiscard]] Result<bool> is_asleep(ClothId id) const;
    Result<void> wake(ClothId id);
    /// Sets ClothSettings::importance, at no cost: once a frame, for WorldSettings::budget.
    Result<void> set_importance(ClothId id, float importance);
    /// Makes a cloth the next coarser level of a garment, whose finest mesh is `finest`: level 1, or behind
    /// those that were added before, up to level 3. One level is stepped; the others wait, switched off, at
    /// the cost of their memory. Both cloths must lie in one pose now, every vertex of each within `reach`
    /// [m] of the other's surface: later the one that takes over gets places, velocities and the places
    /// before the last step from the other's surface. Its pins go to their own targets: move pins, skin and
    /// frame of all levels alike. Momentum changes by less than 2 % of mass times root mean square speed;
    /// folds that the coarser mesh cannot have are lost, and DrawnMesh::begin_blend() hides it. Removing or
    /// cutting a level takes it and all coarser ones out of the garment; the next finer one takes over from
    /// one that is removed while it is stepped. Errors, by which nothing changes: a stale id; as many
    /// particles as the level above, or more; a fifth level; a cloth that is a level already, or has seams;
    /// vertices out of reach, or a reach that is not above 0 to 10 m.
    Result<void> add_level(ClothId finest, ClothId coarser, float reach = 0.1f);
    /// Sets the level that is stepped, of the garment that the cloth belongs to: by distance, between steps,
    /// before pins, skins and frames are moved. With WorldSettings::budget it is the finest level allowed:
    /// where time is short, garments that count least (ClothSettings::importance of the level that is
    /// stepped) go to coarser levels after a step, and back when there has been time for a second. A
    /// garment that is switched off (set_enabled of the level that is stepped) stays off. Takes no memory.
    /// Error: a level that the garment does not have; cloth without levels has level 0 alone.
    Result<void> set_level(ClothId id, std::uint32_t level);
    /// The level that is stepped, 0 the finest: whose cloth to draw. It may change in each step with a
    /// budget.
    [[nodiscard]] Result<std::uint32_t> level(ClothId id) const;
    [[nodiscard]] Result<ClothInfo> cloth_info(ClothId id) const;
    /// Returns the cloth's buffers. The World owns the view, so that a loop over world.cloth(id)->positions
    /// is sound; the next call for the same cloth overwrites it. When the cloth is removed the view becomes
    /// empty, and may later be another's; it ends with the World, not when that moves. Copied spans end with
    /// the cloth.
    [[nodiscard]] Result<const ClothView&> cloth(ClothId id) const;
    /// Writes vertices [first, first + count), as far as they exist, by the mesh's own numbers, into the
    /// host's streams. It allocates nothing. Tangents, strains and previous normals are computed from the
    /// triangles round each vertex and take many times as long as the rest, which is copied: `weft_bench
    /// --calls`. Calls may run side by side, and beside work(): threads may divide the vertices, and draw the
    /// last step's result from begin_step() to end_step(). Errors: a stream of less room than all vertices
    /// take, or whose stride is less than a value; texture coordinates or tangents of a cloth whose mesh has
    /// no texture coordinates.
    Result<void> write_vertices(ClothId id, const VertexStreams& to, std::size_t first = 0,
                                std::size_t count = SIZE_MAX) const;

    /// Pins particles where they are, until move_pin or unpin: all of them or, with an error, none. Vertices
    /// are those of the input mesh; a pinned one stays as it is. With tethers on, the first change after a
    /// step measures the cloth; after further changes the next step measures it once more.
    Result<void> pin(ClothId id, std::span<const std::uint32_t> vertices);
    Result<void> pin(ClothId id, std::uint32_t vertex) { return pin(id, {&vertex, 1}); }
    /// Moves the pinned vertex to `target` [m] straight over the next step; where the cloth is off, at once.
    Result<void> move_pin(ClothId id, std::uint32_t vertex, const Vec3& target);
    /// Moves each vertex to the target of its number: all of them or, with an error, none. For pins that
    /// follow an animation; it takes no memory.
    Result<void> move_pins(ClothId id, std::span<const std::uint32_t> vertices,
                           std::span<const Vec3> targets);
    /// Releases vertices: all of them or, with an error, none. A vertex that is not pinned stays free.
    Result<void> unpin(ClothId id, std::span<const std::uint32_t> vertices);
    Result<void> unpin(ClothId id, std::uint32_t vertex) { return unpin(id, {&vertex, 1}); }

    /// Teleports the cloth, with its pins, their targets, its skin and its frame. It keeps its shape and its
    /// motion, which turn with it, and gains no velocity. Its last positions move along, so that a blend
    /// shows no path. Colliders and other cloths stay: cloth that crosses at the new place is separated, and
    /// cloth inside a collider is pushed out. The rotation is about the World's origin. Errors: the rotation
    /// is none, or a vertex would be out of the 100 km around the origin.
    Result<void> move_cloth(ClothId id, const Transform& by);

    /// Puts the cloth into a pose, at rest: for a respawn or a camera's cut. `positions` are of the mesh's
    /// vertices [m], such as a skinned mesh's; of welded vertices the last counts. Velocities are 0, nothing
    /// is remembered of motion and contact, and a blend shows no path. Pins go where their vertices are put;
    /// attached vertices go to their bodies. Skin and frame are at once where the host last set them, so set
    /// them before, and place colliders. Cloth that crosses in this pose is separated, and cloth inside a
    /// collider comes out at a limited speed. Takes no memory. Errors: another count than the mesh's
    /// vertices; a vertex that is not finite, or beyond 100 km.
    Result<void> reset_cloth(ClothId id, std::span<const Vec3> positions);
    /// Puts the cloth into a pose in motion, as reset_cloth() does at rest: carry_state() calls it where
    /// another mesh of a garment takes over. `previous_positions` are those at the start of the last step,
    /// from which a blend starts [m]; velocities [m/s] of pinned and attached vertices are 0. Errors, too:
    /// another count of these, or a velocity that is not finite.
    Result<void> resume_cloth(ClothId id, std::span<const Vec3> positions,
                              std::span<const Vec3> previous_positions, std::span<const Vec3> velocities);

    /// Sets a moving frame of reference for cloth on a character or a vehicle. The first call places the
    /// frame and moves nothing; each later one moves it over the next step. In a step without a call it
    /// stands still. ClothSettings::frame_inertia says how much of the frame's acceleration acts on the
    /// cloth: at 1 each all of it, as without a frame; at 0 each none, as though the frame stood still, with
    /// gravity and wind as they are in the World.
    ///
    /// Before a step the cloth is transported by the part of the frame's motion that does not act on it: 1 -
    /// linear of its origin's, 1 - angular of its turn. Its velocities turn with it, and lack that part, too.
    /// Pins go where the host moves them. Colliders move relative to the cloth as they do to the frame, so
    /// that a body that moves with it neither rubs nor pushes. Cloths that touch need the same frame and
    /// inertia: otherwise one is transported across the other, and has to be separated. A turn in one step is
    /// the shorter way round. A jump needs move_cloth, or ClothSettings::teleport_distance and
    /// teleport_angle: then a frame that moves or turns farther in one step takes its cloth along, as
    /// move_cloth does, and a skin that the host has not set for this step. Each pin and collider is taken
    /// along too, or stays, whichever makes its way in the step shorter. Errors: a rotation that is none, a
    /// place beyond 100 km.
    Result<void> set_frame(ClothId id, const Transform& pose);
    /// Removes the frame, as before the first set_frame().
    Result<void> leave_frame(ClothId id);

    /// Sets a map: a number for each vertex, or none, which removes the map. It is not saved. Errors: values
    /// of another count than the mesh's vertices; a value out of the map's range, by its vertex; a backstop
    /// that begins beyond the leash.
    Result<void> set_map(ClothId id, Map map, std::span<const float> values);
    /// Sets the skin for leashes and backstops (Map), once a step: each vertex's place on what the cloth is
    /// worn on, and the normal there, outwards, of any length. The first call sets it at once, and teleports
    /// cloth beyond its limits there as a whole, with the pins that the host has not moved since the last
    /// step. Later calls move the skin over the next step, and take no memory. Of welded vertices the last
    /// counts. Only backstops need normals.
    ///
    /// After a step every free particle is within its leash and out of its backstop, but for rounding; both
    /// are frictionless. They are in the equation of implicit methods, as colliders are, and are applied
    /// after colliders. Pins have precedence over them, and so has, by SelfCollisionMethod::contact and by
    /// impact zones, that cloth does not cross: StepReport::limits_exceeded counts the particles that this
    /// kept beyond. Errors name the vertex; or no map of leashes or backstops is set.
    Result<void> set_skin(ClothId id, std::span<const Vec3> places, std::span<const Vec3> normals);

    /// Makes `to` the World's new origin: it is subtracted from all coordinates in the World, gusts' too, and
    /// nothing else changes. Single precision has steps of 8 mm at 100 km, and of 0.06 mm at 1 km. So keep
    /// the World's origin near the camera: shift it by whole metres whenever the camera is some 500 m away.
    /// Add the sum of all `to`, in double precision, to what the World gives out, and subtract it from poses
    /// and targets. Saves have coordinates by the origin of their time. Error: something would be out of the
    /// 100 km around the new origin.
    Result<void> shift_origin(const Vec3& to);

    /// Copies a shape, for colliders that are instances of it (PlacedShape). Errors name the vertex, the
    /// triangle, or what is not closed.
    Result<ShapeId> add_shape(const Shape& shape);
    /// Moves the vertices of a TriangleMesh; the triangles stay. All its colliders have the new shape at
    /// once. In the next step they push and drag what they meet at the speed at which vertices got there.
    /// There must be as many vertices as it was made of.
    Result<void> deform_shape(ShapeId id, std::span<const Vec3> vertices);
    /// Error: a collider is an instance of it.
    Result<void> remove_shape(ShapeId id);
    [[nodiscard]] Result<ShapeInfo> shape_info(ShapeId id) const;

    /// The World's first collider gives each cloth 34 bytes a particle more, or 98 with an implicit method.
    Result<ColliderId> add_collider(const Collider& collider);
    /// Moves the collider to `target` over the next step. It pushes and drags what it meets, where it ends
    /// and on the way. One that would exceed WorldSettings::max_speed jumps, and meets nothing on the way.
    /// `target` has the same kind of shape; an instance stays one of its shape.
    Result<void> move_collider(ColliderId id, const Collider& target);
    /// Places the collider at once, without a velocity: cloth inside it comes out at a limited speed (see
    /// ColliderResponse), and is neither pushed nor dragged. `place` has the same kind of shape.
    Result<void> place_collider(ColliderId id, const Collider& place);
    Result<void> remove_collider(ColliderId id);
    [[nodiscard]] Result<Collider> collider(ColliderId id) const;

    /// Adds a body that cloth moves. In each step Weft moves it: it falls, turns, and receives the reaction
    /// to what its colliders and attached vertices give cloth. It stands and slides on the World's unattached
    /// colliders (see body.h); contact with other bodies is for the host's engine. A host whose engine moves
    /// the body sets its state before each step, takes body_impulses() after it, and lets its engine do the
    /// rest.
    ///
    /// With Multilevel, the default, bodies are unknowns of the cloth's equation: stable from a hundredth to
    /// a hundred times the cloth's mass. Cloth that is pinned, or that a body presses onto a collider, stops
    /// the body. With other methods bodies receive what the step gave the particles that touch them, which
    /// supports only much lighter bodies. With ColliderResponse::velocity_filter they receive nothing.
    ///
    /// Cloths that may meet the same body are solved with it as one equation: those with
    /// SelfCollisionMethod::contact, and those without it. The two, and cloths of another method, of other
    /// ClothSettings::substeps, time scheme or in a frame, are solved in turn. Each then expects of the
    /// others what they gave last, which needs a body that is not much lighter than the cloths. Cloths of one
    /// equation and bodies that nothing else holds keep their momentum together to rounding.
    ///
    /// Each body gives every cloth 192 bytes more. The first of a World also gives 100 bytes a particle, and
    /// what a first collider does.
    Result<BodyId> add_body(const BodySettings& settings, const BodyState& state = {});
    /// Removes the body. Its colliders stay where they are, its vertices are released.
    Result<void> remove_body(BodyId id);
    [[nodiscard]] Result<BodySettings> body_settings(BodyId id) const;
    Result<void> set_body_settings(BodyId id, const BodySettings& settings);
    [[nodiscard]] Result<BodyState> body_state(BodyId id) const;
    /// Places the body at once; cloth inside its colliders is pushed out.
    Result<void> set_body_state(BodyId id, const BodyState& state);
    /// Attaches the collider to the body: it keeps its place in the body's frame, and can neither be moved
    /// nor placed otherwise. A collider is of one body at most, the last it was attached to. Error: a Plane.
    Result<void> attach_collider(BodyId id, ColliderId collider);
    /// Detaches the collider, which stays where it is, from its body, if it has one.
    Result<void> detach_collider(ColliderId collider);
    /// Attaches vertices to the body, each at its place in the body's frame, where they pull it: all of them
    /// or, with an error, none. A vertex is of one body at most, the last it was attached to. A pin has
    /// precedence. Tethers do not start from attached vertices.
    Result<void> attach(BodyId id, ClothId cloth, std::span<const std::uint32_t> vertices);
    /// Detaches vertices: all of them or, with an error, none. A vertex that is attached to nothing stays so.
    Result<void> detach(ClothId cloth, std::span<const std::uint32_t> vertices);
    /// Impulse of each body in the last step, in the order of their ids. Valid until the next step(),
    /// add_body() or remove_body(). Impulses of a cloth that was put back to the start of the step are
    /// included.
    [[nodiscard]] std::span<const BodyImpulse> body_impulses() const noexcept;

    /// Sews vertices together by a seam, whose k-th stitch joins vertices_a[k] of cloth `a` to vertices_b[k]
    /// of cloth `b`, which may be the same cloth: buttons, patchwork, a sleeve on its shirt. A stitch is a
    /// spring in the cloths' equation, which are solved together: it pulls as hard on one as on the other,
    /// and holds light cloth on heavy as well as heavy on light. It pushes, too, so that it holds cloth at
    /// SeamSettings::rest_length.
    ///
    /// Stitches act on vertices that are pinned or attached as well. Cloth that is switched off
    /// (ClothSettings::enabled) holds what is sewn to it as pins do. Cloths that are joined sleep and wake
    /// together, and take no long steps by WorldSettings::budget. move_cloth() moves one cloth: move all that
    /// are joined before the next step. A cut (recut_cloth) keeps each stitch at the first vertex that comes
    /// from its own. Removing a cloth removes its seams.
    ///
    /// All stitches are made or, with an error, none. Errors: a stale id; a vertex that its cloth does not
    /// have; as many vertices on one side as on the other were not given, or none; a stitch from a vertex to
    /// itself; a setting out of range; a cloth by another method than Multilevel, or by impact zones, whose
    /// equations have no place for stitches. set_cloth_settings() refuses these for cloth that has seams.
    Result<SeamId> stitch(ClothId a, std::span<const std::uint32_t> vertices_a, ClothId b,
                          std::span<const std::uint32_t> vertices_b, const SeamSettings& settings = {});
    /// Removes a seam with all its stitches.
    Result<void> unstitch(SeamId id);
    /// How many stitches hold, and how hard they pulled in the last step. StepReport::broken_stitches counts
    /// those that broke in it.
    [[nodiscard]] Result<SeamInfo> seam_info(SeamId id) const;

    /// Advances by dt seconds, in [least_step, greatest_step], else StepFlags::invalid_dt. Steps may differ
    /// in length: the time scheme keeps its order. It never allocates, and prepares nothing: what a change
    /// needs is made by the call that changes it. While another thread takes a step:
    /// StepFlags::step_under_way.
    const StepReport& step(float dt) noexcept;
    [[nodiscard]] const StepReport& report() const noexcept;
    /// The cloth's part of report(), with the flags that it raised.
    [[nodiscard]] Result<ClothReport> cloth_report(ClothId id) const;

    /// step() in three: begin_step() and end_step() on the host's own thread, and between them work() in one
    /// task of the host's, on any thread, while the host draws. The bytes are those of step(). Calls of one
    /// World are still for one thread at a time, but for these while work() runs: cloth(), write_vertices(),
    /// report(), settings(), cloth_settings(), body_settings(), shape_info(), and those that are refused.
    ///
    /// From begin_step() to end_step() cloth() shows copies: all buffers as the last step left them. report()
    /// is the last step's, too. begin_step() makes the copies, which takes time and, from the first call on,
    /// 64 bytes a particle (step() takes neither). All other calls are refused by their name, step() by
    /// StepFlags::step_under_way. Calls that have no error to return are empty: no contacts, impulses or
    /// stages, a hash and a size of 0, and nothing drawn.
    ///
    /// Errors: a step was begun already; dt out of step()'s range.
    Result<void> begin_step(float dt);
    /// Takes the step that was begun, by all threads of the World. Error: none was begun, or it was taken.
    Result<void> work();
    /// Ends the step: views and report() show its result. If work() was not called, end_step() does its work.
    /// Errors: no step was begun; work() has not returned.
    Result<void> end_step();

    /// Contacts of the last step, out of StepReport::contacts: the strongest that
    /// WorldSettings::contact_reports has room for, and those of triggers, which have no strength, where room
    /// is left. Valid until the next step() or set_settings(). They are in the order of cloths; each cloth's
    /// are first those with cloth, then those with colliders by particle, then those with triggers.
    ///
    /// Impulses are of the whole step. A particle and its colliders are one contact. A pair of features or
    /// particles is one for each substep in which it pushed: a cloth's impulse is the sum. With colliders it
    /// is within 2 %. By SelfCollisionMethod::contact, with the method Multilevel only, few sweeps share the
    /// impulses of features out among pairs: a quarter of what free cloths transmit can be assigned wrongly,
    /// and on pinned cloth it can be many times too much. With Jacobi and ConjugateGradient the residual
    /// counts, too. A cloth put back to the start of the step reports none.
    [[nodiscard]] std::span<const Contact> contacts() const noexcept;

    /// Times of the stages of the step, as a tree (see StageTime), the whole step last; the percentiles are
    /// computed by this call.
    [[nodiscard]] std::span<const StageTime> profile() const;
    /// Starts to record when stages and blocks of parallel loops ran on which thread, up to `max_events` (40
    /// bytes each; 1 to 2^26), for write_trace. An error leaves the trace as it was.
    Result<void> start_trace(std::size_t max_events = 1u << 20);
    /// Writes the trace in Chrome's trace event format, a track for each thread: opens in Perfetto and
    /// chrome://tracing.
    Result<void> write_trace(const std::filesystem::path& file) const;

    /// Draws `parts` on the canvas, as they are after the last step. It takes no memory; only exceptions of
    /// the canvas leave it.
    void debug_draw(const DebugCanvas& canvas, DebugParts parts) const;

    /// Describes all that the World holds, with settings, memory, and each cloth's cost and flags in the last
    /// step: for people, or as JSON, whose keys are the names of this interface.
    [[nodiscard]] Result<std::string> describe(DescriptionFormat format = DescriptionFormat::text) const;

    /// Hash of all that changes from step to step, pins and colliders included: the same for any number of
    /// threads, with the same binary.
    [[nodiscard]] std::uint64_t state_hash() const;

    /// Size of a save in the host's memory [bytes]. It has all that changes from step to step, pins and
    /// colliders included: for going back by some steps, and for saved games. Steps that follow restore()
    /// give the bytes of those that followed save(), on any number of threads and any processor that rounds
    /// alike (guide: threads), whatever was done in between.
    ///
    /// Meshes, shapes and settings are not in it, except for the vertices of deformed shapes. A World that
    /// restores it, this one or one made later, must have the same cloths, shapes and colliders, in the order
    /// of their ids, and the host sets their settings. Pins may differ. A library with another layout refuses
    /// saves by their version.
    [[nodiscard]] std::size_t save_size() const noexcept;
    /// Writes the first save_size() bytes. Error: `to` is shorter.
    Result<void> save(std::span<std::byte> to) const;
    /// Restores a save, exactly the bytes that were written. report() stays the last step's; contacts() is
    /// empty then. Errors, by which nothing changes: a save that is damaged, of another version, or of a
    /// World with other cloths (or other ClothSettings::key), shapes or colliders, or settings by which they
    /// have another state; one that was altered, checksum included, if it names what is not there or has
    /// numbers that are none. Masses stay those of the cloths here.
    Result<void> restore(std::span<const std::byte> saved);
    /// Restores of a World's save only the cloths that are here too, after cloths were added or removed:
    /// those of the same ClothSettings::key, other than 0. Returns how many. All else stays as it is: other
    /// cloths, colliders, bodies, stitches that broke, the time. Errors, by which nothing changes: as of
    /// restore() for a cloth, named by its key, such as one that was cut since; two cloths of one key.
    Result<std::uint32_t> restore_cloths(std::span<const std::byte> saved);

    /// Size of a save of one cloth [bytes]; 0 if the id is stale. It has all that changes of it from step to
    /// step: places and velocities of this step and the last one, pins with their targets, frame, skin,
    /// contact and sleep.
    [[nodiscard]] std::size_t cloth_save_size(ClothId id) const noexcept;
    /// Writes the first cloth_save_size() bytes. Errors: a stale id; `to` is shorter.
    Result<void> save_cloth(ClothId id, std::span<std::byte> to) const;
    /// Restores a save of one cloth, of this cloth or of another one with the same mesh and settings, in any
    /// World. Where no other cloth meets it, and colliders and wind do as they did, the steps that follow
    /// give the bytes of those that followed save_cloth(). What bodies gave the cloth is kept if the World
    /// has as many as it had. Cloth that slept sleeps on: wake() it where what holds it has changed. Where
    /// cloth is here now, the two are separated. Errors, by which nothing changes: a stale id; those of
    /// restore().
    Result<void> restore_cloth(ClothId id, std::span<const std::byte> saved);

    /// Starts to record every call that changes the World, with its arguments, and after each step a hash of
    /// each cloth: see replay(). Not recording costs nothing. A recorded step takes longer by a hash of the
    /// state, some twentieth with the default, and may allocate. Errors: something has changed since the
    /// World was made; it is recorded already; the file cannot be written.
    Result<void> start_recording(const std::filesystem::path& file);
    Result<void> start_recording(const RecordingSink& sink);
    /// Ends the recording, as the World's end does. Errors: nothing is recorded; some of it could not be
    /// written, or had no memory: the recording breaks off there, and the World went on.
    Result<void> stop_recording();

  private:
    friend class Replayer;
    struct Impl;
    explicit World(std::unique_ptr<Impl> impl);
    std::unique_ptr<Impl> impl_;
};

}  // namespace weft
