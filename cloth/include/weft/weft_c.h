#pragma once
// Weft for C, and for whatever calls C: one header, C99. It needs the C library alone, and compiles as C++98
// and later, too.
//
//   WeftWorld* world;
//   WeftMesh* sheet;
//   WeftClothId cloth;
//   if (weft_world_create(NULL, &world) || weft_mesh_make_sheet(NULL, &sheet) ||
//       weft_world_add_cloth(world, sheet, NULL, &cloth))
//       fail(weft_error_text());
//   for (;;) {
//       weft_world_step(world, 1.0f / 60.0f);
//       weft_world_write_vertices(world, cloth, &streams, 0, SIZE_MAX);  // into buffers of your own
//   }
//
// Each function and struct is the one of its name in the C++ headers, which say what it does, takes and
// refuses: weft_world_add_cloth is World::add_cloth. Where they differ:
//
// - A call that can fail returns a WeftResult, 0 for success, and writes its result through its last pointer.
//   Nothing throws. Settings and places that are null pointers are the defaults. Any other null pointer is an
//   error; calls that return no WeftResult take null for an empty object.
// - A struct that begins with struct_size can grow at its end in later versions: the size says which version
//   the host was compiled with. Structs with an _init function get it there, with all defaults; for the
//   others set struct_size and leave the rest 0: `WeftHooks hooks = {.struct_size = sizeof hooks}`. Fields
//   that a host does not know keep their defaults. All other structs stay as they are within one 0.x of the
//   version.
// - A pointer that a call returns belongs to Weft. It is valid as long as the C++ span or view is.

#include "weft/c/reports.h"
#include "weft/c/settings.h"
#include "weft/c/values.h"

