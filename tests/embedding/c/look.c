/* What a host in C reads, draws, saves and records. */

#include <math.h>
#include <string.h>

#include "check.h"
#include "host.h"

typedef struct Drawn {
    int lines, texts;
} Drawn;

static void count_line(void* user, const WeftVec3* from, const WeftVec3* to, const WeftVec3* colour) {
    CHECK(isfinite(from->x) && isfinite(to->y) && colour->z >= 0 && colour->z <= 1);
    ((Drawn*)user)->lines += 1;
}
static void count_text(void* user, const WeftVec3* at, const char* words, const WeftVec3* colour) {
    CHECK(isfinite(at->z) && strlen(words) > 0 && colour->x >= 0);
    ((Drawn*)user)->texts += 1;
}

static void vertices(const WeftWorld* world, WeftClothId cloth) {
    WeftClothView view = {.struct_size = sizeof view};
    WeftVertexStreams streams;
    float places[200][5];
    uint32_t i;
    memset(&streams, 0, sizeof streams);
    memset(places, 0, sizeof places);
    TAKES(weft_world_cloth(world, cloth, &view));
    CHECK(view.particles == 144 && view.vertices == 144 && view.triangle_count == 242);
    CHECK(view.positions[0].w == 0 && view.positions[20].w > 0); /* pinned, free */
    streams.struct_size = sizeof streams;
    streams.positions.data = places[0] + 1;
    streams.positions.bytes = sizeof places - sizeof(float);
    streams.positions.stride = sizeof places[0];
    TAKES(weft_world_write_vertices(world, cloth, &streams, 10, SIZE_MAX));
    CHECK(places[9][1] == 0 && places[9][2] == 0);
    for (i = 10; i < view.vertices; ++i) {
        const WeftVec4 at = view.positions[view.vertex_to_particle[i]];
        CHECK(places[i][1] == at.x && places[i][2] == at.y && places[i][3] == at.z && places[i][4] == 0);
    }
    {
        const WeftVec4 pinned = view.positions[view.vertex_to_particle[11]];
        CHECK(pinned.x == 0.5f && pinned.y == 1.01f && pinned.z == -1.5f); /* the origin was shifted by 1 m */
    }
    streams.positions.stride = 8;
    REFUSES(WEFT_INVALID_ARGUMENT, "", weft_world_write_vertices(world, cloth, &streams, 0, SIZE_MAX));
}

typedef struct Whole {
    float place[3], place_before[3], normal[3], normal_before[3], tangent[4];
    float texcoord[2], strain[2];
} Whole;

static WeftStream stream_at(void* first, const Whole* all, size_t count) {
    WeftStream stream;
    stream.data = first;
    stream.bytes = count * sizeof(Whole) - (size_t)((const char*)first - (const char*)all);
    stream.stride = sizeof(Whole);
    return stream;
}

static float length_of(const float v[3]) {
    return sqrtf(v[0] * v[0] + v[1] * v[1] + v[2] * v[2]);
}

/* Each stream has what it is called. */
static void all_streams(const WeftWorld* world, WeftClothId cloth) {
    static Whole all[144];
    WeftClothView view = {.struct_size = sizeof view};
    WeftVertexStreams streams = {.struct_size = sizeof streams};
    uint32_t i;
    TAKES(weft_world_cloth(world, cloth, &view));
    streams.positions = stream_at(all[0].place, all, 144);
    streams.previous_positions = stream_at(all[0].place_before, all, 144);
    streams.normals = stream_at(all[0].normal, all, 144);
    streams.previous_normals = stream_at(all[0].normal_before, all, 144);
    streams.strains = stream_at(all[0].strain, all, 144);
    if (view.texcoords != NULL) {
        streams.tangents = stream_at(all[0].tangent, all, 144);
        streams.texcoords = stream_at(all[0].texcoord, all, 144);
    }
    TAKES(weft_world_write_vertices(world, cloth, &streams, 0, SIZE_MAX));
    for (i = 0; i < 144; ++i) {
        const uint32_t particle = view.vertex_to_particle[i];
        CHECK(all[i].place[1] == view.positions[particle].y);
        CHECK(all[i].place_before[1] == view.previous_positions[particle].y);
        CHECK(all[i].normal[2] == view.normals[particle].z);
        CHECK(fabsf(length_of(all[i].normal_before) - 1) < 1e-5f &&
              all[i].normal_before[2] != all[i].normal[2]);
        CHECK(fabsf(all[i].strain[0]) < 1 && all[i].strain[0] != 0 && all[i].strain[0] != all[i].strain[1]);
        if (view.texcoords == NULL) continue;
        CHECK(fabsf(length_of(all[i].tangent) - 1) < 1e-5f && fabsf(all[i].tangent[3]) == 1);
        CHECK(all[i].texcoord[0] == view.texcoords[i].x && all[i].texcoord[1] == view.texcoords[i].y);
    }
}

