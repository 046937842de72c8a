/* A host in C99 that calls all of weft_c.h: what is given comes back, what is wrong is refused by words, and
   what steps make is what the same calls make in C++ (see c_test.cpp). */

#include "host.h"

#include <math.h>
#include <stddef.h>
#include <stdint.h>
#include <stdlib.h>
#include <string.h>

#include "check.h"

enum { side = 12, steps = 20 };

typedef struct Vertex {
    float place[3];
    float normal[3];
    unsigned char colour[4];
} Vertex;

static const WeftInput nothing = {NULL, 0, 0};

static void run_in_order(void* user, uint32_t block_count, WeftBlockBody body, void* context) {
    uint32_t block;
    *(int*)user += 1;
    for (block = 0; block < block_count; ++block) body(context, block);
}

static WeftWorld* make_world(int* executor_calls) {
    WeftWorldSettings settings, seen;
    WeftWorld* world = NULL;
    weft_world_settings_init(&settings, sizeof settings);
    CHECK(settings.struct_size == sizeof settings && settings.gravity.y == -9.81f &&
          settings.executor.width == 1);
    settings.substeps = 7;
    weft_world_settings_init(&settings, 8); /* a size that is none changes nothing */
    CHECK(settings.struct_size == sizeof settings && settings.substeps == 7);
    settings.substeps = 0;
    REFUSES(WEFT_INVALID_ARGUMENT, "substeps", weft_world_create(&settings, &world));
    CHECK(world == NULL);
    settings.substeps = 1;
    settings.contact_reports = 64;
    settings.executor.run = run_in_order;
    settings.executor.user = executor_calls;
    settings.executor.width = 2;
    TAKES(weft_world_create(&settings, &world));
    seen.struct_size = sizeof seen;
    TAKES(weft_world_settings(world, &seen));
    CHECK(seen.executor.run == run_in_order && seen.executor.user == executor_calls &&
          seen.contact_reports == 64);
    seen.wind.velocity.x = 3;
    TAKES(weft_world_set_settings(world, &seen));
    seen.max_speed = -1;
    seen.executor.run = NULL; /* is not taken either */
    REFUSES(WEFT_INVALID_ARGUMENT, "max_speed", weft_world_set_settings(world, &seen));
    return world;
}

static WeftMesh* make_mesh(void) {
    WeftSheetSettings sheet;
    WeftMeshView view = {0};
    WeftMesh *made = NULL, *copy = NULL;
    weft_sheet_settings_init(&sheet, sizeof sheet);
    sheet.rows = sheet.columns = side;
    sheet.origin.y = 1;
    TAKES(weft_mesh_make_sheet(&sheet, &made));
    view.struct_size = sizeof view;
    TAKES(weft_mesh_view(made, &view));
    CHECK(view.rows == side && view.positions.count == side * side);

    /* The same by a host's own vertices. */
    {
        Vertex vertices[side * side];
        uint32_t i;
        for (i = 0; i < side * side; ++i)
            memcpy(vertices[i].place, (const WeftVec3*)view.positions.data + i, 12);
        view.positions.data = vertices[0].place;
        view.positions.stride = sizeof(Vertex);
        TAKES(weft_mesh_create(&view, &copy));
        view.positions.stride = 8;
        REFUSES(WEFT_INVALID_ARGUMENT, "stride", weft_mesh_create(&view, &made));
    }
    weft_mesh_destroy(made);
    return copy;
}