#ifdef __cplusplus
extern "C" {
#endif

// Message of the last call on this thread that failed, "" before one has. It names the value and what would
// be right.
WEFT_API const char* weft_error_text(void);

// Sets all defaults. struct_size: sizeof of the struct, as the host has it.
WEFT_API void weft_world_settings_init(WeftWorldSettings* settings, size_t struct_size);
WEFT_API void weft_cloth_settings_init(WeftClothSettings* settings, size_t struct_size);
WEFT_API void weft_method_init(WeftMethod* method, int32_t kind);
WEFT_API void weft_collider_init(WeftCollider* collider, size_t struct_size, int32_t kind);
WEFT_API void weft_shape_init(WeftShape* shape, size_t struct_size, int32_t kind);
WEFT_API void weft_body_settings_init(WeftBodySettings* settings, size_t struct_size);
WEFT_API void weft_seam_settings_init(WeftSeamSettings* settings, size_t struct_size);
WEFT_API void weft_body_state_init(WeftBodyState* state, size_t struct_size);
WEFT_API void weft_sheet_settings_init(WeftSheetSettings* settings, size_t struct_size);
WEFT_API void weft_proxy_settings_init(WeftProxySettings* settings, size_t struct_size);
WEFT_API void weft_drawn_mesh_settings_init(WeftDrawnMeshSettings* settings, size_t struct_size);
WEFT_API void weft_fixed_step_settings_init(WeftFixedStepSettings* settings, size_t struct_size);
// Sets the identity, which moves nothing.
WEFT_API void weft_transform_init(WeftTransform* transform);

// Numbers of settings with their ranges: numbers_of(). Writes the first `room` of them, and how many there
// are.
WEFT_API WeftResult weft_cloth_settings_numbers(WeftClothSettings* settings, WeftSettingNumber* numbers,
                                                size_t room, size_t* count);
WEFT_API WeftResult weft_world_settings_numbers(WeftWorldSettings* settings, WeftSettingNumber* numbers,
                                                size_t room, size_t* count);

// Fabrics by name.
WEFT_API const WeftNamedFabric* weft_fabrics(size_t* count);
WEFT_API WeftResult weft_fabric_named(const char* name, WeftFabric* fabric);
// Returns the time scheme that settings resolve to: WEFT_TIME_BACKWARD_EULER or WEFT_TIME_BDF2;
// WEFT_TIME_OF_METHOD if the call fails.
WEFT_API int32_t weft_resolved_time_scheme(const WeftClothSettings* settings);

// Meshes, which copy the data that they are made of. File names are UTF-8.
WEFT_API WeftResult weft_mesh_create(const WeftMeshView* of, WeftMesh** mesh);
WEFT_API WeftResult weft_mesh_make_sheet(const WeftSheetSettings* settings, WeftMesh** mesh);
// report may be null. texcoords_are_pattern: ObjOptions.
WEFT_API WeftResult weft_mesh_load_obj(const char* file, WeftBool texcoords_are_pattern,
                                       WeftObjReport* report, WeftMesh** mesh);
// report may be null.
WEFT_API WeftResult weft_mesh_make_proxy(const WeftMesh* fine, const WeftProxySettings* settings,
                                         WeftProxyReport* report, WeftMesh** mesh);
WEFT_API WeftResult weft_mesh_save_obj(const WeftMesh* mesh, const char* file);
WEFT_API WeftResult weft_mesh_view(const WeftMesh* mesh, WeftMeshView* view);
WEFT_API void weft_mesh_destroy(WeftMesh* mesh);

// Cuts and tears. A mesh that was cut holds MeshCut::from, which weft_world_recut_cloth uses.
WEFT_API WeftResult weft_cut_mesh(const WeftMesh* mesh, const WeftMeshEdge* edges, size_t count,
                                  WeftMesh** cut);
WEFT_API const uint32_t* weft_mesh_cut_from(const WeftMesh* cut, size_t* count);
WEFT_API uint32_t weft_mesh_added_particles(const WeftMesh* cut);
WEFT_API WeftResult weft_cut_stroke_create(WeftCutStroke** stroke);
WEFT_API void weft_cut_stroke_destroy(WeftCutStroke* stroke);
// Positions are three floats each. The edges are valid until the next call with this stroke.
WEFT_API WeftResult weft_edges_along(const WeftMesh* mesh, WeftInput positions, const WeftBlade* blade,
                                     WeftCutStroke* stroke, const WeftMeshEdge** edges, size_t* count);
// Writes as many edges as there is room for; found: how many there are.
WEFT_API WeftResult weft_edges_to_tear(const WeftMesh* mesh, WeftInput positions,
                                       const WeftStrainedEdge* strained, size_t count, WeftMeshEdge* to,
                                       size_t room, size_t* found);

// Cloth that is cooked once.
WEFT_API WeftResult weft_cooked_cloth_create(const WeftMesh* mesh, const WeftClothSettings* settings,
                                             const WeftCookProgress* progress, WeftCookedCloth** cooked);
WEFT_API WeftResult weft_cooked_cloth_load(const void* saved, size_t bytes, const WeftClothSettings* settings,
                                           WeftCookedCloth** cooked);
// From an address that is a multiple of 64 nothing is copied.
WEFT_API WeftResult weft_cooked_cloth_load_in_place(const void* saved, size_t bytes, const WeftLender* lender,
                                                    const WeftClothSettings* settings,
                                                    WeftCookedCloth** cooked);
WEFT_API WeftResult weft_cooked_cloth_info(const WeftCookedCloth* cooked, WeftClothInfo* info);
WEFT_API WeftResult weft_cooked_cloth_report(const WeftCookedCloth* cooked, WeftCookReport* report);
WEFT_API size_t weft_cooked_cloth_save_size(const WeftCookedCloth* cooked);
WEFT_API WeftResult weft_cooked_cloth_save(const WeftCookedCloth* cooked, void* to, size_t bytes);
WEFT_API void weft_cooked_cloth_destroy(WeftCookedCloth* cooked);

// The World: one thread at a time per World.
WEFT_API WeftResult weft_world_create(const WeftWorldSettings* settings, WeftWorld** world);
WEFT_API void weft_world_destroy(WeftWorld* world);
WEFT_API WeftResult weft_world_settings(const WeftWorld* world, WeftWorldSettings* settings);
WEFT_API WeftResult weft_world_set_settings(WeftWorld* world, const WeftWorldSettings* settings);

// Points are three floats each, and so are the velocities that are written.
WEFT_API WeftResult weft_world_sample_air(const WeftWorld* world, WeftInput points, WeftStream velocities);

WEFT_API WeftResult weft_world_add_cloth(WeftWorld* world, const WeftMesh* mesh,
                                         const WeftClothSettings* settings, WeftClothId* id);
WEFT_API WeftResult weft_world_add_cooked_cloth(WeftWorld* world, const WeftCookedCloth* cooked,
                                                const WeftTransform* place, WeftClothId* id);
WEFT_API WeftResult weft_world_measure_cloth(const WeftWorld* world, const WeftMesh* mesh,
                                             const WeftClothSettings* settings, WeftClothInfo* info);
// only: a cloth, or null for all. *found is 0, and *point stays, if there is no such place.
WEFT_API WeftResult weft_world_cast_ray(const WeftWorld* world, WeftVec3 from, WeftVec3 direction,
                                        float reach, WeftClothId only, WeftClothPoint* point,
                                        WeftBool* found);
WEFT_API WeftResult weft_world_closest_point(const WeftWorld* world, WeftVec3 to, float within,
                                             WeftClothId only, WeftClothPoint* point, WeftBool* found);
// found: how many there are, which may be more than the room.
WEFT_API WeftResult weft_world_triangles_in_ball(const WeftWorld* world, WeftVec3 center, float radius,
                                                 WeftClothId only, WeftClothPoint* to, size_t room,
                                                 size_t* found);
WEFT_API WeftResult weft_world_remove_cloth(WeftWorld* world, WeftClothId id);
WEFT_API WeftResult weft_world_recut_cloth(WeftWorld* world, WeftClothId id, const WeftMesh* cut);
WEFT_API WeftResult weft_world_strained_edges(const WeftWorld* world, WeftClothId id, float strain,
                                              WeftStrainedEdge* to, size_t room, uint32_t* written);
WEFT_API WeftResult weft_world_cloth_settings(const WeftWorld* world, WeftClothId id,
                                              WeftClothSettings* settings);
WEFT_API WeftResult weft_world_set_cloth_settings(WeftWorld* world, WeftClothId id,
                                                  const WeftClothSettings* settings);
WEFT_API WeftResult weft_world_set_enabled(WeftWorld* world, WeftClothId id, WeftBool on);
WEFT_API WeftResult weft_world_is_asleep(const WeftWorld* world, WeftClothId id, WeftBool* asleep);
WEFT_API WeftResult weft_world_wake(WeftWorld* world, WeftClothId id);
WEFT_API WeftResult weft_world_set_importance(WeftWorld* world, WeftClothId id, float importance);
WEFT_API WeftResult weft_world_add_level(WeftWorld* world, WeftClothId finest, WeftClothId coarser,
                                         float reach);
WEFT_API WeftResult weft_world_set_level(WeftWorld* world, WeftClothId id, uint32_t level);
WEFT_API WeftResult weft_world_level(const WeftWorld* world, WeftClothId id, uint32_t* level);
WEFT_API WeftResult weft_world_filling_info(const WeftWorld* world, WeftClothId id, WeftFillingInfo* info);
WEFT_API WeftResult weft_world_cloth_info(const WeftWorld* world, WeftClothId id, WeftClothInfo* info);
WEFT_API WeftResult weft_world_cloth(const WeftWorld* world, WeftClothId id, WeftClothView* view);
WEFT_API WeftResult weft_world_write_vertices(const WeftWorld* world, WeftClothId id,
                                              const WeftVertexStreams* to, size_t first, size_t count);

// Targets, places and normals are three floats each.
WEFT_API WeftResult weft_world_pin(WeftWorld* world, WeftClothId id, const uint32_t* vertices, size_t count);
WEFT_API WeftResult weft_world_move_pin(WeftWorld* world, WeftClothId id, uint32_t vertex, WeftVec3 target);
WEFT_API WeftResult weft_world_move_pins(WeftWorld* world, WeftClothId id, const uint32_t* vertices,
                                         size_t count, WeftInput targets);
WEFT_API WeftResult weft_world_unpin(WeftWorld* world, WeftClothId id, const uint32_t* vertices,
                                     size_t count);
WEFT_API WeftResult weft_world_move_cloth(WeftWorld* world, WeftClothId id, const WeftTransform* by);
// positions: three floats for each vertex.
WEFT_API WeftResult weft_world_reset_cloth(WeftWorld* world, WeftClothId id, WeftInput positions);
WEFT_API WeftResult weft_world_resume_cloth(WeftWorld* world, WeftClothId id, WeftInput positions,
                                            WeftInput previous_positions, WeftInput velocities);
WEFT_API WeftResult weft_world_set_frame(WeftWorld* world, WeftClothId id, const WeftTransform* pose);
WEFT_API WeftResult weft_world_leave_frame(WeftWorld* world, WeftClothId id);
// map: WEFT_MAP_...; values are floats, or none.
WEFT_API WeftResult weft_world_set_map(WeftWorld* world, WeftClothId id, int32_t map, WeftInput values);
WEFT_API WeftResult weft_world_set_skin(WeftWorld* world, WeftClothId id, WeftInput places,
                                        WeftInput normals);
WEFT_API WeftResult weft_world_shift_origin(WeftWorld* world, WeftVec3 to);

WEFT_API WeftResult weft_world_add_shape(WeftWorld* world, const WeftShape* shape, WeftShapeId* id);
WEFT_API WeftResult weft_world_deform_shape(WeftWorld* world, WeftShapeId id, WeftInput vertices);
WEFT_API WeftResult weft_world_remove_shape(WeftWorld* world, WeftShapeId id);
WEFT_API WeftResult weft_world_shape_info(const WeftWorld* world, WeftShapeId id, WeftShapeInfo* info);
WEFT_API WeftResult weft_world_add_collider(WeftWorld* world, const WeftCollider* collider,
                                            WeftColliderId* id);
WEFT_API WeftResult weft_world_move_collider(WeftWorld* world, WeftColliderId id, const WeftCollider* target);
WEFT_API WeftResult weft_world_place_collider(WeftWorld* world, WeftColliderId id, const WeftCollider* place);
WEFT_API WeftResult weft_world_remove_collider(WeftWorld* world, WeftColliderId id);
WEFT_API WeftResult weft_world_collider(const WeftWorld* world, WeftColliderId id, WeftCollider* collider);

WEFT_API WeftResult weft_world_add_body(WeftWorld* world, const WeftBodySettings* settings,
                                        const WeftBodyState* state, WeftBodyId* id);
WEFT_API WeftResult weft_world_remove_body(WeftWorld* world, WeftBodyId id);
WEFT_API WeftResult weft_world_body_settings(const WeftWorld* world, WeftBodyId id,
                                             WeftBodySettings* settings);
WEFT_API WeftResult weft_world_set_body_settings(WeftWorld* world, WeftBodyId id,
                                                 const WeftBodySettings* settings);
WEFT_API WeftResult weft_world_body_state(const WeftWorld* world, WeftBodyId id, WeftBodyState* state);
WEFT_API WeftResult weft_world_set_body_state(WeftWorld* world, WeftBodyId id, const WeftBodyState* state);
WEFT_API WeftResult weft_world_attach_collider(WeftWorld* world, WeftBodyId id, WeftColliderId collider);
WEFT_API WeftResult weft_world_detach_collider(WeftWorld* world, WeftColliderId collider);
WEFT_API WeftResult weft_world_attach(WeftWorld* world, WeftBodyId id, WeftClothId cloth,
                                      const uint32_t* vertices, size_t count);
WEFT_API WeftResult weft_world_detach(WeftWorld* world, WeftClothId cloth, const uint32_t* vertices,
                                      size_t count);
WEFT_API const WeftBodyImpulse* weft_world_body_impulses(const WeftWorld* world, size_t* count);

// Joins `count` vertices of each cloth pairwise. Null settings: the defaults.
WEFT_API WeftResult weft_world_stitch(WeftWorld* world, WeftClothId a, const uint32_t* vertices_a,
                                      WeftClothId b, const uint32_t* vertices_b, size_t count,
                                      const WeftSeamSettings* settings, WeftSeamId* id);
WEFT_API WeftResult weft_world_unstitch(WeftWorld* world, WeftSeamId id);
WEFT_API WeftResult weft_world_seam_info(const WeftWorld* world, WeftSeamId id, WeftSeamInfo* info);

// Errors: dt out of range; a step is under way. All other problems are in the report's flags.
WEFT_API WeftResult weft_world_step(WeftWorld* world, float dt);
WEFT_API WeftResult weft_world_report(const WeftWorld* world, WeftStepReport* report);
WEFT_API WeftResult weft_world_cloth_report(const WeftWorld* world, WeftClothId id, WeftClothReport* report);
// The error text of weft_world_work is that of the thread that calls it.
WEFT_API WeftResult weft_world_begin_step(WeftWorld* world, float dt);
WEFT_API WeftResult weft_world_work(WeftWorld* world);
WEFT_API WeftResult weft_world_end_step(WeftWorld* world);
WEFT_API const WeftContact* weft_world_contacts(const WeftWorld* world, size_t* count);

WEFT_API const WeftStageTime* weft_world_profile(const WeftWorld* world, size_t* count);
WEFT_API WeftResult weft_world_start_trace(WeftWorld* world, size_t max_events);
WEFT_API WeftResult weft_world_write_trace(const WeftWorld* world, const char* file);
// parts: WEFT_DRAW_..., several by |.
WEFT_API WeftResult weft_world_debug_draw(const WeftWorld* world, const WeftDebugCanvas* canvas,
                                          uint32_t parts);
// format: WEFT_DESCRIBE_...; the text is valid until the next call of this function for this World.
WEFT_API WeftResult weft_world_describe(WeftWorld* world, int32_t format, const char** text);

WEFT_API uint64_t weft_world_state_hash(const WeftWorld* world);
WEFT_API size_t weft_world_save_size(const WeftWorld* world);
WEFT_API WeftResult weft_world_save(const WeftWorld* world, void* to, size_t bytes);
WEFT_API WeftResult weft_world_restore(WeftWorld* world, const void* saved, size_t bytes);
// restored: number of cloths; may be null.
WEFT_API WeftResult weft_world_restore_cloths(WeftWorld* world, const void* saved, size_t bytes,
                                              uint32_t* restored);
WEFT_API size_t weft_world_cloth_save_size(const WeftWorld* world, WeftClothId id);
WEFT_API WeftResult weft_world_save_cloth(const WeftWorld* world, WeftClothId id, void* to, size_t bytes);
WEFT_API WeftResult weft_world_restore_cloth(WeftWorld* world, WeftClothId id, const void* saved,
                                             size_t bytes);

WEFT_API WeftResult weft_world_start_recording(WeftWorld* world, const char* file);
WEFT_API WeftResult weft_world_start_recording_to(WeftWorld* world, const WeftRecordingSink* sink);
WEFT_API WeftResult weft_world_stop_recording(WeftWorld* world);
// threads: ReplayOptions.
WEFT_API WeftResult weft_replay_file(const char* file, int32_t threads, WeftReplay* replay);
WEFT_API WeftResult weft_replay_bytes(const void* recording, size_t bytes, int32_t threads,
                                      WeftReplay* replay);

// A fine mesh that is drawn over a cloth. It is bound to a cloth of a World, and updated by the same one.
WEFT_API WeftResult weft_drawn_mesh_bind(const WeftWorld* world, WeftClothId cloth,
                                         const WeftDrawnSurface* surface,
                                         const WeftDrawnMeshSettings* settings, WeftDrawnMesh** mesh);
WEFT_API size_t weft_drawn_mesh_size(const WeftDrawnMesh* mesh);
// Each output is null, or has room for all vertices and is aligned to 16 bytes; others are errors.
WEFT_API WeftResult weft_drawn_mesh_update(const WeftDrawnMesh* mesh, const WeftWorld* world,
                                           WeftClothId cloth, WeftVec4* positions, WeftVec4* normals,
                                           WeftVec4* tangents, size_t first, size_t count);
// There is one position and one normal for each vertex; normals may be null.
WEFT_API WeftResult weft_drawn_mesh_begin_blend(WeftDrawnMesh* mesh, const WeftWorld* world,
                                                WeftClothId cloth, const WeftVec4* positions,
                                                const WeftVec4* normals);
WEFT_API WeftResult weft_drawn_mesh_blend(WeftDrawnMesh* mesh, float left);
// Returns the bonds, one a vertex, which hold until the mesh is destroyed; null: no mesh.
WEFT_API const WeftDrawnBond* weft_drawn_mesh_bonds(const WeftDrawnMesh* mesh);
WEFT_API float weft_drawn_mesh_rounding(const WeftDrawnMesh* mesh);
WEFT_API size_t weft_drawn_mesh_save_size(const WeftDrawnMesh* mesh);
WEFT_API WeftResult weft_drawn_mesh_save(const WeftDrawnMesh* mesh, void* to, size_t bytes);
// For a cloth of the mesh that was bound to.
WEFT_API WeftResult weft_drawn_mesh_load(const void* saved, size_t bytes, const WeftWorld* world,
                                         WeftClothId cloth, WeftDrawnMesh** mesh);
// Has a cloth take over from another mesh of the same garment.
WEFT_API WeftResult weft_carry_state(WeftWorld* world, WeftClothId from, WeftClothId to,
                                     const WeftDrawnMesh* bonds);
WEFT_API void weft_drawn_mesh_destroy(WeftDrawnMesh* mesh);

// The clock of a game loop.
WEFT_API WeftResult weft_fixed_step_create(const WeftFixedStepSettings* settings, WeftFixedStep** clock);
WEFT_API WeftFixedStepFrame weft_fixed_step_advance(WeftFixedStep* clock, double frame_seconds);
WEFT_API void weft_fixed_step_reset(WeftFixedStep* clock);
WEFT_API WeftResult weft_fixed_step_settings(const WeftFixedStep* clock, WeftFixedStepSettings* settings);
WEFT_API void weft_fixed_step_destroy(WeftFixedStep* clock);

// Sets the hooks of the whole process; null: none.
WEFT_API WeftResult weft_set_hooks(const WeftHooks* hooks);
WEFT_API WeftMemoryUse weft_memory_in_use(void);

#ifdef __cplusplus
}
#endif
