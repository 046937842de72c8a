#pragma once
// Air that hands set in motion: a fan, a blast, and the wakes of balls that pass.

#include <span>
#include <vector>

#include "weft/render/camera.h"
#include "weft/world.h"

namespace weft::demo {

class HandAir {
  public:
    float fan_speed = 12;    ///< [m/s]
    float blast_speed = 25;  ///< at the beginning of a blast, its strongest moment [m/s]
    bool wakes = true;       ///< balls, and colliders that hands move, leave wakes

    /// Places a fan at the ray's start that blows along the ray until put_fan_away().
    void hold_fan(const render::Ray& ray);
    void put_fan_away() { fan_ = {}; }
    void blast_at(const Vec3& place);
    /// Sets the air sources of the World's wind for the step of dt [s] that follows. `moving`: colliders that
    /// may leave a wake.
    void before_step(World& world, std::span<const ColliderId> moving, std::span<const BodyId> balls,
                     float dt);
    /// Call this when the world is gone or was restored to another time.
    void forget();

    [[nodiscard]] const AirSource& fan() const { return fan_; }
    [[nodiscard]] const AirSource& blast() const { return blast_; }

  private:
    struct Seen {
        ColliderId id;
        Vec3 middle;
    };
    void add_wakes(const World& world, std::span<const ColliderId> moving, std::span<const BodyId> balls,
                   float dt, std::vector<AirSource>& air);

    AirSource fan_{}, blast_{};
    std::vector<Seen> seen_;  // middles of colliders before the last step
    bool blew_ = false;
};

}  // namespace weft::demo
