#include "demo/time/time_bar.h"

#include <algorithm>
#include <cinttypes>
#include <cstdio>

#include "demo/panels/widgets.h"

namespace weft::demo {
namespace {

constexpr float widest_bar = 592;  // [pixels]

float width_of(const char* label) {
    return ImGui::CalcTextSize(label).x;
}
float width_of_button(const char* label) {
    return width_of(label) + 2 * ImGui::GetStyle().FramePadding.x;
}

/// Draws the slider over the timeline's moments.
void show_moments(const Timeline& timeline, Playback& playback, TimeRequests& requests) {
    const int last = static_cast<int>(timeline.size()) - 1;
    int here = static_cast<int>(timeline.here());
    ImGui::PushItemWidth(-1);
    char text[48];
    std::snprintf(text, sizeof text, "%.2f s", last < 0 ? 0.0 : timeline.time_of(timeline.here()));
    if (ImGui::SliderInt("##moment", &here, 0, std::max(last, 1), text, ImGuiSliderFlags_NoInput) &&
        last >= 0) {
        playback.paused = true;
        requests.go_to = static_cast<std::size_t>(std::clamp(here, 0, last));
    }
    tooltip("Drag to go back in time. What runs on from there is a new future.");
    ImGui::PopItemWidth();
}

void show_buttons(const Timeline& timeline, Playback& playback, TimeRequests& requests) {
    if (ImGui::Button("<") && timeline.here() > 0) {
        playback.paused = true;
        requests.go_to = timeline.here() - 1;
    }
    tooltip("Comma. A step back.");
    const float pause = std::max(width_of_button("Pause"), width_of_button("Run"));
    same_line_if_room(pause);
    if (ImGui::Button(playback.paused ? "Run" : "Pause", {pause, 0})) playback.paused = !playback.paused;
    tooltip("Space.");
    same_line_if_room(width_of_button(">"));
    if (ImGui::Button(">")) {
        playback.paused = true;
        if (timeline.here() + 1 < timeline.size())
            requests.go_to = timeline.here() + 1;
        else
            ++playback.single_steps;
    }
    tooltip("Full stop. A step on: one that was taken already, or a new one of 1/60 s.");
    constexpr float speeds = 110;
    same_line_if_room(speeds + ImGui::GetStyle().ItemInnerSpacing.x + width_of("speed"));
    ImGui::PushItemWidth(speeds);
    slider("speed", playback.speed, 0.05f, 1, "%.2f x", "Slow motion: seconds of the scene in a second.",
           ImGuiSliderFlags_Logarithmic);
    ImGui::PopItemWidth();
    same_line_if_room(width_of_button("Reset"));
    requests.restart = ImGui::Button("Reset");
    tooltip("R. The scene from its start, with the settings as they are.");
    same_line_if_room(width_of_button("Defaults"));
    requests.defaults = ImGui::Button("Defaults");
    tooltip("The scene from its start, with all settings as they were.");
}

}  // namespace

std::string words_of(const RepeatCheck& check) {
    char text[160];
    if (!check.difference()) {
        std::snprintf(text, sizeof text, "%" PRIu64 " steps taken twice: the same bytes", check.checked());
        return text;
    }
    const RepeatCheck::Difference& found = *check.difference();
    if (found.cloth)
        std::snprintf(text, sizeof text, "step %" PRIu64 " differs, first in cloth %zu, particle %u",
                      found.step, *found.cloth, found.particle);
    else
        std::snprintf(text, sizeof text, "step %" PRIu64 " differs: %016" PRIx64 ", %016" PRIx64, found.step,
                      found.first, found.second);
    return text;
}

TimeRequests time_bar(const Timeline& timeline, Playback& playback, RepeatCheck& check, float room) {
    TimeRequests requests;
    const ImVec2 picture = ImGui::GetIO().DisplaySize;
    ImGui::SetNextWindowPos({0.5f * room, picture.y - panel_margin}, ImGuiCond_Always, {0.5f, 1});
    ImGui::SetNextWindowSize({std::min(widest_bar, room - 2 * panel_margin), 0});  // height by its content
    ImGui::Begin("Time", nullptr,
                 ImGuiWindowFlags_NoSavedSettings | ImGuiWindowFlags_NoTitleBar | ImGuiWindowFlags_NoResize |
                     ImGuiWindowFlags_NoMove | ImGuiWindowFlags_NoScrollbar);
    show_buttons(timeline, playback, requests);
    same_line_if_room(ImGui::GetFrameHeight() + ImGui::GetStyle().ItemInnerSpacing.x + width_of("twice"));
    if (ImGui::Checkbox("twice", &check.enabled)) check.forget();
    tooltip("Each step is taken, undone and taken again: both must leave the same bytes.");
    show_moments(timeline, playback, requests);
    if (check.enabled) ImGui::TextUnformatted(words_of(check).c_str());
    ImGui::End();
    return requests;
}

}  // namespace weft::demo
