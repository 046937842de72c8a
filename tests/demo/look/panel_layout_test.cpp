// Panels at every size of the window: within it, beside each other, with the larger half left to the scene.

#include <vector>

#include "tests/demo/look/panel_frames.h"
#include "tests/demo/look/seen_windows.h"

namespace weft::demo {
namespace {

class PanelLayout : public PanelFrames, public testing::WithParamInterface<std::pair<ImVec2, float>> {};

TEST_P(PanelLayout, NothingOverlapsAndNothingLeavesTheWindow) {
    const auto [size, text] = GetParam();
    Simulation flag = simulation();
    panels.look.text_size = text;
    panels.message =
        "A message that is long enough to be broken into two lines or three, as errors of files are.";
    playback.behind_real_time = true;
    for (bool* const shown : {static_cast<bool*>(nullptr), &panels.help, &panels.gallery}) {
        panels.help = panels.gallery = false;
        if (shown != nullptr) *shown = true;
        std::vector<Seen> seen;
        for (int i = 0; i < 4; ++i) frame(flag, size, [&] { seen = windows_of_this_frame(); });
        EXPECT_EQ(seen.size(), 3u) << "the column, the bar of time, and messages, help or gallery";
        expect_apart(seen, size);
    }
    EXPECT_LT(panels.covered(), 0.46f * size.x);
}

TEST_P(PanelLayout, LabelsAreWithinTheColumn) {
    const auto [size, text] = GetParam();
    Simulation flag = simulation();
    panels.look.text_size = text;
    all_open = true;
    slider_probe = [&](const char* label, float&, float, float) {
        const ImGuiWindow* const window = ImGui::GetCurrentContext()->CurrentWindow;
        EXPECT_LE(ImGui::GetItemRectMax().x, window->WorkRect.Max.x + 1) << label;
        EXPECT_LE(window->DC.CursorMaxPos.x, window->WorkRect.Max.x + 1) << "before " << label;
        EXPECT_GT(ImGui::CalcItemWidth(), 50) << label;
        return false;
    };
    for (int i = 0; i < 3; ++i) frame(flag, size, [] {});
}

INSTANTIATE_TEST_SUITE_P(Sizes, PanelLayout,
                         testing::Values(std::pair(ImVec2(640, 480), 1.0f), std::pair(ImVec2(800, 600), 1.0f),
                                         std::pair(ImVec2(1280, 800), 1.0f),
                                         std::pair(ImVec2(1280, 800), 1.5f),
                                         std::pair(ImVec2(1920, 1080), 1.0f),
                                         std::pair(ImVec2(2560, 1440), 1.0f),
                                         std::pair(ImVec2(2560, 1440), 2.0f)));

TEST_F(PanelFrames, TheColumnFoldsToATabAndComesBack) {
    Simulation flag = simulation();
    const ImVec2 size(1280, 800);
    frame(flag, size, [] {});
    EXPECT_GT(panels.covered(), 200);
    panels.collapsed = true;
    frame(flag, size, [] {});
    frame(flag, size, [&] {
        for (const Seen& each : windows_of_this_frame()) {
            if (each.name == "Time") continue;
            EXPECT_LT(each.place.GetWidth(), 60) << each.name;
        }
    });
    EXPECT_EQ(panels.covered(), 0);
    panels.visible = false;
    frame(flag, size, [] {});
    frame(flag, size, [] { EXPECT_TRUE(windows_of_this_frame().empty()); });
}

}  // namespace
}  // namespace weft::demo
