#include "demo/panels/column.h"
#include "demo/panels/panels.h"
#include "demo/panels/widgets.h"

namespace weft::demo {
namespace {

/// The choice among the experiments of the contact lab.
void lab_menu(const SceneEntry& chosen, PanelRequests& requests) {
    if (!ImGui::BeginCombo("experiment", chosen.name)) return;
    for (const SceneEntry& entry : all_scenes()) {
        if (entry.group != SceneGroup::lab) continue;
        if (ImGui::Selectable(entry.name, &entry == &chosen)) requests.scene = &entry;
        tooltip(entry.description);
    }
    ImGui::EndCombo();
}

}  // namespace

void scene_panel(const Simulation& simulation, ScenePictures& pictures, bool& gallery,
                 PanelRequests& requests) {
    const Section section("Scene", true);
    if (!section) return;
    const SceneEntry& chosen = simulation.entry();
    if (const render::ShownImage* const image = pictures.of(chosen.name); image != nullptr) {
        ImGui::Image(image->texture(), {8 * ImGui::GetFontSize(), 5 * ImGui::GetFontSize()});
        ImGui::SameLine();
    }
    ImGui::BeginGroup();
    ImGui::TextUnformatted(chosen.name);
    ImGui::TextWrapped("%s", chosen.description);
    if (ImGui::Button("All scenes")) gallery = !gallery;
    tooltip("G. Every scene with its picture.");
    ImGui::EndGroup();
    if (chosen.group == SceneGroup::lab) lab_menu(chosen, requests);
}

}  // namespace weft::demo
