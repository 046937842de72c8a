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

/// Visits a cloth's head and state.
template <class Visit>
void for_each_cloth_part(const Cloth& cloth, const Visit& visit) {
    visit.head(ClothHead(cloth.state, cloth.model.fingerprint, cloth.settings.key));
    for_each_part(cloth.state, visit);
}

/// Visits all that a save has before its cloths.
template <class Visit>
void for_each_part_before_cloths(const Simulation& simulation, const Visit& visit) {
    for_each_part(simulation.state, visit);
    simulation.shapes.for_each([&](ShapeId, const std::unique_ptr<HeldShape>& shape) {
        visit.head(ShapeHead(*shape));
        for_each_part(*shape, visit);
    });
}

/// Calls visit(span) for each part, and visit.head(head) before the parts of each shape and each cloth, whose
/// sizes the head states.
template <class Visit>
void for_each_part(const Simulation& simulation, const Visit& visit) {
    for_each_part_before_cloths(simulation, visit);
    simulation.cloths.for_each(
        [&](ClothId, const std::unique_ptr<Cloth>& cloth) { for_each_cloth_part(*cloth, visit); });
}

}  // namespace weft
