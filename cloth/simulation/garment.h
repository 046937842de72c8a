#pragma once
// A garment of several meshes, its levels, one of which is stepped at a time.

#include <cstdint>
#include <optional>
#include <vector>

#include "cloth/budget/ladder.h"
#include "cloth/surface/surface_state.h"
#include "weft/cloth_id.h"
#include "weft/drawn_mesh.h"

namespace weft {

/// WorldState::levels says which of its cloths is stepped; the others wait, switched off.
struct Garment {
    std::vector<ClothId> levels;     ///< from the finest
    std::vector<DrawnMesh> coarser;  ///< bonds of level k + 1's vertices to level k
    std::vector<DrawnMesh> finer;    ///< bonds of level k's vertices to level k + 1
    SurfaceState carried;            ///< has room for the finest
    std::uint32_t least = 0;         ///< finest level that the host allows the budget

    struct Choice {
        std::uint32_t level = 0, rung = 0;
    };
    std::optional<Choice> next;  ///< the budget's choice, taken at the end of the step
};

inline constexpr std::uint32_t no_garment = ~0u;

}  // namespace weft