static void files(const WeftMesh* mesh, const char* folder) {
    char file[512];
    WeftObjReport report = {.struct_size = sizeof report};
    WeftMesh* loaded = NULL;
    snprintf(file, sizeof file, "%s/mesh.obj", folder);
    TAKES(weft_mesh_save_obj(mesh, file));
    TAKES(weft_mesh_load_obj(file, 0, &report, &loaded));
    CHECK(report.ignored_lines == 0);
    weft_mesh_destroy(loaded);
    {
        WeftMeshView view = {.struct_size = sizeof view};
        FILE* const text = fopen(file, "w");
        CHECK(text != NULL);
        fputs("v 0 0 0\nv 1 0 0\nv 1 0 1\nv 0 0 1\nvt 0 0\nvt 2 0\nvt 2 2\nvt 0 2\n", text);
        fputs("vn 0 1 0\ng part\nf 1/1 4/4 3/3 2/2\n", text);
        fclose(text);
        TAKES(weft_mesh_load_obj(file, 1, &report, &loaded));
        CHECK(report.ignored_lines == 2 && report.triangulated_faces == 1);
        CHECK(report.crossing_faces == 0 && report.touching_faces == 0);
        TAKES(weft_mesh_view(loaded, &view));
        CHECK(view.pattern.count == 4 && view.triangles.count == 2);
        weft_mesh_destroy(loaded);
    }
    {
        /* A host that was built against the report's first version. */
        FILE* const text = fopen(file, "w");
        CHECK(text != NULL);
        fputs("v 0 0 0\nv 1 0 0\nv 1 0 1\nv 0 0 1\nf 1 3 2 4\n", text);
        fclose(text);
        report.struct_size = offsetof(WeftObjReport, crossing_faces);
        report.crossing_faces = 77;
        TAKES(weft_mesh_load_obj(file, 0, &report, &loaded));
        CHECK(report.triangulated_faces == 1 && report.crossing_faces == 77);
        weft_mesh_destroy(loaded);
        report.struct_size = sizeof report;
        TAKES(weft_mesh_load_obj(file, 0, &report, &loaded));
        CHECK(report.crossing_faces == 1 && report.touching_faces == 0);
        weft_mesh_destroy(loaded);
    }
    REFUSES(WEFT_FILE_NOT_FOUND, "nothing.obj", weft_mesh_load_obj("nothing.obj", 0, NULL, &loaded));
}

static WeftBool count_calls(void* user, float done) {
    *(int*)user += 1;
    return done < 2;
}
static WeftBool cancel(void* user, float done) {
    (void)user;
    (void)done;
    return 0;
}

static void count_give_back(void* user) {
    ++*(int*)user;
}

// Bytes that are used where they lie are given back with the last cloth of theirs; those that had to be
// copied, at once; refused ones, never.
static void lend(const void* saved, size_t bytes, const WeftClothInfo* info) {
    const size_t line = 64;
    char* const room = malloc(bytes + 2 * line);
    char* const aligned = room + (line - (uintptr_t)room % line);
    int given_back = 0;
    const WeftLender lender = {&given_back, count_give_back};
    WeftClothInfo same = {.struct_size = sizeof same};
    WeftCookedCloth* loaded = NULL;
    WeftWorld* world = NULL;
    WeftClothId cloth;
    memcpy(aligned, saved, bytes);
    REFUSES(WEFT_MALFORMED_FILE, "",
            weft_cooked_cloth_load_in_place(aligned, bytes - 1, &lender, NULL, &loaded));
    REFUSES(WEFT_INVALID_ARGUMENT, "lender",
            weft_cooked_cloth_load_in_place(aligned, bytes, NULL, NULL, &loaded));
    CHECK(given_back == 0);
    TAKES(weft_cooked_cloth_load_in_place(aligned, bytes, &lender, NULL, &loaded));
    TAKES(weft_cooked_cloth_info(loaded, &same));
    CHECK(memcmp(info, &same, sizeof same) == 0);
    TAKES(weft_world_create(NULL, &world));
    TAKES(weft_world_add_cooked_cloth(world, loaded, NULL, &cloth));
    weft_cooked_cloth_destroy(loaded);
    CHECK(given_back == 0);
    weft_world_destroy(world);
    CHECK(given_back == 1);
    memmove(aligned + 1, aligned, bytes);
    TAKES(weft_cooked_cloth_load_in_place(aligned + 1, bytes, &lender, NULL, &loaded));
    CHECK(given_back == 2);
    weft_cooked_cloth_destroy(loaded);
    CHECK(given_back == 2);
    free(room);
}

static WeftCookedCloth* cook(const WeftMesh* mesh) {
    int calls = 0;
    const WeftCookProgress progress = {&calls, count_calls}, cancelled = {NULL, cancel};
    WeftCookedCloth *cooked = NULL, *loaded = NULL;
    WeftClothInfo info = {.struct_size = sizeof info}, same = {.struct_size = sizeof same};
    WeftCookReport report = {.struct_size = sizeof report};
    void* saved;
    size_t bytes;
    TAKES(weft_cooked_cloth_create(mesh, NULL, &progress, &cooked));
    CHECK(calls > 1);
    REFUSES(WEFT_CANCELLED, "cancelled", weft_cooked_cloth_create(mesh, NULL, &cancelled, &loaded));
    TAKES(weft_cooked_cloth_info(cooked, &info));
    TAKES(weft_cooked_cloth_report(cooked, &report));
    CHECK(info.particles == side * side && report.welded_count == 0 && report.dropped_count == 0);
    bytes = weft_cooked_cloth_save_size(cooked);
    saved = malloc(bytes);
    TAKES(weft_cooked_cloth_save(cooked, saved, bytes));
    TAKES(weft_cooked_cloth_load(saved, bytes, NULL, &loaded));
    TAKES(weft_cooked_cloth_info(loaded, &same));
    CHECK(memcmp(&info, &same, sizeof info) == 0);
    REFUSES(WEFT_MALFORMED_FILE, "", weft_cooked_cloth_load(saved, bytes - 1, NULL, &loaded));
    weft_cooked_cloth_destroy(loaded);
    lend(saved, bytes, &info);
    free(saved);
    return cooked;
}

