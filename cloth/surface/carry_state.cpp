// The state of a cloth, carried to another mesh of the same garment.

#include <string>
#include <vector>

#include "cloth/surface/drawn_bonds.h"
#include "cloth/surface/surface_state.h"
#include "engine/memory/without_exceptions.h"
#include "engine/vector.h"

namespace weft {

void SurfaceState::reserve(std::size_t vertices) {
    drawn.reserve(vertices);
    for (std::vector<Vec3>* list : {&positions, &previous_positions, &velocities}) list->reserve(vertices);
}

void SurfaceState::carry(const ClothView& from, const DrawnMesh& bonds) {
    ClothView before = from;
    before.positions = from.previous_positions;
    drawn.resize(bonds.size());
    const auto write = [&](const ClothView& cloth, std::vector<Vec3>& to) {
        bonds.update(cloth, {.positions = drawn});
        to.clear();
        for (const Vec4& p : drawn) to.push_back({p.x, p.y, p.z});
    };
    write(from, positions);
    write(before, previous_positions);
    velocities.clear();
    for (const DrawnBond& bond : bonds.bonds())
        velocities.push_back(to_vec3(interpolated(bond, from.velocities)));
}

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
        SurfaceState carried;
        carried.carry(*old, bonds);
        return world.resume_cloth(to, carried.positions, carried.previous_positions, carried.velocities);
    });
}

}  // namespace weft
