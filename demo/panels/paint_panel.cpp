// Maps that are painted on cloth with a brush.

#include <algorithm>

#include "demo/character/garment/painted_maps.h"
#include "demo/hands/hands.h"
#include "demo/panels/panels.h"
#include "demo/panels/widgets.h"

namespace weft::demo {
namespace {

void map_menu(Brush& brush) {
    if (ImGui::BeginCombo("paints", paint_of(brush.map).name)) {
        for (const Paint& each : paints()) {
            if (ImGui::Selectable(each.name, each.map == brush.map) && each.map != brush.map) {
                brush.map = each.map;
                brush.value = each.value;
            }
            tooltip(each.explanation);
        }
        ImGui::EndCombo();
    }
    tooltip(paint_of(brush.map).explanation);
}

void brush_sliders(Brush& brush) {
    const Paint& paint = paint_of(brush.map);
    float value = paint.unit * brush.value;
    constexpr ImGuiSliderFlags flags = ImGuiSliderFlags_Logarithmic;
    if (slider("to", value, paint.unit * paint.least, paint.unit * paint.most, paint.format,
               paint.explanation, flags))
        brush.value = std::clamp(value / paint.unit, paint.least, paint.most);
    float size = 1000 * brush.radius;
    if (slider("brush's size", size, 5, 500, "%.0f mm", "How far round the pointer it paints.", flags))
        brush.radius = 1e-3f * size;
}

}  // namespace

Result<void> paint_panel(Simulation& simulation, Brush& brush, Inside& inside, std::string& message) {
    const Section section("Paint");
    Result<void> done;
    if (section) {
        ImGui::Checkbox("brush in hand", &brush.is_in_hand);
        tooltip(
            "The left button paints cloth instead of dragging it. Blue is the least, red the most, grey is "
            "not painted.");
        map_menu(brush);
        brush_sliders(brush);
        const float half = 0.5f * (ImGui::GetContentRegionAvail().x - ImGui::GetStyle().ItemSpacing.x);
        if (ImGui::Button("Fill", {half, 0})) done = brush.fill(simulation, false);
        tooltip("Paints all of the cloth.");
        ImGui::SameLine();
        if (ImGui::Button("Clear", {half, 0})) done = brush.fill(simulation, true);
        tooltip("Takes this paint off all of the cloth.");
        if (const std::filesystem::path& file = simulation.options().garment; !file.empty()) {
            if (ImGui::Button("Save beside the garment", {-1, 0})) {
                const auto saved = save_maps(simulation);
                message = saved ? *saved : saved.error().message;
            }
            tooltip(("Writes " + maps_file(file).filename().string() + ", which is read with the garment.")
                        .c_str());
        }
    }
    inside.painted = brush.is_in_hand ? std::optional(brush.map) : std::nullopt;
    return done;
}

}  // namespace weft::demo
