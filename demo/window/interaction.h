#pragma once
// The mouse: it drags cloth, cuts it, or moves the camera.

#include <string>
#include <utility>

#include "demo/cutting/knife.h"
#include "demo/scene_simulation.h"
#include "demo/window/grab.h"
#include "weft/render/camera.h"

namespace weft::demo {

/// The mouse in one frame.
struct Pointer {
    float x = 0, y = 0;         ///< place in the picture, in [0, 1]; (0, 0) is the upper left corner
    float right = 0, down = 0;  ///< motion since the last frame, in heights of the picture
    bool left_button = false, other_button = false;  ///< held
    float wheel = 0;                                 ///< notches, away from the hand > 0
    bool over_panel = false;
    bool has_knife = false;  ///< the key is held with which the left button cuts
};

class Interaction {
  public:
    /// The left button on cloth grabs it, beside it orbits, and with the knife cuts all cloth on its way;
    /// another button pans; the wheel zooms. A drag lasts until all buttons are up, wherever the pointer
    /// goes; one that began on a panel belongs to the panel.
    void update(const Pointer& pointer, float aspect, Simulation& simulation, render::OrbitCamera& camera);
    /// Moves the grabbed particle over the step of dt [s] that follows. Pins that the scene moves itself obey
    /// the scene.
    void before_step(Simulation& simulation, float dt) { grab_.before_step(simulation.world(), dt); }
    /// Call this when the hand's world is gone.
    void forget() {
        grab_.forget();
        if (drag_ == Drag::cut) drag_ = Drag::none;
    }
    /// The grabbed particle stays pinned when it is let go.
    void leave_pinned() { grab_.leave_pinned(); }

    [[nodiscard]] const Grab& grab() const { return grab_; }
    [[nodiscard]] bool cuts() const { return drag_ == Drag::cut; }
    /// Why cloth could not be cut, reported once; empty: it could.
    [[nodiscard]] std::string take_complaint() { return std::exchange(complaint_, {}); }

  private:
    enum class Drag { none, panel, grab, cut, orbit, pan };
    Drag begin_drag(const Pointer& pointer, float aspect, Simulation& simulation,
                    const render::OrbitCamera& camera);

    Drag drag_ = Drag::none;
    Grab grab_;
    Knife knife_;
    std::string complaint_;
};

}  // namespace weft::demo
