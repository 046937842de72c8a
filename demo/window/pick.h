#pragma once
// Which particle is under the pointer.

#include <cstdint>
#include <optional>

#include "weft/render/camera.h"
#include "weft/world.h"

namespace weft::demo {

struct Hit {
    float distance;          ///< along the ray [m]
    std::uint32_t particle;  ///< of the triangle's three, the nearest to where the ray meets it
};

/// Where the ray first meets the cloth, from either side.
[[nodiscard]] std::optional<Hit> first_hit(const ClothView& cloth, const render::Ray& ray);

}  // namespace weft::demo
