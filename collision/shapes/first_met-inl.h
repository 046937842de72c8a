// Continuous collision: where a path first meets a shape. Included as engine/simd/lanes-inl.h is.

#if defined(WEFT_COLLISION_SHAPES_FIRST_MET_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef WEFT_COLLISION_SHAPES_FIRST_MET_INL_H
#undef WEFT_COLLISION_SHAPES_FIRST_MET_INL_H
#else
#define WEFT_COLLISION_SHAPES_FIRST_MET_INL_H
#endif

#include "collision/shapes/round_lanes-inl.h"

HWY_BEFORE_NAMESPACE();
namespace weft::HWY_NAMESPACE {

/// Margins of a sweep of a block's particles.
struct Sweep {
    float beyond;  ///< the shape's thickness less that of cloth and collider [m]
    float thin;    ///< see Sweeping [m]
};

/// Whether a path may have passed a shape that may have no thickness. A path of at most twice the thickness
/// (4 thin) that passes something ends near it; if it began in front of the plane of the surface nearest to
/// its end, it passed no other. A longer path passed nothing if its end is farther away than it is long.
template <class Mask>
HWY_INLINE Mask may_have_passed(const Sweep& sweep, const Lanes3& way, Lanes squared,
                                const SurfaceLanes<Mask>& at_end) {
    const Lanes clear = hn::Sub(set(sweep.beyond), at_end.penetration);
    const Lanes began = hn::Sub(clear, dot(at_end.normal, way));  // from the plane, less the thickness
    const auto from_behind = hn::And(at_end.is_near, hn::Lt(began, set(-2.5f * sweep.thin)));
    const auto is_far = hn::Gt(squared, set(16 * sweep.thin * sweep.thin));
    const auto is_within = hn::Or(hn::Lt(clear, set(0)), hn::Lt(hn::Mul(clear, clear), squared));
    return hn::Or(from_behind, hn::And(is_far, is_within));
}

/// Whether a path stays outside of a convex shape with faces: both of its ends are in front of the plane of
/// the surface nearest to its end. That plane, not the one of first contact, then keeps the particle away: by
/// the latter a plate would hold the cloth that is pulled from under its rim.
template <class Shape, class Mask>
HWY_INLINE Mask stayed_outside(const Shape& shape, const Lanes3& way, const Lanes3& end, Mask asked) {
    const auto nearest = shape.surface(end, asked);
    const Lanes at_end = hn::Sub(shape.thickness, nearest.penetration);
    const Lanes at_start = hn::Sub(at_end, dot(nearest.normal, way));
    return hn::Gt(hn::Min(at_start, at_end), set(0));
}

/// The surface at which a path first comes nearer than the thickness, if the path ends beyond the contact
/// plane there; otherwise `at_end`. The shape moves this plane along to the substep's end. Paths are straight
/// in the shape's moving frame, so each substep's path begins where the last one's ended, and nothing slips
/// through between the two. Conservative advancement (Mirtich 1996), a distance at a time as in sphere
/// tracing (Hart 1996).
template <class Shape, class Mask>
HWY_INLINE SurfaceLanes<Mask> first_met(const Shape& shape, const Sweep& sweep, const Lanes3& start,
                                        const Lanes3& end, Mask may_meet, const SurfaceLanes<Mask>& at_end) {
    const bool convex = shape.convex();
    const int most_steps = convex ? 32 : 64;  // a path past a round body takes at most 32
    const Tag d;
    const Lanes3 from = shape.carried(start), way = end - from;
    const Lanes squared = dot(way, way), beyond = set(sweep.beyond);
    auto traced = hn::And(may_meet, hn::Gt(squared, set(sweep.thin * sweep.thin)));
    if (hn::AllFalse(d, traced)) return at_end;
    if (!convex)
        traced = hn::And(traced, may_have_passed(sweep, way, squared, at_end));
    else if (Shape::has_faces)
        traced = hn::AndNot(stayed_outside(shape, way, end, traced), traced);
    if (hn::AllFalse(d, traced)) return at_end;

    const Lanes per_length = hn::Div(set(1), hn::Sqrt(squared)), near = set(0.05f * sweep.thin);
    auto met = hn::Lt(squared, set(0));
    Lanes t = set(0);
    Lanes3 contact = end;
    for (int step = 0; step < most_steps && !hn::AllFalse(d, traced); ++step) {
        const Lanes3 p = mul_add(t, way, from);
        const auto surface = shape.surface(p, traced);
        const Lanes clear = hn::Sub(beyond, surface.penetration);
        // A path that begins inside is not traced: the surface nearest to its end pushes the particle out.
        if (step == 0) traced = hn::And(traced, hn::Gt(clear, set(-sweep.thin)));
        const auto touches = hn::And(traced, hn::Lt(clear, near));
        const auto meets = hn::And(touches, hn::Lt(dot(surface.normal, way), set(0)));
        contact = either(meets, p, contact);
        met = hn::Or(met, meets);
        Lanes free = hn::Max(clear, near);
        if (Shape::has_faces && convex) {
            // A convex body lies behind its tangent plane nearest to p, which a path along a face reaches
            // late.
            const Lanes approach = hn::Neg(hn::Mul(dot(surface.normal, way), per_length));
            traced = hn::And(traced, hn::Gt(approach, set(0)));
            free = hn::Max(free, hn::Div(clear, approach));
        }
        t = hn::MulAdd(free, per_length, t);
        // A path that moves away from a convex shape does not return.
        traced = hn::And(hn::AndNot(convex ? touches : meets, traced), hn::Lt(t, set(1)));
    }
    if (hn::AllFalse(d, met)) return at_end;
    auto surface = shape.surface(contact, met);
    surface.penetration = hn::Sub(surface.penetration, dot(surface.normal, end - contact));
    auto passed = hn::And(met, hn::Gt(surface.penetration, beyond));
    // Round a concave corner a path may end deeper in a surface that it did not meet first.
    const auto deeper = hn::Gt(surface.penetration, at_end.penetration);
    if (!convex) passed = hn::And(passed, hn::Or(hn::Not(at_end.is_near), deeper));
    return {hn::Or(passed, at_end.is_near), hn::IfThenElse(passed, surface.penetration, at_end.penetration),
            either(passed, surface.normal, at_end.normal), either(passed, surface.velocity, at_end.velocity)};
}

}  // namespace weft::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
