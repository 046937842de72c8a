#pragma once
// The wind as an arrow in the picture, to be dragged.

#include "demo/window/wind_control.h"
#include "weft/render/camera.h"
#include "weft/types.h"

namespace weft::demo {

/// It lies level below what the camera looks at, and turns with the scene. Seen from too low it is shown as
/// from 35 degrees above, so that it can always be pointed. Places are in heights of the picture, from its
/// upper left corner.
class WindArrow {
  public:
    static constexpr float reach = 0.045f;  ///< of the hand that takes hold of its tip or shaft

    /// Where the camera has it now.
    void place(const render::OrbitCamera& camera, float aspect);

    [[nodiscard]] Vec2 foot() const { return foot_; }
    [[nodiscard]] Vec2 tip(const WindControl& wind) const;
    /// Where a level way from the foot leads: `right` and `away` as the camera looks.
    [[nodiscard]] Vec2 at(float right, float away) const;
    [[nodiscard]] bool is_under(Vec2 pointer, const WindControl& wind) const;
    /// Turns the wind so that the tip comes to the pointer.
    void drag(Vec2 pointer, WindControl& wind) const;

  private:
    Vec2 foot_{};
    float heading_ = 0;  // in which the camera looks, as WindControl's
    float rise_ = 1;     // of what lies a height farther away, in the picture
};

}  // namespace weft::demo
