#pragma once
// The World: cloths, colliders and wind, stepped together.

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <memory>
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
#include "weft/recording.h"
#include "weft/report.h"
#include "weft/settings.h"
#include "weft/shapes.h"
#include "weft/transform.h"
#include "weft/types.h"
#include "weft/vertex_streams.h"

namespace weft {

/// A cloth's buffers, uncopied, in the layout in which they are uploaded. Take it anew after each step or
/// change: an old one can still be read, since its memory is there until the cloth is removed or the World
/// ends, whatever else is called, but positions and previous_positions may have changed places. Particles are
/// numbered by Weft; vertex_to_particle leads there from the mesh's own vertices: see World::write_vertices,
/// too.
struct ClothView {
    std::span<const Vec4> positions{};  ///< x y z [m], w inverse mass [1/kg], 0 for pinned particles
    /// At the start of the last step; blend by FixedStepFrame::alpha.
    std::span<const Vec4> previous_positions{};
    std::span<const Vec4> velocities{};     ///< x y z [m/s]
    std::span<const Vec4> normals{};        ///< x y z, unit length, out of the front of the triangles
    std::span<const Triangle> triangles{};  ///< particle indices
    std::span<const std::uint32_t> vertex_to_particle{};
    std::span<const Vec2> texcoords{};  ///< the mesh's, of its vertices, or none
    /// `triangles` by the mesh's vertices, for an index buffer; of a mesh that is no grid only where it has
    /// texture coordinates.
    std::span<const Triangle> vertex_triangles{};
    Bounds bounds{};  ///< of the positions
};

/// How World::describe() writes.
enum class DescriptionFormat : std::uint8_t { text, json };

/// Not thread-safe, but free of globals: one thread at a time per World, and Worlds are independent of each
/// other.
class WEFT_API World {
  public:
    /// Error: a setting out of range.
    [[nodiscard]] static Result<World> create(const WorldSettings& settings = {});
    World(World&&) noexcept;
    World& operator=(World&&) noexcept;
    ~World();

    [[nodiscard]] const WorldSettings& settings() const noexcept;
    Result<void> set_settings(const WorldSettings& settings);
    /// Writes the air's velocity at points [m/s], as the next step will have it: wind, gusts and sources. For
    /// what drifts in it besides cloth, such as leaves and smoke; takes some 30 ns a point where there are
    /// gusts. Errors: not as many velocities as points; a point that is not finite or beyond 100 km.
    Result<void> sample_air(std::span<const Vec3> points, std::span<Vec3> velocities) const;

