#pragma once
// A hand on the cloth: it holds one particle and moves it with the pointer.

#include <cstdint>

#include "weft/render/camera.h"
#include "weft/world.h"

namespace weft::demo {

class Grab {
  public:
    /// The fastest that the hand moves [m/s]: a jump of the pointer must not tear at the cloth.
    static constexpr float max_speed = 8.0f;

    /// Takes hold of the particle under the ray. False if the ray meets no cloth. The hand moves in the plane
    /// through that particle normal to `forward`, the direction in which the camera looks.
    bool begin(World& world, const render::Ray& ray, const Vec3& forward);
    /// Sets the hand's target: the point of its plane on the ray.
    void aim(const render::Ray& ray);
    /// Moves the particle towards the target over the step of dt [s] that follows.
    void before_step(World& world, float dt);
    /// Lets go. A particle that the scene had pinned stays pinned.
    void end(World& world);
    /// The particle will stay pinned after end(), as though the scene had pinned it.
    void leave_pinned() { was_pinned_ = true; }
    /// Forgets the particle: its world is gone.
    void forget() { active_ = false; }

    [[nodiscard]] bool active() const { return active_; }
    [[nodiscard]] bool was_pinned() const { return was_pinned_; }
    [[nodiscard]] ClothId cloth() const { return cloth_; }
    [[nodiscard]] std::uint32_t vertex() const { return vertex_; }
    [[nodiscard]] Vec3 hand() const { return hand_; }  ///< place of the particle at the end of the step [m]

  private:
    bool active_ = false;
    bool was_pinned_ = false;
    ClothId cloth_;
    std::uint32_t vertex_ = 0;
    Vec3 forward_, hand_, target_;
};

}  // namespace weft::demo
