#pragma once
// The wind as an arrow in the picture, to be dragged.

#include "demo/window/wind_control.h"
#include "weft/render/camera.h"
#include "weft/types.h"

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

}  // namespace weft::demo
