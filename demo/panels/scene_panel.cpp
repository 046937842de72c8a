#include "demo/panels/column.h"
#include "demo/panels/panels.h"
#include "demo/panels/scene_list.h"
#include "demo/panels/widgets.h"

namespace weft::demo {

void scene_panel(const Simulation& simulation, ScenePictures& pictures, PanelRequests& requests) {
    const Section section("Scene", true);
    if (!section) return;
    ImGui::BeginChild("scenes", {0, 5.5f * ImGui::GetTextLineHeightWithSpacing()});
    scene_list(simulation, pictures, requests);
    ImGui::EndChild();
}

}  // namespace weft::demo
