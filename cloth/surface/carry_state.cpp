// The state of a cloth, carried to another mesh of the same garment.

#include <string>
#include <vector>

#include "cloth/surface/drawn_bonds.h"
#include "engine/memory/without_exceptions.h"
#include "engine/vector.h"

namespace weft {

namespace {

std::vector<Vec3> places_of(const DrawnMesh& bonds, const ClothView& cloth) {
    std::vector<Vec4> written(bonds.size());
    bonds.update(cloth, {.positions = written});
    std::vector<Vec3> places;
    for (const Vec4& p : written) places.push_back({p.x, p.y, p.z});
    return places;
}

}  // namespace

Result<void> carry_state(World& world, ClothId from, ClothId to, const DrawnMesh& bonds) {
    return without_exceptions([&]() -> Result<void> {
        const auto old = world.cloth(from);
        if (!old) return old.error();
        const auto next = world.cloth(to);
        if (!next) return next.error();
        if (bonds.bonds_->mesh != BoundMesh(*old))
            return Error{ErrorCode::invalid_argument,
                         "the bonds are to another mesh than that of the cloth `from`: bind them to it"};
        if (bonds.size() != next->vertex_to_particle.size())
            return Error{ErrorCode::invalid_argument, "the bonds are of " + std::to_string(bonds.size()) +
                                                          " vertices; the mesh of the cloth `to` has " +
                                                          std::to_string(next->vertex_to_particle.size())};
        ClothView before = *old;
        before.positions = old->previous_positions;
        std::vector<Vec3> velocities;
        for (const DrawnBond& bond : bonds.bonds()) {
            const auto velocity = [&](std::size_t c) { return xyz(old->velocities[bond.particles[c]]); };
            velocities.push_back(to_vec3((1 - bond.second - bond.third) * velocity(0) +
                                         bond.second * velocity(1) + bond.third * velocity(2)));
        }
        return world.resume_cloth(to, places_of(bonds, *old), places_of(bonds, before), velocities);
    });
}

}  // namespace weft
