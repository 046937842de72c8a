#include "demo/options/method_table.h"
#include "demo/panels/column.h"
#include "demo/panels/panels.h"
#include "demo/panels/widgets.h"

namespace weft::demo {
namespace {

void method_choice(Look& look) {
    if (ImGui::BeginCombo("with", entry_of(look.compared).title, ImGuiComboFlags_HeightLarge)) {
        for (const NamedMethod& each : all_methods()) {
            if (ImGui::Selectable(each.title, each.method.index() == look.compared.index()))
                look.compared = each.method;
            tooltip(each.summary);
        }
        ImGui::EndCombo();
    }
    tooltip("The other way of computing the same cloth: it stands to the right.");
    if (ImGui::RadioButton("same steps", look.fairness == Fairness::same_steps))
        look.fairness = Fairness::same_steps;
    tooltip("Both take the same steps, whatever they cost.");
    ImGui::SameLine();
    if (ImGui::RadioButton("same time", look.fairness == Fairness::same_time))
        look.fairness = Fairness::same_time;
    tooltip("The other takes as many steps as fit into the milliseconds of the shown one.");
}

void side_row(const char* name, const Comparison::Side& side) {
    ImGui::TableNextRow();
    ImGui::TableNextColumn();
    ImGui::TextUnformatted(name);
    ImGui::TableNextColumn();
    ImGui::Text("%.2f", static_cast<double>(side.milliseconds));
    ImGui::TableNextColumn();
    ImGui::Text("%.1f", static_cast<double>(side.usual));
    ImGui::TableNextColumn();
    ImGui::Text("%.0f", static_cast<double>(side.farthest));
}

void sides_table(const Simulation& simulation, const Comparison& comparison) {
    const auto settings = simulation.world().cloth_settings(simulation.content().cloths.front().id);
    if (!ImGui::BeginTable("sides", 4, ImGuiTableFlags_SizingStretchProp)) return;
    ImGui::TableSetupColumn("", 0, 2.2f);
    for (const char* title : {"ms", "off mm", "most"}) ImGui::TableSetupColumn(title, 0, 1);
    ImGui::TableHeadersRow();
    side_row(entry_of(settings->method).title, comparison.shown());
    side_row(entry_of(comparison.method()).title, comparison.other());
    ImGui::EndTable();
    tooltip(
        "Milliseconds of a step, and how far particles are from where the exact motion puts them: usually "
        "and at "
        "most. Exact is the same cloth by eight times the steps, each solved to its end.");
    ImGui::TextWrapped("The other takes %d cloth substeps.", comparison.other().substeps);
}

}  // namespace

void compare_panel(const Simulation& simulation, Look& look) {
    const Section section("Compare");
    if (!section) return;
    method_choice(look);
    const bool running = look.comparison.has_value();
    if (ImGui::Button(running ? "End" : "Compare from the start", {-1, 0})) {
        look.wants_comparison = !running;
        if (running) look.comparison.reset();
    }
    tooltip("Both begin the scene anew with the same settings. Takes several times as long.");
    if (running && look.comparison) sides_table(simulation, *look.comparison);
}

}  // namespace weft::demo
