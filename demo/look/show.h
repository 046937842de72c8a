#pragma once
// Draws, names and saves the window's pictures, by the look.

#include "demo/hands/key_taps.h"
#include "demo/headless/picture.h"
#include "demo/look/look.h"

namespace weft::demo {

/// Starts quality low where a processor draws; it rises later.
void begin_look(Picture& picture, Look& look);

/// Draws the view, and chooses the quality of the next picture by this one's time.
void draw_picture(Picture& picture, const render::View& view, int width, int height, Look& look);

/// Draws the inside's words over the picture. Called between the panels' begin() and end().
void draw_words(const Picture& picture, const render::OrbitCamera& camera);

/// Draws the method's name over each of the compared cloths. Called where draw_words() is.
void draw_names(const Picture& picture, const Simulation& shown, const Comparison& comparison,
                const render::OrbitCamera& camera);

/// Moves the camera so that both compared scenes are seen; 0 moves it back. `beside`: distance of the second
/// scene [m]; `before`: that of the last call.
void make_room_beside(render::OrbitCamera& camera, float beside, float& before);

/// Saves and records the pictures that the look asks for, at full quality and without space for panels.
/// Returns the outcome in words; empty: nothing was done.
[[nodiscard]] std::string save_pictures(Picture& picture, const render::View& view, int width, int height,
                                        Look& look);

/// Reads F2, F5 and F6. True: panels are to be shown or hidden.
[[nodiscard]] bool read_look_keys(const KeyTaps& keys, Look& look);

}  // namespace weft::demo
