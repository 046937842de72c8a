// The user's own file, and files of settings.

#include <algorithm>
#include <array>
#include <cstdio>

#include "demo/character/garment/gltf_file.h"
#include "demo/headless/report_text.h"
#include "demo/look/settings_file.h"
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

namespace {

bool unit_menu(float& unit) {
    constexpr std::array units{0.0f, 1.0f, 0.01f, 0.001f, 0.0254f};
    constexpr const char* names[] = {"by its size", "metres", "centimetres", "millimetres", "inches"};
    auto chosen = static_cast<int>(std::ranges::find(units, unit) - units.begin());
    const bool changed = ImGui::Combo("its unit", &chosen, names, static_cast<int>(units.size()));
    tooltip("By its size: that by which it is as large as a garment.");
    if (changed) unit = units[static_cast<std::size_t>(chosen)];
    return changed;
}

bool up_menu(bool& y_is_up) {
    constexpr const char* ups[] = {"+Z (most garments)", "+Y"};
    int up = y_is_up ? 1 : 0;
    const bool changed = ImGui::Combo("its up", &up, ups, static_cast<int>(std::size(ups)));
    tooltip("Which way is up in the file: try the other where it lies on its side.");
    y_is_up = up == 1;
    return changed;
}

bool hold_menu(Hold& hold) {
    constexpr const char* holds[] = {"its highest opening, or end", "its top", "its border",
                                     "nothing: pin by P"};
    auto chosen = static_cast<int>(hold);
    const bool changed = ImGui::Combo("held by", &chosen, holds, static_cast<int>(std::size(holds)));
    tooltip(
        "What of the file's cloth stays where it is. By nothing it falls: pause, point at it and press P to "
        "pin it.");
    hold = static_cast<Hold>(chosen);
    return changed;
}

void show_size(const Simulation& simulation) {
    const Mesh& mesh = simulation.content().cloths.front().mesh;
    Vec3 lower = mesh.positions.front(), upper = lower;
    for (const Vec3& p : mesh.positions) {
        lower = {std::min(lower.x, p.x), std::min(lower.y, p.y), std::min(lower.z, p.z)};
        upper = {std::max(upper.x, p.x), std::max(upper.y, p.y), std::max(upper.z, p.z)};
    }
    ImGui::Text("%.2f m wide, %.2f m high, %.2f m deep", static_cast<double>(upper.x - lower.x),
                static_cast<double>(upper.y - lower.y), static_cast<double>(upper.z - lower.z));
}

}  // namespace

void file_window(bool& shown, Simulation& simulation, const std::string& message, float room,
                 PanelRequests& requests) {
    const float em = ImGui::GetFontSize(), width = std::min(26 * em, room - em);
    ImGui::SetNextWindowPos({0.5f * em, 0.5f * em});
    ImGui::SetNextWindowSizeConstraints({width, 0}, {width, ImGui::GetIO().DisplaySize.y - 8 * em});
    constexpr ImGuiWindowFlags flags = ImGuiWindowFlags_NoCollapse | ImGuiWindowFlags_NoMove |
                                       ImGuiWindowFlags_NoSavedSettings | ImGuiWindowFlags_AlwaysAutoResize;
    if (ImGui::Begin("Your file", &shown, flags)) {
        ImGui::PushItemWidth(-7 * em);
        SceneOptions& options = simulation.options();
        const bool hangs = simulation.entry().needs_garment, gltf = is_gltf(options.garment);
        ImGui::TextWrapped("%s", options.garment.filename().string().c_str());
        show_size(simulation);
        if (!gltf || hangs) requests.reload |= unit_menu(options.unit);
        if (!gltf) requests.reload |= up_menu(options.y_is_up);
        if (hangs) requests.reload |= hold_menu(options.hold);
        if (ImGui::Button(hangs ? "Put it on somebody" : "Hang it up", {-1, 0}))
            requests.scene = find_scene(hangs ? "character" : "garment");
        if (!message.empty()) ImGui::TextWrapped("%s", plain_words(message).c_str());
        ImGui::PopItemWidth();
    }
    ImGui::End();
}

}  // namespace weft::demo
