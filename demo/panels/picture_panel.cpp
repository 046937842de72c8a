#include <cstdio>

#include "demo/panels/column.h"
#include "demo/panels/panels.h"
#include "demo/panels/widgets.h"

namespace weft::demo {
namespace {

void quality_controls(QualityChoice& quality) {
    if (ImGui::BeginCombo("quality", quality.automatic ? "chosen by its time" : quality.now().name)) {
        if (ImGui::Selectable("chosen by its time", quality.automatic)) quality.automatic = true;
        tooltip("The best that leaves the pictures a second below.");
        int level = 0;
        for (const QualityLevel& each : quality_levels()) {
            if (ImGui::Selectable(each.name, !quality.automatic && level == quality.level()))
                quality.choose(level);
            tooltip(each.left_out[0] != 0 ? each.left_out : "Nothing is left out.");
            ++level;
        }
        ImGui::EndCombo();
    }
    tooltip("How much goes into a picture. Slow machines without a graphics card want less.");
    if (quality.automatic)
        slider("at least", quality.pictures_a_second, 10, 60, "%.0f pictures/s",
               "Quality goes down until drawing leaves time for so many.");
    const QualityLevel& now = quality.now();
    if (now.left_out[0] != 0)
        ImGui::TextWrapped("%s: %s", now.name, now.left_out);
    else
        ImGui::TextWrapped("%s: nothing is left out", now.name);
}

void picture_buttons(Look& look) {
    const float half = 0.5f * (ImGui::GetContentRegionAvail().x - ImGui::GetStyle().ItemSpacing.x);
    look.wants_picture |= ImGui::Button("Save picture", {half, 0});
    tooltip("F5. Leaves weft-0001.png, and so on, in the folder that the demo was started in.");
    ImGui::SameLine();
    const bool recording = look.recorder.recording();
    look.wants_film |= ImGui::Button(recording ? "Stop recording" : "Record", {half, 0});
    tooltip(
        "F6. Every picture, 30 for each second of the scene, as PNG files; and as an MP4 where ffmpeg is "
        "found.");
    if (recording) ImGui::Text("%d pictures so far", look.recorder.pictures());
}

}  // namespace

void picture_panel(Look& look) {
    const Section section("Picture");
    if (!section) return;
    quality_controls(look.quality);
    picture_buttons(look);
    slider("text size", look.text_size, 0.75f, 2, "%.2f x", "How large the panels' letters are.");
}

}  // namespace weft::demo
