// Every slider to both its ends and back: the cloth is whole again within three seconds.

#include <cmath>
#include <map>

#include "demo/scenes/measures.h"
#include "tests/demo/look/panel_frames.h"

namespace weft::demo {
namespace {

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
    Simulation flag = simulation();
    const auto sliders = all_sliders(flag);
    EXPECT_GE(sliders.size(), 18u);
    for (const auto& [label, ends] : sliders) {
        if (label == "threads" || label == "text size" || label == "at least") continue;
        Simulation each = simulation();
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
