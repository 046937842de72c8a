#pragma once
// A hand that moves and scales a ball, a capsule or a box of the scene.

#include <optional>
#include <span>

#include "weft/render/camera.h"
#include "weft/world.h"

namespace weft::demo {

/// Distance to the collider along the ray [m]; none if the ray misses. Planes and PlacedShapes have none.
[[nodiscard]] std::optional<float> distance_to(const Collider& collider, const render::Ray& ray);

class HeldCollider {
  public:
    static constexpr float max_speed = 6.0f;   ///< of the hand [m/s]
    static constexpr float max_growth = 2.0f;  ///< factor in a second

    /// Takes hold of the first collider on the ray within `nearer_than` [m]. The hand moves in the plane
    /// normal to `forward` through the hit. A body's collider is let go at the next step.
    bool begin(const World& world, std::span<const ColliderId> colliders, const render::Ray& ray,
               const Vec3& forward, float nearer_than);
    void aim(const render::Ray& ray);
    /// Multiplies the target size, from 1/50 to 50 times the first; max_growth limits the change.
    void scale(float factor);
    /// Moves and scales the collider over the step of dt [s] that follows.
    void before_step(World& world, float dt);
    void end() { active_ = false; }

    [[nodiscard]] bool active() const { return active_; }
    [[nodiscard]] ColliderId id() const { return id_; }

  private:
    bool active_ = false;
    ColliderId id_;
    Vec3 forward_, hand_, target_;
    float size_ = 1, wanted_size_ = 1;  // over the first size
};

}  // namespace weft::demo