static WeftClothId add_cloths(WeftWorld* world, const WeftMesh* mesh, const WeftCookedCloth* cooked,
                              WeftClothId* other) {
    WeftClothSettings settings, seen = {.struct_size = sizeof seen};
    WeftTransform place;
    WeftClothInfo info = {.struct_size = sizeof info};
    WeftClothId cloth, third;
    WeftBool asleep = 1;
    weft_cloth_settings_init(&settings, sizeof settings);
    settings.time_scheme = 9;
    REFUSES(WEFT_INVALID_ARGUMENT, "time_scheme", weft_world_add_cloth(world, mesh, &settings, &cloth));
    settings.time_scheme = WEFT_TIME_OF_METHOD;
    TAKES(weft_fabric_named("denim", &settings.fabric));
    REFUSES(WEFT_INVALID_ARGUMENT, "denim", weft_fabric_named("tin", &settings.fabric));
    weft_method_init(&settings.method, WEFT_METHOD_JACOBI);
    CHECK(settings.method.iterations == 15 && settings.method.exact_mean_motion);
    CHECK(weft_resolved_time_scheme(&settings) == WEFT_TIME_BACKWARD_EULER);
    CHECK(weft_resolved_time_scheme(NULL) == WEFT_TIME_BDF2);
    TAKES(weft_world_measure_cloth(world, mesh, &settings, &info));
    CHECK(info.vertices == side * side && info.bytes > 0);
    REFUSES(WEFT_INVALID_ARGUMENT, "id", weft_world_add_cloth(world, mesh, &settings, NULL));
    TAKES(weft_world_add_cloth(world, mesh, &settings, &cloth));
    TAKES(weft_world_cloth_settings(world, cloth, &seen));
    CHECK(memcmp(&seen, &settings, sizeof seen) == 0);
    seen.air_damping = 0.3f;
    TAKES(weft_world_set_cloth_settings(world, cloth, &seen));
    TAKES(weft_world_cloth_info(world, cloth, &info));
    TAKES(weft_world_set_importance(world, cloth, 2));
    TAKES(weft_world_wake(world, cloth));
    TAKES(weft_world_is_asleep(world, cloth, &asleep));
    CHECK(!asleep);

    weft_transform_init(&place);
    place.translation.x = 3;
    TAKES(weft_world_add_cooked_cloth(world, cooked, &place, other));
    TAKES(weft_world_add_cooked_cloth(world, cooked, NULL, &third));
    TAKES(weft_world_set_enabled(world, third, 0));
    TAKES(weft_world_remove_cloth(world, third));
    REFUSES(WEFT_STALE_ID, "ClothId", weft_world_remove_cloth(world, third));
    return cloth;
}

static void save_and_restore(WeftWorld* world, WeftClothId cloth) {
    const size_t bytes = weft_world_cloth_save_size(world, cloth);
    void* const saved = malloc(bytes);
    TAKES(weft_world_save_cloth(world, cloth, saved, bytes));
    REFUSES(WEFT_INVALID_ARGUMENT, "bytes", weft_world_save_cloth(world, cloth, saved, bytes - 1));
    TAKES(weft_world_restore_cloth(world, cloth, saved, bytes));
    REFUSES(WEFT_MALFORMED_FILE, "is of one cloth", weft_world_restore_cloths(world, saved, bytes, NULL));
    free(saved);
}