    /// Makes particles, springs and solver memory from the mesh, as CookedCloth::create() does, for this
    /// cloth alone; the mesh is not kept.
    Result<ClothId> add_cloth(const Mesh& mesh, const ClothSettings& settings = {});
    /// Another cloth of it, with the settings that it was made with, moved from where its mesh lies: the same
    /// cloth as by the mesh, but that it copies its state alone, and shares what is constant. It does not
    /// need the CookedCloth any more. Errors: the rotation is none, or a vertex would be out of the 100 km
    /// around the origin.
    Result<ClothId> add_cloth(const CookedCloth& cooked, const Transform& place = {});
    /// What cloth_info would say of it; nothing is added. Takes as long as add_cloth, and the memory
    /// meanwhile.
    [[nodiscard]] Result<ClothInfo> measure_cloth(const Mesh& mesh, const ClothSettings& settings = {}) const;
    Result<void> remove_cloth(ClothId id);
    /// From here on the cloth is of this mesh, as one that was cut (cut_mesh): it keeps its id, its settings
    /// and how it lies and moves. `from[v]` is the vertex, of the mesh that it was of, that vertex v comes
    /// from: it gets that one's place, velocity, pin, body, place on the skin and values of maps. What it
    /// rests at, and its mass, are those of the new mesh. By contact, particles that come from one are put
    /// apart by some 0.4 % of an edge, into their own triangles, or they would rub each other. It takes as
    /// long as add_cloth(); where nothing changes, nothing of the cloth's motion does. Its spans end as by
    /// remove_cloth(), a DrawnMesh has to be bound anew, and saves from before are not restored any more.
    /// Errors: as add_cloth(); another length of `from` than the mesh has vertices, a vertex in it that the
    /// cloth does not have, vertices of one particle that come from several.
    Result<void> recut_cloth(ClothId id, const Mesh& mesh, std::span<const std::uint32_t> from);
    /// Edges that are longer than at rest by more than this part, those that are strained most first: as many
    /// as there is room for. Of a sheet, those along its threads. Returns how many were written. Error: a
    /// strain that is not a number from -1.
    [[nodiscard]] Result<std::uint32_t> strained_edges(ClothId id, float strain,
                                                       std::span<StrainedEdge> to) const;
    [[nodiscard]] Result<ClothSettings> cloth_settings(ClothId id) const;
    Result<void> set_cloth_settings(ClothId id, const ClothSettings& settings);
    /// ClothSettings::enabled, at no cost: for what is out of sight. Switched on, cloth begins from rest
    /// where it was left, or where its pins, bodies and skin are now, and finds its way out of what is there.
    Result<void> set_enabled(ClothId id, bool on);
    /// See ClothSettings::sleep_speed.
    [[nodiscard]] Result<bool> is_asleep(ClothId id) const;
    Result<void> wake(ClothId id);
    /// ClothSettings::priority and view_distance, at no cost: once a frame, for WorldSettings::budget.
    Result<void> set_importance(ClothId id, float priority, float view_distance);
    [[nodiscard]] Result<ClothInfo> cloth_info(ClothId id) const;
    /// The view is the World's own, so that `for (const Vec4& p : world.cloth(id)->positions)` is sound; the
    /// next call for the same cloth writes it anew. When the cloth is removed it becomes empty, and may later
    /// be another's; it ends with the World, not when that moves. Spans that were copied end with the cloth.
    [[nodiscard]] Result<const ClothView&> cloth(ClothId id) const;
    /// Writes vertices [first, first + count), those there are, as a renderer wants them: by the mesh's own
    /// numbers, into the host's memory, each kind that is asked for. It only writes there, allocates nothing,
    /// and copies, but for tangents and previous normals, which are made of the triangles round each vertex
    /// and take many times as long: `weft_bench --calls`. Threads may share the vertices, and draw from
    /// begin_step() to end_step() what the last step left: calls of it may run side by side, and beside
    /// work(). Errors: a stream of less room than all vertices take, or whose stride is less than a value;
    /// texture coordinates or tangents of a cloth whose mesh has no texture coordinates.
    Result<void> write_vertices(ClothId id, const VertexStreams& to, std::size_t first = 0,
                                std::size_t count = SIZE_MAX) const;

    /// Holds particles where they are, until move_pin or unpin: all of them or, with an error, none. Vertices
    /// are those of the mesh that was given; one that is pinned already stays so. With tethers on,
    /// the first change after a step measures the cloth; if there are more before the next step, that step
    /// measures it once more.
    Result<void> pin(ClothId id, std::span<const std::uint32_t> vertices);
    Result<void> pin(ClothId id, std::uint32_t vertex) { return pin(id, {&vertex, 1}); }
    /// The pinned vertex moves to `target` [m] straight over the next step; where the cloth is off, at once.
    Result<void> move_pin(ClothId id, std::uint32_t vertex, const Vec3& target);
    /// Each vertex to the target of its number: all of them or, with an error, none. For what an animation
    /// holds; it takes no memory.
    Result<void> move_pins(ClothId id, std::span<const std::uint32_t> vertices,
                           std::span<const Vec3> targets);
    /// All of them or, with an error, none. A vertex that is not pinned stays free.
    Result<void> unpin(ClothId id, std::span<const std::uint32_t> vertices);
    Result<void> unpin(ClothId id, std::uint32_t vertex) { return unpin(id, {&vertex, 1}); }

    /// Teleports the cloth, with its pins, their targets, its skin and its frame: it keeps its shape, and how
    /// it moves within it, and gets no velocity. Its last positions go along, so that a blend of the two
    /// shows no way. Colliders and other cloths stay; what it then crosses is let apart, what it is then
    /// inside of puts it out. The rotation is about the World's origin. Errors: the rotation is none, or a
    /// vertex would be out of the 100 km around the origin.
    Result<void> move_cloth(ClothId id, const Transform& by);

