#pragma once
// Balls to throw.

#include <span>
#include <vector>

#include "weft/render/camera.h"
#include "weft/world.h"

namespace weft::demo {

/// A few bodies, there from the first throw on: the one that was thrown longest ago is thrown next. They
/// bounce on the floor at y = 0. Those that nobody has thrown yet fall far below the floor, out of sight.
class Balls {
  public:
    static constexpr std::size_t count = 6;
    static constexpr float radius = 0.11f;  ///< [m]
    static constexpr float bounce = 0.55f;  ///< of the speed, left by the floor

    float mass = 0.45f;  ///< of the next [kg]
    float speed = 9.0f;  ///< of the next, as it is thrown [m/s]

    /// From the ray's start along it. Error: the World takes no more bodies.
    Result<void> throw_along(World& world, const render::Ray& ray);
    /// Adds them to the World or takes them out of it, as `there` says: a save has them or not.
    Result<void> set_there(World& world, bool there);
    /// Bounces off the floor what comes to it.
    void before_step(World& world, float dt);
    /// Their world is gone.
    void forget();

    [[nodiscard]] bool are_there() const { return !balls_.empty(); }
    /// Of those that were thrown. Valid until the next call.
    [[nodiscard]] std::span<const ColliderId> in_play(const World& world);
    [[nodiscard]] std::span<const BodyId> bodies() const { return bodies_; }

  private:
    Result<void> add(World& world);

    std::vector<ColliderId> balls_, shown_;
    std::vector<BodyId> bodies_;
    std::size_t next_ = 0;
};

}  // namespace weft::demo