static void hold(WeftWorld* world, WeftClothId cloth, WeftClothId other) {
    const uint32_t corners[2] = {0, side - 1};
    const Vertex targets[2] = {{{-0.5f, 1.01f, -0.5f}, {0, 1, 0}, {0, 0, 0, 0}},
                               {{0.5f, 1.01f, -0.5f}, {0, 1, 0}, {0, 0, 0, 0}}};
    const WeftInput by_stride = {targets, 2, sizeof(Vertex)};
    const WeftVec3 lifted = {-0.5f, 1.02f, -0.5f}, origin = {0, 0, 1};
    float friction[side * side];
    WeftVec3 skin[side * side];
    WeftInput values = {friction, side * side, 0}, places = {skin, side * side, 0};
    WeftTransform by;
    uint32_t i;
    TAKES(weft_world_pin(world, cloth, corners, 2));
    TAKES(weft_world_move_pins(world, cloth, corners, 2, by_stride));
    TAKES(weft_world_move_pin(world, cloth, 0, lifted));
    REFUSES(WEFT_INVALID_ARGUMENT, "null", weft_world_pin(world, cloth, NULL, 2));
    TAKES(weft_world_unpin(world, cloth, corners + 1, 1));
    TAKES(weft_world_pin(world, cloth, corners, 2));
    TAKES(weft_world_move_pins(world, cloth, corners, 2, by_stride));

    weft_transform_init(&by);
    TAKES(weft_world_set_frame(world, other, &by));
    TAKES(weft_world_leave_frame(world, other));
    by.translation.y = 0.1f;
    TAKES(weft_world_move_cloth(world, other, &by));
    for (i = 0; i < side * side; ++i) {
        friction[i] = 2;
        skin[i].x = 3 + 0.1f * (float)(i % side) - 0.5f;
        skin[i].y = 1;
        skin[i].z = 0.1f * (float)(i / side);
    }
    TAKES(weft_world_reset_cloth(world, other, places));
    REFUSES(WEFT_INVALID_ARGUMENT, "0 positions", weft_world_reset_cloth(world, other, nothing));
    TAKES(weft_world_resume_cloth(world, other, places, places, places));
    REFUSES(WEFT_INVALID_ARGUMENT, "0 velocities",
            weft_world_resume_cloth(world, other, places, places, nothing));
    TAKES(weft_world_set_map(world, cloth, WEFT_MAP_FRICTION, values));
    REFUSES(WEFT_INVALID_ARGUMENT, "map", weft_world_set_map(world, cloth, 77, values));
    TAKES(weft_world_set_map(world, cloth, WEFT_MAP_COLLIDER_MASK, values));
    TAKES(weft_world_set_map(world, cloth, WEFT_MAP_COLLIDER_MASK, nothing));
    save_and_restore(world, cloth);
    TAKES(weft_world_set_map(world, other, WEFT_MAP_LEASH, values));
    TAKES(weft_world_set_skin(world, other, places, nothing));
    TAKES(weft_world_set_map(world, other, WEFT_MAP_LEASH, nothing));
    TAKES(weft_world_shift_origin(world, origin));
}

/* A sheet of 1 m by 1 m, of so many particles a side. */
static WeftClothId sheet_of(WeftWorld* world, uint32_t count) {
    WeftSheetSettings shape;
    WeftMesh* mesh = NULL;
    WeftClothId cloth;
    weft_sheet_settings_init(&shape, sizeof shape);
    shape.rows = count;
    shape.columns = count;
    TAKES(weft_mesh_make_sheet(&shape, &mesh));
    TAKES(weft_world_add_cloth(world, mesh, NULL, &cloth));
    weft_mesh_destroy(mesh);
    return cloth;
}

static void levels(void) {
    WeftWorld* world = NULL;
    WeftClothId finest, coarser;
    uint32_t level = 9;

    TAKES(weft_world_create(NULL, &world));
    finest = sheet_of(world, 9);
    coarser = sheet_of(world, 5);
    REFUSES(WEFT_INVALID_ARGUMENT, "81 particles", weft_world_add_level(world, coarser, finest, 0.1f));
    TAKES(weft_world_add_level(world, finest, coarser, 0.1f));
    REFUSES(WEFT_INVALID_ARGUMENT, "level", weft_world_set_level(world, finest, 2));
    TAKES(weft_world_set_level(world, finest, 1));
    TAKES(weft_world_level(world, finest, &level));
    CHECK(level == 1);
    weft_world_destroy(world);
}

