#include <algorithm>
#include <array>

#include "demo/panels/panels.h"
#include "demo/panels/widgets.h"
#include "demo/report_text.h"

namespace weft::demo {
namespace {

constexpr std::array<ImU32, 13> palette{
    IM_COL32(86, 180, 233, 255),  IM_COL32(230, 159, 0, 255),   IM_COL32(0, 158, 115, 255),
    IM_COL32(240, 228, 66, 255),  IM_COL32(204, 121, 167, 255), IM_COL32(213, 94, 0, 255),
    IM_COL32(0, 114, 178, 255),   IM_COL32(170, 170, 170, 255), IM_COL32(148, 103, 189, 255),
    IM_COL32(140, 190, 120, 255), IM_COL32(230, 120, 120, 255), IM_COL32(120, 200, 200, 255),
    IM_COL32(200, 200, 140, 255),
};

ImU32 stage_color(std::size_t stage) {
    return palette[stage % palette.size()];
}

/// The plot's upper end: the next of 1, 2, 4, 8, ... ms above the slowest step shown.
float plot_range(const StageHistory& history) {
    const std::size_t whole_step = history.stages() - 1;
    float slowest = 0;
    for (std::size_t age = 0; age < history.size(); ++age)
        slowest = std::max(slowest, history.at(whole_step, age));
    float range = 1;
    while (range < slowest) range *= 2;
    return range;
}

/// What is shown: the parts of the work on cloths, and not their parts in turn.
bool is_shown(const StageTime& stage) {
    return stage.depth == 2;
}

/// Each step is a column, the latest at the right; its stages are stacked in the order in which they run.
void plot_stages(std::span<const StageTime> stages, const StageHistory& history, ImVec2 size) {
    const ImVec2 corner = ImGui::GetCursorScreenPos();
    ImGui::Dummy(size);
    ImDrawList& draw = *ImGui::GetWindowDrawList();
    draw.AddRectFilled(corner, {corner.x + size.x, corner.y + size.y}, ImGui::GetColorU32(ImGuiCol_FrameBg));
    if (history.size() == 0) return;

    const float range = plot_range(history);
    const float column = size.x / static_cast<float>(StageHistory::length);
    for (std::size_t age = 0; age < history.size(); ++age) {
        const float right = corner.x + size.x - column * static_cast<float>(age);
        float bottom = corner.y + size.y;
        for (std::size_t stage = 0; stage + 1 < history.stages(); ++stage) {
            if (!is_shown(stages[stage])) continue;
            const float top = bottom - history.at(stage, age) / range * size.y;
            draw.AddRectFilled({right - column, top}, {right, bottom}, stage_color(stage));
            bottom = top;
        }
    }
    char label[32];
    std::snprintf(label, sizeof label, "%.0f ms", static_cast<double>(range));
    draw.AddText({corner.x + 4, corner.y + 2}, ImGui::GetColorU32(ImGuiCol_Text), label);
}

void stage_row(const StageTime& stage, ImU32 color) {
    ImGui::TableNextRow();
    ImGui::TableNextColumn();
    const ImVec2 corner = ImGui::GetCursorScreenPos();
    const float side = ImGui::GetFontSize();
    ImGui::GetWindowDrawList()->AddRectFilled({corner.x + 2, corner.y + 3},
                                              {corner.x + side - 3, corner.y + side - 2}, color);
    ImGui::SetCursorPosX(ImGui::GetCursorPosX() + side);
    ImGui::TextUnformatted(stage.name);
    for (const float milliseconds : {stage.last, stage.p50, stage.p95}) {
        ImGui::TableNextColumn();
        ImGui::Text("%7.3f", static_cast<double>(milliseconds));
    }
}

void stage_table(std::span<const StageTime> stages) {
    if (!ImGui::BeginTable("stages", 4, ImGuiTableFlags_SizingStretchProp)) return;
    ImGui::TableSetupColumn("stage [ms]", 0, 2);
    for (const char* title : {"last", "p50", "p95"}) ImGui::TableSetupColumn(title, 0, 1);
    ImGui::TableHeadersRow();
    const std::size_t whole_step = stages.size() - 1;
    for (std::size_t s = 0; s < whole_step; ++s)
        if (is_shown(stages[s])) stage_row(stages[s], stage_color(s));
    stage_row(stages[whole_step], IM_COL32_BLACK_TRANS);
    ImGui::EndTable();
}

void troubles(const StepReport& report, const Playback& playback) {
    ImGui::PushTextWrapPos(0);
    if (playback.behind_real_time) ImGui::TextUnformatted("Slower than real time: time was dropped.");
    if (report.flags != StepFlags::none) ImGui::TextUnformatted(flags_text(report.flags).c_str());
    ImGui::PopTextWrapPos();
}

}  // namespace

void profiler_panel(const Simulation& simulation, const StageHistory& history, const Playback& playback) {
    begin_panel("Time of a step", {-panel_margin, -panel_margin}, {340, 398});
    const StepReport& report = simulation.world().report();
    ImGui::Text("%u particles, %d substeps, residual %.2g", report.particles, report.substeps,
                static_cast<double>(report.residual));
    ImGui::Text("%u collider contacts, %u self contacts", report.collider_contacts, report.self_contacts);
    troubles(report, playback);
    const auto stages = simulation.world().profile();
    plot_stages(stages, history, {ImGui::GetContentRegionAvail().x, 76});
    stage_table(stages);
    ImGui::End();
}

}  // namespace weft::demo