static void questions(const WeftWorld* world, WeftClothId cloth) {
    const WeftVec3 up = {0, 1, 0};
    const WeftClothId all = {0, 0};
    WeftClothView view = {.struct_size = sizeof view};
    WeftClothPoint point, touched[4];
    WeftVec3 below, corner;
    WeftBool found = 0;
    size_t count = 0;
    TAKES(weft_world_cloth(world, cloth, &view));
    corner.x = view.positions[20].x;
    corner.y = view.positions[20].y;
    corner.z = view.positions[20].z;
    below = corner;
    below.y -= 10;
    TAKES(weft_world_cast_ray(world, below, up, 100, cloth, &point, &found));
    CHECK(found && point.cloth.index == cloth.index && point.triangle < view.triangle_count);
    CHECK(fabsf(point.weights.x + point.weights.y + point.weights.z - 1) < 1e-5f);
    TAKES(weft_world_closest_point(world, corner, 1, all, &point, &found));
    CHECK(found && point.distance < 1e-5f);
    TAKES(weft_world_triangles_in_ball(world, corner, 0.05f, cloth, touched, 4, &count));
    CHECK(count >= 3);
    TAKES(weft_world_cast_ray(world, below, up, 0.001f, all, &point, &found));
    CHECK(!found);
    REFUSES(WEFT_INVALID_ARGUMENT, "reach", weft_world_cast_ray(world, below, up, -1, all, &point, &found));
}

static void reports(const WeftWorld* world, WeftClothId cloth) {
    WeftStepReport report = {.struct_size = sizeof report};
    WeftClothReport own = {.struct_size = sizeof own};
    size_t contacts = 0, stages = 0, bodies = 0;
    const WeftContact* contact;
    const WeftStageTime* stage;
    const WeftBodyImpulse* impulse;
    TAKES(weft_world_report(world, &report));
    CHECK(report.cloths == 2 && report.step == 20 && report.particles == 288);
    TAKES(weft_world_cloth_report(world, cloth, &own));
    CHECK(own.enabled && own.particles == 144);
    contact = weft_world_contacts(world, &contacts);
    CHECK(contacts > 0 && contacts <= report.contacts);
    CHECK(contact->collider.generation != 0 && contact->other_cloth.generation == 0);
    CHECK(fabsf(contact->normal.x * contact->normal.x + contact->normal.y * contact->normal.y +
                contact->normal.z * contact->normal.z - 1) < 1e-3f);
    stage = weft_world_profile(world, &stages);
    CHECK(stages > 2 && strlen(stage->name) > 0 && stage[stages - 1].depth == 0 &&
          stage[stages - 1].samples == 20);
    impulse = weft_world_body_impulses(world, &bodies);
    CHECK(bodies == 1 && (impulse->linear.x != 0 || impulse->linear.y != 0));
}

void look_at(WeftWorld* world, WeftClothId cloth, const char* folder) {
    Drawn drawn = {0, 0};
    const WeftDebugCanvas canvas = {&drawn, count_line, count_text};
    const char* text = NULL;
    char file[512];
    vertices(world, cloth);
    all_streams(world, cloth);
    questions(world, cloth);
    reports(world, cloth);
    TAKES(weft_world_debug_draw(world, &canvas, WEFT_DRAW_STRAIN | WEFT_DRAW_COSTS));
    CHECK(drawn.lines > 0 && drawn.texts > 0);
    TAKES(weft_world_describe(world, WEFT_DESCRIBE_JSON, &text));
    CHECK(text[0] == '{');
    REFUSES(WEFT_INVALID_ARGUMENT, "format", weft_world_describe(world, 2, &text));
    snprintf(file, sizeof file, "%s/trace.json", folder);
    TAKES(weft_world_start_trace(world, 64));
    TAKES(weft_world_write_trace(world, file));
}

