#pragma once
// What of contact with colliders goes on from step to step.

#include <cstddef>
#include <cstdint>

#include "engine/memory/aligned_buffer.h"
#include "weft/types.h"

namespace weft {

/// How hard particles press on colliders, and rub, from one step to the next.
struct HeldContacts {
    static constexpr std::uint32_t group = 16;  ///< particles

    AlignedBuffer<Vec4> normals;            ///< of contact, 0 without it; w the impulse along it [kg m/s]
    AlignedBuffer<float> rubbed;            ///< what the damper took when last looked at [kg m/s]
    AlignedBuffer<float> loads;             ///< what they bear at rest: of the impulse along the normal, what
                                            ///< did not go into stopping the particle [kg m/s]
    AlignedBuffer<std::uint32_t> touching;  ///< per group of 16: whether a particle of it is in contact; else
                                            ///< the others are 0

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
