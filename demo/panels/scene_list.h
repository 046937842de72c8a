#pragma once
// The scenes with pictures of themselves.

#include "demo/panels/panels.h"

namespace weft::demo {

/// Lists all scenes in the open panel, with the keys of the first nine beside their names.
void scene_list(const Simulation& simulation, ScenePictures& pictures, PanelRequests& requests);

}  // namespace weft::demo
