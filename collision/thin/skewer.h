#pragma once
// Cloth that the axis of a limb sticks through. No corner need be inside, and what began there is let be, so
// nothing else would take it off.

#include <array>
#include <cstdint>
#include <optional>
#include <span>

#include "collision/colliders/collider_contacts.h"
#include "collision/thin/cores.h"
#include "engine/vector.h"
#include "weft/types.h"

namespace weft {

/// The axis of something round at the end of a substep.
class Skewer {
  public:
    using Triangle = std::array<std::uint32_t, 3>;  ///< particles

    /// Nothing of what has no axis. The cores are to outlive it.
    [[nodiscard]] static std::optional<Skewer> of(const Cores& cores);

    /// Around it, in the World, and in a space of its own.
    [[nodiscard]] Bounds bounds() const;
    [[nodiscard]] TurningBox box() const;
    [[nodiscard]] bool goes_through(const Triangle& corners, std::span<const Vec4> positions) const {
        return hit(corners, positions).has_value();
    }

    /// Where cloth may come off: beyond an end that no other collider holds, and if each is held, the one
    /// that is thinner, as a hand is at the end of an arm. Precondition: the motion is one of the colliders.
    void find_ways(const ColliderMotion& motion, std::span<const ColliderMotion> colliders,
                   const ClothSide& cloth, float h);
    /// Moves the corners along, so that the triangle comes off over the nearer end of these. That way becomes
    /// no velocity. Returns whether it went through.
    bool take_off(const Triangle& corners, float h, std::span<Vec4> positions) const;

  private:
    struct Hit {
        std::array<float, 3> weights;  // of corners
        float x;                       // along the axis
    };

    [[nodiscard]] std::optional<Hit> hit(const Triangle& corners, std::span<const Vec4> positions) const;

    const Cores* cores_ = nullptr;
    float length_ = 0;                    // of the axis [m]
    float off_first_ = 0, off_last_ = 0;  // from its ends to where cloth is off [m]
    bool over_first_ = false, over_last_ = false;
};

}  // namespace weft
