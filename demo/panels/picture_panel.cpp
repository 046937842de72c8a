// The picture's quality, and views into the cloth's state.

#include <array>
#include <cstdio>

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

namespace {

struct ShownPart {
    DebugParts part;
    const char* name;
    const char* explanation;
};
constexpr std::array shown_parts{
    ShownPart{DebugParts::strain, "stretch",
              "Edges: red where they are 5 % longer than at rest, blue where shorter."},
    ShownPart{DebugParts::velocities, "velocities", "Lines to where each particle will be in 1/60 s."},
    ShownPart{DebugParts::normals, "normals", "Which way the front of the cloth faces."},
    ShownPart{DebugParts::pins, "pins", "What holds the cloth, and how far it is from where it should be."},
    ShownPart{DebugParts::contacts, "contacts", "Where cloth touches, and how hard: longer lines push more."},
    ShownPart{DebugParts::tangles, "crossings", "Where cloth goes through cloth. There should be none."},
    ShownPart{DebugParts::colliders, "bodies", "Surfaces that the cloth keeps out of."},
    ShownPart{DebugParts::levels, "multigrid levels",
              "Knots of the coarse nets by which it is computed: redder is coarser."},
    ShownPart{DebugParts::cloths, "boxes", "Of each cloth: green awake, blue asleep."},
    ShownPart{DebugParts::costs, "cost per cloth", "Milliseconds that each cloth took in the last step."},
};

void colour_menu(Inside& inside) {
    constexpr const char* names[] = {"the fabric's own", "stretch", "bending", "speed"};
    auto chosen = static_cast<int>(inside.colour);
    if (ImGui::Combo("colour", &chosen, names, static_cast<int>(std::size(names))))
        inside.colour = static_cast<ShownAsColour>(chosen);
    tooltip("What the cloth's colour shows.");
    if (inside.colour != ShownAsColour::nothing) ImGui::TextWrapped("%s", scale_of(inside.colour));
}

/// Requests reports of contacts only while they are shown.
Result<void> report_contacts(Simulation& simulation, bool wanted) {
    WorldSettings settings = simulation.world().settings();
    const int reports = wanted ? 4096 : 0;
    if (settings.contact_reports == reports) return {};
    settings.contact_reports = reports;
    return simulation.world().set_settings(settings);
}

}  // namespace

Result<void> inside_panel(Simulation& simulation, Inside& inside) {
    const Section section("Look inside");
    if (!section) return {};
    colour_menu(inside);
    ImGui::Checkbox("wireframe", &inside.wireframe);
    tooltip("The triangles that the cloth is drawn by.");
    const float half = 0.5f * ImGui::GetContentRegionAvail().x;
    Result<void> result;
    int place = 1;
    for (const ShownPart& each : shown_parts) {
        if (place++ % 2 == 1) ImGui::SameLine(half);
        bool shown = has(inside.parts, each.part);
        if (ImGui::Checkbox(each.name, &shown)) {
            inside.toggle(each.part);
            if (each.part == DebugParts::contacts) result = report_contacts(simulation, shown);
        }
        tooltip(each.explanation);
    }
    const std::uint32_t crossings = simulation.world().report().crossings;
    if (has(inside.parts, DebugParts::tangles)) ImGui::Text("%u crossings", crossings);
    return result;
}

}  // namespace weft::demo