    /// For cloth on what moves: a character, a vehicle. The first call says where the cloth's frame is and
    /// moves nothing; by each later one it goes there over the next step. A step in which it is not told
    /// where to go it stands still. By ClothSettings::frame_inertia the cloth then feels the frame's
    /// acceleration: all of it where each is 1, as cloth does that knows of no frame; none where each is 0,
    /// as though the frame stood still, with gravity and wind as they are in the World.
    ///
    /// Before a step the cloth is carried by what of the frame's way it is not to feel (1 - linear of the way
    /// of its origin, 1 - angular of its turn), its velocities turned with it: they, too, are without that
    /// part. Pins are where they are told to be. Colliders go relative to the cloth as they do to the frame,
    /// so that a body that moves with it rubs and pushes nothing. Cloths that touch want the same frame and
    /// inertia: what one is carried across crosses, and is let apart. A turn in one step is the shorter way
    /// round; a jump is move_cloth's. Errors: a rotation that is none, a place beyond 100 km.
    Result<void> set_frame(ClothId id, const Transform& pose);
    /// As before the first set_frame().
    Result<void> leave_frame(ClothId id);

    /// A number for each vertex, or none, which takes the map away. It is not saved. Errors: values of
    /// another count than the mesh's vertices; a value out of the map's range, by its vertex; a backstop that
    /// begins beyond the leash.
    Result<void> set_map(ClothId id, Map map, std::span<const float> values);
    /// Where each vertex would be if it were part of what the cloth is worn on, and the normal there, out of
    /// it, of any length: once a step, for leashes and backstops (Map). The first call says where that is,
    /// and cloth beyond its limits is teleported there as a whole, with the pins that the host has not moved
    /// since the last step; by later calls it goes there over the next step. The last of welded vertices
    /// counts. Normals are needed by backstops only. Later calls take no memory.
    ///
    /// A step ends with every free particle within its leash and out of its backstop, but for rounding; both
    /// are smooth. They are in the equation of implicit methods, as colliders are, and come after colliders.
    /// Pins come before them; so does by SelfCollisionMethod::contact, and by impact zones, that cloth does
    /// not cross: StepReport::limits_exceeded says where that kept one. Errors name the vertex; or no map of
    /// leashes or backstops is set.
    Result<void> set_skin(ClothId id, std::span<const Vec3> places, std::span<const Vec3> normals);

    /// Makes `to` the World's new origin: all that is in it, gusts too, gets coordinates less by that, and
    /// nothing else changes. Single precision has steps of 8 mm at 100 km, and of 0.06 mm at 1 km. So keep
    /// the World's origin near the camera, by whole metres whenever that is some 500 m away, and add the sum
    /// of all `to`, in double precision, to what the World gives out. Poses and targets are then given less
    /// that sum. Saves have coordinates by the origin that there was. Error: something would be out of the
    /// 100 km around the new origin.
    Result<void> shift_origin(const Vec3& to);

    /// Takes a copy of a shape, of which colliders are then placed (PlacedShape). Errors name the vertex, the
    /// triangle, or what is not closed.
    Result<ShapeId> add_shape(const Shape& shape);
    /// A TriangleMesh's vertices move, the triangles stay: all colliders of it are so at once, and push and
    /// drag what they meet in the next step at the speed with which vertices get there. As many as it was
    /// made of.
    Result<void> deform_shape(ShapeId id, std::span<const Vec3> vertices);
    /// Error: a collider is an instance of it.
    Result<void> remove_shape(ShapeId id);
    [[nodiscard]] Result<ShapeInfo> shape_info(ShapeId id) const;

    /// The first of a World gives each cloth 26 bytes a particle more, one of an implicit method 90.
    Result<ColliderId> add_collider(const Collider& collider);
    /// The collider moves there over the next step, and pushes and drags what it meets, where it ends and on
    /// the way, with WorldSettings::max_speed at most: one that is to go faster jumps, and meets nothing on
    /// the way. The same kind of shape; an instance stays one of its own.
    Result<void> move_collider(ColliderId id, const Collider& target);
    /// The collider is there at once, without a velocity: what it comes to hold comes outside at a limited
    /// speed (see ColliderResponse), and is neither pushed nor dragged. The same kind of shape, likewise.
    Result<void> place_collider(ColliderId id, const Collider& place);
    Result<void> remove_collider(ColliderId id);
    [[nodiscard]] Result<Collider> collider(ColliderId id) const;

