#pragma once
// All that changes from step to step in a World, in one order: what is hashed, and what is saved.

#include <cstdint>
#include <memory>
#include <span>

#include "cloth/simulation/simulation.h"
#include "cloth/store/save_format.h"

namespace weft {

/// Of a shape: what deforming changed.
template <class Visit>
void for_each_part(const HeldShape& shape, const Visit& visit) {
    const HeldShape::Deformation deformation = shape.deformation();
    if (deformation.vertices.empty()) return;
    visit(deformation.vertices);
    visit(deformation.displacements);
    visit(std::span(&deformation.step, 1));
}

/// visit(span) for each part, and visit.head(head) for what says which parts of a shape or a cloth there are.
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
