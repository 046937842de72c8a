#include <array>
#include <cstdio>

#include "demo/look/settings_file.h"
#include "demo/panels/column.h"
#include "demo/panels/panels.h"
#include "demo/panels/widgets.h"

namespace weft::demo {
namespace {

void settings_buttons(Look& look) {
    std::array<char, 256> name{};
    std::snprintf(name.data(), name.size(), "%s", look.settings_file.c_str());
    if (ImGui::InputText("settings", name.data(), name.size())) look.settings_file = name.data();
    tooltip("A JSON file with all that the panels set; --settings FILE takes it, too.");
    const float half = 0.5f * (ImGui::GetContentRegionAvail().x - ImGui::GetStyle().ItemSpacing.x);
    look.wants_save |= ImGui::Button("Save", {half, 0});
    tooltip("Writes it.");
    ImGui::SameLine();
    look.wants_load |= ImGui::Button("Load", {half, 0});
    tooltip("Gives the cloth and the wind what the file says.");
}

/// Menus of a garment's pins and of its up axis. True if one was changed.
bool hold_menu(SceneOptions& options) {
    constexpr const char* holds[] = {"its highest opening", "its top", "its border", "nothing: pin by P"};
    auto hold = static_cast<int>(options.hold);
    bool changed = ImGui::Combo("held by", &hold, holds, static_cast<int>(std::size(holds)));
    tooltip(
        "What of the file's cloth stays where it is. By nothing it falls: pause, point at it and press P to "
        "pin it.");
    options.hold = static_cast<Hold>(hold);
    constexpr const char* ups[] = {"+Z (most garments)", "+Y"};
    int up = options.y_is_up ? 1 : 0;
    changed |= ImGui::Combo("its up", &up, ups, static_cast<int>(std::size(ups)));
    tooltip("Which way is up in the file: try the other where it lies on its side.");
    options.y_is_up = up == 1;
    return changed;
}

}  // namespace

void files_panel(Simulation& simulation, Look& look, PanelRequests& requests) {
    const Section section("Files");
    if (!section) return;
    settings_buttons(look);
    if (simulation.entry().needs_garment) requests.reload |= hold_menu(simulation.options());
    ImGui::TextWrapped("Drop an OBJ or glTF file on the window to hang it up, or a JSON file of settings.");
}

}  // namespace weft::demo
