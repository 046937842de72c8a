// The scenes, one line each, in the order in which they are listed: group by group. The line (GROUP, NAME,
// ...) names make_NAME_scene, which the scene's file defines. STAGED is a scene of contact/, by its name
// there and its StageView. The first is the one that starts when none is named.

#include "demo/scene.h"
#include "demo/scenes/contact/contact_scene.h"

// clang-format off
#define WEFT_SCENES(SCENE, STAGED) \
    SCENE(wind, flag, "A flag flies on its pole in a gusty wind.") \
    SCENE(wind, curtain, "A curtain on rings is drawn to and fro in a slow breeze.") \
    SCENE(wind, banner, "A banner is held at both ends, across a gusty wind.") \
    SCENE(wind, flags, "A hundred flags fly, made of one cooked cloth.") \
    SCENE(wind, bar, "A wall hanging carries a heavy bar along its lower edge.") \
    SCENE(play, sheet, "A sheet falls over a sphere and onto the ground.") \
    SCENE(play, ball, "A ball falls into a hammock.") \
    SCENE(play, trampoline, "A box falls on a trampoline.") \
    SCENE(play, shapes, "A sheet falls over each kind of shape.") \
    SCENE(play, rag, "A rag rides on a ball that goes to and fro.") \
    SCENE(play, tear, "A sheet is drawn apart till it tears in two.") \
    SCENE(wear, character, "Somebody walks in a dress, or in --garment, as --motion says.", .takes_garment = true, .takes_motion = true) \
    SCENE(wear, runner, "Somebody runs in a dress.", .takes_garment = true, .takes_motion = true) \
    SCENE(wear, crowd, "Twenty people walk in dresses.", .takes_garment = true, .takes_motion = true) \
    SCENE(wear, capes, "Five figures in capes turn to and fro in the wind.") \
    SCENE(wear, garment, "A garment from a file is hung by its highest opening.", .needs_garment = true) \
    STAGED(meet, hammock, "A sheet is dropped on one that hangs by its corners.", "dropped on of cloths", .nearer = 1.4f, .lower = -0.35f) \
    STAGED(meet, layers, "Three sheets fall over a sphere.", "stacked of cloths", .nearer = 1.7f, .damping = 0.01f, .air_damping = 2) \
    SCENE(meet, ribbon, "A long ribbon, lowered end first, piles up on itself.") \
    STAGED(meet, release, "A strip is twisted twice round, and let go.", "twist and release", .nearer = 0.9f, .lower = -0.1f, .check_steps = 420) \
    SCENE(learn, truth, "A flag flies beside its own motion in eight substeps.") \
    SCENE(learn, worn_truth, "A skirt walks beside its own motion in eight substeps.") \
    SCENE(learn, bench, "A strip bends beside its exact curve, and Cusick's drape is measured.") \
    STAGED(lab, folddrop, "A sheet folded ten times falls to the ground.", "folddrop", .nearer = 1.6f, .lower = 0.1f) \
    STAGED(lab, stack, "Five sheets are laid on one another.", "stack 5 of cloths") \
    STAGED(lab, stack10, "Ten sheets are laid on one another.", "ten sheets") \
    STAGED(lab, crumple, "A ceiling comes down on an upright sheet, and goes up again.", "crumple", .nearer = 1.6f, .lower = 0.25f) \
    STAGED(lab, twist, "The ends of a strip are turned against each other, twice.", "twist", .nearer = 1.25f) \
    STAGED(lab, gathered, "A curtain is drawn together to a quarter.", "gathered") \
    STAGED(lab, yank, "A corner is pulled at 10 m/s through its own cloth, which stops it.", "yank 10") \
    STAGED(lab, meeting, "Two sheets meet where nothing has weight.", "zero gravity of cloths", .nearer = 0.8f) \
    STAGED(lab, tangled, "Cloth that starts through itself comes apart.", "tangled hung", .nearer = 0.5f, .lower = 0.5f) \
    STAGED(lab, crossed, "Two sheets that start through each other come apart.", "crossed 20")
// clang-format on

namespace weft::demo {

#define WEFT_DECLARE_SCENE(group, name, ...) std::unique_ptr<Scene> make_##name##_scene();
#define WEFT_NO_DECLARATION(...)
WEFT_SCENES(WEFT_DECLARE_SCENE, WEFT_NO_DECLARATION)

std::span<const SceneEntry> all_scenes() {
#define WEFT_LIST_SCENE(in, scene, text, ...) \
    SceneEntry{.name = #scene,                \
               .description = text,           \
               .make = make_##scene##_scene,  \
               .group = SceneGroup::in __VA_OPT__(, ) __VA_ARGS__},
#define WEFT_LIST_STAGED(in, scene, text, of_study, ...)                           \
    SceneEntry{.name = #scene,                                                     \
               .description = text,                                                \
               .make = [] { return make_contact_stage(of_study, {__VA_ARGS__}); }, \
               .group = SceneGroup::in},
    static constexpr SceneEntry scenes[] = {WEFT_SCENES(WEFT_LIST_SCENE, WEFT_LIST_STAGED)};
    return scenes;
}

}  // namespace weft::demo
