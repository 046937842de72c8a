#pragma once
// Cloth that bodies squeeze, so that no place is free for it (Baraff, Witkin, Kass, "Untangling cloth", 2003,
// "flypapering").

#include <array>
#include <cstdint>
#include <span>

#include "collision/collider_contacts.h"
#include "engine/vector.h"
#include "weft/types.h"

namespace weft {

/// Of a particle that is nearer than the thickness to the surfaces of two colliders which leave no free place
/// within the thickness of it. It stays between them: it goes with the mean of the two, without sliding, and
/// is drawn to where it is as deep in both.
struct Squeeze {
    bool is_squeezed = false;
    Vector3 normal = Vector3::Zero();    ///< from the shallower to the deeper, of unit length
    Vector3 velocity = Vector3::Zero();  ///< the mean of their surfaces' [m/s]
    float to_middle = 0;                 ///< along the normal [m]
};

/// Particles of a block that may be squeezed, close together in memory.
struct SqueezedParticles {
    std::uint32_t count = 0;
    std::array<std::uint32_t, block_size> indices;  ///< in the block
    alignas(64) std::array<Vec4, block_size> points;
    std::array<Squeeze, block_size> squeezes;

    void add(std::uint32_t index, const Vec4& point) {
        indices[count] = index;
        points[count++] = point;
    }
};

/// Fills the squeezes of those that were added, for where their points are in the colliders at the end of a
/// substep of h [s].
void find_squeezes(std::span<const ColliderMotion> colliders, const ClothSide& cloth, float h,
                   SqueezedParticles& particles);

}  // namespace weft
