// The real window on a real display, with real events: what hands do is felt.

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <vector>

#include "demo/app.h"
#include "demo/hands/project.h"
#include "engine/vector.h"
#include "tests/demo/window/screen.h"

namespace weft::demo {
namespace {

constexpr int across = 480, down = 320;

/// A play in acts: each is called after every picture until it says that it is over.
class Window : public testing::Test {
  protected:
    using Act = std::function<bool(const AppFrame&)>;

    static void SetUpTestSuite() { screen() = Screen::start(); }
    static void TearDownTestSuite() { screen().reset(); }
    static std::optional<Screen>& screen() {
        static std::optional<Screen> one;
        return one;
    }
    void SetUp() override {
        if (!screen()) GTEST_SKIP() << "Xvfb or xdotool is missing; tests/run installs them";
    }

    void play(const char* scene, std::vector<Act> acts, int most_frames = 250,
              std::uint32_t particles = 300) {
        Options options;
        options.width = across;
        options.height = down;
        options.scene_options.particles = particles;
        options.frames = most_frames;
        Overrides overrides;
        overrides.threads = 1;
        auto simulation = Simulation::create(*find_scene(scene), options.scene_options, overrides);
        ASSERT_TRUE(simulation) << simulation.error().message;
        point({0.75f, 0.4f});  // keys go to the window that the pointer is in
        std::size_t act = 0;
        const int status = run_app(options, std::move(*simulation), [&](const AppFrame& frame) {
            if (acts[act](frame)) ++act;
            return act < acts.size();
        });
        EXPECT_EQ(status, 0);
        EXPECT_EQ(act, acts.size()) << "an act that did not end";
    }
    /// Waits for some pictures: events come by the window system.
    static Act wait(int pictures) {
        return [=, left = pictures](const AppFrame&) mutable { return --left <= 0; };
    }
    static void point(Vec2 place) {
        screen()->move_pointer(static_cast<float>(down) * place.x, static_cast<float>(down) * place.y);
    }
    static Act at_once(const std::function<void(const AppFrame&)>& act) {
        return [=](const AppFrame& frame) {
            act(frame);
            return true;
        };
    }
    static Act key(const char* name) {
        return at_once([=](const AppFrame&) { screen()->key(name); });
    }
};

/// Which way the flag flies, from its pole.
float heading_of_flag(const Simulation& simulation) {
    Vector3 sum = Vector3::Zero();
    for (const Vec4& p : simulation.world().cloth(simulation.content().cloths.front().id)->positions)
        sum += xyz(p);
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
                  [&](const AppFrame& frame) {
                      return std::abs(std::remainder(frame.wind.heading() - wanted, 6.2831853f)) < 0.2f;
                  },
                  at_once([](const AppFrame& frame) {
                      const Vec3 told = frame.wind.velocity(),
                                 felt = frame.simulation.world().settings().wind.velocity;
                      EXPECT_EQ(told.x, felt.x);
                      EXPECT_EQ(told.z, felt.z);
                      EXPECT_GT(frame.wind.speed(), 5);
                      screen()->release();
                  }),
                  wait(90), at_once([&](const AppFrame& frame) {
                      const float flies = heading_of_flag(frame.simulation);
                      EXPECT_LT(std::abs(std::remainder(flies - wanted, 6.2831853f)), 0.8f);
                      EXPECT_FALSE(frame.hands.holds_arrow());
                  })});
}

TEST_F(Window, BackInTimeAndOnAgainComesToTheSameBytes) {
    std::uint64_t last = 0, earlier = 0;
    std::size_t moment = 0;
    const auto hash = [](const AppFrame& frame) { return frame.simulation.world().state_hash(); };
    std::vector<Act> acts{wait(12), key("space"), [](const AppFrame& frame) { return frame.playback.paused; },
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
        const auto positions =
            frame.simulation.world().cloth(frame.simulation.content().cloths.front().id)->positions;
        return std::ranges::count_if(positions, [](const Vec4& p) { return p.w == 0; });
    };
    std::ptrdiff_t before = 0;
    play("sheet",
         {wait(2), key("F2"), key("space"), [](const AppFrame& frame) { return frame.playback.paused; },
          at_once([&](const AppFrame& frame) {
              before = pins(frame);
              const auto positions =
                  frame.simulation.world().cloth(frame.simulation.content().cloths.front().id)->positions;
              const Vec4& middle = positions[positions.size() / 2 + 9];
              point(*project(frame.camera, {middle.x, middle.y, middle.z},
                             static_cast<float>(across) / static_cast<float>(down)));
          }),
          wait(2), key("p"), [&](const AppFrame& frame) { return pins(frame) == before + 1; }, key("p"),
          [&](const AppFrame& frame) { return pins(frame) == before; }, key("t"),
          [](const AppFrame& frame) { return frame.hands.balls.are_there(); }});
}

TEST_F(Window, AKnifeDrawnOverTheFlagCutsIt) {
    std::size_t particles = 0;
    const auto count = [](const AppFrame& frame) {
        return frame.simulation.world().cloth(frame.simulation.content().cloths.front().id)->positions.size();
    };
    const auto point_at = [](const AppFrame& frame, const Vec3& place) {
        point(*project(frame.camera, place, static_cast<float>(across) / static_cast<float>(down)));
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
          // What was saved of the whole flag is of no use.
          [](const AppFrame& frame) { return frame.simulation.cuts() > 0 && frame.timeline.size() == 1; }});
}

TEST_F(Window, OpensEveryScene) {
    for (const SceneEntry& entry : all_scenes()) {
        if (entry.needs_garment) continue;
        SCOPED_TRACE(entry.name);
        int drawn = 0;
        play(entry.name,
             {[&](const AppFrame& frame) { return ++drawn == 2 && &frame.simulation.entry() == &entry; }}, 3,
             1000);
    }
}

}  // namespace
}  // namespace weft::demo
