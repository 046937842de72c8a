#pragma once
// Bodies in the user's hand: a collider that is moved and scaled, and balls that are thrown.

#include <optional>
#include <span>
#include <vector>

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

/// A few bodies, added to the World at the first throw; the ball thrown longest ago is thrown next. Balls
/// bounce on the floor at y = 0. Balls that were not thrown yet fall far below the floor, out of sight.
class Balls {
  public:
    static constexpr std::size_t count = 6;
    static constexpr float radius = 0.11f;  ///< [m]
    static constexpr float bounce = 0.55f;  ///< share of the speed that the floor leaves

    float mass = 0.45f;  ///< of the next ball [kg]
    float speed = 9.0f;  ///< of the next ball, when thrown [m/s]

    /// Throws a ball from the ray's start along the ray. Error: the World takes no more bodies.
    Result<void> throw_along(World& world, const render::Ray& ray);
    /// Adds the balls to the World or removes them, as the save that is restored next needs it.
    Result<void> set_there(World& world, bool there);
    /// Bounces the balls that reach the floor in the step of dt [s] that follows.
    void before_step(World& world, float dt);
    /// Call this when their world is gone.
    void forget();

    [[nodiscard]] bool are_there() const { return !balls_.empty(); }
    /// Colliders of the balls that were thrown. Valid until the next call.
    [[nodiscard]] std::span<const ColliderId> in_play(const World& world);
    [[nodiscard]] std::span<const BodyId> bodies() const { return bodies_; }

  private:
    Result<void> add(World& world);

    std::vector<ColliderId> balls_, shown_;
    std::vector<BodyId> bodies_;
    std::size_t next_ = 0;
};

}  // namespace weft::demo
