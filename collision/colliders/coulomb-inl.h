// Coulomb's law, as contacts of all kinds apply it. Included as engine/simd/lanes-inl.h is.

#if defined(WEFT_COLLISION_COLLIDERS_COULOMB_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef WEFT_COLLISION_COLLIDERS_COULOMB_INL_H
#undef WEFT_COLLISION_COLLIDERS_COULOMB_INL_H
#else
#define WEFT_COLLISION_COLLIDERS_COULOMB_INL_H
#endif

#include "engine/simd/lanes-inl.h"

HWY_BEFORE_NAMESPACE();
namespace weft::HWY_NAMESPACE {

/// The part that friction removes from a velocity along a contact: all of it, or as much as `limit`, the
/// friction coefficient times the normal velocity that the contact took away [m/s].
HWY_INLINE Lanes3 stopped_by_friction(const Lanes3& sliding, Lanes limit) {
    const Lanes speed = hn::Sqrt(dot(sliding, sliding));
    const auto slides_on = hn::Gt(speed, limit);
    return hn::IfThenElse(slides_on, hn::Div(limit, speed), set(1)) * sliding;
}

}  // namespace weft::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
