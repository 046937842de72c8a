// Where a path first meets a shape. Included as engine/simd/lanes-inl.h is.

#if defined(WEFT_COLLISION_SHAPES_FIRST_MET_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef WEFT_COLLISION_SHAPES_FIRST_MET_INL_H
#undef WEFT_COLLISION_SHAPES_FIRST_MET_INL_H
#else
#define WEFT_COLLISION_SHAPES_FIRST_MET_INL_H
#endif

#include "collision/shapes/round_lanes-inl.h"

HWY_BEFORE_NAMESPACE();
namespace weft::HWY_NAMESPACE {

/// How far apart a block's particles are from what a shape meets in the thickness, and how thin it is.
struct Sweep {
    float beyond;  ///< what the shape's thickness is more than that of cloth and collider [m]
    float thin;    ///< see thin_part() [m]
};

/// Of a shape that may be as thin as nothing. Who goes no farther than twice the thickness, which is four
/// times `thin`, and passes something, ends near it; and where it came through the plane of the surface that
/// is nearest there, from outside, it did not come through another. Who goes farther passes nothing where the
/// end is clear by as much.
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

/// Where paths first come nearer than the thickness, if they end beyond the plane of contact there: the shape
/// takes this plane along to the substep's end, so that what passed it meets it. Else `at_end`. Paths are
/// straight for who moves along with the shape, so where one substep's ends, the next one's begins, and
/// nothing slips through between the two. Conservative advancement (Mirtich 1996), a distance at a time as in
/// sphere tracing (Hart 1996).
template <class Shape, class Mask>
HWY_INLINE SurfaceLanes<Mask> first_met(const Shape& shape, const Sweep& sweep, const Lanes3& start,
                                        const Lanes3& end, Mask may_meet, const SurfaceLanes<Mask>& at_end) {
    const bool convex = shape.convex();
    const int most_steps = convex ? 32 : 64;  // past a round body none takes more than 32
    const Tag d;
    const Lanes3 from = shape.carried(start), way = end - from;
    const Lanes squared = dot(way, way), beyond = set(sweep.beyond);
    auto traced = hn::And(may_meet, hn::Gt(squared, set(sweep.thin * sweep.thin)));
    if (hn::AllFalse(d, traced)) return at_end;
    if (!convex) traced = hn::And(traced, may_have_passed(sweep, way, squared, at_end));
    if (hn::AllFalse(d, traced)) return at_end;

    const Lanes per_length = hn::Div(set(1), hn::Sqrt(squared)), near = set(0.05f * sweep.thin);
    auto met = hn::Lt(squared, set(0));
    Lanes t = set(0);
    Lanes3 contact = end;
    for (int step = 0; step < most_steps && !hn::AllFalse(d, traced); ++step) {
        const Lanes3 p = mul_add(t, way, from);
        const auto surface = shape.surface(p, traced);
        const Lanes clear = hn::Sub(beyond, surface.penetration);
        // What begins inside is no path to here: the surface that is nearest at the end puts it out.
        if (step == 0) traced = hn::And(traced, hn::Gt(clear, set(-sweep.thin)));
        const auto touches = hn::And(traced, hn::Lt(clear, near));
        const auto meets = hn::And(touches, hn::Lt(dot(surface.normal, way), set(0)));
        contact = either(meets, p, contact);
        met = hn::Or(met, meets);
        Lanes free = hn::Max(clear, near);
        if (Shape::has_faces && convex) {
            // All of it lies behind the plane that it shows to p, which a path along a face reaches late.
            const Lanes approach = hn::Neg(hn::Mul(dot(surface.normal, way), per_length));
            traced = hn::And(traced, hn::Gt(approach, set(0)));
            free = hn::Max(free, hn::Div(clear, approach));
        }
        t = hn::MulAdd(free, per_length, t);
        // From a convex shape what draws away does not come back.
        traced = hn::And(hn::AndNot(convex ? touches : meets, traced), hn::Lt(t, set(1)));
    }
    if (hn::AllFalse(d, met)) return at_end;
    auto surface = shape.surface(contact, met);
    surface.penetration = hn::Sub(surface.penetration, dot(surface.normal, end - contact));
    auto passed = hn::And(met, hn::Gt(surface.penetration, beyond));
    // Round a corner that is dented it may end deeper in what it did not meet first.
    const auto deeper = hn::Gt(surface.penetration, at_end.penetration);
    if (!convex) passed = hn::And(passed, hn::Or(hn::Not(at_end.is_near), deeper));
    return {hn::Or(passed, at_end.is_near), hn::IfThenElse(passed, surface.penetration, at_end.penetration),
            either(passed, surface.normal, at_end.normal), either(passed, surface.velocity, at_end.velocity)};
}

}  // namespace weft::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
