#pragma once
// How a cloth's particles meet colliders.

#include <cstdint>

#include "collision/colliders/collider_contacts.h"
#include "engine/memory/aligned_buffer.h"
#include "weft/settings.h"

namespace weft {

/// What ClothSide has of each particle, written when settings or maps change.
struct ColliderSide {
    explicit ColliderSide(std::uint32_t particles) : thickness(particles), friction(particles) {}

    AlignedBuffer<float> thickness, friction;          ///< of each particle: see ClothSide
    AlignedBuffer<float> thickness_map, friction_map;  ///< factors; empty: the map is not set

    void write(const ClothSettings& settings) noexcept {
        const auto fill = [](AlignedBuffer<float>& values, float of_all, const AlignedBuffer<float>& map) {
            for (std::uint32_t i = 0; i < values.size(); ++i)
                values[i] = map.size() > 0 ? of_all * map[i] : of_all;
        };
        fill(thickness, settings.thickness, thickness_map);
        fill(friction, settings.friction, friction_map);
    }
    [[nodiscard]] std::size_t bytes() const noexcept {
        return thickness.bytes() + friction.bytes() + thickness_map.bytes() + friction_map.bytes();
    }
};

}  // namespace weft
