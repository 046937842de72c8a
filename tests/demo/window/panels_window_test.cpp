// Panels in the window: they follow its size and the mouse.

#include "demo/panels/column.h"
#include "demo/panels/widgets.h"
#include "tests/demo/look/seen_windows.h"
#include "tests/demo/window/window.h"

namespace weft::demo {
namespace {

class WindowPanels : public Window {
  protected:
    ~WindowPanels() override {
        slider_probe = nullptr;
        all_open = false;
    }
};

TEST_F(WindowPanels, FollowTheWindowsSize) {
    ImVec2 size;
    std::vector<Seen> seen;
    all_open = true;
    slider_probe = [&](const char*, float&, float, float) {
        size = ImGui::GetIO().DisplaySize;
        seen = windows_of_this_frame(true);
        return false;
    };
    std::vector<Act> acts;
    for (const ImVec2 wanted : {ImVec2(640, 480), ImVec2(2560, 1440), ImVec2(1280, 800)}) {
        acts.push_back(at_once([=](const AppFrame&) {
            screen()->resize(static_cast<int>(wanted.x), static_cast<int>(wanted.y));
        }));
        acts.push_back([&, wanted](const AppFrame&) { return size.x == wanted.x && size.y == wanted.y; });
        acts.push_back(wait(3));
        acts.push_back(at_once([&, wanted](const AppFrame& frame) {
            EXPECT_GE(seen.size(), 2u) << "the column, the bar of time";
            expect_apart(seen, wanted);
            EXPECT_GT(frame.panels.covered(), 100);
            EXPECT_LT(frame.panels.covered(), 0.46f * wanted.x);
        }));
    }
    play("flag", std::move(acts));
}

TEST_F(WindowPanels, ASliderFollowsTheMouseToBothEnds) {
    std::string label;
    ImVec2 low, high;
    float now = 0, least = 0, most = 0;
    slider_probe = [&](const char* each, float& value, float from, float until_) {
        const ImGuiWindow* const column = ImGui::GetCurrentContext()->CurrentWindow;
        const ImVec2 corner = ImGui::GetItemRectMin(), other = ImGui::GetItemRectMax();
        if (label.empty() && column->InnerClipRect.Contains(ImRect(corner, other))) label = each;
        if (label != each) return false;
        low = corner;
        high = {corner.x + ImGui::CalcItemWidth(), other.y};
        now = value, least = from, most = until_;
        return false;
    };
    const auto pull = [&](float part) {
        return at_once([&, part](const AppFrame&) {
            screen()->move_pointer(low.x + part * (high.x - low.x), 0.5f * (low.y + high.y));
        });
    };
    play("flag",
         {wait(4), at_once([&](const AppFrame&) { ASSERT_FALSE(label.empty()) << "no slider is in sight"; }),
          pull(0.5f), wait(2), at_once([](const AppFrame&) { screen()->press(); }), wait(2), pull(-0.5f),
          [&](const AppFrame&) { return now == least; }, pull(1.5f),
          [&](const AppFrame&) { return now == most; }, at_once([](const AppFrame&) { screen()->release(); }),
          wait(2), at_once([&](const AppFrame& frame) { EXPECT_EQ(frame.panels.message, "") << label; })},
         {.across = 640, .down = 480});
}

}  // namespace
}  // namespace weft::demo
