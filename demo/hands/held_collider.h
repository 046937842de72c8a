#pragma once
// A hand on a ball, a capsule or a box of the scene: moves it and makes it larger or smaller.

#include <optional>
#include <span>

#include "weft/render/camera.h"
#include "weft/world.h"

namespace weft::demo {

/// Along the ray [m]; none if it misses. Of a PlacedShape: none.
[[nodiscard]] std::optional<float> distance_to(const Collider& collider, const render::Ray& ray);

class HeldCollider {
  public:
    static constexpr float max_speed = 6.0f;   ///< of the hand [m/s]
    static constexpr float max_growth = 2.0f;  ///< a second

    /// Takes hold of the nearest that the ray meets, unless it is farther than `nearer_than` [m] or a body
    /// carries it. It is then moved in the plane across `forward` through where it was met.
    bool begin(const World& world, std::span<const ColliderId> colliders, const render::Ray& ray,
               const Vec3& forward, float nearer_than);
    void aim(const render::Ray& ray);
    /// Times its size, to be reached at a rate that cloth bears. It stays within a fiftieth and fifty times.
    void scale(float factor);
    /// Moves it over the step of dt [s] that follows.
    void before_step(World& world, float dt);
    void end() { active_ = false; }

    [[nodiscard]] bool active() const { return active_; }
    [[nodiscard]] ColliderId id() const { return id_; }

  private:
    bool active_ = false;
    ColliderId id_;
    Vec3 forward_, hand_, target_;
    float size_ = 1, wanted_size_ = 1;  // times what it was
};

}  // namespace weft::demo
