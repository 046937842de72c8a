#include "demo/panels/panels.h"

#include <algorithm>

#include "demo/hands/hands.h"
#include "demo/hands/overlay.h"
#include "demo/headless/report_text.h"
#include "demo/panels/widgets.h"

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
    residual_ = 0;
    message.clear();
    troubles_.clear();
    look.comparison.reset();
}

void Panels::record(const World& world) {
    history_.add(world.profile());
    look.times.add_step(world.report().milliseconds);
    constexpr float share = 0.02f;  // of a step: the mean is over a second, about
    residual_ += share * (world.report().residual - residual_);
}

PanelRequests Panels::draw(Simulation& simulation, WindControl& wind, Hands& hands, const Playback& playback,
                           const render::OrbitCamera& camera) {
    PanelRequests requests;
    ImGui::GetIO().FontGlobalScale = look.text_size;
    const ImVec2 window = ImGui::GetIO().DisplaySize;
    covered_ = 0;
    if (visible) {
        if (begin_column(collapsed)) {
            covered_ = column_width(window, ImGui::GetFontSize());
            draw_column(simulation, wind, hands, camera, requests);
        }
        ImGui::End();
    }
    show_messages(simulation, playback, window.x - covered_);
    if (help) help_window(help, window.x - covered_);
    if (simulation.entry().group == SceneGroup::lab) lab_ = &simulation.entry();
    if (lab_ == nullptr) lab_ = &*std::ranges::find(all_scenes(), SceneGroup::lab, &SceneEntry::group);
    own_file = own_file && simulation.entry().takes_garment && !simulation.options().garment.empty();
    if (help) return requests;
    if (gallery)
        demo::gallery(gallery, simulation.entry(), *lab_, pictures_, window.x - covered_, requests);
    else if (own_file)
        file_window(own_file, simulation, message, window.x - covered_, requests);
    return requests;
}

void Panels::draw_column(Simulation& simulation, WindControl& wind, Hands& hands,
                         const render::OrbitCamera& camera, PanelRequests& requests) {
    if (ImGui::Button(">")) collapsed = true;
    tooltip("Folds the panels away. F2 hides them altogether.");
    ImGui::SameLine();
    if (ImGui::Button("Help")) help = !help;
    tooltip("F1. Keys and mouse.");
    ImGui::SameLine();
    ImGui::Text("%.0f pictures a second", static_cast<double>(ImGui::GetIO().Framerate));
    scene_panel(simulation, pictures_, gallery, requests);
    note(wind_panel(simulation, wind, camera));
    hands_panel(hands);
    note(cloth_panel(simulation));
    note(paint_panel(simulation, hands.brush, look.inside, message));
    picture_panel(look);
    files_panel(simulation, look, own_file);
    note(inside_panel(simulation, look.inside));
    note(times_panel(simulation, history_, residual_, look));
    note(method_panel(simulation));
    compare_panel(simulation, look);
}

/// Collects troubles of the last steps, and keeps them readable for some time after their end.
void Panels::note_troubles(const Simulation& simulation, const Playback& playback) {
    const StepReport& report = simulation.world().report();
    std::string present;
    if (playback.behind_real_time)
        present
            .append(what_is_slow(look.times.percentile(0.5f),
                                 look.quality.level() + 1 == static_cast<int>(quality_levels().size())))
            .append("\n");
    // `unsolved` is left out: a cracking flag leaves more unsolved than swinging cloth. The times' panel
    // shows how much.
    const auto flags = static_cast<StepFlags>(static_cast<unsigned>(seen_flags(report)) &
                                              ~static_cast<unsigned>(StepFlags::unsolved));
    present += flags_text(flags, speed_of(simulation.world().settings().wind));
    constexpr double long_enough = 3;  // [s]
    if (!present.empty() && (present.size() >= troubles_.size() || ImGui::GetTime() > troubled_until_)) {
        troubles_ = present;
        troubled_until_ = ImGui::GetTime() + long_enough;
    }
    if (ImGui::GetTime() > troubled_until_) troubles_.clear();
}

/// Draws messages and troubles over the scene's upper left corner.
void Panels::show_messages(const Simulation& simulation, const Playback& playback, float room) {
    note_troubles(simulation, playback);
    if (help || gallery || own_file || (message.empty() && troubles_.empty()))
        return;  // windows cover their place
    const float em = ImGui::GetFontSize();
    ImGui::SetNextWindowPos({0.5f * em, 0.5f * em});
    ImGui::SetNextWindowBgAlpha(0.6f);
    constexpr ImGuiWindowFlags flags = ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_NoMove |
                                       ImGuiWindowFlags_NoSavedSettings | ImGuiWindowFlags_AlwaysAutoResize |
                                       ImGuiWindowFlags_NoFocusOnAppearing | ImGuiWindowFlags_NoInputs;
    ImGui::Begin("messages", nullptr, flags);
    ImGui::PushTextWrapPos(std::min(34 * em, room - 2 * em));
    if (!message.empty()) ImGui::TextUnformatted(plain_words(message).c_str());
    ImGui::PushStyleColor(ImGuiCol_Text, ImVec4(0.98f, 0.72f, 0.40f, 1));
    if (!troubles_.empty())
        ImGui::TextUnformatted(troubles_.c_str(), troubles_.c_str() + troubles_.size() - 1);
    ImGui::PopStyleColor();
    ImGui::PopTextWrapPos();
    ImGui::End();
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

namespace {

constexpr const char* lines[][2] = {
    {"left drag",
     "the wind's arrow, cloth, a ball or box; beside them, the camera; with shift, cuts; with the brush, "
     "paints"},
    {"right drag, wheel", "moves the camera, comes nearer; over what is held: its size"},
    {"arrow keys", "turn the wind; make it faster or slower"},
    {"T, P, F, B", "where the pointer is: throws a ball, pins or lets go, a fan, a blast"},
    {"G", "all scenes"},
    {"1 to 9", "the first scenes"},
    {"space, N, comma, full stop", "stops and goes; a step; a step back, a step on"},
    {"R", "the scene from its start"},
    {"F1", "this"},
    {"F2", "hides and shows the panels"},
    {"F5", "saves a picture"},
    {"F6", "records a film, until pressed again"},
    {"drop a file", "OBJ or glTF: hangs it up; JSON: settings"},
};

}  // namespace

void help_window(bool& shown, float room) {
    const float em = ImGui::GetFontSize();
    const float width = std::min(30 * em, room - em);
    const float height = ImGui::GetIO().DisplaySize.y - 8 * em;  // the bar of time is below
    ImGui::SetNextWindowPos({0.5f * (room - width), 0.5f * em});
    ImGui::SetNextWindowSizeConstraints({width, 0}, {width, height});
    constexpr ImGuiWindowFlags flags = ImGuiWindowFlags_NoCollapse | ImGuiWindowFlags_NoMove |
                                       ImGuiWindowFlags_NoSavedSettings | ImGuiWindowFlags_AlwaysAutoResize;
    if (ImGui::Begin("Help", &shown, flags) &&
        ImGui::BeginTable("keys", 2, ImGuiTableFlags_SizingStretchProp)) {
        ImGui::TableSetupColumn("what", 0, 1);
        ImGui::TableSetupColumn("does", 0, 2);
        for (const auto& [what, does] : lines) {
            ImGui::TableNextColumn();
            ImGui::TextWrapped("%s", what);
            ImGui::TableNextColumn();
            ImGui::TextWrapped("%s", does);
        }
        ImGui::EndTable();
        ImGui::TextWrapped("Rest the pointer on anything at the right to read what it does.");
    }
    ImGui::End();
}

}  // namespace weft::demo
