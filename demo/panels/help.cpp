#include <algorithm>

#include "demo/panels/column.h"
#include "demo/panels/panels.h"

namespace weft::demo {
namespace {

constexpr const char* lines[][2] = {
    {"left drag", "the wind's arrow, cloth, a ball or box; beside them, the camera; with shift, cuts"},
    {"right drag, wheel", "moves the camera, comes nearer; over what is held: its size"},
    {"arrow keys", "turn the wind; make it faster or slower"},
    {"T, P, F, B", "where the pointer is: throws a ball, pins or lets go, a fan, a blast"},
    {"G", "all scenes"},
    {"1 to 9", "the first scenes"},
    {"space, N, comma, full stop", "stops and goes; a step; a step back, a step on"},
    {"R", "the scene from its start"},
    {"F1", "this"},
    {"F2", "hides and shows the panels"},
    {"F5", "saves a picture"},
    {"F6", "records a film, until pressed again"},
    {"drop a file", "OBJ or glTF: hangs it up; JSON: settings"},
};

}  // namespace

void help_window(bool& shown, float room) {
    const float em = ImGui::GetFontSize();
    const float width = std::min(30 * em, room - em);
    const float height = ImGui::GetIO().DisplaySize.y - 8 * em;  // the bar of time is below
    ImGui::SetNextWindowPos({0.5f * (room - width), 0.5f * em});
    ImGui::SetNextWindowSizeConstraints({width, 0}, {width, height});
    constexpr ImGuiWindowFlags flags = ImGuiWindowFlags_NoCollapse | ImGuiWindowFlags_NoMove |
                                       ImGuiWindowFlags_NoSavedSettings | ImGuiWindowFlags_AlwaysAutoResize;
    if (ImGui::Begin("Help", &shown, flags) &&
        ImGui::BeginTable("keys", 2, ImGuiTableFlags_SizingStretchProp)) {
        ImGui::TableSetupColumn("what", 0, 1);
        ImGui::TableSetupColumn("does", 0, 2);
        for (const auto& [what, does] : lines) {
            ImGui::TableNextColumn();
            ImGui::TextWrapped("%s", what);
            ImGui::TableNextColumn();
            ImGui::TextWrapped("%s", does);
        }
        ImGui::EndTable();
        ImGui::TextWrapped("Rest the pointer on anything at the right to read what it does.");
    }
    ImGui::End();
}

}  // namespace weft::demo
