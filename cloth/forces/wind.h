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

/// The air's velocity at each particle [m/s].
void sample_wind(Parallel& parallel, const ClothState& state, const WindField& field,
                 std::span<Vec4> air_velocities);

/// A third of each triangle's air force, for each of its corners, and of its slope in w. `air_velocities`: as
/// sampled, or empty where the mean wind blows everywhere.
void compute_air_forces(Parallel& parallel, const CookedCloth& model, const ClothState& state,
                        const Wind& wind, std::span<const Vec4> air_velocities,
                        std::span<Vec4> triangle_forces);

}  // namespace weft