    /// A body that cloth moves, and Weft with it: in each step it falls, turns, and gets back what its
    /// colliders and the vertices attached to it give cloth. A body meets cloth only: what it does on the
    /// World's other colliders, and to other bodies, is for the host's engine. A host whose engine moves it
    /// sets the body's state before each step, takes body_impulses() after it, and lets its engine do the
    /// rest.
    ///
    /// With Multilevel, the default, bodies are unknowns of the cloth's equation: stable from a hundredth to
    /// a hundred times the cloth's mass. Cloth that is pinned, or that a body presses onto a collider, stops
    /// the body. With other methods they get what the step gave particles that touch them, which holds up
    /// little but what is much lighter than these. By ColliderResponse::velocity_filter they get nothing.
    ///
    /// Cloths that may meet the same body are solved with it as one equation: those with
    /// SelfCollisionMethod::contact, and those without it. The two, and cloths of another method, of other
    /// ClothSettings::substeps, time scheme or in a frame, are solved in turn, each expecting of the others
    /// what they gave last: that wants a body that is not much lighter than the cloths. Cloths of one
    /// equation and bodies that nothing else holds keep their momentum together to rounding. Bodies meet
    /// neither one another nor the World's other colliders: the host's engine does that.
    ///
    /// Each gives every cloth 192 bytes; the first of a World also 100 bytes a particle, and what a first
    /// collider does.
    Result<BodyId> add_body(const BodySettings& settings, const BodyState& state = {});
    /// Its colliders stay where they are, its vertices are let go.
    Result<void> remove_body(BodyId id);
    [[nodiscard]] Result<BodySettings> body_settings(BodyId id) const;
    Result<void> set_body_settings(BodyId id, const BodySettings& settings);
    [[nodiscard]] Result<BodyState> body_state(BodyId id) const;
    /// The body is there at once; what its colliders come to hold is put outside.
    Result<void> set_body_state(BodyId id, const BodyState& state);
    /// From here on the body carries the collider, which keeps its place in the body's frame, and neither
    /// moves nor is placed otherwise. A collider is of one body at most, the last it was attached to.
    Result<void> attach_collider(BodyId id, ColliderId collider);
    /// It stays where it is. Of no body, none.
    Result<void> detach_collider(ColliderId collider);
    /// From here on vertices go with the body, each at its place in the body's frame, and pull it: all of
    /// them or, with an error, none. A vertex is of one body at most, the last it was attached to. While it
    /// is pinned the pin holds it. Tethers do not start from it.
    Result<void> attach(BodyId id, ClothId cloth, std::span<const std::uint32_t> vertices);
    /// All of them or, with an error, none. What is attached to nothing stays so.
    Result<void> detach(ClothId cloth, std::span<const std::uint32_t> vertices);
    /// Of each body, in the order of their ids, what it got in the last step. Valid until the next step(),
    /// add_body() or remove_body(). What a cloth gave that was put back to the start of the step is in it.
    [[nodiscard]] std::span<const BodyImpulse> body_impulses() const noexcept;

    /// Advances by dt seconds, in [least_step, greatest_step], else StepFlags::invalid_dt. Steps may differ
    /// in length: the time scheme keeps its order. It never allocates, and prepares nothing: what a change
    /// needs is made by the call that changes it. Beside another thread's: StepFlags::step_under_way.
    const StepReport& step(float dt) noexcept;
    [[nodiscard]] const StepReport& report() const noexcept;
    /// What the cloth had of the last step; which cloth raised which flag.
    [[nodiscard]] Result<ClothReport> cloth_report(ClothId id) const;

    /// step() in three: begin_step() and end_step() on the host's own thread, and between them work() in one
    /// task of the host's, on any thread, while the host draws. Same bytes as by step(). Calls of one World
    /// still are one thread's at a time, but for these while work() runs: cloth(), write_vertices(),
    /// report(), settings(), cloth_settings(), body_settings(), shape_info(), and those that are refused.
    ///
    /// From begin_step() to end_step() a cloth()'s view shows copies: all buffers as the last step left them.
    /// report() is the last step's, too. begin_step() makes the copies: it takes the time, and from the first
    /// call on the memory, of 64 bytes a particle (step() takes neither). All other calls are refused by
    /// their name, step() by StepFlags::step_under_way; those that have no error to give give nothing: no
    /// contacts, impulses or stages, a hash and a size of 0, and nothing drawn.
    ///
    /// Errors: a step was begun already; dt out of step()'s range.
    Result<void> begin_step(float dt);
    /// Takes the step that was begun, by all threads of the World. Error: none was begun, or it was taken.
    Result<void> work();
    /// Shows what the step came to; views and report() are of it. What work() was not called for it does
    /// itself. Errors: no step was begun; work() has not returned.
    Result<void> end_step();

