#pragma once
// Shapes that cloth collides with.

#include <cstdint>
#include <variant>

#include "weft/types.h"

namespace weft {

struct Sphere {
    Vec3 center{};        ///< [m]
    float radius = 0.1f;  ///< [m], > 0
};

/// All points within `radius` of the segment a b.
struct Capsule {
    Vec3 a{}, b{};        ///< [m]; a == b is a sphere
    float radius = 0.1f;  ///< [m], > 0
};

/// The half space normal . p <= offset is solid.
struct Plane {
    Vec3 normal{0, 1, 0};  ///< need not be of unit length; must not be zero
    float offset = 0;      ///< [m], along the unit normal
};

struct Collider {
    std::variant<Sphere, Capsule, Plane> shape{};
    float friction = 0.4f;  ///< Coulomb coefficient, >= 0; multiplied by the cloth's own
};

/// Generation-checked; all-zero is null.
struct ColliderId {
    std::uint32_t index = 0, generation = 0;
    friend bool operator==(ColliderId, ColliderId) = default;
};

}  // namespace weft
