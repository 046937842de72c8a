/* The smallest host in C: a flag in the wind, written into vertices of the host's own. */

#include <stdio.h>
#include <stdlib.h>
#include <weft/weft_c.h>

enum { rows = 16, columns = 24 };

/* A vertex as a renderer might have it. */
typedef struct Vertex {
    float place[3];
    float normal[3];
    float texcoord[2];
} Vertex;

static Vertex vertices[rows * columns];

/* This host gives up at the first error. */
static void need(WeftResult result) {
    if (result == WEFT_OK) return;
    fprintf(stderr, "%s\n", weft_error_text());
    exit(1);
}

static WeftStream stream_at(float* first) {
    WeftStream stream;
    stream.data = first;
    stream.bytes = sizeof vertices - (size_t)((char*)first - (char*)vertices);
    stream.stride = sizeof(Vertex);
    return stream;
}

int main(void) {
    WeftWorldSettings air;
    WeftSheetSettings shape;
    WeftClothSettings cloth;
    WeftWorld* world = NULL;
    WeftMesh* sheet = NULL;
    WeftClothId flag;
    WeftVertexStreams streams = {.struct_size = sizeof streams};
    uint32_t pole[rows], row;
    int step;

    weft_world_settings_init(&air, sizeof air);
    air.wind.velocity.x = 6;
    air.wind.gust = 0.3f;
    need(weft_world_create(&air, &world));

    weft_sheet_settings_init(&shape, sizeof shape);
    shape.rows = rows;
    shape.columns = columns;
    shape.origin.y = 2;
    shape.u.x = 1.5f;
    shape.v.y = -1;
    shape.v.z = 0;
    need(weft_mesh_make_sheet(&shape, &sheet));

    weft_cloth_settings_init(&cloth, sizeof cloth);
    need(weft_fabric_named("flag", &cloth.fabric));
    need(weft_world_add_cloth(world, sheet, &cloth, &flag));
    weft_mesh_destroy(sheet);
    for (row = 0; row < rows; ++row) pole[row] = row * columns;
    need(weft_world_pin(world, flag, pole, rows));

    streams.positions = stream_at(vertices[0].place);
    streams.normals = stream_at(vertices[0].normal);
    for (step = 1; step <= 120; ++step) {
        need(weft_world_step(world, 1.0f / 60.0f));
        need(weft_world_write_vertices(world, flag, &streams, 0, SIZE_MAX));
    }
    printf("Weft %s: after 2 s the flag's far corner is at (%.2f, %.2f, %.2f)\n", weft_version_string(),
           (double)vertices[columns - 1].place[0], (double)vertices[columns - 1].place[1],
           (double)vertices[columns - 1].place[2]);
    weft_world_destroy(world);
    return 0;
}
