#pragma once
// The energy of a cloth of springs, in double precision.

#include "cloth/instance/cloth.h"

namespace weft::study {

struct Energy {
    double kinetic = 0, elastic = 0, gravity = 0;  ///< [J]; gravity's is 0 at y = 0
    [[nodiscard]] double total() const { return kinetic + elastic + gravity; }
};

[[nodiscard]] Energy energy_of(const Cloth& cloth, const Vec3& gravity);

}  // namespace weft::study
