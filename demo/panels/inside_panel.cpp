#include <array>

#include "demo/panels/column.h"
#include "demo/panels/panels.h"
#include "demo/panels/widgets.h"

namespace weft::demo {
namespace {

struct Part {
    DebugParts part;
    const char* name;
    const char* explanation;
};
constexpr std::array parts{
    Part{DebugParts::strain, "stretch",
         "Edges: red where they are 5 % longer than at rest, blue where shorter."},
    Part{DebugParts::velocities, "velocities", "Lines to where each particle will be in 1/60 s."},
    Part{DebugParts::normals, "normals", "Which way the front of the cloth faces."},
    Part{DebugParts::pins, "pins", "What holds the cloth, and how far it is from where it should be."},
    Part{DebugParts::contacts, "contacts", "Where cloth touches, and how hard: longer lines push more."},
    Part{DebugParts::tangles, "crossings", "Where cloth goes through cloth. There should be none."},
    Part{DebugParts::colliders, "bodies", "Surfaces that the cloth keeps out of."},
    Part{DebugParts::levels, "multigrid levels",
         "Knots of the coarse nets by which it is computed: redder is coarser."},
    Part{DebugParts::cloths, "boxes", "Of each cloth: green awake, blue asleep."},
    Part{DebugParts::costs, "cost per cloth", "Milliseconds that each cloth took in the last step."},
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
    for (const Part& each : parts) {
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
