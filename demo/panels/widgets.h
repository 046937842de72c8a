#pragma once
// Small helpers over Dear ImGui that the panels share, and the column that holds the panels.

#include <imgui.h>

#include <algorithm>
#include <cstdio>
#include <functional>
#include <string>
#include <type_traits>

namespace weft::demo {

/// Small helpers over Dear ImGui that the panels share.
inline constexpr float panel_margin = 12;  // between panels and the picture's edge [pixels]

/// A test's function that is called for every slider and may move it; true if it did.
using SliderProbe = std::function<bool(const char* label, float& value, float least, float most)>;
inline SliderProbe slider_probe;

/// Explains the previous widget while the pointer rests on it.
inline void tooltip(const char* text) {
    if (!ImGui::IsItemHovered()) return;
    ImGui::BeginTooltip();
    ImGui::PushTextWrapPos(26 * ImGui::GetFontSize());
    ImGui::TextUnformatted(text);
    ImGui::PopTextWrapPos();
    ImGui::EndTooltip();
}

/// A number in five letters, so that slow steps fit into their column.
inline std::string in_column(float number) {
    char text[32];
    std::snprintf(text, sizeof text, "%.*f",
                  number < 100    ? 2
                  : number < 1000 ? 1
                                  : 0,
                  static_cast<double>(number));
    return text;
}

/// Keeps the next item, of this width [pixels], in the line if there is room for it.
inline void same_line_if_room(float width) {
    const float end = ImGui::GetItemRectMax().x + ImGui::GetStyle().ItemSpacing.x + width;
    if (end <= ImGui::GetWindowPos().x + ImGui::GetWindowContentRegionMax().x) ImGui::SameLine();
}

/// The end of a slider's range: `end`, or the widest that it has had.
template <class Number, class Wider>
Number widest(const char* label, const char* which, Number end, Wider wider) {
    ImGui::PushID(label);
    const ImGuiID id = ImGui::GetID(which);
    ImGui::PopID();
    ImGuiStorage& storage = *ImGui::GetStateStorage();
    if constexpr (std::is_same_v<Number, float>) {
        const float before = storage.GetFloat(id, end);
        if (wider(before, end)) return before;
        storage.SetFloat(id, end);
    } else {
        const int before = storage.GetInt(id, end);
        if (wider(before, end)) return before;
        storage.SetInt(id, end);
    }
    return end;
}

/// A slider with its explanation. True if moved. The range includes every value that the slider has shown, so
/// that values of the command line or the scene are shown uncut and can be restored.
inline bool slider(const char* label, float& value, float least, float most, const char* format,
                   const char* explanation, ImGuiSliderFlags flags = ImGuiSliderFlags_None) {
    const float low = widest(label, ".least", std::min(least, value), std::less<float>());
    const float high = widest(label, ".most", std::max(most, value), std::greater<float>());
    const bool moved =
        ImGui::SliderFloat(label, &value, low, high, format, flags | ImGuiSliderFlags_AlwaysClamp);
    tooltip(explanation);
    return (slider_probe && slider_probe(label, value, least, most)) || moved;
}
inline bool slider(const char* label, int& value, int least, int most, const char* format,
                   const char* explanation, ImGuiSliderFlags flags = ImGuiSliderFlags_None) {
    const int low = widest(label, ".least", std::min(least, value), std::less<int>());
    const int high = widest(label, ".most", std::max(most, value), std::greater<int>());
    const bool moved =
        ImGui::SliderInt(label, &value, low, high, format, flags | ImGuiSliderFlags_AlwaysClamp);
    tooltip(explanation);
    auto number = static_cast<float>(value);
    if (!slider_probe || !slider_probe(label, number, static_cast<float>(least), static_cast<float>(most)))
        return moved;
    value = static_cast<int>(number);
    return true;
}

/// Width of the column in a window of this size [pixels]: 23 font sizes, at most 0.45 of the window, so that
/// the scene has the larger half.
[[nodiscard]] float column_width(ImVec2 window, float font_size);

/// Opens the column's window; with `collapsed` a tab that opens it. True if panels are to follow; close with
/// ImGui::End() in either case.
bool begin_column(bool& collapsed);

/// Opens all sections and folds, whatever was clicked; for tests.
inline bool all_open = false;

/// Begins a fold, for controls that are seldom needed; if it is open, close it with ImGui::TreePop().
[[nodiscard]] bool begin_fold(const char* title);

/// A part of the column under a title that folds it away.
class Section {
  public:
    explicit Section(const char* title, bool open_at_first = false);
    Section(const Section&) = delete;
    Section& operator=(const Section&) = delete;
    ~Section();
    explicit operator bool() const { return open_; }

  private:
    bool open_;
};

}  // namespace weft::demo
