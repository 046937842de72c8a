#pragma once
// What touched what in a step, and how hard: for sounds, dust, damage, and whatever gameplay asks.

#include <cstdint>

#include "weft/cloth_id.h"
#include "weft/collider.h"
#include "weft/types.h"

namespace weft {

/// Where something pushed cloth in a step of the World: a particle that colliders held or pushed, or two
/// features that pushed each other, a vertex and a triangle or two edges; by avoidance, two particles. Or
/// where cloth is in a trigger: then the impulse is 0. Ids are those of the step.
struct Contact {
    ClothId cloth{};        ///< what was pushed; of two cloths the one of the lower index
    ClothId other_cloth{};  ///< what it touched, itself too; null: a collider
    ColliderId collider{};  ///< likewise; null: cloth. Of several that a particle met, the nearest at the end
    /// Particles nearest to the point: they index the buffers of ClothView.
    std::uint32_t particle = 0, other_particle = 0;
    Vec3 point{};   ///< on the collider's surface, or half way between the features, at the end [m]
    Vec3 normal{};  ///< of unit length, out of the other and towards `cloth`
    /// That `cloth` got, friction included [N s]; the other got the opposite. Over the step's length it is
    /// the mean force [N]; along the normal it is positive. 0: `collider` is a trigger.
    Vec3 impulse{};
};

}  // namespace weft
