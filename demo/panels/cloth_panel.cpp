#include <algorithm>
#include <array>
#include <thread>

#include "demo/look/materials.h"
#include "demo/panels/panels.h"
#include "demo/panels/widgets.h"
#include "demo/self_collision.h"

namespace weft::demo {
namespace {

/// The fabric's name among materials(), else among fabrics(); "own" where sliders have changed it.
const char* material_name(const Fabric& fabric) {
    for (const Material& each : materials())
        if (each.fabric == fabric) return each.name;
    const auto measured = std::ranges::find(fabrics(), fabric, &NamedFabric::fabric);
    return measured == fabrics().end() ? "own" : measured->name;
}

bool choice(const char* name, const char* note, const Fabric& offered, Fabric& fabric) {
    const bool chosen = offered == fabric;
    const bool taken = ImGui::Selectable(name, chosen) && !chosen;
    tooltip(note);
    if (taken) fabric = offered;
    return taken;
}

/// A menu of materials. `woven`: the chosen material, whose threads the cloth gets, too.
bool material_menu(Fabric& fabric, const Material*& woven) {
    bool changed = false;
    if (ImGui::BeginCombo("material", material_name(fabric), ImGuiComboFlags_HeightLargest)) {
        for (const Material& each : materials()) {
            if (!choice(each.name, each.note, each.fabric, fabric)) continue;
            woven = &each;
            changed = true;
        }
        ImGui::Separator();
        for (const NamedFabric& each : fabrics())
            if (std::ranges::find(materials(), std::string_view(each.name), &Material::name) ==
                materials().end())
                changed |= choice(each.name, each.source, each.fabric, fabric);
        ImGui::EndCombo();
    }
    tooltip("What the cloth is made of: how it moves and how it looks. Each says what one will see.");
    return changed;
}

/// True if these settings accept stiffening.
bool can_stiffen(const ClothSettings& settings) {
    return !settings.finite_elements.enabled && !std::holds_alternative<Xpbd>(settings.method) &&
           !std::holds_alternative<Fibres>(settings.method);
}

constexpr ImGuiSliderFlags by_factors = ImGuiSliderFlags_Logarithmic;

bool plain_sliders(Fabric& fabric) {
    float stiffness = stiffness_of(fabric);
    bool changed =
        slider("stiffness", stiffness, 30, 10000, "%.0f N/m",
               "How hard it is to stretch: below 100 it sags like a net, above 1000 it keeps its length.",
               by_factors);
    if (changed) set_stiffness(fabric, stiffness);
    float micro = 1e6f * fabric.bending;
    if (slider("bending", micro, 0.5f, 500, "%.1f \xc2\xb5N m",
               "How hard it is to fold: 2 falls in small wrinkles, 20 in wide folds, 300 is leather.",
               by_factors)) {
        fabric.bending = 1e-6f * micro;
        changed = true;
    }
    changed |=
        slider("weight", fabric.areal_density, 0.04f, 1, "%.2f kg/m\xc2\xb2",
               "Of a square metre: light cloth follows the wind, heavy cloth hangs and swings.", by_factors);
    float milliseconds = 1e3f * fabric.damping;
    if (slider("damping", milliseconds, 0, 50, "%.2f ms",
               "How soon trembling dies: 0 rustles like paper, 50 moves like wet cloth.", by_factors)) {
        fabric.damping = 1e-3f * milliseconds;
        changed = true;
    }
    return changed;
}

bool further_sliders(ClothSettings& settings) {
    Fabric& fabric = settings.fabric;
    bool changed = slider("warp", fabric.warp, 20, 20000, "%.0f N/m",
                          "Stiffness along the rows alone: how little it stretches that way.", by_factors);
    changed |= slider("weft", fabric.weft, 20, 20000, "%.0f N/m",
                      "Stiffness along the columns alone: how little it stretches down.", by_factors);
    changed |= slider("shear", fabric.shear, 2, 3000, "%.0f N/m",
                      "How hard squares become diamonds: low drapes round shapes, high creases.", by_factors);
    changed |= slider("weft bends", fabric.bending_ratio, 0.05f, 20, "%.2f times warp",
                      "How hard the columns are to fold, over the rows: at 10 it rolls up one way only.",
                      by_factors);
    if (can_stiffen(settings))
        changed |= slider("stiffening", fabric.stiffening, 0, 120, fabric.stiffening > 0 ? "%.1f" : "none",
                          "How much stiffer it is when stretched: wovens 2, knits up to 116.", by_factors);
    changed |= slider("air drag", settings.air_damping, 0, 10, "%.2f /s",
                      "How fast any motion dies, as in thick air: at 10 it sinks as in water.", by_factors);
    float skin = 1e3f * settings.thickness;
    if (slider("gap to bodies", skin, 1, 30, "%.1f mm",
               "How far from balls, bodies and the floor the cloth stays.", by_factors)) {
        settings.thickness = 1e-3f * skin;
        changed = true;
    }
    changed |= slider("friction", settings.friction, 0, 2, "%.2f",
                      "How well it holds on what it lies on: 0 slides off, 1 lies still.");
    changed |= slider("back's friction", settings.back_friction_ratio, 0, 4, "%.2f times front's",
                      "How well its back holds, over its front: below 1 it has a smooth lining.");
    return changed;
}

/// A slider by which closed cloth is blown up; other cloth has none.
bool filling_slider(const World& world, ClothId id, Filling& filling) {
    const auto info = world.filling_info(id);
    if (!info || info->open_edges > 0 || filling.kind == FillingKind::volume) return false;
    float pressure = filling.kind == FillingKind::none ? 0 : filling.pressure;
    if (!slider("blown up", pressure, 0, 20000, pressure > 0 ? "%.0f Pa" : "not at all",
                "The pressure in it, above that outside: a balloon has some 3000 Pa.", by_factors))
        return false;
    filling.pressure = pressure;
    if (filling.kind != FillingKind::gas)
        filling.kind = pressure > 0 ? FillingKind::pressure : FillingKind::none;
    return true;
}

bool self_collision_controls(ClothSettings& settings) {
    SelfCollision& self = settings.self_collision;
    auto chosen = static_cast<int>(std::ranges::find(self_collision_methods, self.method) -
                                   self_collision_methods.begin());
    std::array<const char*, self_collision_methods.size()> names;
    std::ranges::transform(self_collision_methods, names.begin(), name_of);
    bool changed = ImGui::Combo("self-collision", &chosen, names.data(), static_cast<int>(names.size()));
    tooltip(
        "Off costs nothing. Avoidance keeps particles apart, and layers still pass through each other where "
        "they are pressed. Impact zones keep momentum where layers meet, and still let some through. Contact "
        "lets nothing through, and costs most.");
    if (changed) set_method(self, self_collision_methods[static_cast<std::size_t>(chosen)]);
    float millimetres = 1e3f * self.distance;
    if (slider("layers apart", millimetres, 0, 30, millimetres > 0 ? "%.1f mm" : "from the mesh",
               "How far apart layers lie: more looks thicker. 0 takes 0.75 of an edge by avoidance, else "
               "0.3.")) {
        self.distance = 1e-3f * millimetres;
        changed = true;
    }
    if (self.method == SelfCollisionMethod::impact_zones)
        changed |= slider("restitution", self.restitution, 0, 1, "%.2f",
                          "How layers bounce off each other: 0 not at all, 1 as fast as they came.");
    return changed;
}

bool world_sliders(WorldSettings& settings) {
    bool changed = slider("substeps", settings.substeps, 1, 32, "%d",
                          "Steps in each 1/60 s: more follow fast wind and hands better, and take longer.",
                          ImGuiSliderFlags_Logarithmic);
    const int cores = static_cast<int>(std::max(1u, std::thread::hardware_concurrency()));
    changed |=
        slider("threads", settings.threads, 0, std::max(cores, settings.threads),
               settings.threads > 0 ? "%d" : "one per core",
               "Processors that work on the cloth: its motion is the same by any number, the time is not.");
    return changed;
}

}  // namespace

Result<void> cloth_panel(Simulation& simulation) {
    const Section section("Material", true);
    if (!section) return {};
    World& world = simulation.world();
    auto cloth = world.cloth_settings(simulation.content().cloths.front().id);
    const Material* woven = nullptr;
    bool cloth_changed = material_menu(cloth->fabric, woven);
    if (woven != nullptr) simulation.weave(woven->look);
    cloth_changed |= plain_sliders(cloth->fabric);
    const bool defaults = ImGui::Button("Restore defaults");
    tooltip("The scene's own material, wind and way of computing, as they were at first.");
    if (defaults) return simulation.restore_defaults();
    bool world_changed = false;
    WorldSettings settings = world.settings();
    if (begin_fold("More")) {
        cloth_changed |= further_sliders(*cloth);
        cloth_changed |= filling_slider(world, simulation.content().cloths.front().id, cloth->filling);
        cloth_changed |= self_collision_controls(*cloth);
        world_changed = world_sliders(settings);
        ImGui::TreePop();
    }
    if (world_changed)
        if (auto set = world.set_settings(settings); !set) return set;
    return cloth_changed ? set_all_cloths(simulation, *cloth) : Result<void>();
}

}  // namespace weft::demo
