// The scenes, one line each, in the order in which they are listed. The line (NAME, ...) names make_NAME,
// which the scene's file defines. The first is the one that starts when none is named.

#include "demo/scene.h"

// clang-format off
#define WEFT_SCENES(SCENE)                                                                                   \
    SCENE(flag, "a flag on its pole in a gusty wind")                                                        \
    SCENE(curtain, "a curtain on rings, drawn to and fro in a slow breeze")                                  \
    SCENE(sheet, "a sheet that falls over a sphere and onto the ground")                                     \
    SCENE(ribbon, "a long ribbon, lowered end first, piles up on itself")                                    \
    SCENE(garment, "a garment from a file, hung by its highest opening", .needs_garment = true)         \
    SCENE(character, "somebody walks in a dress, or in --garment, as --motion says", .takes_garment = true, .takes_motion = true) \
    SCENE(crowd, "twenty of them", .takes_garment = true, .takes_motion = true)                              \
    SCENE(folddrop, "a sheet folded ten times falls to the ground")                                          \
    SCENE(stack, "five sheets are laid on one another")                                                      \
    SCENE(layers, "three sheets fall over a sphere")                                                         \
    SCENE(crumple, "a ceiling comes down on an upright sheet, and goes up again")                            \
    SCENE(twist, "the ends of a strip are turned against each other, twice")                                 \
    SCENE(gathered, "a curtain is drawn together to a quarter")                                              \
    SCENE(yank, "a corner is pulled at 10 m/s through its own cloth, which stops it")                        \
    SCENE(meeting, "two sheets meet where nothing has weight")                                               \
    SCENE(hammock, "a sheet is dropped on one that hangs by its corners")                                    \
    SCENE(tangled, "cloth that starts through itself comes apart")                                           \
    SCENE(crossed, "two sheets that start through each other come apart")                                   \
    SCENE(ball, "a ball falls into a hammock")                                                              \
    SCENE(trampoline, "a box on a trampoline")                                                              \
    SCENE(shapes, "a sheet over each kind of shape")                                                        \
    SCENE(runner, "somebody runs", .takes_garment = true)                                                   \
    SCENE(banner, "a banner held at both ends, across a gusty wind")                                        \
    SCENE(flags, "a hundred flags, made of one cooked cloth")                                               \
    SCENE(capes, "five figures in capes turn to and fro in the wind")                                       \
    SCENE(rag, "a rag on a ball that goes to and fro")                                                      \
    SCENE(bar, "a wall hanging whose lower edge is fixed to a bar with mass")                               \
    SCENE(release, "a strip is twisted twice round, and let go")                                            \
    SCENE(stack10, "ten sheets are laid on one another")                                                            \
    SCENE(tear, "a sheet is drawn apart till it tears in two")                                               \
    SCENE(truth, "a flag beside its own motion in eight substeps")                                          \
    SCENE(worn_truth, "a skirt that walks, beside its own motion in eight substeps")                        \
    SCENE(bench, "a strip beside its exact curve, and Cusick's drape: two tests of fabric")
// clang-format on

namespace weft::demo {

#define WEFT_DECLARE_SCENE(name, ...) std::unique_ptr<Scene> make_##name##_scene();
WEFT_SCENES(WEFT_DECLARE_SCENE)

std::span<const SceneEntry> all_scenes() {
#define WEFT_LIST_SCENE(scene, text, ...) \
    SceneEntry{.name = #scene, .description = text, .make = make_##scene##_scene __VA_OPT__(, ) __VA_ARGS__},
    static constexpr SceneEntry scenes[] = {WEFT_SCENES(WEFT_LIST_SCENE)};
    return scenes;
}

}  // namespace weft::demo
