#pragma once
// Dear ImGui without a picture: panels are built, and the pointer is where the test says.

#include <gtest/gtest.h>
#include <imgui.h>

#include "demo/hands/hands.h"
#include "demo/panels/column.h"
#include "demo/panels/panels.h"
#include "demo/panels/widgets.h"
#include "demo/time/repeat_check.h"
#include "demo/time/time_bar.h"
#include "demo/time/timeline.h"

namespace weft::demo {

class PanelFrames : public testing::Test {
  protected:
    PanelFrames() {
        ImGui::SetCurrentContext(context_);
        ImGuiIO& io = ImGui::GetIO();
        io.IniFilename = nullptr;
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

    static Simulation simulation(const char* scene = "flag", std::uint32_t particles = 200) {
        SceneOptions options;
        options.particles = particles;
        Overrides overrides;
        overrides.threads = 1;
        auto made = Simulation::create(*find_scene(scene), options, overrides);
        EXPECT_TRUE(made.ok());
        return std::move(*made);
    }

    /// `between`: what is asked while the frame is built.
    template <class Between>
    void frame(Simulation& of, ImVec2 size, const Between& between) {
        ImGui::GetIO().DisplaySize = size;
        ImGui::NewFrame();
        requests = panels.draw(of, wind, hands, playback, of.content().camera);
        if (panels.visible) (void)time_bar(timeline, playback, repeat, size.x - panels.covered());
        between();
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

}  // namespace weft::demo
