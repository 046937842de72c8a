#pragma once
// Maps of a cloth: their names in files, their defaults and ranges, and their values by vertex.

#include <array>
#include <limits>
#include <string_view>
#include <vector>

#include "weft/maps.h"

namespace weft::demo {

/// A map with its value for each vertex.
struct PaintedMap {
    Map map;
    std::vector<float> values;
};

/// A map with its name in files, its default, and its range as in weft/maps.h.
struct NamedMap {
    std::string_view name;
    Map map;
    float unset, least, most;
};
inline constexpr float unlimited = std::numeric_limits<float>::infinity();
inline constexpr std::array<NamedMap, 9> named_maps{
    {{"mass", Map::mass, 1, 0.01f, 100},
     {"pin", Map::pin, 0, 0, 1},
     {"leash", Map::leash, unlimited, 0, unlimited},
     {"backstop", Map::backstop, unlimited, -10, unlimited},
     {"backstop_radius", Map::backstop_radius, unlimited, 1e-3f, unlimited},
     {"friction", Map::friction, 1, 0, 1000},
     {"thickness", Map::thickness, 1, 0, 1},
     {"stiffness", Map::stiffness, 1, 1e-3f, 1000},
     {"collider_mask", Map::collider_mask, most_collider_mask, 0, most_collider_mask}}};

[[nodiscard]] constexpr const NamedMap& named(Map map) {
    for (const NamedMap& each : named_maps)
        if (each.map == map) return each;
    return named_maps.front();
}

}  // namespace weft::demo
