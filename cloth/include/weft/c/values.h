#pragma once
// The plain values of Weft's interface for C: see weft/weft_c.h. SI units, float, right-handed coordinates,
// +Y up.

#include <stddef.h>
#include <stdint.h>

#include "weft/export.h"
#include "weft/version.h"

#ifdef __cplusplus
extern "C" {
#endif

typedef int32_t WeftBool;  // 0: no; all else: yes

// Result of a call. If it is not WEFT_OK nothing has changed, outputs are as they were, and weft_error_text()
// says why.
typedef int32_t WeftResult;
enum {
    WEFT_OK = 0,
    WEFT_INVALID_ARGUMENT = 1,  // a setting or value outside its range; a null pointer
    WEFT_STALE_ID = 2,          // an id that is null, or whose object has been removed
    WEFT_INVALID_MESH = 3,      // a mesh from which no cloth can be made
    WEFT_FILE_NOT_FOUND = 4,    // a file that does not exist, or cannot be read or written
    WEFT_MALFORMED_FILE = 5,    // a file whose content breaks its format
    WEFT_OUT_OF_MEMORY = 6,
    WEFT_UNSUPPORTED = 7,
    WEFT_CANCELLED = 8  // a callback of the host's cancelled the call
};

typedef struct WeftVec2 {
    float x, y;
} WeftVec2;
typedef struct WeftVec3 {
    float x, y, z;
} WeftVec3;
typedef struct WeftVec4 {
    float x, y, z, w;
} WeftVec4;
// A quaternion: x, y and z are the axis times sin(angle / 2), w is cos(angle / 2).
typedef struct WeftRotation {
    float x, y, z, w;
} WeftRotation;
// Maps the point p to rotation p + translation.
typedef struct WeftTransform {
    WeftVec3 translation;
    WeftRotation rotation;
} WeftTransform;
// A bounding box, empty while lower > upper.
typedef struct WeftBounds {
    WeftVec3 lower, upper;
} WeftBounds;
typedef struct WeftTriangle {
    uint32_t vertices[3];  // counter-clockwise seen from the front
} WeftTriangle;

// weft/cutting.h
typedef struct WeftMeshEdge {
    uint32_t vertices[2];
} WeftMeshEdge;
typedef struct WeftStrainedEdge {
    uint32_t a, b;
    float strain;
} WeftStrainedEdge;
typedef struct WeftBlade {
    WeftVec3 was_a, was_b, is_a, is_b;
} WeftBlade;

// Identifiers of objects in a World. All-zero is null.
typedef struct WeftClothId {
    uint32_t index, generation;
} WeftClothId;
typedef struct WeftColliderId {
    uint32_t index, generation;
} WeftColliderId;
typedef struct WeftShapeId {
    uint32_t index, generation;
} WeftShapeId;
typedef struct WeftBodyId {
    uint32_t index, generation;
} WeftBodyId;
typedef struct WeftSeamId {
    uint32_t index, generation;
} WeftSeamId;

// Objects that exist until they are destroyed.
typedef struct WeftWorld WeftWorld;
typedef struct WeftMesh WeftMesh;
typedef struct WeftCookedCloth WeftCookedCloth;
typedef struct WeftDrawnMesh WeftDrawnMesh;
typedef struct WeftCutStroke WeftCutStroke;
typedef struct WeftFixedStep WeftFixedStep;

// The bond of a drawn vertex; weft/drawn_mesh.h has the formula that reads it.
typedef struct WeftDrawnBond {
    uint32_t particles[3];
    float second, third;
    float offset[3];
    float normal[3];
    float tangent[2];
    float handedness;
    float unused[2];
} WeftDrawnBond;

// Items in the host's memory, each `stride` bytes behind the one before it; 0: they are contiguous.
typedef struct WeftInput {
    const void* data;
    size_t count, stride;
} WeftInput;
// One attribute that is written for each vertex, `stride` bytes apart as in WeftInput, into `bytes` of
// memory. Null: the attribute is not written.
typedef struct WeftStream {
    void* data;
    size_t bytes, stride;
} WeftStream;

#ifdef __cplusplus
}
#endif
