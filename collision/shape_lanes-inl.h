// Shapes of colliders in registers, and where a path first meets one. Included as engine/simd/lanes-inl.h is.

#if defined(WEFT_COLLISION_SHAPE_LANES_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef WEFT_COLLISION_SHAPE_LANES_INL_H
#undef WEFT_COLLISION_SHAPE_LANES_INL_H
#else
#define WEFT_COLLISION_SHAPE_LANES_INL_H
#endif

#include "collision/collider_kernels.h"
#include "engine/simd/lanes-inl.h"

HWY_BEFORE_NAMESPACE();
namespace weft::HWY_NAMESPACE {

HWY_INLINE Lanes3 set3(const Vector3& v) {
    return {set(v.x()), set(v.y()), set(v.z())};
}
HWY_INLINE Lanes3 set3(const Vec3& v) {
    return {set(v.x), set(v.y), set(v.z)};
}
HWY_INLINE Lanes3 set3(const Vec4& v) {
    return {set(v.x), set(v.y), set(v.z)};
}
HWY_INLINE Lanes4 with_w(const Lanes3& v, Lanes w) {
    return {v.x, v.y, v.z, w};
}
HWY_INLINE Lanes3 turned(const Matrix3& turn, const Lanes3& v) {
    const auto row = [&](int i) { return dot(set3(Vector3(turn.row(i))), v); };
    return {row(0), row(1), row(2)};
}
template <class Mask>
HWY_INLINE Lanes4 either(Mask mask, const Lanes4& yes, const Lanes4& no) {
    return with_w(either(mask, xyz(yes), xyz(no)), hn::IfThenElse(mask, yes.w, no.w));
}

/// Where the surface is nearest, lane by lane.
template <class Mask>
struct SurfaceLanes {
    Mask is_near;
    Lanes penetration;  // into what lies nearer than the thickness [m]
    Lanes3 normal;      // of unit length, outward
    Lanes3 velocity;    // [m/s]
};

// Shapes answer, for points p, whether any is near, and then where the surface is. Comparisons are such that
// what is not a number is near nothing.

struct CapsuleLanes {
    static constexpr bool is_swept = true;
    const MovingCapsule& shape;
    Lanes thickness, reach_squared;

    CapsuleLanes(const MovingCapsule& shape, float thickness)
        : shape(shape),
          thickness(set(thickness)),
          reach_squared(set((shape.radius + thickness) * (shape.radius + thickness))) {}

    /// Fraction of the way from a to b of the axis point nearest to p.
    [[nodiscard]] HWY_INLINE Lanes along(const Lanes3& from_a) const {
        const Lanes t = hn::Mul(dot(from_a, set3(shape.axis)), set(shape.per_length_squared));
        return hn::Min(hn::Max(t, set(0)), set(1));
    }
    /// Where a point at the substep's start is if the capsule takes it along: no nearer, and no farther.
    [[nodiscard]] HWY_INLINE Lanes3 carried(const Lanes3& p) const {
        const Lanes3 from_a = p - set3(shape.start_a);
        const Lanes t = hn::Mul(dot(from_a, set3(shape.start_axis)), set(shape.per_start_length_squared));
        const Lanes s = hn::Min(hn::Max(t, set(0)), set(1));
        const Lanes3 out = turned(shape.turn, from_a - s * set3(shape.start_axis));
        const Lanes length = hn::Max(hn::Sqrt(dot(out, out)), set(1e-6f * shape.radius));
        const Lanes wider = hn::Add(set(1), hn::Div(set(shape.radius - shape.start_radius), length));
        return set3(shape.a) + (s * set3(shape.axis) + wider * out);
    }
    [[nodiscard]] HWY_INLINE auto near(const Lanes3& p) const {
        const Lanes3 from_a = p - set3(shape.a);
        const Lanes3 out = from_a - along(from_a) * set3(shape.axis);
        return hn::Lt(dot(out, out), reach_squared);
    }
    template <class Mask>
    [[nodiscard]] HWY_INLINE SurfaceLanes<Mask> surface(const Lanes3& p, Mask is_near) const {
        const Lanes3 from_a = p - set3(shape.a);
        const Lanes t = along(from_a);
        const Lanes3 out = from_a - t * set3(shape.axis);
        const Lanes length = hn::Sqrt(dot(out, out));
        const Lanes penetration = hn::Sub(thickness, hn::Sub(length, set(shape.radius)));
        const Lanes3 normal = either(hn::Gt(length, set(1e-6f * shape.radius)), hn::Div(set(1), length) * out,
                                     set3(shape.across));
        const Lanes3 of_axis = mul_add(t, set3(shape.difference), set3(shape.velocity));
        return {hn::And(is_near, hn::Gt(penetration, set(0))), penetration, normal,
                mul_add(set(shape.growth), normal, of_axis)};
    }
};

struct PlaneLanes {
    static constexpr bool is_swept = false;  // whoever passes it is inside
    const MovingPlane& shape;
    Lanes thickness;