void go_back(WeftWorld* world) {
    const size_t bytes = weft_world_save_size(world);
    void* const saved = malloc(bytes);
    const uint64_t hash = weft_world_state_hash(world);
    uint32_t restored = 7;
    WeftStepReport report = {.struct_size = sizeof report};
    TAKES(weft_world_save(world, saved, bytes));
    REFUSES(WEFT_INVALID_ARGUMENT, "dt", weft_world_step(world, 2));
    TAKES(weft_world_begin_step(world, 1.0f / 60));
    REFUSES(WEFT_INVALID_ARGUMENT, "end_step", weft_world_step(world, 1.0f / 60));
    TAKES(weft_world_work(world));
    TAKES(weft_world_end_step(world));
    REFUSES(WEFT_INVALID_ARGUMENT, "begin_step", weft_world_end_step(world));
    CHECK(weft_world_state_hash(world) != hash);
    TAKES(weft_world_restore(world, saved, bytes));
    CHECK(weft_world_state_hash(world) == hash);
    REFUSES(WEFT_MALFORMED_FILE, "", weft_world_restore(world, saved, bytes - 1));
    TAKES(weft_world_restore_cloths(world, saved, bytes, &restored));
    CHECK(restored == 0);
    report.struct_size = 3;
    REFUSES(WEFT_INVALID_ARGUMENT, "struct_size", weft_world_report(world, &report));
    free(saved);
}

typedef struct Bytes {
    unsigned char* data;
    size_t count;
} Bytes;
static WeftBool never(void* user, const void* bytes, size_t count) {
    (void)user;
    (void)bytes;
    (void)count;
    return 0;
}
static WeftBool append(void* user, const void* bytes, size_t count) {
    Bytes* const to = user;
    to->data = realloc(to->data, to->count + count);
    memcpy(to->data + to->count, bytes, count);
    to->count += count;
    return 1;
}

void record(const char* folder) {
    char file[512];
    Bytes bytes = {NULL, 0};
    const WeftRecordingSink sink = {append, &bytes}, other = {never, NULL};
    WeftReplay replay = {.struct_size = sizeof replay};
    int to_file;
    snprintf(file, sizeof file, "%s/c.weftrec", folder);
    for (to_file = 0; to_file < 2; ++to_file) {
        WeftWorld* world = NULL;
        WeftMesh* mesh = NULL;
        WeftClothId cloth;
        WeftClothSettings settings;
        int i;
        TAKES(weft_world_create(NULL, &world));
        TAKES(weft_mesh_make_sheet(NULL, &mesh));
        weft_cloth_settings_init(&settings, sizeof settings);
        settings.self_collision.method = WEFT_SELF_CONTACT;
        settings.self_collision.distance = 5; /* more particles than Weft keeps a list of */
        REFUSES(WEFT_INVALID_ARGUMENT, "distance", weft_world_add_cloth(world, mesh, &settings, &cloth));
        TAKES(to_file ? weft_world_start_recording(world, file)
                      : weft_world_start_recording_to(world, &sink));
        REFUSES(WEFT_INVALID_ARGUMENT, "record", weft_world_start_recording_to(world, &other));
        TAKES(weft_world_add_cloth(world, mesh, NULL, &cloth));
        for (i = 0; i < 3; ++i) TAKES(weft_world_step(world, 1.0f / 60));
        TAKES(weft_world_stop_recording(world));
        REFUSES(WEFT_INVALID_ARGUMENT, "", weft_world_stop_recording(world));
        weft_mesh_destroy(mesh);
        weft_world_destroy(world);
    }
    TAKES(weft_replay_bytes(bytes.data, bytes.count, 1, &replay));
    CHECK(replay.steps == 3 && replay.calls == 1 && replay.is_whole && !replay.differs);
    TAKES(weft_replay_bytes(bytes.data, bytes.count - 1, 1, &replay));
    CHECK(!replay.is_whole && !replay.differs);
    memset(&replay, 0, sizeof replay);
    replay.struct_size = sizeof replay;
    TAKES(weft_replay_file(file, 2, &replay));
    CHECK(replay.steps == 3 && replay.is_whole && !replay.differs && replay.different_cloth == -1);
    REFUSES(WEFT_FILE_NOT_FOUND, "none", weft_replay_file("none", 1, &replay));
    free(bytes.data);
}

