// Panels in frames without a picture: what they show and where, and what their controls do.

#include "demo/panels/panels.h"

#include <gtest/gtest.h>
#include <imgui.h>

#include <map>
#include <vector>

#include "demo/hands/hands.h"
#include "demo/headless/report_text.h"
#include "demo/options/method_table.h"
#include "demo/panels/widgets.h"
#include "demo/scenes/measures.h"
#include "demo/time/time_bar.h"
#include "demo/time/timeline.h"
#include "tests/demo/look/seen_windows.h"
#include "tests/demo/small_world.h"

namespace weft::demo {
namespace {

/// Dear ImGui without a picture: panels are built, and the pointer is where the test says.
class PanelFrames : public testing::Test {
  protected:
    PanelFrames() {
        ImGui::SetCurrentContext(context_);
        ImGuiIO& io = ImGui::GetIO();
        io.IniFilename = nullptr;
        io.DisplaySize = {1280, 800};
        io.DeltaTime = 1.0f / 60;
        unsigned char* pixels = nullptr;
        int across = 0, down = 0;
        io.Fonts->GetTexDataAsRGBA32(&pixels, &across, &down);
    }
    ~PanelFrames() override {
        slider_probe = nullptr;
        all_open = false;
        ImGui::DestroyContext(context_);
    }

    /// `between`: what is asked while the frame is built.
    template <class Between>
    void frame(Simulation& of, ImVec2 size, const Between& between) {
        ImGui::GetIO().DisplaySize = size;
        build([&] {
            requests = panels.draw(of, wind, hands, playback, of.content().camera);
            if (panels.visible) (void)time_bar(timeline, playback, repeat, size.x - panels.covered());
            between();
        });
    }
    template <class Build>
    static void build(const Build& content) {
        ImGui::NewFrame();
        content();
        ImGui::Render();
    }

    Panels panels;
    PanelRequests requests;
    WindControl wind;
    Playback playback;
    Hands hands;
    Timeline timeline;
    RepeatCheck repeat;

