#pragma once
// What the files that make up the public World share.

#include <string>

#include "cloth/frame/simulation.h"
#include "weft/world.h"

namespace weft {

struct World::Impl {
    explicit Impl(const WorldSettings& settings) : simulation(settings) {}
    Simulation simulation;
};

template <class Id>
Error stale_id(const char* type, Id id) {
    if (id == Id{})
        return {ErrorCode::stale_id, std::string(type) + " is null; use the one that the World returned"};
    return {ErrorCode::stale_id, std::string(type) + " {" + std::to_string(id.index) + ", " +
                                     std::to_string(id.generation) +
                                     "} is of an object that was removed, or of another World"};
}

/// The particles of mesh vertices. Error: one that the mesh does not have.
[[nodiscard]] Result<std::vector<std::uint32_t>> particles_of(const Cloth& cloth,
                                                              std::span<const std::uint32_t> vertices);

}  // namespace weft