static void air(const WeftWorld* world) {
    const WeftVec3 points[2] = {{0, 0, 0}, {5, 0, 0}};
    const WeftInput at = {points, 2, 0};
    float found[2][4] = {{0, 0, 0, 9}, {0, 0, 0, 9}};
    WeftStream to = {found, sizeof found, sizeof found[0]};
    TAKES(weft_world_sample_air(world, at, to));
    CHECK(found[0][0] == 3 && found[1][0] == 3 && found[0][3] == 9);
    to.bytes = 16 + 11;
    REFUSES(WEFT_INVALID_ARGUMENT, "27 bytes", weft_world_sample_air(world, at, to));
    to.bytes = 16 + 12;
    TAKES(weft_world_sample_air(world, at, to));
}

static uint32_t triangles_of(WeftWorld* world, const WeftShape* shape, float* error) {
    WeftShapeId id;
    WeftShapeInfo info = {.struct_size = sizeof info};
    TAKES(weft_world_add_shape(world, shape, &id));
    TAKES(weft_world_shape_info(world, id, &info));
    TAKES(weft_world_remove_shape(world, id));
    *error = info.error;
    return info.triangles;
}

static void seams(WeftWorld* world, WeftClothId cloth) {
    static const uint32_t left[2] = {0, 1}, right[2] = {2, 3};
    WeftSeamSettings thread;
    WeftSeamInfo info = {.struct_size = sizeof info};
    WeftSeamId seam;

    weft_seam_settings_init(&thread, sizeof thread);
    CHECK(thread.rest_length == 0 && thread.stiffness == 0 && thread.break_force > 1e30f);
    thread.break_force = -1;
    REFUSES(WEFT_INVALID_ARGUMENT, "break_force",
            weft_world_stitch(world, cloth, left, cloth, right, 2, &thread, &seam));
    REFUSES(WEFT_INVALID_ARGUMENT, "same particle",
            weft_world_stitch(world, cloth, left, cloth, left, 2, NULL, &seam));
    TAKES(weft_world_stitch(world, cloth, left, cloth, right, 2, NULL, &seam));
    TAKES(weft_world_seam_info(world, seam, &info));
    CHECK(info.stitches == 2 && info.holding == 2 && info.a.index == cloth.index);
    TAKES(weft_world_unstitch(world, seam));
    REFUSES(WEFT_STALE_ID, "SeamId", weft_world_unstitch(world, seam));
}

static void fillings(WeftWorld* world, WeftClothId cloth) {
    WeftFillingInfo info = {.struct_size = sizeof info};
    WeftClothSettings settings;

    TAKES(weft_world_filling_info(world, cloth, &info));
    CHECK(info.open_edges > 0 && info.volume == 0 && info.pressure == 0);
    weft_cloth_settings_init(&settings, sizeof settings);
    CHECK(settings.filling.kind == WEFT_FILLING_NONE && settings.filling.outside == 101325);
    settings.filling.kind = WEFT_FILLING_VOLUME;
    REFUSES(WEFT_INVALID_ARGUMENT, "open edges", weft_world_set_cloth_settings(world, cloth, &settings));
}

