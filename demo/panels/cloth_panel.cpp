#include <algorithm>
#include <array>
#include <thread>

#include "demo/panels/panels.h"
#include "demo/panels/widgets.h"
#include "demo/rung.h"

namespace weft::demo {
namespace {

/// Fabrics by name; "own" where the sliders have made another.
bool fabric_menu(Fabric& fabric) {
    const auto present = std::ranges::find(fabrics(), fabric, &NamedFabric::fabric);
    bool changed = false;
    if (ImGui::BeginCombo("fabric", present == fabrics().end() ? "own" : present->name)) {
        for (const NamedFabric& each : fabrics()) {
            const bool chosen = each.fabric == fabric;
            if (ImGui::Selectable(each.name, chosen) && !chosen) {
                fabric = each.fabric;
                changed = true;
            }
            tooltip(each.source);
        }
        ImGui::EndCombo();
    }
    tooltip(present == fabrics().end() ? "Measured fabrics; each tells where its figures are from."
                                       : present->source);
    return changed;
}

/// Others refuse it.
bool can_stiffen(const ClothSettings& settings) {
    return !settings.finite_elements.enabled && !std::holds_alternative<Xpbd>(settings.method) &&
           !std::holds_alternative<Fibres>(settings.method);
}

bool fabric_sliders(ClothSettings& settings) {
    constexpr ImGuiSliderFlags log = ImGuiSliderFlags_Logarithmic;
    Fabric& fabric = settings.fabric;
    bool changed = fabric_menu(fabric);
    changed |= slider("warp", fabric.warp, 1, 1e5f, "%.0f N/m",
                      "Tension over strain along the rows, or along the pattern's first axis.", log);
    changed |= slider("weft", fabric.weft, 1, 1e5f, "%.0f N/m", "The same across them.", log);
    changed |= slider("shear", fabric.shear, 0.1f, 1e5f, "%.1f N/m", "Stiffness in shear.", log);
    float micro = 1e6f * fabric.bending;
    if (slider("bending", micro, 0.1f, 1e4f, "%.1f uN m", "Flexural rigidity: moment over curvature.", log)) {
        fabric.bending = 1e-6f * micro;
        changed = true;
    }
    changed |= slider("damping", fabric.damping, 0, 0.1f, "%.5f s",
                      "Time constant with which a strain that is let go decays.", log);
    if (can_stiffen(settings))
        changed |= slider("stiffening", fabric.stiffening, 0, 200, fabric.stiffening > 0 ? "%.1f" : "none",
                          "Growth of stiffness per strain: wovens 2, knits up to 116.", log);
    changed |= slider("weight", fabric.areal_density, 0.02f, 2, "%.2f kg/m2", "Mass of a square metre.", log);
    changed |=
        slider("air damping", settings.air_damping, 0, 10, "%.2f /s", "Rate at which velocity decays.", log);
    return changed;
}

bool self_collision_controls(ClothSettings& settings) {
    SelfCollision& self = settings.self_collision;
    auto rung = static_cast<int>(rung_of(self));
    std::array<const char*, rungs.size()> names;
    std::ranges::transform(rungs, names.begin(), name_of);
    bool changed = ImGui::Combo("self-collision", &rung, names.data(), static_cast<int>(names.size()));
    tooltip(
        "Off costs nothing. Avoidance keeps particles apart, and layers still pass through each other where "
        "they are pressed. Impact zones keep momentum where layers meet, and still let some through. Contact "
        "lets nothing through, and costs most.");
    if (changed) set_rung(self, static_cast<Rung>(rung));
    float millimetres = 1e3f * self.distance;
    if (slider("distance", millimetres, 0, 60, millimetres > 0 ? "%.1f mm" : "from the mesh",
               "How far apart layers are kept; 0 takes 0.75 of the mean edge by avoidance, else 0.3.")) {
        self.distance = 1e-3f * millimetres;
        changed = true;
    }
    if (rung_of(self) == Rung::impact_zones)
        changed |= slider("restitution", self.restitution, 0, 1, "%.2f",
                          "Of layers that meet: relative velocity after over before.");
    return changed;
}

bool world_sliders(WorldSettings& settings) {
    bool changed = slider("substeps", settings.substeps, 1, 256, "%d", "Steps of the solver in each 1/60 s.",
                          ImGuiSliderFlags_Logarithmic);
    const int cores = static_cast<int>(std::max(1u, std::thread::hardware_concurrency()));
    changed |= slider("threads", settings.threads, 0, std::max(cores, settings.threads),
                      settings.threads > 0 ? "%d" : "one per core", "The result does not depend on it.");
    return changed;
}

}  // namespace

Result<void> cloth_panel(Simulation& simulation) {
    begin_panel("Cloth", {-panel_margin, panel_margin}, {340, 370});
    World& world = simulation.world();
    ImGui::PushItemWidth(190);
    auto cloth = world.cloth_settings(simulation.content().cloths.front().id);
    bool cloth_changed = fabric_sliders(*cloth);
    ImGui::Separator();
    cloth_changed |= self_collision_controls(*cloth);
    ImGui::Separator();
    WorldSettings settings = world.settings();
    const bool world_changed = world_sliders(settings);
    ImGui::PopItemWidth();
    ImGui::End();

    if (world_changed)
        if (auto set = world.set_settings(settings); !set) return set;
    return cloth_changed ? set_all_cloths(simulation, *cloth) : Result<void>();
}

}  // namespace weft::demo
