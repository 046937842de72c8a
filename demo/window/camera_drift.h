#pragma once
// The camera's own motion: it follows cloth that would leave the picture, and goes round when nobody does
// anything.

#include <optional>

#include "demo/scene_simulation.h"
#include "weft/render/camera.h"

namespace weft::demo {

/// A box about all cloths of the scene.
[[nodiscard]] Bounds bounds_of_cloth(const Simulation& simulation);

class CameraDrift {
  public:
    static constexpr float idle_after = 30;    ///< [s]
    static constexpr float turn_rate = 0.06f;  ///< of the idle camera [rad/s]

    /// The user did something: the idle camera stops.
    void wake() { idle_ = 0; }
    /// Moves the camera over `seconds`, so that the box comes back into the picture. The view that the user,
    /// or the scene, gave the camera last is kept as long as the box is as far within the picture as it was
    /// then.
    void update(const Bounds& cloth, float aspect, float seconds, render::OrbitCamera& camera);

  private:
    struct Extent {
        Vec2 least, most;  // in picture heights
    };
    [[nodiscard]] static std::optional<Extent> extent_of(const Bounds& cloth, float aspect,
                                                         const render::OrbitCamera& camera);

    render::OrbitCamera home_, seen_;  // the view that was given; the camera after the last update
    float seen_aspect_ = 0;
    Extent allowed_{};
    Vec2 offset_{};  // from home_, as OrbitCamera::pan() takes it
    float idle_ = 0;
};

}  // namespace weft::demo
