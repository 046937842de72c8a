#pragma once
// Which of Dear ImGui's windows are there, and where.

#include <gtest/gtest.h>
#include <imgui_internal.h>

#include <string>
#include <vector>

namespace weft::demo {

struct Seen {
    std::string name;
    ImRect place;
    float cut = 0;  ///< so much of what it holds is beyond its right edge
};

/// The windows that have been built; in the midst of a frame those of the last one are all there.
inline std::vector<Seen> windows_of_this_frame(bool last_frame = false) {
    std::vector<Seen> all;
    for (const ImGuiWindow* window : ImGui::GetCurrentContext()->Windows) {
        const bool own = (window->Flags & (ImGuiWindowFlags_ChildWindow | ImGuiWindowFlags_Tooltip)) == 0;
        if ((last_frame ? window->WasActive : window->Active) && !window->Hidden && own &&
            std::string(window->Name) != "Debug##Default")
            all.push_back(
                {window->Name, window->Rect(), window->ContentSize.x - window->ContentRegionRect.GetWidth()});
    }
    return all;
}

/// Within a window of that size, and beside each other.
inline void expect_apart(const std::vector<Seen>& seen, ImVec2 size) {
    for (const Seen& each : seen) {
        EXPECT_GE(each.place.Min.x, 0) << each.name;
        EXPECT_GE(each.place.Min.y, 0) << each.name;
        EXPECT_LE(each.place.Max.x, size.x) << each.name;
        EXPECT_LE(each.place.Max.y, size.y) << each.name;
        EXPECT_GT(each.place.GetHeight(), 10) << each.name;
        EXPECT_LE(each.cut, 1) << each.name;
    }
    for (std::size_t i = 0; i < seen.size(); ++i)
        for (std::size_t k = 0; k < i; ++k)
            EXPECT_FALSE(seen[i].place.Overlaps(seen[k].place)) << seen[i].name << " and " << seen[k].name;
}

}  // namespace weft::demo
