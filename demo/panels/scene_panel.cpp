#include <cstdio>

#include "demo/panels/column.h"
#include "demo/panels/panels.h"
#include "demo/panels/widgets.h"

namespace weft::demo {

void scene_panel(const Simulation& simulation, Playback& playback, PanelRequests& requests) {
    const Section section("Scene", true);
    if (!section) return;
    ImGui::BeginChild("scenes", {0, 5.5f * ImGui::GetTextLineHeightWithSpacing()});
    int key = 0;
    for (const SceneEntry& entry : all_scenes()) {
        char label[64];
        if (++key <= 9)  // that has one
            std::snprintf(label, sizeof label, "%d  %s", key, entry.name);
        else
            std::snprintf(label, sizeof label, "   %s", entry.name);
        if (ImGui::Selectable(label, &entry == &simulation.entry())) requests.scene = &entry;
        tooltip(entry.description);
    }
    ImGui::EndChild();
    const float third = (ImGui::GetContentRegionAvail().x - 2 * ImGui::GetStyle().ItemSpacing.x) / 3;
    if (ImGui::Button(playback.paused ? "Run" : "Pause", {third, 0})) playback.paused = !playback.paused;
    tooltip("Space. Time stands still; camera and panels do not.");
    ImGui::SameLine();
    if (ImGui::Button("Step", {third, 0})) {
        playback.paused = true;
        ++playback.single_steps;
    }
    tooltip("N. Pauses and advances by 1/60 s.");
    ImGui::SameLine();
    if (ImGui::Button("Reset", {third, 0})) requests.restart = true;
    tooltip("R. Starts the scene afresh with the settings as they are.");
    ImGui::Text("%.1f s", simulation.time());
}

}  // namespace weft::demo