static void solids(WeftWorld* world, WeftClothId other) {
    static const WeftVec3 corners[4] = {{0, 0, 0}, {1, 0, 0}, {0, 0, -1}, {0, 1, 0}};
    static const uint32_t faces[4][3] = {{0, 2, 1}, {0, 1, 3}, {0, 3, 2}, {1, 2, 3}};
    const WeftInput vertices = {corners, 4, 0}, triangles = {faces, 4, 0};
    const WeftVec3 far_away = {3, 0.7f, -1};
    const uint32_t corner = 0;
    WeftShape shape;
    WeftShapeId mesh;
    WeftShapeInfo info = {.struct_size = sizeof info};
    WeftCollider collider, seen = {.struct_size = sizeof seen};
    WeftColliderId ball, placed, ground;
    WeftBodySettings heavy, same = {.struct_size = sizeof same};
    WeftBodyState state, now = {.struct_size = sizeof now};
    WeftBodyId body;

    weft_shape_init(&shape, sizeof shape, WEFT_TRIANGLE_MESH);
    CHECK(shape.closed);
    shape.vertices = vertices;
    shape.triangles = triangles;
    TAKES(weft_world_add_shape(world, &shape, &mesh));
    {
        static const float heights[6] = {0, 1, 0, 1, 0, 1};
        const WeftInput all_heights = {heights, 6, 0};
        WeftShape other_shape = shape;
        float error = 0;
        other_shape.kind = WEFT_CONVEX_HULL;
        CHECK(triangles_of(world, &other_shape, &error) == 4);
        other_shape.kind = WEFT_DISTANCE_FIELD;
        other_shape.cell = 0.1f;
        CHECK(triangles_of(world, &other_shape, &error) == 0 && error > 0.05f && error < 0.1f);
        weft_shape_init(&other_shape, sizeof other_shape, WEFT_HEIGHT_FIELD);
        CHECK(other_shape.spacing == 1);
        other_shape.rows = 2;
        other_shape.columns = 3;
        other_shape.heights = all_heights;
        CHECK(triangles_of(world, &other_shape, &error) == 4);
    }
    shape.kind = 4;
    REFUSES(WEFT_INVALID_ARGUMENT, "kind", weft_world_add_shape(world, &shape, &mesh));
    TAKES(weft_world_shape_info(world, mesh, &info));
    CHECK(info.triangles == 4);
    TAKES(weft_world_deform_shape(world, mesh, vertices));

    weft_collider_init(&collider, sizeof collider, WEFT_PLACED_SHAPE);
    CHECK(collider.rotation.w == 1 && collider.layers == 1);
    collider.shape = mesh;
    collider.center.x = -20;
    TAKES(weft_world_add_collider(world, &collider, &placed));
    TAKES(weft_world_remove_collider(world, placed));
    TAKES(weft_world_remove_shape(world, mesh));

    weft_collider_init(&collider, sizeof collider, WEFT_SPHERE);
    CHECK(collider.radius == 0.1f);
    collider.center.y = 0.8f;
    collider.center.z = -1;
    collider.radius = 0.15f;
    REFUSES(WEFT_INVALID_ARGUMENT, "id", weft_world_add_collider(world, &collider, NULL));
    TAKES(weft_world_add_collider(world, &collider, &ball));
    TAKES(weft_world_place_collider(world, ball, &collider));
    collider.center.y = 0.82f;
    TAKES(weft_world_move_collider(world, ball, &collider));
    TAKES(weft_world_collider(world, ball, &seen));
    CHECK(seen.kind == WEFT_SPHERE && seen.radius == 0.15f);
    weft_collider_init(&collider, sizeof collider, WEFT_PLANE);
    TAKES(weft_world_add_collider(world, &collider, &ground));
    collider.kind = -1;
    REFUSES(WEFT_INVALID_ARGUMENT, "kind", weft_world_add_collider(world, &collider, &ground));

    weft_body_settings_init(&heavy, sizeof heavy);
    weft_body_state_init(&state, sizeof state);
    CHECK(heavy.mass == 1 && state.rotation.w == 1);
    heavy.mass = 0.2f;
    state.position = far_away;
    TAKES(weft_world_add_body(world, &heavy, &state, &body));
    TAKES(weft_world_body_settings(world, body, &same));
    CHECK(memcmp(&same, &heavy, sizeof same) == 0);
    TAKES(weft_world_set_body_settings(world, body, &same));
    TAKES(weft_world_body_state(world, body, &now));
    TAKES(weft_world_set_body_state(world, body, &now));
    TAKES(weft_world_attach_collider(world, body, ball));
    TAKES(weft_world_detach_collider(world, ball));
    TAKES(weft_world_attach(world, body, other, &corner, 1));
    TAKES(weft_world_detach(world, other, &corner, 1));
    TAKES(weft_world_attach(world, body, other, &corner, 1));
    TAKES(weft_world_add_body(world, NULL, NULL, &body));
    TAKES(weft_world_remove_body(world, body));
}

uint64_t hash_of_host_in_c(const char* folder) {
    int executor_calls = 0;
    WeftClothId cloth, other;
    WeftMesh* const mesh = make_mesh();
    WeftCookedCloth* const cooked = cook(mesh);
    WeftWorld* const world = make_world(&executor_calls);
    uint64_t hash;
    int i;
    files(mesh, folder);
    cloth = add_cloths(world, mesh, cooked, &other);
    hold(world, cloth, other);
    air(world);
    solids(world, other);
    seams(world, other);
    fillings(world, other);
    weft_mesh_destroy(mesh);
    weft_cooked_cloth_destroy(cooked);
    for (i = 0; i < steps; ++i) TAKES(weft_world_step(world, 1.0f / 60));
    CHECK(executor_calls ==
          steps + 4); /* and once to move a cloth, to reset and to resume it, and to shift the origin */
    look_at(world, cloth, folder);
    hash = weft_world_state_hash(world);
    go_back(world);
    weft_world_destroy(world);
    levels();
    record(folder);
    cut_cloth();
    rest_of_the_host();
    return hash;
}