static void drawn_mesh(void) {
    static WeftVec4 places[9];
    static unsigned char saved[256];
    const WeftVec3 corners[3] = {{-0.2f, 0.01f, -0.2f}, {0.2f, 0.01f, -0.2f}, {0, 0.01f, 0.2f}};
    const uint32_t triangle[3] = {0, 2, 1};
    WeftDrawnSurface surface;
    WeftDrawnMeshSettings settings;
    WeftDrawnMesh* drawn = NULL;
    WeftWorld* world = NULL;
    WeftMesh* mesh = NULL;
    WeftClothId cloth;
    /* Floats need not lie at a multiple of 16 bytes; the first such place in them does. */
    WeftVec4* const aligned = (WeftVec4*)(((uintptr_t)places + 15) / 16 * 16);
    memset(&surface, 0, sizeof surface);
    surface.struct_size = sizeof surface;
    surface.vertices.data = corners;
    surface.vertices.count = 3;
    surface.triangles.data = triangle;
    surface.triangles.count = 1;
    weft_drawn_mesh_settings_init(&settings, sizeof settings);
    CHECK(settings.rounding == 0.5f);
    TAKES(weft_world_create(NULL, &world));
    TAKES(weft_mesh_make_sheet(NULL, &mesh));
    TAKES(weft_world_add_cloth(world, mesh, NULL, &cloth));
    TAKES(weft_drawn_mesh_bind(world, cloth, &surface, &settings, &drawn));
    CHECK(weft_drawn_mesh_size(drawn) == 3);
    TAKES(weft_drawn_mesh_update(drawn, world, cloth, aligned, aligned + 4, NULL, 0, SIZE_MAX));
    CHECK(fabsf(aligned[4].y - 1) < 1e-5f && aligned[4].w == 0);
    CHECK(fabsf(aligned[1].x - 0.2f) < 1e-5f && fabsf(aligned[1].y - 0.01f) < 1e-5f && aligned[1].w == 1);
    REFUSES(WEFT_INVALID_ARGUMENT, "aligned",
            weft_drawn_mesh_update(drawn, world, cloth, (WeftVec4*)((char*)aligned + 4), NULL, NULL, 0, 1));
    CHECK(weft_drawn_mesh_rounding(drawn) == 0.5f && weft_drawn_mesh_rounding(NULL) == 0);
    CHECK(weft_drawn_mesh_bonds(drawn)[1].normal[2] > 0.99f && weft_drawn_mesh_bonds(NULL) == NULL);
    CHECK(weft_drawn_mesh_save_size(drawn) == sizeof saved && weft_drawn_mesh_save_size(NULL) == 0);
    REFUSES(WEFT_INVALID_ARGUMENT, "256", weft_drawn_mesh_save(drawn, saved, 255));
    TAKES(weft_drawn_mesh_save(drawn, saved, sizeof saved));
    aligned[0].y += 0.02f;
    TAKES(weft_drawn_mesh_begin_blend(drawn, world, cloth, aligned, NULL));
    TAKES(weft_drawn_mesh_blend(drawn, 0.5f));
    TAKES(weft_drawn_mesh_update(drawn, world, cloth, aligned, NULL, NULL, 0, SIZE_MAX));
    CHECK(fabsf(aligned[0].y - 0.02f) < 1e-5f && fabsf(aligned[1].y - 0.01f) < 1e-5f);
    REFUSES(WEFT_INVALID_ARGUMENT, "left", weft_drawn_mesh_blend(drawn, 2));
    REFUSES(WEFT_INVALID_ARGUMENT, "null", weft_drawn_mesh_begin_blend(drawn, world, cloth, NULL, NULL));
    REFUSES(WEFT_INVALID_ARGUMENT, "3 vertices", weft_carry_state(world, cloth, cloth, drawn));
    weft_drawn_mesh_destroy(drawn);
    TAKES(weft_drawn_mesh_load(saved, sizeof saved, world, cloth, &drawn));
    CHECK(weft_drawn_mesh_size(drawn) == 3);
    saved[99] ^= 1;
    REFUSES(WEFT_MALFORMED_FILE, "checksum", weft_drawn_mesh_load(saved, sizeof saved, world, cloth, &drawn));
    weft_drawn_mesh_destroy(drawn);
    weft_mesh_destroy(mesh);
    weft_world_destroy(world);
}

