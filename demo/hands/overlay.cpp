#include "demo/hands/overlay.h"

#include <imgui.h>

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "demo/hands/project.h"
#include "demo/panels/widgets.h"
#include "engine/vector.h"

namespace weft::demo {
namespace {

constexpr ImU32 arrow_colour = IM_COL32(30, 110, 190, 225), held_colour = IM_COL32(70, 165, 250, 255);
constexpr std::size_t most_pins = 120;  // pins that are shown; more are a seam or a body's own

/// Draws at points of the world, or at places in picture heights.
class Pen {
  public:
    explicit Pen(const render::OrbitCamera& camera)
        : list_(*ImGui::GetBackgroundDrawList()), camera_(camera) {
        const ImVec2 size = ImGui::GetIO().DisplaySize;
        height_ = size.y;
        aspect_ = size.x / size.y;
    }
    [[nodiscard]] ImVec2 pixels(Vec2 place) const { return {height_ * place.x, height_ * place.y}; }
    [[nodiscard]] std::optional<ImVec2> pixels(const Vec3& point) const {
        const auto place = project(camera_, point, aspect_);
        return place ? std::optional(pixels(*place)) : std::nullopt;
    }
    void line(const Vec3& from, const Vec3& to, ImU32 colour, float width) const {
        const auto a = pixels(from), b = pixels(to);
        if (a && b) list_.AddLine(*a, *b, colour, width);
    }
    /// A circle round `middle`, normal to `axis`.
    void ring(const Vec3& middle, const Vector3& axis, float radius, ImU32 colour) const {
        const Vector3 other = std::abs(axis.y()) < 0.9f ? Vector3(0, 1, 0) : Vector3(1, 0, 0);
        const Vector3 x = axis.cross(other).normalized(), y = axis.cross(x);
        Vector3 last = to_vector(middle) + radius * x;
        for (int k = 1; k <= 24; ++k) {
            const float angle = 6.2831853f * static_cast<float>(k) / 24;
            const Vector3 next = to_vector(middle) + radius * (std::cos(angle) * x + std::sin(angle) * y);
            line(to_vec3(last), to_vec3(next), colour, 2);
            last = next;
        }
    }
    [[nodiscard]] ImDrawList& list() const { return list_; }
    [[nodiscard]] float height() const { return height_; }

