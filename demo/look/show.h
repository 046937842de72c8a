#pragma once
// The look's part of a picture in the window.

#include "demo/hands/key_taps.h"
#include "demo/headless/picture.h"
#include "demo/look/look.h"

namespace weft::demo {

/// Where a processor draws, quality starts low and rises.
void begin_look(Picture& picture, Look& look);

/// Draws the view, and chooses the quality of the next picture by what this one took.
void draw_picture(Picture& picture, const render::View& view, int width, int height, Look& look);

/// Words of the inside over the picture, between the panels' begin() and end().
void draw_words(const Picture& picture, const render::OrbitCamera& camera);

/// Likewise what each of the compared is computed by, over it.
void draw_names(const Picture& picture, const Simulation& shown, const Comparison& comparison,
                const render::OrbitCamera& camera);

/// Moves the camera so that what stands beside the scene is seen as well; `beside` is how far away that is,
/// and was at the last call. Puts it back once it is 0.
void make_room_beside(render::OrbitCamera& camera, float beside, float& before);

/// Saves and records what the look asks for, of the view as it is shown but for what panels cover. What came
/// of it, in words; empty: nothing.
[[nodiscard]] std::string save_pictures(Picture& picture, const render::View& view, int width, int height,
                                        Look& look);

/// F2, F5 and F6; true if panels are to be shown or hidden.
[[nodiscard]] bool read_look_keys(const KeyTaps& keys, Look& look);

}  // namespace weft::demo
