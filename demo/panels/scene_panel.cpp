
#include <imgui.h>

#include <algorithm>

#include "demo/panels/panels.h"
#include "demo/panels/widgets.h"

namespace weft::demo {

namespace {

/// The titles of the groups, in the order of SceneGroup.
constexpr const char* titles[] = {"Wind", "Play", "Wear", "Meet", "Learn", "Contact lab"};
constexpr const char* lab_sentence = "Ten experiments of cloth that touches cloth; the panel has the choice.";

/// A card's picture, and the whole card: picture, name, three lines.
struct CardSize {
    ImVec2 picture, card;
};

/// Cards of 12 font sizes at least, as many as fill a row.
CardSize card_size(int& across) {
    const float em = ImGui::GetFontSize(), gap = ImGui::GetStyle().ItemSpacing.x;
    const float room = ImGui::GetContentRegionAvail().x + gap;
    across = std::max(1, static_cast<int>(room / (12 * em + gap)));
    const float width = room / static_cast<float>(across) - gap;
    const ImVec2 picture{width, 0.625f * width};
    return {picture, {width, picture.y + 4.6f * em}};
}

bool card(const SceneEntry& entry, const char* name, const char* sentence, const render::ShownImage* image,
          bool chosen, const CardSize& size) {
    const ImVec2 corner = ImGui::GetCursorScreenPos();
    ImGui::PushID(entry.name);
    const bool pressed = ImGui::Selectable("##card", chosen, 0, size.card);
    ImGui::PopID();
    if (chosen && ImGui::IsWindowAppearing()) ImGui::SetScrollHereY();
    ImDrawList& list = *ImGui::GetWindowDrawList();
    const ImVec2 below{corner.x + size.picture.x, corner.y + size.picture.y};
    if (image != nullptr)
        list.AddImage(image->texture(), corner, below);
    else
        list.AddRectFilled(corner, below, ImGui::GetColorU32(ImGuiCol_FrameBg));
    const float em = ImGui::GetFontSize();
    list.AddText({corner.x, below.y + 0.1f * em}, ImGui::GetColorU32(ImGuiCol_Text), name);
    list.AddText(ImGui::GetFont(), em, {corner.x, below.y + 1.3f * em},
                 ImGui::GetColorU32(ImGuiCol_TextDisabled), sentence, nullptr, size.card.x);
    return pressed;
}

}  // namespace

void gallery(bool& shown, const SceneEntry& chosen, const SceneEntry& lab, ScenePictures& pictures,
             float room, PanelRequests& requests) {
    const float em = ImGui::GetFontSize();
    ImGui::SetNextWindowPos({0.5f * em, 0.5f * em});
    ImGui::SetNextWindowSize({room - em, ImGui::GetIO().DisplaySize.y - 8 * em});  // the bar of time is below
    ImGui::SetNextWindowBgAlpha(1);
    constexpr ImGuiWindowFlags flags = ImGuiWindowFlags_NoCollapse | ImGuiWindowFlags_NoMove |
                                       ImGuiWindowFlags_NoResize | ImGuiWindowFlags_NoSavedSettings;
    if (ImGui::Begin("Scenes", &shown, flags)) {
        int across = 0;
        const CardSize size = card_size(across);
        int place = 0;
        const char* title = nullptr;
        for (const SceneEntry& entry : all_scenes()) {
            const bool in_lab = entry.group == SceneGroup::lab;
            if (in_lab && &entry != &lab) continue;
            if (const char* const group = titles[static_cast<int>(entry.group)]; group != title) {
                ImGui::TextUnformatted(title = group);
                place = 0;
            }
            if (place++ % across > 0) ImGui::SameLine();
            if (card(entry, in_lab ? "contact lab" : entry.name, in_lab ? lab_sentence : entry.description,
                     pictures.of(entry.name), &entry == &chosen, size))
                requests.scene = &entry;
        }
    }
    ImGui::End();
    if (requests.scene != nullptr) shown = false;
}

const render::ShownImage* ScenePictures::of(const char* scene) {
    const auto [entry, is_new] = pictures_.try_emplace(scene);
    if (is_new) {
        const std::string file = std::string(WEFT_SCENE_PICTURES "/") + scene + ".png";
        if (auto loaded = render::ShownImage::load(file.c_str())) entry->second.emplace(std::move(*loaded));
    }
    return entry->second ? &*entry->second : nullptr;
}

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
