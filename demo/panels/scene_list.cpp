#include "demo/panels/scene_list.h"

#include <cstdio>

#include "demo/panels/widgets.h"

namespace weft::demo {
namespace {

const ImVec2 picture_size{64, 40};

/// A row of the list, as high as its picture.
bool scene_row(const SceneEntry& entry, int key, const render::ShownImage* picture, bool chosen) {
    ImGui::PushID(entry.name);
    const ImVec2 corner = ImGui::GetCursorPos();
    const float height = picture != nullptr ? picture_size.y : ImGui::GetTextLineHeight();
    const bool pressed = ImGui::Selectable("##row", chosen, 0, {0, height});
    tooltip(entry.description);
    const ImVec2 next = ImGui::GetCursorPos();
    char label[64];
    if (key <= 9)  // later scenes have no key
        std::snprintf(label, sizeof label, "%d  %s", key, entry.name);
    else
        std::snprintf(label, sizeof label, "   %s", entry.name);
    if (picture != nullptr) {
        ImGui::SetCursorPos(corner);
        ImGui::Image(picture->texture(), picture_size);
    }
    const float beside = picture != nullptr ? picture_size.x + 10 : 0;
    ImGui::SetCursorPos({corner.x + beside, corner.y + 0.5f * (height - ImGui::GetTextLineHeight())});
    ImGui::TextUnformatted(label);
    ImGui::SetCursorPos(next);
    ImGui::PopID();
    return pressed;
}

}  // namespace

const render::ShownImage* ScenePictures::of(const char* scene) {
    const auto [entry, is_new] = pictures_.try_emplace(scene);
    if (is_new) {
        const std::string file = std::string(WEFT_SCENE_PICTURES "/") + scene + ".png";
        if (auto loaded = render::ShownImage::load(file.c_str())) entry->second.emplace(std::move(*loaded));
    }
    return entry->second ? &*entry->second : nullptr;
}

void scene_list(const Simulation& simulation, ScenePictures& pictures, PanelRequests& requests) {
    int key = 0;
    for (const SceneEntry& entry : all_scenes())
        if (scene_row(entry, ++key, pictures.of(entry.name), &entry == &simulation.entry()))
            requests.scene = &entry;
}

}  // namespace weft::demo
