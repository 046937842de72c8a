#include <algorithm>
#include <array>
#include <utility>

#include "demo/panels/panels.h"
#include "demo/panels/widgets.h"

namespace weft::demo {
namespace {

const ImVec4 good_color{0.45f, 0.85f, 0.50f, 1}, fair_color{0.95f, 0.80f, 0.35f, 1},
    bad_color{0.98f, 0.50f, 0.42f, 1};

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
    float slowest = 0;
    for (std::size_t age = 0; age < history.size(); ++age)
        slowest = std::max(slowest, history.at(history.stages() - 1, age));
    float range = 1;
    while (range < slowest) range *= 2;
    return range;
}

/// True if a stage is plotted: parts of the work on cloths are, their own parts are not.
bool is_shown(const StageTime& stage) {
    return stage.depth == 2;
}

/// Draws columns of stacked times, the latest at the right, up to `range` milliseconds. `parts(age, add)`
/// calls add(milliseconds, colour) for each part of a column, from the lowest up. Returns the plot's corners.
std::pair<ImVec2, ImVec2> plot_columns(std::size_t count, std::size_t most, float range, const auto& parts) {
    const ImVec2 corner = ImGui::GetCursorScreenPos();
    const ImVec2 size(ImGui::GetContentRegionAvail().x, 4 * ImGui::GetFontSize());
    ImGui::Dummy(size);
    ImDrawList& draw = *ImGui::GetWindowDrawList();
    const ImVec2 end(corner.x + size.x, corner.y + size.y);
    draw.AddRectFilled(corner, end, ImGui::GetColorU32(ImGuiCol_FrameBg));
    const float column = size.x / static_cast<float>(most);
    for (std::size_t age = 0; age < count; ++age) {
        const float right = end.x - column * static_cast<float>(age);
        float bottom = end.y;
        parts(age, [&](float milliseconds, ImU32 colour) {
            const float top = std::max(bottom - milliseconds / range * size.y, corner.y);
            draw.AddRectFilled({right - column, top}, {right, bottom}, colour);
            bottom = top;
        });
    }
    char label[32];
    std::snprintf(label, sizeof label, "%.0f ms", static_cast<double>(range));
    draw.AddText({corner.x + 4, corner.y + 2}, ImGui::GetColorU32(ImGuiCol_Text), label);
    return {corner, end};
}

/// Each step is a column; its stages are stacked in the order in which they run.
void plot_stages(std::span<const StageTime> stages, const StageHistory& history) {
    plot_columns(history.size(), StageHistory::length, plot_range(history),
                 [&](std::size_t age, const auto& add) {
                     for (std::size_t stage = 0; stage + 1 < history.stages(); ++stage)
                         if (is_shown(stages[stage])) add(history.at(stage, age), stage_color(stage));
                 });
}

/// Begins a table of times.
bool begin_times(const char* name, const char* title) {
    if (!ImGui::BeginTable(name, 5, ImGuiTableFlags_SizingStretchProp)) return false;
    ImGui::TableSetupColumn(title, 0, 2.6f);
    for (const char* column : {"now", "p50", "p99", "share"}) ImGui::TableSetupColumn(column, 0, 1);
    ImGui::TableHeadersRow();
    return true;
}

void stage_row(const StageTime& stage, float whole, ImU32 color) {
    ImGui::TableNextRow();
    ImGui::TableNextColumn();
    const ImVec2 corner = ImGui::GetCursorScreenPos();
    const float side = ImGui::GetFontSize();
    const float indent = 0.5f * side * static_cast<float>(std::max(stage.depth - 1, 0));
    ImGui::GetWindowDrawList()->AddRectFilled({corner.x + indent + 2, corner.y + 3},
                                              {corner.x + indent + side - 3, corner.y + side - 2}, color);
    ImGui::SetCursorPosX(ImGui::GetCursorPosX() + indent + side);
    ImGui::TextUnformatted(stage.name);
    for (const float milliseconds : {stage.last, stage.p50, stage.p99}) {
        ImGui::TableNextColumn();
        ImGui::TextUnformatted(in_column(milliseconds).c_str());
    }
    ImGui::TableNextColumn();
    if (whole > 0) ImGui::Text("%.0f %%", static_cast<double>(100 * stage.p50 / whole));
}

void stage_table(std::span<const StageTime> stages) {
    if (!begin_times("stages", "part of a step [ms]")) return;
    const std::size_t whole_step = stages.size() - 1;
    const float whole = stages[whole_step].p50;
    for (std::size_t s = 0; s < whole_step; ++s)
        stage_row(stages[s], whole, is_shown(stages[s]) ? stage_color(s) : IM_COL32_BLACK_TRANS);
    stage_row(stages[whole_step], whole, IM_COL32_BLACK_TRANS);
    ImGui::EndTable();
    tooltip("Of the last step, of the usual, and of the slowest in a hundred; share: of the whole step.");
}

constexpr ImU32 cloth_color = IM_COL32(86, 180, 233, 255), drawing_color = IM_COL32(230, 159, 0, 255),
                rest_color = IM_COL32(130, 130, 130, 255);

/// Each picture is a column: cloth, drawing and the rest on top of each other, with a line at 1/60 s.
void plot_pictures(const PictureTimes& times) {
    float range = 20;
    while (range < times.percentile(0.99f).whole) range *= 2;
    const auto [corner, end] =
        plot_columns(times.size(), PictureTimes::length, range, [&](std::size_t age, const auto& add) {
            const PictureTime& time = times.at(age);
            add(time.cloth, cloth_color);
            add(time.drawing, drawing_color);
            add(time.rest(), rest_color);
        });
    const float sixtieth = end.y - 1000.0f / 60 / range * (end.y - corner.y);
    ImGui::GetWindowDrawList()->AddLine({corner.x, sixtieth}, {end.x, sixtieth},
                                        IM_COL32(255, 255, 255, 120));
}

void picture_row(const char* name, ImU32 color, float now, float usual, float slowest, float whole) {
    StageTime row{.name = name, .depth = 0, .last = now, .p50 = usual};
    row.p99 = slowest;
    stage_row(row, whole, color);
}

void picture_table(const PictureTimes& times) {
    if (times.size() == 0) return;
    const PictureTime now = times.at(0), usual = times.percentile(0.5f), slow = times.percentile(0.99f);
    if (!begin_times("pictures", "of a picture [ms]")) return;
    picture_row("cloth", cloth_color, now.cloth, usual.cloth, slow.cloth, usual.whole);
    picture_row("drawing", drawing_color, now.drawing, usual.drawing, slow.drawing, usual.whole);
    picture_row("the rest", rest_color, now.rest(), usual.rest(), slow.rest(), usual.whole);
    picture_row("whole", IM_COL32_BLACK_TRANS, now.whole, usual.whole, slow.whole, usual.whole);
    ImGui::EndTable();
    tooltip("The rest is the window system, the panels, other programs, and waiting.");
}

/// Buttons for the budget of a step, and a bar of its use.
bool budget_bar(WorldSettings& settings, const StepReport& report) {
    bool changed = false;
    ImGui::TextUnformatted("budget [ms]");
    for (const float milliseconds : {0.0f, 0.5f, 1.0f, 2.0f, 4.0f}) {
        char label[16];
        std::snprintf(label, sizeof label, milliseconds > 0 ? "%g" : "none",
                      static_cast<double>(milliseconds));
        same_line_if_room(ImGui::GetFrameHeight() + ImGui::GetStyle().ItemInnerSpacing.x +
                          ImGui::CalcTextSize(label).x);
        const bool chosen = settings.budget == milliseconds;
        if (ImGui::RadioButton(label, chosen) && !chosen) {
            settings.budget = milliseconds;
            changed = true;
        }
        tooltip(
            "Milliseconds that a step may take. Where it would take more, cloth is computed more roughly, "
            "what "
            "counts least first.");
    }
    if (settings.budget <= 0) return changed;
    const float used = report.milliseconds / settings.budget;
    char text[64];
    std::snprintf(text, sizeof text, "%.2f of %g ms, %u cloths reduced",
                  static_cast<double>(report.milliseconds), static_cast<double>(settings.budget),
                  report.reduced_cloths);
    ImGui::PushStyleColor(ImGuiCol_PlotHistogram, used > 1 ? bad_color : good_color);
    ImGui::ProgressBar(std::min(used, 1.0f), {-1, 0}, text);
    ImGui::PopStyleColor();
    return changed;
}

/// The method's mean residual, in a word and a colour.
void error_line(float residual) {
    const bool small = residual < 0.25f, some = residual < 0.6f;
    ImGui::TextUnformatted("error:");
    ImGui::SameLine();
    ImGui::TextColored(small  ? good_color
                       : some ? fair_color
                              : bad_color,
                       "%s",
                       small  ? "small"
                       : some ? "some: a bit softer or slower than it should be"
                              : "large: softer or slower than its material");
    char text[200];
    std::snprintf(
        text, sizeof text,
        "Part of the forces that the way of computing left unbalanced in the last second: %.2f. 0 is "
        "exact, 1 as "
        "if the cloth had no stiffness.",
        static_cast<double>(residual));
    tooltip(text);
}

}  // namespace

Result<void> times_panel(Simulation& simulation, const StageHistory& history, float residual,
                         const Look& look) {
    const Section section("Time of a picture");
    if (!section) return {};
    plot_pictures(look.times);
    picture_table(look.times);
    ImGui::Separator();
    const StepReport& report = simulation.world().report();
    ImGui::TextWrapped("%u particles, %d substeps, %u contacts with bodies, %u with cloth", report.particles,
                       report.substeps, report.collider_contacts, report.self_contacts);
    error_line(residual);
    WorldSettings settings = simulation.world().settings();
    const bool changed = budget_bar(settings, report);
    const auto stages = simulation.world().profile();
    if (begin_fold("Parts of a step")) {
        plot_stages(stages, history);
        stage_table(stages);
        ImGui::TreePop();
    }
    return changed ? simulation.world().set_settings(settings) : Result<void>();
}

}  // namespace weft::demo
