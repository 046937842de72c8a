#pragma once
// Finds the particle under the pointer.

#include <cstdint>
#include <optional>

#include "weft/render/camera.h"
#include "weft/world.h"

namespace weft::demo {

struct Hit {
    float distance;          ///< along the ray [m]
    std::uint32_t particle;  ///< corner of the triangle nearest to the point that was hit
};

/// The ray's first hit on the cloth, from either side.
[[nodiscard]] std::optional<Hit> first_hit(const ClothView& cloth, const render::Ray& ray);

}  // namespace weft::demo