    /// What touched what in the last step, and how hard: the strongest that WorldSettings::contact_reports
    /// has room for, of StepReport::contacts; triggers', which have no strength, where there is room left.
    /// Valid until the next step() or set_settings(). In the order of cloths; of each first what it has with
    /// cloth, then with colliders by particle, then with triggers.
    ///
    /// Impulses are of the whole step. A particle and its colliders are one contact; a pair of features or
    /// particles is one for each substep in which it pushed: what a cloth got is the sum. With colliders it
    /// is within 2 %. What features by SelfCollisionMethod::contact, of cloths of the method Multilevel only,
    /// get is shared out among pairs by few sweeps: a quarter of what cloths that are free pass on can go
    /// astray, and on pinned cloth it can be many times too much. With Jacobi and ConjugateGradient, what
    /// they leave unsolved counts, too. A cloth put back to the start of the step reports none.
    [[nodiscard]] std::span<const Contact> contacts() const noexcept;

    /// Times of the stages of the step, as a tree (see StageTime), the whole step last; the percentiles are
    /// computed by this call.
    [[nodiscard]] std::span<const StageTime> profile() const;
    /// Keeps from here on when stages and blocks of parallel loops ran on which thread, up to `max_events`
    /// (40 bytes each; 1 to 2^26), for write_trace. An error leaves the trace as it was.
    Result<void> start_trace(std::size_t max_events = 1u << 20);
    /// Chrome's trace event format, a track for each thread: opens in Perfetto and chrome://tracing.
    Result<void> write_trace(const std::filesystem::path& file) const;

    /// Calls the canvas with what is asked for, as it is after the last step: it takes no memory, and as long
    /// as it takes to draw. Only exceptions of the canvas leave it.
    void debug_draw(const DebugCanvas& canvas, DebugParts parts) const;

    /// All that it holds, with settings, memory, what each cost in the last step, and the flags that each
    /// raised: for people, or as JSON, whose keys are the names of this interface.
    [[nodiscard]] Result<std::string> describe(DescriptionFormat format = DescriptionFormat::text) const;

    /// Of all that changes from step to step, pins and colliders included: the same for any number of
    /// threads, with the same binary.
    [[nodiscard]] std::uint64_t state_hash() const;

    /// All that changes from step to step, pins and colliders included, in the host's memory: for going back
    /// by some steps, and for saved games. Steps that follow restore() give the bytes of those that followed
    /// save(), on any number of threads and any processor, whatever was done in between.
    ///
    /// Meshes, shapes and settings are not in it, but for the vertices of deformed shapes. The World it is
    /// put back into, this one or one made later, has the same cloths, shapes and colliders, in the order of
    /// their ids, and the host sets the settings that they had. Pins may be others. A library that lays saves
    /// out otherwise refuses them by their version.
    [[nodiscard]] std::size_t save_size() const noexcept;
    /// Writes the first save_size() bytes. Error: `to` is shorter.
    Result<void> save(std::span<std::byte> to) const;
    /// Takes exactly the bytes that were written. report() stays the last step's; contacts() are none.
    /// Errors, by which nothing changes: a save that is damaged, of another version, or of a World with other
    /// cloths, shapes or colliders, or settings by which they have another state; one that somebody has
    /// changed, checksum and all, if what it names is not there or its numbers are none. Masses stay those of
    /// the cloths here.
    Result<void> restore(std::span<const std::byte> saved);

    /// From here on writes down every call that changes the World, with all that it is given, and after each
    /// step a hash of each cloth: see replay(). Not recording costs nothing. A recorded step takes longer by
    /// a hash of the state, some twentieth with the default, and may allocate. Errors: something has changed
    /// since the World was made; it is recorded already; the file cannot be written.
    Result<void> start_recording(const std::filesystem::path& file);
    Result<void> start_recording(const RecordingSink& sink);
    /// So does the World's end. Errors: nothing is recorded; some of it could not be written, or had no
    /// memory: the recording breaks off there, and the World went on.
    Result<void> stop_recording();

  private:
    friend class Replayer;
    struct Impl;
    explicit World(std::unique_ptr<Impl> impl);
    std::unique_ptr<Impl> impl_;
};

}  // namespace weft
