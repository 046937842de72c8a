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

}  // namespace

void files_panel(const Simulation& simulation, Look& look, bool& own_file) {
    const Section section("Files");
    if (!section) return;
    settings_buttons(look);
    if (!simulation.options().garment.empty() && ImGui::Button("Your file", {-1, 0})) own_file = true;
    ImGui::TextWrapped("Drop an OBJ or glTF file on the window to hang it up, or a JSON file of settings.");
}

}  // namespace weft::demo
