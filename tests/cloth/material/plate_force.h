#pragma once
// The force of air on one triangle, as the formula is written: the reference of the kernels.

#include <cmath>

#include "engine/vector.h"
#include "weft/settings.h"

namespace weft::test {

/// Force of air that streams past a flat plate at the air's velocity minus the plate's [m/s].
struct PlateForce {
    Vector3 force;  ///< [N]
    float slope;    ///< [N s/m], at least the force's largest rate of change with the plate's velocity
};

/// `area_normal`: normal times area [m^2], of either sign. See cloth/air/wind.cpp.
inline PlateForce plate_force(const Vector3& u, const Vector3& area_normal, const Wind& wind) {
    const float speed = u.norm();
    const float area = area_normal.norm();
    if (speed < 1e-6f || area < 1e-12f) return {Vector3::Zero(), 0};

    const float through = u.dot(area_normal) / area;  // u.n, signed
    const Vector3 n = std::copysign(1.0f, through) / area * area_normal;
    const float facing = std::abs(through);
    const float pressure = 0.5f * wind.air_density * area * facing;
    const Vector3 force = pressure * ((wind.drag - wind.lift * facing / speed) * u + wind.lift * speed * n);
    return {force, wind.air_density * area * speed * (wind.drag + wind.lift)};
}

}  // namespace weft::test