    PlaneLanes(const MovingPlane& shape, float thickness) : shape(shape), thickness(set(thickness)) {}

    [[nodiscard]] HWY_INLINE Lanes distance(const Lanes3& p) const {
        return hn::Sub(dot(set3(shape.normal), p), set(shape.offset));
    }
    [[nodiscard]] HWY_INLINE auto near(const Lanes3& p) const { return hn::Lt(distance(p), thickness); }
    template <class Mask>
    [[nodiscard]] HWY_INLINE SurfaceLanes<Mask> surface(const Lanes3& p, Mask is_near) const {
        const Lanes3 normal = set3(shape.normal);
        const Lanes turning = hn::Sub(set(shape.advance), dot(set3(shape.turn), p));
        const Lanes speed = hn::Min(hn::Max(turning, set(-shape.fastest)), set(shape.fastest));
        return {is_near, hn::Sub(thickness, distance(p)), normal, speed * normal};
    }
};

/// How far apart a block's particles are from what a shape meets in the thickness, and how thin it is.
struct Sweep {
    float beyond;  ///< what the shape's thickness is more than that of cloth and collider [m]
    float thin;    ///< see thin_part() [m]
};

/// Where paths first come nearer than the thickness, if they end beyond the plane of contact there: the shape
/// takes this plane along to the substep's end, so that what passed it meets it. Else `at_end`. Paths are
/// straight for who moves along with the shape, so where one substep's ends, the next one's begins, and
/// nothing slips through between the two. Conservative advancement (Mirtich 1996), a distance at a time as in
/// sphere tracing (Hart 1996).
template <class Shape, class Mask>
HWY_INLINE SurfaceLanes<Mask> first_met(const Shape& shape, const Sweep& sweep, const Lanes3& start,
                                        const Lanes3& end, Mask may_meet, const SurfaceLanes<Mask>& at_end) {
    constexpr int most_steps = 32;  // past a round body none takes more
    const Tag d;
    const Lanes3 from = shape.carried(start), way = end - from;
    const Lanes squared = dot(way, way), beyond = set(sweep.beyond);
    auto traced = hn::And(may_meet, hn::Gt(squared, set(sweep.thin * sweep.thin)));
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
        t = hn::MulAdd(hn::Max(clear, near), per_length, t);
        // From a convex shape what draws away does not come back.
        traced = hn::And(hn::AndNot(touches, traced), hn::Lt(t, set(1)));
    }
    if (hn::AllFalse(d, met)) return at_end;
    auto surface = shape.surface(contact, met);
    surface.penetration = hn::Sub(surface.penetration, dot(surface.normal, end - contact));
    const auto passed = hn::And(met, hn::Gt(surface.penetration, beyond));
    return {hn::Or(passed, at_end.is_near), hn::IfThenElse(passed, surface.penetration, at_end.penetration),
            either(passed, surface.normal, at_end.normal), either(passed, surface.velocity, at_end.velocity)};
}

}  // namespace weft::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
