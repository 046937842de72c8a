#include "demo/panels/panels.h"
#include "demo/panels/scene_list.h"
#include "demo/panels/widgets.h"

namespace weft::demo {

void scene_panel(const Simulation& simulation, ScenePictures& pictures, const std::string& message,
                 Playback& playback, PanelRequests& requests) {
    begin_panel("Scene", {panel_margin, panel_margin}, {300, 264});
    ImGui::BeginChild("scenes", {0, 5.5f * ImGui::GetTextLineHeightWithSpacing()});
    scene_list(simulation, pictures, requests);
    ImGui::EndChild();
    ImGui::Separator();
    if (ImGui::Button(playback.paused ? "Run" : "Pause", {84, 0})) playback.paused = !playback.paused;
    tooltip("Space. Time stands still; camera and panels do not.");
    ImGui::SameLine();
    if (ImGui::Button("Single step", {96, 0})) {
        playback.paused = true;
        ++playback.single_steps;
    }
    tooltip("N. Pauses and advances by 1/60 s.");
    ImGui::SameLine();
    if (ImGui::Button("Reset", {84, 0})) requests.restart = true;
    tooltip("R. Starts the scene afresh with the settings as they are.");
    ImGui::Text("%.1f s, %.0f pictures a second", simulation.time(),
                static_cast<double>(ImGui::GetIO().Framerate));
    if (!message.empty()) ImGui::TextWrapped("%s", message.c_str());
    ImGui::TextDisabled("Drag: cloth, or the camera. Wheel: zoom.");
    ImGui::TextDisabled("Arrow keys: wind. F1: panels.");
    ImGui::End();
}

}  // namespace weft::demo
