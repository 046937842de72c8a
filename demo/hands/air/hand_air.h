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
    float blast_speed = 25;  ///< at its beginning, where it is strongest [m/s]
    bool wakes = true;       ///< of balls and of colliders that hands move

    /// A fan at the ray's start, blowing along it, until told otherwise.
    void hold_fan(const render::Ray& ray);
    void put_fan_away() { fan_ = {}; }
    void blast_at(const Vec3& place);
    /// Tells the World's wind what blows in the step of dt [s] that follows. `moving`: what may leave a wake.
    void before_step(World& world, std::span<const ColliderId> moving, std::span<const BodyId> balls,
                     float dt);
    /// Its world is gone, or at another time.
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
    std::vector<Seen> seen_;  // where colliders were before the last step
    bool blew_ = false;
};

}  // namespace weft::demo
