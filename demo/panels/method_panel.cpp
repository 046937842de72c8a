// The method, and two methods side by side.

#include "demo/options/method_table.h"
#include "demo/panels/panels.h"
#include "demo/panels/widgets.h"

namespace weft::demo {

namespace {

constexpr ImGuiSliderFlags logarithmic = ImGuiSliderFlags_Logarithmic;

/// A choice between `names`. True if it has changed.
bool choice(const char* label, int& chosen, std::span<const char* const> names) {
    return ImGui::Combo(label, &chosen, names.data(), static_cast<int>(names.size()));
}

/// A list of methods; a chosen one has its default settings.
bool method_list(Method& method) {
    bool changed = false;
    if (ImGui::BeginCombo("method", entry_of(method).title, ImGuiComboFlags_HeightLarge)) {
        for (const NamedMethod& each : all_methods()) {
            const bool present = each.method.index() == method.index();
            if (ImGui::Selectable(each.title, present) && !present) {
                method = each.method;
                changed = true;
            }
            tooltip(each.summary);
        }
        ImGui::EndCombo();
    }
    tooltip(entry_of(method).summary);
    return changed;
}

bool iterations_slider(int& iterations, int least, const char* explanation) {
    return slider("iterations", iterations, least, 500, "%d", explanation, logarithmic);
}

bool mean_motion_box(bool& exact) {
    const bool changed = ImGui::Checkbox("exact mean motion", &exact);
    tooltip("A cloth that nothing holds falls freely however few iterations run.");
    return changed;
}

bool own_controls(Jacobi& method) {
    const bool changed = iterations_slider(
        method.iterations, 0,
        "Steps towards the solution: few, and cloth sags and lags. Odd counts tremble less.");
    return mean_motion_box(method.exact_mean_motion) || changed;
}

bool own_controls(Chebyshev& method) {
    const bool changed = iterations_slider(
        method.iterations, 1, "Steps towards the solution in each substep: few, and cloth sags and lags.");
    return mean_motion_box(method.exact_mean_motion) || changed;
}

bool own_controls(ConjugateGradient& method) {
    return iterations_slider(method.iterations, 1,
                             "Steps towards the solution in each substep: few, and cloth sags and lags.");
}

bool own_controls(Multilevel& method) {
    return slider("passes", method.passes, 1, 20, "%d",
                  "How often a substep starts anew from where it has come: more, and fast motion is truer.");
}

bool own_controls(Xpbd& method) {
    return iterations_slider(method.iterations, 1, "More substeps of the cloth do more for their cost.");
}

bool set_solver_choice(const char* label, Fibres::SetSolver& solver) {
    constexpr const char* solvers[] = {"Gauss-Seidel", "LDL^T"};
    int chosen = static_cast<int>(solver);
    const bool changed = choice(label, chosen, solvers);
    solver = static_cast<Fibres::SetSolver>(chosen);
    return changed;
}

bool own_controls(Fibres& method) {
    bool changed =
        iterations_slider(method.iterations, 1, "Rounds over all fibres: few, and cloth stretches.");
    changed |= set_solver_choice("vertical", method.vertical);
    changed |= set_solver_choice("horizontal", method.horizontal);
    changed |= set_solver_choice("shear", method.shear);
    return changed;
}

bool own_controls(SymplecticEuler& /*method*/) {
    return false;
}

bool time_controls(ClothSettings& settings) {
    bool changed = slider(
        "cloth substeps", settings.substeps, 1, 64, "%d",
        "Shorter steps for the cloth alone: motion is livelier and truer, and takes longer.", logarithmic);
    if (!has_time_scheme(settings.method)) return changed;
    bool second_order = resolved(settings.time_scheme, settings.method) == TimeScheme::bdf2;
    const bool clicked = ImGui::Checkbox("second order in time", &second_order);
    tooltip("BDF2 in place of backward Euler: swings live longer, and less depends on the step.");
    if (!clicked) return changed;
    settings.time_scheme = second_order ? TimeScheme::bdf2 : TimeScheme::backward_euler;
    return true;
}

bool tether_controls(Tethers& tethers) {
    bool changed = ImGui::Checkbox("tethers", &tethers.enabled);
    tooltip("No particle gets further from the pins than the way along the cloth.");
    if (tethers.enabled)
        changed |= slider("slack", tethers.slack, 1, 2, "%.2f x", "Times the length along the cloth.");
    return changed;
}

}  // namespace

bool method_controls(ClothSettings& settings) {
    bool changed = method_list(settings.method);
    const bool positional =
        std::holds_alternative<Xpbd>(settings.method) || std::holds_alternative<Fibres>(settings.method);
    if (positional) settings.fabric.stiffening = 0;  // these methods refuse it
    changed |= std::visit([](auto& method) { return own_controls(method); }, settings.method);
    changed |= time_controls(settings);
    changed |= tether_controls(settings.tethers);
    return changed;
}

Result<void> method_panel(Simulation& simulation) {
    const Section section("How it is computed");
    if (!section) return {};
    auto settings = simulation.world().cloth_settings(simulation.content().cloths.front().id);
    const bool changed = method_controls(*settings);
    return changed ? set_all_cloths(simulation, *settings) : Result<void>();
}

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
    tooltip("The faster one takes more substeps, until both take as many milliseconds.");
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
        "most. Exact is the same cloth by at least four times the steps, each solved in four passes.");
    ImGui::TextWrapped("Cloth substeps: %d and %d. Where a cloth is off, the exact one shows as a ghost.",
                       comparison.shown().substeps, comparison.other().substeps);
}

}  // namespace

void compare_panel(const Simulation& simulation, Look& look) {
    const Section section("Compare");
    if (!section) return;
    method_choice(look);
    const bool running = look.comparison.has_value();
    if (ImGui::Button(running ? "End" : "Compare from the start", {-1, 0})) {
        look.wants_comparison = !running;
        look.ends_comparison = running;
    }
    tooltip("Both begin the scene anew with the same settings. Takes several times as long.");
    if (running && look.comparison) sides_table(simulation, *look.comparison);
}

}  // namespace weft::demo
