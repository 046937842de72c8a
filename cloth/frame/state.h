#pragma once
// What changes from step to step, one array an attribute.

#include <cstdint>
#include <utility>

#include "engine/aligned_buffer.h"
#include "weft/types.h"

namespace weft {

/// Loose and pinned particles have inverse mass 0.
struct ClothState {
    AlignedBuffer<Vec4> positions;           ///< x y z [m], w inverse mass [1/kg]
    AlignedBuffer<Vec4> previous_positions;  ///< at the start of the step, w likewise
    AlignedBuffer<Vec4> velocities;          ///< x y z [m/s], w 0
    AlignedBuffer<Vec4> normals;             ///< x y z of unit length, w 0

    ClothState() = default;
    explicit ClothState(std::uint32_t particles)
        : positions(particles), previous_positions(particles), velocities(particles), normals(particles) {}

    [[nodiscard]] std::uint32_t size() const noexcept { return static_cast<std::uint32_t>(positions.size()); }
    [[nodiscard]] std::size_t bytes() const noexcept {
        return positions.bytes() + previous_positions.bytes() + velocities.bytes() + normals.bytes();
    }
};

}  // namespace weft