static void proxy(void) {
    WeftProxySettings settings;
    WeftProxyReport report = {.struct_size = sizeof report};
    WeftMesh *mesh = NULL, *made = NULL;
    WeftMeshView view = {.struct_size = sizeof view};
    weft_proxy_settings_init(&settings, sizeof settings);
    CHECK(settings.particles == 3000);
    settings.particles = 100;
    TAKES(weft_mesh_make_sheet(NULL, &mesh));
    TAKES(weft_mesh_make_proxy(mesh, &settings, &report, &made));
    TAKES(weft_mesh_view(made, &view));
    CHECK(view.positions.count == 100 && report.parts == 1 && report.longest_edge > report.shortest_edge);
    settings.thickness = -1;
    REFUSES(WEFT_INVALID_ARGUMENT, "thickness", weft_mesh_make_proxy(mesh, &settings, NULL, &made));
    weft_mesh_destroy(made);
    weft_mesh_destroy(mesh);
}

static void clock_of_loop(void) {
    WeftFixedStepSettings settings, seen = {.struct_size = sizeof seen};
    WeftFixedStep* loop = NULL;
    WeftFixedStepFrame frame;
    weft_fixed_step_settings_init(&settings, sizeof settings);
    settings.step = 0.01;
    TAKES(weft_fixed_step_create(&settings, &loop));
    TAKES(weft_fixed_step_settings(loop, &seen));
    CHECK(seen.step == 0.01 && seen.max_steps_per_frame == 4);
    frame = weft_fixed_step_advance(loop, 0.025);
    CHECK(frame.steps == 2 && fabsf(frame.alpha - 0.5f) < 1e-3f);
    weft_fixed_step_reset(loop);
    CHECK(weft_fixed_step_advance(loop, 0.005).steps == 0);
    weft_fixed_step_destroy(loop);
}

static void log_line(void* user, int32_t level, const char* line) {
    CHECK((level == WEFT_LOG_NOTE || level == WEFT_LOG_WARNING) && strlen(line) > 0);
    *(int*)user += 1;
}

static void release(void* user, void* memory, size_t bytes, size_t alignment) {
    (void)user;
    (void)memory;
    (void)bytes;
    (void)alignment;
}

