// Mouse and keys take effect in the real window.

#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>
#include <string>

#include "demo/hands/project.h"
#include "demo/panels/widgets.h"
#include "engine/vector.h"
#include "tests/demo/look/seen_windows.h"
#include "tests/demo/window/window.h"
#include "tests/render/gl_objects.h"

namespace weft::demo {

namespace {

/// Which way the flag flies, from its pole.
float heading_of_flag(const ClothView& flag) {
    Vector3 sum = Vector3::Zero();
    for (const Vec4& p : flag.positions) sum += xyz(p);
    return std::atan2(-sum.z(), sum.x());
}

TEST_F(Window, ADraggedArrowTurnsTheWindAndTheFlag) {
    float wanted = 0;
    play("flag", {wait(3), key("F2"), wait(2),
                  at_once([](const AppFrame& frame) { point(frame.hands.arrow().tip(frame.wind)); }), wait(2),
                  at_once([](const AppFrame&) { screen()->press(); }),
                  [](const AppFrame& frame) { return frame.hands.holds_arrow(); },
                  at_once([&](const AppFrame& frame) {
                      point(frame.hands.arrow().at(-0.2f, -0.02f));  // to the left of the picture
                      wanted = frame.camera.yaw + 3.1415927f;
                  }),
                  // A change before a picture is seen in that picture, not in a later one.
                  at_once([&](const AppFrame& frame) {
                      EXPECT_LT(std::abs(std::remainder(frame.wind.heading() - wanted, 6.2831853f)), 0.2f);
                  }),
                  at_once([](const AppFrame& frame) {
                      const Vec3 told = frame.wind.velocity(),
                                 felt = frame.simulation.world().settings().wind.velocity;
                      EXPECT_EQ(told.x, felt.x);
                      EXPECT_EQ(told.z, felt.z);
                      EXPECT_GT(frame.wind.speed(), 5);
                      screen()->release();
                  }),
                  wait(90), at_once([&](const AppFrame& frame) {
                      const float flies = heading_of_flag(first_cloth(frame));
                      EXPECT_LT(std::abs(std::remainder(flies - wanted, 6.2831853f)), 0.8f);
                      EXPECT_FALSE(frame.hands.holds_arrow());
                  })});
}

TEST_F(Window, BackInTimeAndOnAgainComesToTheSameBytes) {
    std::uint64_t last = 0, earlier = 0;
    std::size_t moment = 0;
    const auto hash = [](const AppFrame& frame) { return frame.simulation.world().state_hash(); };
    std::vector<Act> acts{[](const AppFrame& frame) { return frame.timeline.here() > 8; }, key("space"),
                          [](const AppFrame& frame) { return frame.playback.paused; },
                          at_once([&](const AppFrame& frame) {
                              last = hash(frame);
                              moment = frame.timeline.here();
                              ASSERT_GT(moment, 8u);
                          })};
    for (std::size_t back = 1; back <= 5; ++back) {
        acts.push_back(key("comma"));
        acts.push_back([&, back](const AppFrame& frame) { return frame.timeline.here() == moment - back; });
    }
    acts.push_back(at_once([&](const AppFrame& frame) {
        earlier = hash(frame);
        EXPECT_NE(earlier, last);
        EXPECT_EQ(frame.timeline.size(), moment + 1) << "what was taken is still there to go on to";
    }));
    for (std::size_t on = 1; on <= 5; ++on) {  // steps taken anew
        acts.push_back(key("n"));
        acts.push_back([&, on](const AppFrame& frame) { return frame.timeline.here() == moment - 5 + on; });
    }
    acts.push_back(at_once([&](const AppFrame& frame) { EXPECT_EQ(hash(frame), last); }));
    play("flag", std::move(acts));
}

TEST_F(Window, KeysThrowABallAndPinWhatIsPointedAt) {
    const auto pins = [](const AppFrame& frame) {
        const auto positions = first_cloth(frame).positions;
        return std::ranges::count_if(positions, [](const Vec4& p) { return p.w == 0; });
    };
    std::ptrdiff_t before = 0;
    play("sheet",
         {wait(2), key("F2"), key("space"), [](const AppFrame& frame) { return frame.playback.paused; },
          at_once([&](const AppFrame& frame) {
              before = pins(frame);
              const auto positions = first_cloth(frame).positions;
              const Vec4& middle = positions[positions.size() / 2 + 9];
              point(*project(frame.camera, {middle.x, middle.y, middle.z}, aspect));
          }),
          wait(2), key("p"), [&](const AppFrame& frame) { return pins(frame) == before + 1; }, key("p"),
          [&](const AppFrame& frame) { return pins(frame) == before; }, key("t"),
          [](const AppFrame& frame) { return frame.hands.balls.are_there(); }});
}

/// The truth's ghost and the other method are drawn, and nothing that the driver objects to.
TEST_F(Window, ComparesMethodsWithTheirCostAndErrorUntilTheSceneGoesBack) {
    Vec3 alone{};
    float distance = 0;
    play("flag",
         {wait(3), at_once([&](const AppFrame& frame) {
              ASSERT_TRUE(frame.panels.look.comparison.has_value());
              const Comparison& comparison = *frame.panels.look.comparison;
              EXPECT_TRUE(std::holds_alternative<Xpbd>(comparison.method()));
              alone = frame.simulation.content().camera.target;
              distance = frame.simulation.content().camera.distance;
              // Both stand equally far to the left and right of the middle, whatever way the camera looks.
              const Vec3 middle = frame.camera.target;
              const float across = std::hypot(middle.x - alone.x, middle.z - alone.z);
              EXPECT_GT(across, 0.5f);
              EXPECT_NEAR(std::sin(frame.camera.yaw) * (middle.x - alone.x) +
                              std::cos(frame.camera.yaw) * (middle.z - alone.z),
                          0, 1e-3f)
                  << "as far from the camera";
              EXPECT_GT(frame.camera.distance, distance);
          }),
          [](const AppFrame& frame) { return frame.simulation.time() > 0.5; },
          at_once([&](const AppFrame& frame) {
              const Comparison& comparison = *frame.panels.look.comparison;
              for (const Comparison::Side& side : {comparison.shown(), comparison.other()}) {
                  EXPECT_GT(side.milliseconds, 0);
                  EXPECT_GT(side.usual, 0);
              }
          }),
          key("r"), [](const AppFrame& frame) { return !frame.panels.look.comparison.has_value(); }, wait(2),
          at_once([&](const AppFrame& frame) {
              EXPECT_NEAR(frame.camera.target.x, alone.x, 0.2f) << "but for what follows the flag";
              EXPECT_NEAR(frame.camera.distance, distance, 0.2f);
              EXPECT_EQ(frame.panels.message, "");
          })},
         {.compare = Xpbd{}});
}

TEST_F(Window, SaysThatItRecordsWhileItDoes) {
    const std::filesystem::path before = std::filesystem::current_path(),
                                folder = std::filesystem::path(testing::TempDir()) / "weft_recording";
    std::filesystem::remove_all(folder);
    std::filesystem::create_directories(folder);
    std::filesystem::current_path(folder);
    int pictures = 0;
    play(
        "flag",
        {wait(3), key("F6"), [](const AppFrame& frame) { return frame.panels.look.recorder.pictures() >= 4; },
         at_once([&](const AppFrame& frame) {
             EXPECT_NE(recording_words(frame.panels.look.recorder).find("F6 ends it"), std::string::npos);
         }),
         key("F6"),
         [&](const AppFrame& frame) {
             if (frame.panels.look.recorder.recording()) return false;
             pictures = frame.panels.look.recorder.pictures();
             return true;
         },
         wait(2), at_once([&](const AppFrame& frame) {
             EXPECT_EQ(recording_words(frame.panels.look.recorder), "");
             EXPECT_NE(frame.panels.message.find(std::to_string(pictures) + " pictures"), std::string::npos)
                 << frame.panels.message;
         })});
    int files = 0;
    for (const auto& each : std::filesystem::directory_iterator(folder / "weft-film-0001"))
        files += each.path().extension() == ".png" ? 1 : 0;
    EXPECT_EQ(files, pictures) << "the film has every picture";
    std::filesystem::current_path(before);
    std::filesystem::remove_all(folder);
}

TEST_F(Window, AKnifeDrawnOverTheFlagCutsIt) {
    std::size_t particles = 0;
    const auto count = [](const AppFrame& frame) { return first_cloth(frame).positions.size(); };
    const auto point_at = [](const AppFrame& frame, const Vec3& place) {
        point(*project(frame.camera, place, aspect));
    };
    play("flag",
         {wait(2), key("F2"), key("space"), [](const AppFrame& frame) { return frame.playback.paused; },
          at_once([&](const AppFrame& frame) {
              particles = count(frame);
              EXPECT_GT(frame.timeline.size(), 0u);
              point_at(frame, {0.5f, 2.7f, 0});
              screen()->hold("shift");
          }),
          wait(2), at_once([](const AppFrame&) { screen()->press(); }), wait(2),
          at_once([&](const AppFrame& frame) {
              point_at(frame, {0.5f, 2.1f, 0});
          }),
          wait(2), at_once([](const AppFrame&) {
              screen()->release();
              screen()->let_go("shift");
          }),
          [&](const AppFrame& frame) { return count(frame) > particles; }, key("n"),
          // Saves of the uncut flag do not fit the cut one.
          [](const AppFrame& frame) { return frame.simulation.cuts() > 0 && frame.timeline.size() == 1; }});
}

TEST_F(Window, ScenesThatAreLeftLeaveNothingInOpenGl) {
    std::array<int, 9> first{};
    std::vector<Act> acts;
    for (int round = 0; round < 2; ++round) {
        for (const int scene : {2, 0, 2}) {
            acts.push_back(key(std::to_string(scene + 1)));
            acts.push_back([=](const AppFrame& frame) {
                return &frame.simulation.entry() == &all_scenes()[static_cast<std::size_t>(scene)];
            });
            acts.push_back(key("r"));
            acts.push_back(wait(3));
        }
        acts.push_back(at_once([&first, round](const AppFrame&) {
            const auto now = render::count_gl_objects();
            if (round > 0) {
                EXPECT_EQ(now, first);
            }
            first = now;
            EXPECT_GT(first[1], 5) << "textures";
        }));
    }
    play("flag", std::move(acts));
}

TEST_F(Window, OpensEveryScene) {
    for (const SceneEntry& entry : all_scenes()) {
        if (entry.needs_garment) continue;
        SCOPED_TRACE(entry.name);
        int drawn = 0;
        play(entry.name,
             {[&](const AppFrame& frame) { return ++drawn == 2 && &frame.simulation.entry() == &entry; }},
             {.most_frames = 3, .particles = 1000});
    }
}

// Panels in the window: they follow its size and the mouse.

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
