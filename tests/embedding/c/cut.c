/* A host in C that cuts cloth. */

#include <string.h>

#include "check.h"
#include "host.h"

void cut_cloth(void) {
    /* Over the middle of the default sheet, which lies flat, from border to border. */
    const WeftBlade blade = {{-0.6f, 1, 0.003f}, {-0.6f, -1, 0.003f}, {0.6f, 1, 0.003f}, {0.6f, -1, 0.003f}};
    WeftMeshView view = {.struct_size = sizeof view};
    WeftClothView before = {.struct_size = sizeof before}, after = {.struct_size = sizeof after};
    WeftStrainedEdge strained[4];
    WeftMeshEdge torn[64];
    const WeftMeshEdge* edges = NULL;
    WeftWorld* world = NULL;
    WeftMesh *mesh = NULL, *cut = NULL;
    WeftCutStroke* stroke = NULL;
    WeftClothId cloth;
    size_t count = 0, from = 0, found = 0;
    uint32_t written = 9;
    TAKES(weft_world_create(NULL, &world));
    TAKES(weft_mesh_make_sheet(NULL, &mesh));
    TAKES(weft_world_add_cloth(world, mesh, NULL, &cloth));
    TAKES(weft_mesh_view(mesh, &view));
    TAKES(weft_cut_stroke_create(&stroke));
    TAKES(weft_edges_along(mesh, view.positions, &blade, stroke, &edges, &count));
    CHECK(count >= 63 && edges != NULL);
    TAKES(weft_cut_mesh(mesh, edges, count, &cut));
    CHECK(weft_mesh_added_particles(cut) >= 64);
    CHECK(weft_mesh_cut_from(cut, &from)[1] == 1 && from == 64 * 64 + weft_mesh_added_particles(cut));
    TAKES(weft_world_cloth(world, cloth, &before));
    TAKES(weft_world_recut_cloth(world, cloth, cut));
    TAKES(weft_world_cloth(world, cloth, &after));
    CHECK(after.particles == before.particles + weft_mesh_added_particles(cut));
    TAKES(weft_mesh_view(cut, &view));
    CHECK(view.welds.count == from && view.rows == 0);
    REFUSES(WEFT_INVALID_ARGUMENT, "",
            weft_world_recut_cloth(world, cloth, mesh)); /* it comes from nothing */

    TAKES(weft_world_strained_edges(world, cloth, -0.5f, strained, 4, &written));
    CHECK(written == 4 && strained[0].a != strained[0].b && strained[0].strain >= strained[3].strain);
    memset(torn, 0xab, sizeof torn);
    TAKES(weft_edges_to_tear(cut, view.positions, strained, 1, torn, 64, &found));
    CHECK(found > 1 && found < 64 && torn[found].vertices[0] == 0xabababab); /* nothing behind them */
    {
        const size_t all = found;
        torn[1].vertices[0] = 99999; /* of no mesh here */
        TAKES(weft_edges_to_tear(cut, view.positions, strained, 1, torn, 1, &found));
        CHECK(found == all && torn[1].vertices[0] == 99999); /* no more than there is room for */
    }
    REFUSES(WEFT_INVALID_ARGUMENT, "", weft_edges_to_tear(cut, view.positions, NULL, 1, torn, 64, &found));
    weft_cut_stroke_destroy(stroke);
    weft_mesh_destroy(cut);
    weft_mesh_destroy(mesh);
    weft_world_destroy(world);
}
