#include "demo/panels/widgets.h"

#include <algorithm>

namespace weft::demo {

float column_width(ImVec2 window, float font_size) {
    return std::min(23 * font_size, 0.45f * window.x);
}

bool begin_column(bool& collapsed) {
    const ImVec2 window = ImGui::GetIO().DisplaySize;
    const float em = ImGui::GetFontSize();
    const float width = collapsed ? 2.2f * em : column_width(window, em);
    ImGui::SetNextWindowPos({window.x - width, 0});
    ImGui::SetNextWindowSize({width, collapsed ? 2.4f * em : window.y});
    constexpr ImGuiWindowFlags fixed = ImGuiWindowFlags_NoTitleBar | ImGuiWindowFlags_NoMove |
                                       ImGuiWindowFlags_NoResize | ImGuiWindowFlags_NoSavedSettings |
                                       ImGuiWindowFlags_NoFocusOnAppearing;
    ImGui::PushStyleVar(ImGuiStyleVar_WindowRounding, 0.0f);
    ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, collapsed ? ImVec2(2, 2) : ImVec2(0.6f * em, 0.5f * em));
    ImGui::PushStyleVar(ImGuiStyleVar_WindowMinSize, ImVec2(1, 1));
    ImGui::Begin(collapsed ? "column tab" : "column", nullptr,
                 fixed | (collapsed ? ImGuiWindowFlags_NoScrollbar : ImGuiWindowFlags_None));
    ImGui::PopStyleVar(3);
    if (!collapsed) return true;
    if (ImGui::Button("<", {-1, -1})) collapsed = false;
    return false;
}

bool begin_fold(const char* title) {
    if (all_open) ImGui::SetNextItemOpen(true);
    return ImGui::TreeNode(title);
}

Section::Section(const char* title, bool open_at_first) {
    if (all_open) ImGui::SetNextItemOpen(true);
    open_ = ImGui::CollapsingHeader(title,
                                    open_at_first ? ImGuiTreeNodeFlags_DefaultOpen : ImGuiTreeNodeFlags_None);
    ImGui::PushID(title);
    // Labels stand to the right of their widgets; a narrow column gives them a larger share.
    ImGui::PushItemWidth(-std::min(9.0f * ImGui::GetFontSize(), 0.46f * ImGui::GetContentRegionAvail().x));
}

Section::~Section() {
    ImGui::PopItemWidth();
    ImGui::PopID();
}

}  // namespace weft::demo
