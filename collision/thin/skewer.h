#pragma once
// Removal of cloth that a limb's axis pierces. Nothing else would remove it: no corner need be inside the
// limb, and an edge that begins inside is ignored.

#include <array>
#include <cstdint>
#include <optional>
#include <span>

#include "collision/colliders/collider_contacts.h"
#include "collision/thin/cores.h"
#include "engine/vector.h"
#include "weft/types.h"

namespace weft {

/// The axis of a round collider at the end of a substep.
class Skewer {
  public:
    using Triangle = std::array<std::uint32_t, 3>;  ///< particles

    /// Nothing for cores without an axis. The cores must outlive the skewer.
    [[nodiscard]] static std::optional<Skewer> of(const Cores& cores);

    /// Bounding box of the axis, in the World and in its local frame.
    [[nodiscard]] Bounds bounds() const;
    [[nodiscard]] TurningBox box() const;
    [[nodiscard]] bool goes_through(const Triangle& corners, std::span<const Vec4> positions) const {
        return hit(corners, positions).has_value();
    }

    /// Finds the ends over which cloth may come off: those inside no other collider or, if both are inside
    /// one, the thinner, as a hand at the end of an arm. Precondition: the motion is one of the colliders.
    void find_ways(const ColliderMotion& motion, std::span<const ColliderMotion> colliders,
                   const ClothSide& cloth, float h);
    /// Moves the corners along the axis, so that the triangle comes off over the nearer of these ends. The
    /// motion adds no velocity. Returns whether it moved any.
    bool take_off(const Triangle& corners, float h, std::span<Vec4> positions) const;

  private:
    struct Hit {
        std::array<float, 3> weights;  // of corners
        float x;                       // along the axis
    };

    [[nodiscard]] std::optional<Hit> hit(const Triangle& corners, std::span<const Vec4> positions) const;

    const Cores* cores_ = nullptr;
    float length_ = 0;                    // of the axis [m]
    float off_first_ = 0, off_last_ = 0;  // from the axis's ends to where cloth is off [m]
    bool over_first_ = false, over_last_ = false;
};

}  // namespace weft
