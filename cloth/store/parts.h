#pragma once
// Visits all state of a World that changes from step to step, in one fixed order, for hashes and saves.

#include <cstdint>
#include <memory>
#include <span>

#include "cloth/simulation/simulation.h"
#include "cloth/store/save_format.h"

namespace weft {

/// Visits a shape's deformation; nothing of a shape that was not deformed.
template <class Visit>
void for_each_part(const HeldShape& shape, const Visit& visit) {
    const HeldShape::Deformation deformation = shape.deformation();
    if (deformation.vertices.empty()) return;
    visit(deformation.vertices);
    visit(deformation.displacements);
    visit(std::span(&deformation.step, 1));
}

/// Calls visit(span) for each part, and visit.head(head) before the parts of each shape and each cloth, whose
/// sizes the head states.
template <class Visit>
void for_each_part(const Simulation& simulation, const Visit& visit) {
    for_each_part(simulation.state, visit);
    simulation.shapes.for_each([&](ShapeId, const std::unique_ptr<HeldShape>& shape) {
        visit.head(ShapeHead(*shape));
        for_each_part(*shape, visit);
    });
    simulation.cloths.for_each([&](ClothId, const std::unique_ptr<Cloth>& cloth) {
        visit.head(ClothHead(cloth->state, cloth->model.fingerprint));
        for_each_part(std::as_const(cloth->state), visit);
    });
}

}  // namespace weft
