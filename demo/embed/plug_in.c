/* A plug-in of some other program, with Weft inside: it exports its own function and none of Weft's. */

#include <weft/weft_c.h>

#if defined(_WIN32)
#define SHOWN __declspec(dllexport)
#else
#define SHOWN __attribute__((visibility("default")))
#endif

SHOWN float height_of_falling_cloth(int steps);

/* Height of the sheet's highest point after the steps [m]; -1e9: Weft failed. */
float height_of_falling_cloth(int steps) {
    WeftWorld* world = NULL;
    WeftMesh* sheet = NULL;
    WeftClothId cloth;
    WeftClothView view = {.struct_size = sizeof view};
    float height = -1e9f;
    if (weft_world_create(NULL, &world) == WEFT_OK && weft_mesh_make_sheet(NULL, &sheet) == WEFT_OK &&
        weft_world_add_cloth(world, sheet, NULL, &cloth) == WEFT_OK) {
        while (steps-- > 0) weft_world_step(world, 1.0f / 60.0f);
        if (weft_world_cloth(world, cloth, &view) == WEFT_OK) height = view.bounds.upper.y;
    }
    weft_mesh_destroy(sheet);
    weft_world_destroy(world);
    return height;
}
