#pragma once
// Colliders are drawn between two steps, as late as the cloth that lies on them: their places there.

#include <cstdint>
#include <map>
#include <utility>

#include "weft/world.h"

namespace weft::demo {

class ColliderMotion {
  public:
    /// Keeps the collider's place after the World's last step, if it is a new one. Call this for each
    /// picture.
    void note(ColliderId id, const Collider& collider, std::uint64_t step);
    /// The collider at that share of the way from the step before to the last, 0 to 1. One that has jumped is
    /// where it is. Precondition: note() was called for it.
    [[nodiscard]] Collider at(ColliderId id, float share) const;
    void forget() { motions_.clear(); }

  private:
    struct Motion {
        Collider before, now;
        std::uint64_t step;
    };
    using Key = std::pair<std::uint32_t, std::uint32_t>;
    [[nodiscard]] static Key key(ColliderId id) { return {id.index, id.generation}; }
    std::map<Key, Motion> motions_;
};

}  // namespace weft::demo