static void hooks(void) {
    /* A triangle of no area is left out. */
    static const WeftVec3 places[5] = {{0, 0, 0}, {1, 0, 0}, {0, 0, 1}, {2, 0, 0}, {0, 0, 0}};
    static const uint32_t triangles[2][3] = {{0, 2, 1}, {0, 1, 3}};
    static const WeftVec2 texcoords[5] = {{0, 0}, {1, 0}, {0, 1}, {0.5f, 0}, {0, 0}};
    int lines = 0;
    WeftHooks own;
    WeftMeshView view;
    WeftMesh* mesh = NULL;
    WeftCookedCloth* cooked = NULL;
    WeftCookReport report = {.struct_size = sizeof report};
    memset(&own, 0, sizeof own);
    memset(&view, 0, sizeof view);
    own.struct_size = sizeof own;
    own.user = &lines;
    own.log = log_line;
    TAKES(weft_set_hooks(&own));
    {
        int others = 0;
        WeftHooks refused = own;
        refused.user = &others;
        refused.release = release;
        REFUSES(WEFT_INVALID_ARGUMENT, "release", weft_set_hooks(&refused)); /* lines go on to `lines` */
    }
    view.struct_size = sizeof view;
    view.positions.data = places;
    view.positions.count = 5;
    view.triangles.data = triangles;
    view.triangles.count = 2;
    view.texcoords.data = texcoords;
    view.texcoords.count = 5;
    TAKES(weft_mesh_create(&view, &mesh));
    TAKES(weft_cooked_cloth_create(mesh, NULL, NULL, &cooked));
    TAKES(weft_cooked_cloth_report(cooked, &report));
    CHECK(lines > 0 && report.dropped_count == 1 && report.dropped->why == WEFT_DROP_NO_AREA);
    CHECK(report.welded_count == 1 && report.welded->vertex == 4 && report.loose_count > 0 &&
          report.turned_count == 0);
    CHECK(weft_memory_in_use().bytes > 0);
    {
        WeftWorld* world = NULL;
        WeftClothId cloth;
        WeftClothView seen = {.struct_size = sizeof seen};
        int corner;
        TAKES(weft_world_create(NULL, &world));
        TAKES(weft_world_add_cloth(world, mesh, NULL, &cloth));
        TAKES(weft_world_cloth(world, cloth, &seen));
        CHECK(seen.vertices == 5 && seen.particles == 4 && seen.triangle_count == 1);
        CHECK(seen.vertex_triangles != NULL &&
              seen.vertex_triangles != seen.triangles); /* they are the host's own vertices, and particles */
        for (corner = 0; corner < 3; ++corner)
            CHECK(seen.vertex_to_particle[seen.vertex_triangles->vertices[corner]] ==
                  seen.triangles->vertices[corner]);
        weft_world_destroy(world);
    }
    weft_mesh_destroy(mesh);
    weft_cooked_cloth_destroy(cooked);
    TAKES(weft_set_hooks(NULL));
}

static void numbers_of_settings(void) {
    WeftClothSettings settings;
    WeftWorldSettings world;
    WeftSettingNumber numbers[64];
    size_t count = 0, k, found = 0;
    weft_cloth_settings_init(&settings, sizeof settings);
    CHECK(weft_cloth_settings_numbers(&settings, numbers, 64, &count) == WEFT_OK && count > 30 && count < 64);
    for (k = 0; k < count; ++k)
        if (strcmp(numbers[k].type, "Fabric") == 0 && strcmp(numbers[k].field, "warp") == 0) {
            CHECK(numbers[k].number == &settings.fabric.warp && numbers[k].greatest == 1e9f);
            ++found;
        } else if (strcmp(numbers[k].field, "passes") == 0) {
            CHECK(numbers[k].whole == &settings.method.passes && numbers[k].least == 1);
            ++found;
        }
    CHECK(found == 2);
    weft_world_settings_init(&world, sizeof world);
    CHECK(weft_world_settings_numbers(&world, numbers, 1, &count) == WEFT_OK && count > 1);
    CHECK(numbers[0].number == &world.gravity.x && numbers[0].components == 3);
    REFUSES(WEFT_INVALID_ARGUMENT, "numbers", weft_world_settings_numbers(&world, NULL, 1, &count));
}

void rest_of_the_host(void) {
    numbers_of_settings();
    size_t fabrics = 0;
    const WeftNamedFabric* const fabric = weft_fabrics(&fabrics);
    CHECK(fabrics == 9 && strcmp(fabric->name, "cotton") == 0 && fabric->fabric.warp == 1675);
    CHECK(weft_version() == WEFT_VERSION && strcmp(weft_version_string(), WEFT_VERSION_STRING) == 0);
    drawn_mesh();
    proxy();
    clock_of_loop();
    hooks();
    weft_mesh_destroy(NULL);
    weft_world_destroy(NULL);
    REFUSES(WEFT_INVALID_ARGUMENT, "world", weft_world_step(NULL, 0.01f));
    CHECK(weft_world_contacts(NULL, &fabrics) == NULL && fabrics == 0);
}
