#pragma once
// Collider contact that persists from step to step.

#include <cstddef>
#include <cstdint>

#include "engine/memory/aligned_buffer.h"
#include "weft/types.h"

namespace weft {

/// Normal and friction impulses between particles and colliders, from one step to the next.
struct HeldContacts {
    static constexpr std::uint32_t group = 16;  ///< particles per entry of `touching`

    AlignedBuffer<Vec4> normals;            ///< contact normal, 0 without contact; w its impulse [kg m/s]
    AlignedBuffer<float> rubbed;            ///< friction impulse of the damper, as last computed [kg m/s]
    AlignedBuffer<Vec4> loads;              ///< impulse less the share that stopped the particle [kg m/s]:
                                            ///< x y z friction, w along the normal
    AlignedBuffer<std::uint32_t> touching;  ///< per group of 16: whether any particle is in contact; if none
                                            ///< is, the other arrays are 0 there

    HeldContacts() = default;
    explicit HeldContacts(std::uint32_t particles)
        : normals(particles),
          rubbed(particles),
          loads(particles),
          touching((particles + group - 1) / group) {}
    [[nodiscard]] std::size_t bytes() const noexcept {
        return normals.bytes() + rubbed.bytes() + loads.bytes() + touching.bytes();
    }
};

}  // namespace weft
