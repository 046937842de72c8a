#include "demo/panels/panels.h"

#include <algorithm>

#include "demo/hands/overlay.h"
#include "demo/panels/column.h"
#include "demo/panels/widgets.h"
#include "demo/report_text.h"

namespace weft::demo {

void StageHistory::add(std::span<const StageTime> stages) {
    if (stages.size() != stages_) {
        clear();
        stages_ = stages.size();
        times_.assign(length * stages_, 0.0f);
    }
    for (std::size_t s = 0; s < stages_; ++s) times_[next_ * stages_ + s] = stages[s].last;
    next_ = (next_ + 1) % length;
    size_ = std::min(size_ + 1, length);
}

void StageHistory::clear() {
    size_ = next_ = 0;
}

float StageHistory::at(std::size_t stage, std::size_t age) const {
    const std::size_t row = (next_ + length - 1 - age) % length;
    return times_[row * stages_ + stage];
}

void Panels::forget() {
    history_.clear();
    message.clear();
}

void Panels::record(const World& world) {
    history_.add(world.profile());
    look.times.add_step(world.report().milliseconds);
}

PanelRequests Panels::draw(Simulation& simulation, WindControl& wind, Hands& hands,
                           const Playback& playback, const render::OrbitCamera& camera) {
    PanelRequests requests;
    ImGui::GetIO().FontGlobalScale = look.text_size;
    const ImVec2 window = ImGui::GetIO().DisplaySize;
    room_ = window.x;
    if (visible) {
        if (begin_column(collapsed)) {
            room_ -= column_width(window, ImGui::GetFontSize());
            draw_column(simulation, wind, hands, playback, camera, requests);
        }
        ImGui::End();
    }
    if (help) help_window(help, room_);
    return requests;
}

void Panels::draw_column(Simulation& simulation, WindControl& wind, Hands& hands, const Playback& playback,
                         const render::OrbitCamera& camera, PanelRequests& requests) {
    if (ImGui::Button(">")) collapsed = true;
    tooltip("Folds the panels away. F2 hides them altogether.");
    ImGui::SameLine();
    if (ImGui::Button("Help")) help = !help;
    tooltip("F1. Keys and mouse.");
    ImGui::SameLine();
    ImGui::Text("%.0f pictures a second", static_cast<double>(ImGui::GetIO().Framerate));
    show_troubles(simulation, playback);
    scene_panel(simulation, pictures_, requests);
    note(wind_panel(simulation, wind, camera));
    hands_panel(hands);
    note(cloth_panel(simulation));
    picture_panel(look);
    note(inside_panel(simulation, look.inside));
    note(times_panel(simulation, history_, look));
    note(method_panel(simulation));
}

void Panels::show_troubles(const Simulation& simulation, const Playback& playback) {
    const StepReport& report = simulation.world().report();
    const WorldSettings& settings = simulation.world().settings();
    const ImVec4 warning{0.98f, 0.72f, 0.40f, 1};
    ImGui::PushStyleColor(ImGuiCol_Text, warning);
    ImGui::PushTextWrapPos(0);
    if (!message.empty()) ImGui::TextUnformatted(message.c_str());
    if (playback.behind_real_time)
        ImGui::TextUnformatted(
            what_is_slow(look.times.percentile(0.5f),
                         look.quality.level() + 1 == static_cast<int>(quality_levels().size())));
    if (report.flags != StepFlags::none)
        ImGui::TextUnformatted(flags_text(report.flags, speed_of(settings.wind)).c_str());
    ImGui::PopTextWrapPos();
    ImGui::PopStyleColor();
}

void Panels::note(const Result<void>& set) {
    if (!set) message = set.error().message;
}

Result<void> set_all_cloths(Simulation& simulation, const ClothSettings& settings) {
    for (const SceneCloth& each : simulation.content().cloths) {
        if (auto set = simulation.world().set_cloth_settings(each.id, settings); !set) return set;
    }
    return {};
}

}  // namespace weft::demo
