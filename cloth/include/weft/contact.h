#pragma once
// Contacts of a step and their impulses: for sounds, dust, damage and gameplay.

#include <cstdint>

#include "weft/cloth_id.h"
#include "weft/collider.h"
#include "weft/types.h"

namespace weft {

/// A contact in a step of the World. Either a collider held or pushed a particle, or two features pushed each
/// other: a vertex and a triangle, or two edges (by avoidance, two particles). Or cloth is in a trigger: then
/// the impulse is 0. Ids are those of the step.
struct Contact {
    ClothId cloth{};        ///< the cloth that was pushed; of two cloths the one of the lower index
    ClothId other_cloth{};  ///< the cloth that it touched, possibly itself; null: a collider
    ColliderId collider{};  ///< the collider that it touched, of several the nearest at the end; null: cloth
    /// Particles nearest to the point: they index the buffers of ClothView.
    std::uint32_t particle = 0, other_particle = 0;
    Vec3 point{};   ///< on the collider's surface, or half way between the features, at the end [m]
    Vec3 normal{};  ///< unit vector out of the other, towards `cloth`
    /// Impulse on `cloth`, friction included [N s]; the other received the opposite. Over the step's length
    /// it is the mean force [N]; its normal component is positive. 0: `collider` is a trigger.
    Vec3 impulse{};
};

}  // namespace weft
