#include <cmath>
#include <numbers>

#include "demo/panels/panels.h"
#include "demo/panels/widgets.h"
#include "engine/vector.h"

namespace weft::demo {
namespace {

constexpr float strongest_wind = 40;  // end of the slider [m/s]

/// Diameter of the dial [pixels]; it grows with the text.
float dial_size() {
    return 7.5f * ImGui::GetFontSize();
}

/// Converts the wind's heading to the dial's plane, where up is away from the viewer, for any camera.
class DialFrame {
  public:
    explicit DialFrame(const render::OrbitCamera& camera) {
        const Vector3 look = to_vector(camera.target) - to_vector(camera.eye());
        camera_heading_ = std::atan2(-look.z(), look.x());
    }
    /// Unit vector of a heading on the dial, in the picture's coordinates (y down).
    [[nodiscard]] ImVec2 direction(float heading) const {
        const float from_top = camera_heading_ - heading;
        return {std::sin(from_top), -std::cos(from_top)};
    }
    [[nodiscard]] float heading(ImVec2 direction) const {
        return camera_heading_ - std::atan2(direction.x, -direction.y);
    }

  private:
    float camera_heading_ = 0;
};

void draw_arrow(ImDrawList& draw, ImVec2 centre, ImVec2 along, float length, ImU32 color) {
    const auto at = [&](float forward, float sideways) {
        return ImVec2(centre.x + forward * along.x - sideways * along.y,
                      centre.y + forward * along.y + sideways * along.x);
    };
    draw.AddLine(at(-length, 0), at(length - 8, 0), color, 3);
    draw.AddTriangleFilled(at(length, 0), at(length - 14, 7), at(length - 14, -7), color);
}

/// The wind's dial. True while it is dragged: the wind then blows from the centre towards the pointer.
bool wind_dial(WindControl& wind, const DialFrame& frame) {
    const float radius = 0.5f * dial_size();
    const ImVec2 corner = ImGui::GetCursorScreenPos();
    const ImVec2 centre(corner.x + radius, corner.y + radius);
    ImGui::InvisibleButton("dial", {2 * radius, 2 * radius});
    const bool dragged = ImGui::IsItemActive();
    tooltip(
        "Drag: where the wind blows, seen from above; up is away from you. Left and right arrow keys turn "
        "it.");
    if (dragged) {
        const ImVec2 mouse = ImGui::GetIO().MousePos;
        const ImVec2 to(mouse.x - centre.x, mouse.y - centre.y);
        if (to.x != 0 || to.y != 0) wind.set_heading(frame.heading(to));
    }

    ImDrawList& draw = *ImGui::GetWindowDrawList();
    draw.AddCircleFilled(centre, radius, ImGui::GetColorU32(ImGuiCol_FrameBg), 48);
    draw.AddCircle(centre, radius, ImGui::GetColorU32(ImGuiCol_Border), 48, 1.5f);
    constexpr int ticks = 16;
    for (int i = 0; i < ticks; ++i) {
        const float angle = 2 * std::numbers::pi_v<float> * static_cast<float>(i) / ticks;
        const ImVec2 out(std::sin(angle), std::cos(angle));
        const float inner = radius - (i % 4 == 0 ? 9.0f : 5.0f);
        draw.AddLine({centre.x + inner * out.x, centre.y + inner * out.y},
                     {centre.x + radius * out.x, centre.y + radius * out.y},
                     ImGui::GetColorU32(ImGuiCol_TextDisabled));
    }
    const float length = (0.35f + 0.5f * wind.speed() / (wind.speed() + 6.0f)) * radius;
    const ImGuiCol color = dragged ? ImGuiCol_SliderGrabActive : ImGuiCol_SliderGrab;
    draw_arrow(draw, centre, frame.direction(wind.heading()), length, ImGui::GetColorU32(color));
    return dragged;
}

}  // namespace

Result<void> wind_panel(Simulation& simulation, WindControl& wind, const render::OrbitCamera& camera) {
    const Section section("Wind", true);
    if (!section) return {};
    WorldSettings settings = simulation.world().settings();

    ImGui::SetCursorPosX(0.5f * (ImGui::GetWindowWidth() - dial_size()));
    bool changed = wind_dial(wind, DialFrame(camera));
    float speed = wind.speed();
    if (slider("speed", speed, 0, strongest_wind, "%.1f m/s",
               "How fast the air moves: 3 stirs a curtain, 8 flies a flag, 20 is a gale. Up and down arrow "
               "keys.",
               ImGuiSliderFlags_Logarithmic)) {
        wind.set_speed(speed);
        changed = true;
    }
    changed |=
        slider("gusts", settings.wind.gust, 0, 2, "%.2f x speed",
               "How much the wind comes and goes, over its speed: 0 blows evenly, 0.3 is a gusty day, 1 a "
               "stormy one.");
    changed |=
        slider("air swirl size", settings.wind.gust_length, 0.1f, 5, "%.2f m",
               "How large the swirls of a gust are: small ones make the cloth flutter, large ones swing it.",
               ImGuiSliderFlags_Logarithmic);

    if (!changed) return {};
    settings.wind.velocity = wind.velocity();
    return simulation.world().set_settings(settings);
}

}  // namespace weft::demo
