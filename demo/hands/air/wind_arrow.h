#pragma once
// The wind made visible: an arrow to be dragged, and motes that drift with the air.

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "demo/window/wind_control.h"
#include "weft/render/camera.h"
#include "weft/render/scene_renderer.h"
#include "weft/types.h"
#include "weft/world.h"

namespace weft::demo {

/// A level arrow below the camera's target that turns with the scene. For a low camera it is drawn as from 35
/// degrees above, so that it can always be dragged. Places are in picture heights from the upper left corner.
class WindArrow {
  public:
    static constexpr float reach = 0.045f;  ///< greatest distance from tip or shaft at which it is grabbed

    /// Updates the arrow's place for the camera.
    void place(const render::OrbitCamera& camera, float aspect);

    [[nodiscard]] Vec2 foot() const { return foot_; }
    [[nodiscard]] Vec2 tip(const WindControl& wind) const;
    /// The end of a level vector from the foot; `right` and `away` are relative to the camera.
    [[nodiscard]] Vec2 at(float right, float away) const;
    [[nodiscard]] bool is_under(Vec2 pointer, const WindControl& wind) const;
    /// Sets the wind's heading and speed so that the tip comes to the pointer.
    void drag(Vec2 pointer, WindControl& wind) const;

  private:
    Vec2 foot_{};
    float heading_ = 0;  // heading of the camera, as WindControl's
    float rise_ = 1;     // rise in the picture per unit of length away from the camera
};

/// Air made visible: motes that drift with it and leave streaks.
class Streaks {
  public:
    static constexpr std::size_t count = 120, length = 10;  ///< motes, and kept positions of each

    bool visible = false;

    /// Places new motes in the box round `middle` of that half side [m].
    void begin(const Vec3& middle, float half_side);
    /// Moves the motes with the air over dt [s]. Motes that leave the box or are too old are replaced. Those
    /// before cloth, as seen from `eye`, are not drawn.
    void step(const World& world, float dt, const Vec3& eye);

    struct Mote {
        std::array<Vec3, length> trail;  ///< the last places, the newest first
        std::size_t kept = 0;            ///< valid places of the trail
        float age = 0, lasts = 1;        ///< [s]
        float speed = 0;                 ///< of the air at the mote [m/s]
        bool before_cloth = false;
    };
    /// The streaks, fainter where they are older; none while not visible.
    [[nodiscard]] std::vector<render::DrawnLine> lines() const;

  private:
    void renew(Mote& mote);
    float random();  // random number in [0, 1); it has no effect on the simulation

    Vec3 middle_{};
    float half_side_ = 1;
    std::vector<Mote> motes_;
    std::vector<Vec3> places_, air_;
    std::uint32_t seed_ = 1;
    std::size_t turn_ = 0;
};

}  // namespace weft::demo
