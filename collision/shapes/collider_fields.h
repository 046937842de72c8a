#pragma once
// Fields of colliders and their shapes (engine/fields.h).

#include <limits>

#include "collision/shapes/triangles/ranges.h"
#include "engine/fields.h"
#include "weft/collider.h"

namespace weft {

inline constexpr Range place_range{-farthest_collider, farthest_collider, Ends::closed,
                                   "from -1e5 to 1e5 m on each axis"};
inline constexpr Range radius_range{1e-6f, farthest_collider, Ends::closed, "from 1e-6 to 1e5 m"};
/// A normal's components; validate(Collider) checks its length.
inline constexpr Range normal_range{std::numeric_limits<float>::lowest(), std::numeric_limits<float>::max(),
                                    Ends::closed, "finite and of a length from 1e-12 to 1e12"};

WEFT_FIELDS_OF(Sphere) {
    WEFT_FIELD(center, place_range);
    WEFT_FIELD(radius, radius_range);
}
WEFT_FIELDS_OF(Capsule) {
    WEFT_FIELD(a, place_range);
    WEFT_FIELD(b, place_range);
    WEFT_FIELD(radius, radius_range);
}
WEFT_FIELDS_OF(TaperedCapsule) {
    WEFT_FIELD(a, place_range);
    WEFT_FIELD(b, place_range);
    WEFT_FIELD(radius_a, radius_range);
    WEFT_FIELD(radius_b, radius_range);
}
WEFT_FIELDS_OF(Box) {
    WEFT_FIELD(center, place_range);
    WEFT_FIELD(rotation);
    WEFT_FIELD(half_extents, 1e-6f, farthest_collider, Ends::closed, "from 1e-6 to 1e5 m on each axis");
}
WEFT_FIELDS_OF(Plane) {
    WEFT_FIELD(normal, normal_range);
    WEFT_FIELD(offset, -farthest_collider, farthest_collider, Ends::closed, "from -1e5 to 1e5 m");
}
WEFT_FIELDS_OF(PlacedShape) {
    WEFT_FIELD(shape);
    WEFT_FIELD(position, place_range);
    WEFT_FIELD(rotation);
}
WEFT_FIELDS_OF(Collider) {
    WEFT_FIELD(shape);
    WEFT_FIELD(friction, 0, 1e6f, Ends::closed, "from 0 to 1e6");
    WEFT_FIELD(thickness, 0, 10, Ends::closed, "from 0 to 10 m");
    WEFT_FIELD(restitution, 0, 1);
    WEFT_FIELD(layers);
    WEFT_FIELD(is_trigger);
}

}  // namespace weft
