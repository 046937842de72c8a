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

/// The air's force on each particle, and its slope in w: a third of that on each of its triangles.
/// `air_velocities`: as sampled, or empty where the mean wind blows everywhere. `triangle_scratch`: one a
/// triangle.
void compute_air_forces(Parallel& parallel, const CookedCloth& model, const ClothState& state,
                        const Wind& wind, std::span<const Vec4> air_velocities,
                        std::span<Vec4> triangle_scratch, std::span<Vec4> particle_forces);

}  // namespace weft
