#pragma once
// Results and reports, for C. Each field means what the field of that name does in the header named above its
// struct. Set struct_size before a call fills one of them: see weft/weft_c.h.

#include "weft/c/values.h"

#ifdef __cplusplus
extern "C" {
#endif

// weft/world.h: ClothView. Valid as long as the cloth is there; take it anew after each step or change.
typedef struct WeftClothView {
    uint32_t struct_size;
    uint32_t particles, vertices, triangle_count;
    const WeftVec4* positions;           // of particles; w is the inverse mass
    const WeftVec4* previous_positions;  // of particles, w likewise
    const WeftVec4* velocities;          // of particles
    const WeftVec4* normals;             // of particles
    const WeftTriangle* triangles;       // indices of particles
    const uint32_t* vertex_to_particle;
    const WeftVec2* texcoords;             // of vertices, or null
    const WeftTriangle* vertex_triangles;  // indices of vertices, or null
    WeftBounds bounds;
} WeftClothView;

// weft/vertex_streams.h: destinations of weft_world_write_vertices()
typedef struct WeftVertexStreams {
    uint32_t struct_size;
    WeftStream positions, previous_positions;
    WeftStream normals, previous_normals;
    WeftStream tangents;
    WeftStream texcoords;
    WeftStream strains;
} WeftVertexStreams;

// weft/query.h: ClothPoint
typedef struct WeftClothPoint {
    WeftClothId cloth;
    uint32_t triangle;
    WeftVec3 weights, position, normal;
    float distance;
} WeftClothPoint;

// weft/cooked_cloth.h: ClothInfo
typedef struct WeftClothInfo {
    uint32_t struct_size;
    uint32_t vertices, particles, welded_vertices, triangles, components;
    uint32_t structural_springs, shear_springs, bending_elements, border_edges;
    uint32_t dropped_triangles, turned_triangles, misoriented_edges, loose_particles;
    float mean_edge, mass, least_bending;
    uint64_t bytes, shared_bytes;
    uint32_t flipped_triangles, softened_triangles;
    uint64_t scratch_bytes;
} WeftClothInfo;

// weft/cooked_cloth.h: CookReport. Valid as long as the cooked cloth is there.
enum { WEFT_DROP_NO_AREA, WEFT_DROP_DOUBLED, WEFT_DROP_CROWDED_EDGE, WEFT_DROP_CROWDED_VERTEX };
typedef struct WeftWelded {
    uint32_t vertex, into;
} WeftWelded;
typedef struct WeftDropped {
    uint32_t triangle;
    uint32_t why;  // WEFT_DROP_...
} WeftDropped;
typedef struct WeftSoftened {
    uint32_t triangle;
    float left;
} WeftSoftened;
typedef struct WeftCookReport {
    uint32_t struct_size;
    const WeftWelded* welded;
    size_t welded_count;
    const WeftDropped* dropped;
    size_t dropped_count;
    const uint32_t* turned;
    size_t turned_count;
    const uint32_t* loose;
    size_t loose_count;
    const uint32_t* flipped;
    size_t flipped_count;
    const WeftSoftened* softened;
    size_t softened_count;
} WeftCookReport;

typedef struct WeftObjReport {
    uint32_t struct_size;
    uint32_t ignored_lines, triangulated_faces;
    uint32_t crossing_faces, touching_faces;
} WeftObjReport;

typedef struct WeftProxyReport {
    uint32_t struct_size;
    float cell, shortest_edge, longest_edge;
    uint32_t parts, left_out_parts, left_out_triangles, closed_holes;
    float reach;
} WeftProxyReport;

typedef struct WeftShapeInfo {
    uint32_t struct_size;
    uint32_t triangles;
    WeftBounds bounds;
    float error;
    uint64_t bytes;
} WeftShapeInfo;

// weft/report.h: StepFlags
enum {
    WEFT_STEP_INVALID_DT = 1 << 0,
    WEFT_STEP_STATE_RESTORED = 1 << 1,
    WEFT_STEP_CONTACTS_DROPPED = 1 << 2,
    WEFT_STEP_SPEED_LIMITED = 1 << 3,
    WEFT_STEP_UNSOLVED = 1 << 4,
    WEFT_STEP_PINS_STOPPED = 1 << 5,
    WEFT_STEP_CROSSED = 1 << 6,
    WEFT_STEP_UNDER_WAY = 1 << 7
};
typedef struct WeftStepReport {
    uint32_t struct_size;
    uint32_t flags;  // WEFT_STEP_..., several by |
    uint64_t step;
    int32_t substeps;
    uint32_t cloths, sleeping_cloths, reduced_cloths, particles;
    uint32_t collider_contacts, self_contacts, contacts, peak_self_contacts, truncated_particles;
    float pin_lag;
    uint32_t limits_exceeded;
    float limit_lag;
    uint32_t crossings, unresolved_pairs, restored_cloths;
    float peak_speed, residual, milliseconds;
    uint32_t broken_stitches;
} WeftStepReport;

typedef struct WeftClothReport {
    uint32_t struct_size;
    uint32_t flags;
    WeftBool enabled, asleep;
    uint32_t particles;
    uint32_t collider_contacts, self_contacts, peak_self_contacts, truncated_particles;
    uint32_t crossings, unresolved_pairs;
    float pin_lag;
    uint32_t limits_exceeded;
    float limit_lag, peak_speed, residual;
    uint32_t rung, rate;
    float milliseconds;
} WeftClothReport;

// weft/filling.h
typedef struct WeftFillingInfo {
    uint32_t struct_size;
    uint32_t open_edges;
    float volume, rest_volume, pressure;
} WeftFillingInfo;

// weft/seam.h
typedef struct WeftSeamInfo {
    uint32_t struct_size;
    WeftClothId a, b;
    uint32_t stitches, holding;
    WeftVec3 force;
    float tightest;
} WeftSeamInfo;

// weft/contact.h
typedef struct WeftContact {
    WeftClothId cloth, other_cloth;
    WeftColliderId collider;
    uint32_t particle, other_particle;
    WeftVec3 point, normal, impulse;
} WeftContact;

// weft/body.h
typedef struct WeftBodyImpulse {
    WeftBodyId body;
    WeftVec3 linear, angular;
} WeftBodyImpulse;

// weft/profile.h
typedef struct WeftStageTime {
    const char* name;
    int32_t depth;
    float last, p50, p95, p99, max;
    uint32_t samples;
} WeftStageTime;

// weft/recording.h: Replay
typedef struct WeftReplay {
    uint32_t struct_size;
    uint64_t steps, calls;
    WeftBool is_whole;
    WeftBool differs;         // if it does:
    uint64_t different_step;  // the first step after which the state differs
    int32_t different_cloth;  // the cloth's place among all that were added; -1: what a World has besides
} WeftReplay;

typedef struct WeftMemoryUse {
    uint64_t bytes, blocks;
} WeftMemoryUse;

#ifdef __cplusplus
}
#endif
