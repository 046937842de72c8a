#pragma once
// Settings, for C. Each field means what the field of that name does in the header named above its struct,
// which says its unit, range and consequence. See weft/weft_c.h for struct_size.

#include "weft/c/values.h"

#ifdef __cplusplus
extern "C" {
#endif

// weft/settings.h: Fabric
typedef struct WeftFabric {
    float areal_density;
    float warp, weft, shear;
    float bending, bending_ratio;
    float damping;
    float stiffening;
} WeftFabric;
typedef struct WeftNamedFabric {
    const char* name;
    WeftFabric fabric;
    const char* source;
} WeftNamedFabric;

typedef struct WeftFiniteElements {
    WeftBool enabled;
    float poisson;
    WeftBool dihedral;
    WeftBool consistent_mass;
} WeftFiniteElements;

typedef struct WeftTethers {
    WeftBool enabled;
    float slack;
} WeftTethers;

typedef struct WeftFrameInertia {
    float linear, angular, centrifugal;
} WeftFrameInertia;

// weft/self_collision.h
enum {
    WEFT_SELF_OFF,
    WEFT_SELF_CONTACT,
    WEFT_SELF_IMPACT_ZONES,
    WEFT_SELF_AVOIDANCE,
    WEFT_SELF_AVOIDANCE_BY_SHIFTED_GRIDS,
    WEFT_SELF_AVOIDANCE_BY_SORTED_SWEEP
};
typedef struct WeftSelfCollision {
    int32_t method;  // WEFT_SELF_...
    float distance;
    float friction;
    float restitution;
    uint32_t layers, mask;
} WeftSelfCollision;

// weft/methods.h. weft_method_init() gives each its own defaults.
enum {
    WEFT_METHOD_MULTILEVEL,
    WEFT_METHOD_JACOBI,
    WEFT_METHOD_CHEBYSHEV,
    WEFT_METHOD_CONJUGATE_GRADIENT,
    WEFT_METHOD_XPBD,
    WEFT_METHOD_FIBRES,
    WEFT_METHOD_SYMPLECTIC_EULER
};
enum { WEFT_SET_GAUSS_SEIDEL, WEFT_SET_LDLT };
typedef struct WeftMethod {
    int32_t kind;                         // WEFT_METHOD_...
    int32_t iterations;                   // all but Multilevel and symplectic Euler
    WeftBool exact_mean_motion;           // Jacobi and Chebyshev
    int32_t passes;                       // Multilevel
    float tolerance;                      // Multilevel
    int32_t vertical, horizontal, shear;  // Fibres: WEFT_SET_...
} WeftMethod;
enum { WEFT_TIME_OF_METHOD, WEFT_TIME_BACKWARD_EULER, WEFT_TIME_BDF2 };

// weft/collider.h: ColliderResponse
enum { WEFT_RESPONSE_CONTACT, WEFT_RESPONSE_VELOCITY_FILTER };

// weft/filling.h
enum { WEFT_FILLING_NONE, WEFT_FILLING_PRESSURE, WEFT_FILLING_GAS, WEFT_FILLING_VOLUME };
typedef struct WeftFilling {
    int32_t kind;  // WEFT_FILLING_...
    float pressure, volume, outside;
} WeftFilling;

// weft/settings.h: ClothSettings
typedef struct WeftClothSettings {
    uint32_t struct_size;
    WeftFabric fabric;
    WeftFiniteElements finite_elements;
    WeftMethod method;
    int32_t time_scheme;  // WEFT_TIME_...
    int32_t substeps;
    WeftTethers tethers;
    WeftSelfCollision self_collision;
    float air_damping;
    float thickness, friction, restitution;
    uint32_t collider_mask;
    int32_t collider_response;  // WEFT_RESPONSE_...
    WeftBool enabled;
    float sleep_speed;
    WeftFrameInertia frame_inertia;
    float importance;
    float teleport_distance, teleport_angle;
    float gravity_scale, wind_scale;
    WeftFilling filling;
    float back_friction_ratio;
    uint64_t key;
    float drag_scale, lift_scale, max_speed_in_frame;
} WeftClothSettings;

// weft/settings.h: AirSource
enum { WEFT_AIR_NONE, WEFT_AIR_JET, WEFT_AIR_BLAST, WEFT_AIR_WAKE };
typedef struct WeftAirSource {
    int32_t kind;  // WEFT_AIR_...
    WeftVec3 position, velocity;
    float radius;
} WeftAirSource;

// weft/settings.h: AirShelter
enum { WEFT_SHELTER_NONE, WEFT_SHELTER_BALL, WEFT_SHELTER_BOX };
typedef struct WeftAirShelter {
    int32_t kind;  // WEFT_SHELTER_...
    WeftVec3 position;
    WeftRotation rotation;
    WeftVec3 half_extents;
    float radius, border, exposure;
} WeftAirShelter;

// weft/settings.h: Wind
typedef struct WeftWind {
    WeftVec3 velocity;
    float gust, gust_length;
    float air_density, drag, lift;
    uint32_t seed;
    WeftAirSource sources[8];
    WeftAirShelter shelters[8];
} WeftWind;

// weft/executor.h. `run` calls body(context, block) once for each block and returns when all are done.
typedef void (*WeftBlockBody)(void* context, uint32_t block);
typedef struct WeftExecutor {
    void (*run)(void* user, uint32_t block_count, WeftBlockBody body, void* context);
    void* user;
    int32_t width;
} WeftExecutor;

// weft/settings.h: WorldSettings
typedef struct WeftWorldSettings {
    uint32_t struct_size;
    WeftVec3 gravity;
    WeftWind wind;
    float max_speed;
    int32_t substeps;
    int32_t contact_reports;
    int32_t threads;
    float budget;
    WeftExecutor executor;
} WeftWorldSettings;

// weft/numbers.h: SettingNumber
typedef struct WeftSettingNumber {
    const char *type, *field;
    float* number;       // of a vector: its first component; null, if it is whole
    int32_t* whole;      // null, if it is not
    int32_t components;  // 1; of a vector 3
    float least, greatest;
    WeftBool or_zero, below_greatest;
} WeftSettingNumber;

// weft/maps.h: Map
enum {
    WEFT_MAP_MASS,
    WEFT_MAP_PIN,
    WEFT_MAP_LEASH,
    WEFT_MAP_BACKSTOP,
    WEFT_MAP_BACKSTOP_RADIUS,
    WEFT_MAP_FRICTION,
    WEFT_MAP_THICKNESS,
    WEFT_MAP_STIFFNESS,
    WEFT_MAP_COLLIDER_MASK
};

// weft/collider.h: Collider, with the fields of every shape in one.
enum {
    WEFT_SPHERE,           // center, radius
    WEFT_CAPSULE,          // a, b, radius
    WEFT_PLANE,            // normal, offset
    WEFT_TAPERED_CAPSULE,  // a, b, radius (radius_a there), radius_b
    WEFT_BOX,              // center, rotation, half_extents
    WEFT_PLACED_SHAPE      // shape, center (position there), rotation
};
typedef struct WeftCollider {
    uint32_t struct_size;
    int32_t kind;
    WeftVec3 center, a, b;
    float radius, radius_b;
    WeftRotation rotation;
    WeftVec3 half_extents;
    WeftVec3 normal;
    float offset;
    WeftShapeId shape;
    float friction, thickness, restitution;
    uint32_t layers;
    WeftBool is_trigger;
} WeftCollider;

// weft/shapes.h: Shape, with the fields of every shape in one. Vertices are three floats each, triangles
// three uint32_t, heights one float.
enum {
    WEFT_TRIANGLE_MESH,  // vertices, triangles, closed
    WEFT_CONVEX_HULL,    // vertices (points there)
    WEFT_HEIGHT_FIELD,   // heights, rows, columns, spacing
    WEFT_DISTANCE_FIELD  // vertices, triangles, closed, cell
};
typedef struct WeftShape {
    uint32_t struct_size;
    int32_t kind;
    WeftInput vertices, triangles, heights;
    WeftBool closed;
    uint32_t rows, columns;
    float spacing;
    float cell;
} WeftShape;

// weft/body.h
typedef struct WeftBodySettings {
    uint32_t struct_size;
    float mass;
    WeftVec3 inertia;
    float gravity_scale, damping, angular_damping;
} WeftBodySettings;
typedef struct WeftBodyState {
    uint32_t struct_size;
    WeftVec3 position;
    WeftRotation rotation;
    WeftVec3 velocity, angular_velocity;
} WeftBodyState;

// weft/seam.h
typedef struct WeftSeamSettings {
    uint32_t struct_size;
    float rest_length, break_force, stiffness;
} WeftSeamSettings;

// weft/mesh.h: Mesh. Positions are three floats each, triangles three uint32_t, pattern and texcoords two
// floats.
typedef struct WeftMeshView {
    uint32_t struct_size;
    WeftInput positions, triangles;
    WeftInput pattern, texcoords;  // either may be empty
    uint32_t rows, columns;        // of a sheet, else 0
    WeftInput welds;               // one uint32_t each; may be empty
} WeftMeshView;
typedef struct WeftSheetSettings {
    uint32_t struct_size;
    uint32_t rows, columns;
    WeftVec3 origin, u, v;
} WeftSheetSettings;

// weft/proxy.h
typedef struct WeftProxySettings {
    uint32_t struct_size;
    uint32_t particles;
    float thickness;
} WeftProxySettings;

// weft/drawn_mesh.h. Vertices and normals are three floats each, triangles three uint32_t, texcoords two
// floats.
typedef struct WeftDrawnSurface {
    uint32_t struct_size;
    WeftInput vertices, triangles, texcoords, normals;
} WeftDrawnSurface;
typedef struct WeftDrawnMeshSettings {
    uint32_t struct_size;
    float rounding, reach;
} WeftDrawnMeshSettings;

// weft/fixed_step.h
typedef struct WeftFixedStepSettings {
    uint32_t struct_size;
    int32_t max_steps_per_frame;
    double step;
} WeftFixedStepSettings;
typedef struct WeftFixedStepFrame {
    int32_t steps;
    float alpha;
    double dropped_seconds;
} WeftFixedStepFrame;

// weft/hooks.h. They apply to the whole process.
enum { WEFT_LOG_NOTE, WEFT_LOG_WARNING };
typedef struct WeftHooks {
    uint32_t struct_size;
    void* user;
    void* (*allocate)(void* user, size_t bytes, size_t alignment);
    void (*release)(void* user, void* memory, size_t bytes, size_t alignment);
    void (*log)(void* user, int32_t level, const char* line);  // WEFT_LOG_...
    void (*failed_assertion)(void* user, const char* condition, const char* file, int line);
    void (*begin_zone)(void* user, const char* name);
    void (*end_zone)(void* user, const char* name);
} WeftHooks;

// weft/cooked_cloth.h: CookProgress
typedef struct WeftCookProgress {
    void* user;
    WeftBool (*report)(void* user, float done);  // 0 ends the cooking
} WeftCookProgress;

// Owner of the bytes from which a cooked cloth is read. They stay as they are until give_back is called,
// once, on the thread that drops the last cloth that uses them. If they had to be copied, it is called before
// the load returns; if the load fails, it never is.
typedef struct WeftLender {
    void* user;
    void (*give_back)(void* user);
} WeftLender;

// weft/recording.h: RecordingSink
typedef struct WeftRecordingSink {
    WeftBool (*write)(void* user, const void* bytes, size_t count);  // 0: it failed
    void* user;
} WeftRecordingSink;

// weft/debug_draw.h
enum {
    WEFT_DRAW_STRAIN = 1 << 0,
    WEFT_DRAW_VELOCITIES = 1 << 1,
    WEFT_DRAW_PINS = 1 << 2,
    WEFT_DRAW_CONTACTS = 1 << 3,
    WEFT_DRAW_COLLIDERS = 1 << 4,
    WEFT_DRAW_TANGLES = 1 << 5,
    WEFT_DRAW_CLOTHS = 1 << 6,
    WEFT_DRAW_NORMALS = 1 << 7,
    WEFT_DRAW_LEASHES = 1 << 8,
    WEFT_DRAW_LEVELS = 1 << 9,
    WEFT_DRAW_COSTS = 1 << 10
};
typedef struct WeftDebugCanvas {
    void* user;
    void (*line)(void* user, const WeftVec3* from, const WeftVec3* to, const WeftVec3* colour);
    void (*text)(void* user, const WeftVec3* at, const char* words, const WeftVec3* colour);
} WeftDebugCanvas;

enum { WEFT_DESCRIBE_TEXT, WEFT_DESCRIBE_JSON };

#ifdef __cplusplus
}
#endif