  private:
    ImGuiContext* context_ = ImGui::CreateContext();
};

TEST_F(PanelFrames, ASliderReachesTheValueThatItWasGiven) {
    float number = 50;
    int count = 50;
    ImVec2 right_end[2];
    const auto both = [&] {
        ImGui::SetNextWindowPos({0, 0});
        ImGui::SetNextWindowSize({400, 200});
        ImGui::Begin("panel");
        slider("number", number, 0, 10, "%.1f", "");
        right_end[0] = {ImGui::GetItemRectMin().x + ImGui::CalcItemWidth() - 4,
                        ImGui::GetItemRectMin().y + 4};
        slider("count", count, 0, 10, "%d", "");
        right_end[1] = {ImGui::GetItemRectMin().x + ImGui::CalcItemWidth() - 4,
                        ImGui::GetItemRectMin().y + 4};
        ImGui::End();
    };
    build(both);
    build(both);
    EXPECT_EQ(number, 50);
    EXPECT_EQ(count, 50);
    const auto drag = [&](ImVec2 from, ImVec2 to) {
        for (const auto& [place, held] : {std::pair(from, false), std::pair(from, true), std::pair(to, true),
                                          std::pair(to, true), std::pair(to, false)}) {
            ImGui::GetIO().MousePos = place;
            ImGui::GetIO().MouseDown[0] = held;
            build(both);
        }
    };
    for (const ImVec2& end : right_end) drag({end.x - 100, end.y}, {end.x - 150, end.y});
    EXPECT_LT(number, 40);
    EXPECT_LT(count, 40);
    for (const ImVec2& end : right_end) drag({end.x - 50, end.y}, end);
    EXPECT_EQ(number, 50);
    EXPECT_EQ(count, 50);
}

TEST_F(PanelFrames, PanelsLeaveAloneWhatTheCommandLineAskedFor) {
    Overrides overrides;
    overrides.wind = Vec3{60, 5, -70};
    overrides.method = Xpbd{};
    overrides.iterations = 10000;
    overrides.substeps = 256;
    overrides.threads = 256;
    Simulation simulation = simulation_of("flag", 100, overrides);
    wind = WindControl(*overrides.wind);
    wind.steer(0, 0, 1);
    for (int i = 0; i < 3; ++i) frame(simulation, {1280, 800}, [] {});
    EXPECT_EQ(panels.message, "");
    EXPECT_NEAR(wind.velocity().x, 60, 1e-3);
    EXPECT_NEAR(wind.velocity().z, -70, 1e-3);
    const WorldSettings& world = simulation.world().settings();
    EXPECT_EQ(world.wind.velocity.x, 60);
    EXPECT_EQ(world.substeps, 256);
    EXPECT_EQ(world.threads, 256);
    EXPECT_EQ(
        iterations_of(simulation.world().cloth_settings(simulation.content().cloths.front().id)->method),
        10000);
}

TEST(Panels, SayWhatAClothRefuses) {
    Simulation simulation = simulation_of("flag", 100);
    ClothSettings settings = *simulation.world().cloth_settings(simulation.content().cloths.front().id);
    EXPECT_TRUE(set_all_cloths(simulation, settings).ok());
    settings.fabric.warp = -1;
    const auto refused = set_all_cloths(simulation, settings);
    ASSERT_FALSE(refused.ok());
    EXPECT_NE(refused.error().message.find("warp"), std::string::npos) << refused.error().message;
}

TEST(FlagsText, APinIsNotReportedWhereNobodySeesThatItLags) {
    StepReport report;
    report.flags = StepFlags::pins_stopped | StepFlags::speed_limited;
    report.pin_lag = 0.004f;
    EXPECT_EQ(seen_flags(report), StepFlags::speed_limited);
    report.pin_lag = 0.03f;
    EXPECT_EQ(seen_flags(report), report.flags);
}

TEST(FlagsText, NamesTheSettingToChange) {
    EXPECT_EQ(flags_text(StepFlags::none, 0), "");
    EXPECT_NE(flags_text(StepFlags::state_restored, 0).find("substeps"), std::string::npos);
    EXPECT_NE(flags_text(StepFlags::contacts_dropped, 0).find("layers"), std::string::npos);
    const std::string both = flags_text(StepFlags::state_restored | StepFlags::contacts_dropped, 0);
    EXPECT_EQ(both, flags_text(StepFlags::state_restored, 0) + flags_text(StepFlags::contacts_dropped, 0));
}

class PanelLayout : public PanelFrames, public testing::WithParamInterface<std::pair<ImVec2, float>> {};

TEST_P(PanelLayout, NothingOverlapsAndNothingLeavesTheWindow) {
    const auto [size, text] = GetParam();
    Simulation flag = simulation_of("flag", 200);
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
    Simulation flag = simulation_of("flag", 200);
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
    Simulation flag = simulation_of("flag", 200);
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

// Every slider goes to both its ends and back: the cloth is whole again within three seconds.

struct Ends {
    float first, least, most;
};

class SliderEnds : public PanelFrames {
  protected:
    std::map<std::string, Ends> all_sliders(Simulation& of) {
        std::map<std::string, Ends> ends;
        all_open = true;
        slider_probe = [&](const char* label, float& value, float least, float most) {
            ends.try_emplace(label, Ends{value, least, most});
            return false;
        };
        frame(of, {1280, 2000}, [] {});
        return ends;
    }

    void set(Simulation& of, const std::string& label, float to) {
        slider_probe = [&](const char* each, float& value, float, float) {
            if (label != each) return false;
            value = to;
            return true;
        };
        frame(of, {1280, 2000}, [] {});
        slider_probe = nullptr;
    }

    static void run(Simulation& of, float seconds) {
        for (int i = 0; i < static_cast<int>(60 * seconds); ++i) of.step(1.0f / 60);
    }
};

TEST_F(SliderEnds, LeaveASoundCloth) {
    Simulation flag = simulation_of("flag", 200);
    const auto sliders = all_sliders(flag);
    EXPECT_GE(sliders.size(), 18u);
    for (const auto& [label, ends] : sliders) {
        if (label == "threads" || label == "text size" || label == "at least") continue;
        Simulation each = simulation_of("flag", 200);
        wind = WindControl(each.world().settings().wind.velocity);
        run(each, 0.25f);
        for (const float end : {ends.least, ends.most}) {
            set(each, label, end);
            run(each, 0.5f);
        }
        set(each, label, ends.first);
        EXPECT_EQ(panels.message, "") << label;
        run(each, 3);
        const auto view = each.world().cloth(each.content().cloths.front().id);
        const Stretch stretch = structural_stretch(each.content().cloths.front().mesh, *view);
        EXPECT_LT(stretch.mean, 1.05f) << label;
        EXPECT_LT(stretch.worst, 1.6f) << label;
        EXPECT_FALSE(has(each.world().report().flags, StepFlags::state_restored)) << label;
    }
}

}  // namespace
}  // namespace weft::demo
