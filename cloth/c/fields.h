#pragma once
// Structs for C and their counterparts for C++. fields(way, c, of) lets a way assign each field of one to the
// same field of the other. settings/fields.h lists them; only what has another name for C stands here.

#include <concepts>
#include <type_traits>

#include "cloth/settings/fields.h"
#include "weft/c/reports.h"
#include "weft/c/settings.h"
#include "weft/weft.h"

namespace weft {

WEFT_FIELDS_OF(SheetSettings) {
    WEFT_FIELD(rows);
    WEFT_FIELD(columns);
    WEFT_FIELD(origin);
    WEFT_FIELD(u);
    WEFT_FIELD(v);
}
WEFT_FIELDS_OF(ProxySettings) {
    WEFT_FIELD(particles);
    WEFT_FIELD(thickness);
}
WEFT_FIELDS_OF(DrawnMeshSettings) {
    WEFT_FIELD(rounding);
    WEFT_FIELD(reach);
}
WEFT_FIELDS_OF(FixedStepSettings) {
    WEFT_FIELD(step);
    WEFT_FIELD(max_steps_per_frame);
}

}  // namespace weft

namespace weft::c {

template <class Way, class C, class Of>
void fields(const Way& way, C& c, Of& of) {
    using Struct = std::remove_const_t<Of>;
    if constexpr (std::same_as<Struct, TaperedCapsule>) {
        way(c.a, of.a);
        way(c.b, of.b);
        way(c.radius, of.radius_a);
        way(c.radius_b, of.radius_b);
    } else if constexpr (std::same_as<Struct, PlacedShape>) {
        way(c.shape, of.shape);
        way(c.center, of.position);
        way(c.rotation, of.rotation);
    } else if constexpr (std::same_as<Struct, Collider>) {
        way.variant(c, c.kind, of.shape);
        way(c.friction, of.friction);
        way(c.thickness, of.thickness);
        way(c.restitution, of.restitution);
        way(c.layers, of.layers);
        way(c.is_trigger, of.is_trigger);
    } else {
        for_both(c, of, [&](const char* /*name*/, auto& in_c, auto& in_of, const auto&... /*range*/) {
            way(in_c, in_of);
        });
    }
}

}  // namespace weft::c
