#pragma once
// Air forces on triangles.

#include <span>

#include "cloth/cook.h"
#include "cloth/forces/gusts.h"
#include "cloth/state.h"
#include "engine/parallel_blocks.h"
#include "weft/settings.h"

namespace weft {

/// Force of air that streams past a flat plate at `relative_velocity`, the air's minus the plate's [m/s].
/// `area_normal`: normal times area [m^2], of either sign.
struct PlateForce {
    Vector3 force;  ///< [N]
    float slope;    ///< [N s/m], at least the force's largest rate of change with the plate's velocity
};
[[nodiscard]] PlateForce plate_force(const Vector3& relative_velocity, const Vector3& area_normal,
                                     const Wind& wind);

/// A third of each triangle's air force, for each of its corners, and of its slope in w.
void compute_air_forces(Parallel& parallel, const CookedCloth& model, const ClothState& state,
                        const Wind& wind, const WindField& field, std::span<Vec4> triangle_forces);

}  // namespace weft
