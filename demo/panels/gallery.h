#pragma once
// All scenes with their pictures, as cards in groups.

#include "demo/panels/panels.h"

namespace weft::demo {

/// A window over the scene, within the `room` left of the column [pixels]; the chosen scene is in view when
/// it opens. `lab`: the experiment that the card of the contact lab starts. Choosing a card closes the
/// window.
void gallery(bool& shown, const SceneEntry& chosen, const SceneEntry& lab, ScenePictures& pictures,
             float room, PanelRequests& requests);

}  // namespace weft::demo