  private:
    ImDrawList& list_;
    const render::OrbitCamera& camera_;
    float height_, aspect_;
};

ImU32 faded(ImU32 colour, float opacity) {
    const auto alpha = static_cast<ImU32>(255 * std::clamp(opacity, 0.0f, 1.0f));
    return (colour & ~IM_COL32_A_MASK) | (alpha << IM_COL32_A_SHIFT);
}

/// Draws the arrow from its foot to its tip, and the wind's speed.
void draw_arrow(const Pen& pen, const WindArrow& arrow, const WindControl& wind, bool held) {
    const ImVec2 foot = pen.pixels(arrow.foot()), tip = pen.pixels(arrow.tip(wind));
    const float x = tip.x - foot.x, y = tip.y - foot.y, length = std::max(std::hypot(x, y), 1e-3f);
    const ImVec2 along(x / length, y / length), across(-y / length, x / length);
    const float width = 0.009f * pen.height(), head = std::min(0.045f * pen.height(), 0.7f * length);
    const auto at = [&](float forth, float aside) {
        return ImVec2(foot.x + forth * along.x + aside * across.x,
                      foot.y + forth * along.y + aside * across.y);
    };
    const ImU32 colour = held ? held_colour : arrow_colour;
    ImDrawList& list = pen.list();
    list.AddQuadFilled(at(0, 0.5f * width), at(length - head, width), at(length - head, -width),
                       at(0, -0.5f * width), colour);
    list.AddTriangleFilled(at(length, 0), at(length - head, -0.55f * head), at(length - head, 0.55f * head),
                           colour);
    list.AddCircleFilled(foot, 0.8f * width, colour);
    char text[32];
    std::snprintf(text, sizeof text, "wind %.1f m/s", static_cast<double>(wind.speed()));
    // The text stands beside the foot, on the side away from the tip.
    const float aside = 0.02f * pen.height(), wide = ImGui::CalcTextSize(text).x;
    list.AddText({tip.x < foot.x ? foot.x + aside : foot.x - aside - wide, foot.y + 0.3f * aside},
                 IM_COL32(20, 30, 45, 230), text);
}

void draw_air(const Pen& pen, const HandAir& air) {
    if (air.fan().kind != AirSourceKind::none) {
        const Vector3 axis = to_vector(air.fan().velocity).normalized();
        pen.ring(air.fan().position, axis, air.fan().radius, held_colour);
        pen.ring(air.fan().position, axis, 0.3f * air.fan().radius, held_colour);
        pen.line(air.fan().position, to_vec3(to_vector(air.fan().position) + 0.35f * axis), held_colour, 3);
    }
    const AirSource& blast = air.blast();
    if (blast.kind == AirSourceKind::none) return;
    const float grown = 1.6f - blast.velocity.x / air.blast_speed;
    for (const Vector3& axis : {Vector3(1, 0, 0), Vector3(0, 1, 0), Vector3(0, 0, 1)})
        pen.ring(blast.position, axis, grown * blast.radius,
                 faded(IM_COL32(255, 170, 60, 255), 1.6f - grown));
}

void draw_brush(const Pen& pen, const Brush& brush, const Vec3& eye) {
    if (!brush.place()) return;
    const Vector3 towards = (to_vector(eye) - to_vector(*brush.place())).normalized();
    pen.ring(*brush.place(), towards, brush.radius, held_colour);
}

void draw_pins(const Pen& pen, const Simulation& simulation) {
    const float radius = std::clamp(0.003f * pen.height(), 1.0f, 4.0f);
    for (const SceneCloth& cloth : simulation.content().cloths) {
        const auto view = simulation.world().cloth(cloth.id);
        if (!view) continue;
        const auto is_pinned = [](const Vec4& particle) { return particle.w == 0; };
        const auto pins = static_cast<std::size_t>(std::ranges::count_if(view->positions, is_pinned));
        if (pins > most_pins) continue;
        for (const Vec4& particle : view->positions) {
            if (!is_pinned(particle)) continue;
            const auto place = pen.pixels(Vec3{particle.x, particle.y, particle.z});
            if (place) pen.list().AddCircleFilled(*place, radius, IM_COL32(250, 210, 90, 235));
        }
    }
}

}  // namespace

void draw_overlay(const Hands& hands, const Simulation& simulation, const render::OrbitCamera& camera,
                  const WindControl& wind, bool pins) {
    const Pen pen(camera);
    draw_air(pen, hands.air);
    draw_brush(pen, hands.brush, camera.eye());
    if (pins) draw_pins(pen, simulation);
    draw_arrow(pen, hands.arrow(), wind, hands.holds_arrow());
}

void hands_controls(Hands& hands) {
    ImGui::Checkbox("streaks of air", &hands.streaks.visible);
    tooltip("Motes that drift with the air and show where it goes, and its gusts.");
    ImGui::Checkbox("balls stir the air", &hands.air.wakes);
    tooltip("What flies past pushes air before it and drags air behind it, which cloth feels.");
    slider("fan", hands.air.fan_speed, 2, 40, "%.0f m/s", "Hold F: a fan blows where the pointer is.");
    slider("blast", hands.air.blast_speed, 5, 80, "%.0f m/s", "B: air bursts from where the pointer is.");
    slider("throw", hands.balls.speed, 2, 25, "%.0f m/s", "T: throws a ball to where the pointer is.");
    ImGui::PushTextWrapPos(0);
    ImGui::TextDisabled("Drag the arrow: wind. P: pin or let go.");
    ImGui::TextDisabled("T: throw. Hold F: fan. B: blast.");
    ImGui::TextDisabled("Drag a ball: moves it; wheel: its size.");
    ImGui::PopTextWrapPos();
}

void hands_panel(Hands& hands) {
    if (const Section section("Hands"); section) hands_controls(hands);
}

}  // namespace weft::demo
