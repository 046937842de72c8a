#pragma once
// What calls of the public World share.

#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "cloth/frame/simulation.h"
#include "engine/without_exceptions.h"
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

/// The particle of a mesh vertex.
inline Result<std::uint32_t> particle_of(const Cloth& cloth, std::uint32_t vertex) {
    const auto& map = cloth.model.vertex_to_particle;
    if (vertex >= map.size()) {
        return Error{ErrorCode::invalid_argument, "vertex " + std::to_string(vertex) +
                                                      " does not exist; the mesh has " +
                                                      std::to_string(map.size())};
    }
    return map[vertex];
}

/// The particles of mesh vertices. Error: one that the mesh does not have.
[[nodiscard]] Result<std::vector<std::uint32_t>> particles_of(const Cloth& cloth,
                                                              std::span<const std::uint32_t> vertices);

/// Error: no rotation, or a place that is not finite.
[[nodiscard]] Result<void> validate_transform(const char* name, const Transform& pose);
/// Error: something of the cloth would be out of reach once it is moved so.
[[nodiscard]] Result<void> validate_move(const Cloth& cloth, const RigidMotion& by);

/// Calls `use` with the cloth of an id and returns its result, or says that the id is stale.
template <class Simulation, class Use>
auto with_cloth(Simulation& simulation, ClothId id, const Use& use)
    -> decltype(use(**simulation.cloths.find(id))) {
    return without_exceptions([&]() -> decltype(use(**simulation.cloths.find(id))) {
        auto* slot = simulation.cloths.find(id);
        if (slot == nullptr) return stale_id("ClothId", id);
        return use(**slot);
    });
}

}  // namespace weft
