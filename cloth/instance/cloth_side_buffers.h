#pragma once
// A cloth's thickness and friction, particle by particle.

#include <cstdint>

#include "collision/colliders/collider_contacts.h"
#include "engine/memory/aligned_buffer.h"
#include "weft/settings.h"

namespace weft {

/// The arrays of a cloth's ClothSide: settings times maps. The products are stored whenever either changes,
/// since each pass of each substep reads them.
struct ClothSideBuffers {
    explicit ClothSideBuffers(std::uint32_t particles) : thickness(particles), friction(particles) {}

    AlignedBuffer<float> thickness, friction;          ///< see ClothSide
    AlignedBuffer<float> thickness_map, friction_map;  ///< factors of each particle; empty: no map is set
    AlignedBuffer<float> masks;                        ///< of Map::collider_mask; empty: no map is set

    void write(const ClothSettings& settings) noexcept {
        const auto fill = [](AlignedBuffer<float>& values, float of_all, const AlignedBuffer<float>& map) {
            for (std::uint32_t i = 0; i < values.size(); ++i)
                values[i] = map.size() > 0 ? of_all * map[i] : of_all;
        };
        fill(thickness, settings.thickness, thickness_map);
        fill(friction, settings.friction, friction_map);
    }
    [[nodiscard]] std::size_t bytes() const noexcept {
        return thickness.bytes() + friction.bytes() + thickness_map.bytes() + friction_map.bytes() +
               masks.bytes();
    }
};

}  // namespace weft
