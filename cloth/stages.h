#pragma once
// The stages of a step, as the profiler names them.

#include <array>
#include <cstdint>

namespace weft {

enum class Stage : std::uint32_t {
    wind,
    assemble,
    solve,
    advance,
    tethers,
    colliders,
    self_search,
    self_response,
    guard,
    normals
};
inline constexpr std::array stage_names{"wind",      "assemble",    "solve",         "advance", "tethers",
                                        "colliders", "self search", "self response", "guard",   "normals"};

}  // namespace weft
