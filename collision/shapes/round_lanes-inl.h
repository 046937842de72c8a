// Round shapes and planes in registers. Included as engine/simd/lanes-inl.h is.

#if defined(WEFT_COLLISION_SHAPES_ROUND_LANES_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef WEFT_COLLISION_SHAPES_ROUND_LANES_INL_H
#undef WEFT_COLLISION_SHAPES_ROUND_LANES_INL_H
#else
#define WEFT_COLLISION_SHAPES_ROUND_LANES_INL_H
#endif

#include <type_traits>

#include "collision/shapes/moving_shapes.h"
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

/// The nearest surface, lane by lane.
template <class Mask>
struct SurfaceLanes {
    Mask is_near;
    Lanes penetration;  // thickness less distance [m]
    Lanes3 normal;      // of unit length, outward
    Lanes3 velocity;    // [m/s]
};

// Each shape computes for points p near(), a conservative test, and surface(). Comparisons are such that a
// point that is not a number is near nothing.

/// Moving: a MovingCapsule or a MovingTaperedCapsule.
template <class Moving>
struct RoundLanes {
    static constexpr bool is_swept = true, has_faces = false;
    static constexpr bool is_tapered = std::is_same_v<Moving, MovingTaperedCapsule>;
    const Moving& shape;
    Lanes thickness, reach_squared;

    RoundLanes(const Moving& moving, float total_thickness)
        : shape(moving),
          thickness(set(total_thickness)),
          reach_squared(set((moving.radius + total_thickness) * (moving.radius + total_thickness))) {}

    [[nodiscard]] static constexpr bool convex() { return true; }
    /// Fraction of the axis, from a to b, at which the ball nearest to p = a + from_a is centred.
    [[nodiscard]] HWY_INLINE Lanes along(const Lanes3& from_a) const {
        const Lanes t = hn::Mul(dot(from_a, set3(shape.axis)), set(shape.per_length_squared));
        if constexpr (is_tapered) {
            const Lanes3 out = from_a - t * set3(shape.axis);
            const Lanes tilted = hn::MulAdd(set(shape.tilt), hn::Sqrt(dot(out, out)), t);
            return hn::Min(hn::Max(tilted, set(shape.first)), set(shape.last));
        } else {
            return hn::Min(hn::Max(t, set(0)), set(1));
        }
    }
    [[nodiscard]] HWY_INLINE Lanes radius(Lanes t) const {
        if constexpr (is_tapered)
            return hn::MulAdd(t, set(shape.wider), set(shape.radius));
        else
            return set(shape.radius);
    }
    /// Place of a start's point that moves along with the shape, at an unchanged distance from its surface.
    [[nodiscard]] HWY_INLINE Lanes3 carried(const Lanes3& p) const {
        const Lanes3 from_a = p - set3(shape.start_a);
        const Lanes t = hn::Mul(dot(from_a, set3(shape.start_axis)), set(shape.per_start_length_squared));
        const Lanes s = hn::Min(hn::Max(t, set(0)), set(1));
        const Lanes3 out = turned(shape.turn, from_a - s * set3(shape.start_axis));
        const Lanes length = hn::Max(hn::Sqrt(dot(out, out)), hn::Mul(set(1e-6f), radius(s)));
        Lanes more = set(shape.radius - shape.start_radius);
        if constexpr (is_tapered) more = hn::MulAdd(s, set(shape.wider - shape.wider_at_start), more);
        const Lanes wider = hn::Add(set(1), hn::Div(more, length));
        return set3(shape.a) + (s * set3(shape.axis) + wider * out);
    }
    [[nodiscard]] HWY_INLINE auto near(const Lanes3& p) const {
        const Lanes3 from_a = p - set3(shape.a);
        const Lanes t = along(from_a);
        const Lanes3 out = from_a - t * set3(shape.axis);
        if constexpr (is_tapered) {
            const Lanes reach = hn::Add(radius(t), thickness);
            return hn::Lt(dot(out, out), hn::Mul(reach, reach));
        } else {
            return hn::Lt(dot(out, out), reach_squared);
        }
    }
    template <class Mask>
    [[nodiscard]] HWY_INLINE SurfaceLanes<Mask> surface(const Lanes3& p, Mask is_near) const {
        const Lanes3 from_a = p - set3(shape.a);
        const Lanes t = along(from_a);
        const Lanes3 out = from_a - t * set3(shape.axis);
        const Lanes length = hn::Sqrt(dot(out, out));
        const Lanes penetration = hn::Sub(thickness, hn::Sub(length, radius(t)));
        const Lanes3 normal = either(hn::Gt(length, hn::Mul(set(1e-6f), radius(t))),
                                     hn::Div(set(1), length) * out, set3(shape.across));
        const Lanes3 of_axis = mul_add(t, set3(shape.difference), set3(shape.velocity));
        Lanes growth = set(shape.growth);
        if constexpr (is_tapered) growth = hn::MulAdd(t, set(shape.faster), growth);
        return {hn::And(is_near, hn::Gt(penetration, set(0))), penetration, normal,
                mul_add(growth, normal, of_axis)};
    }
};

struct PlaneLanes {
    static constexpr bool is_swept = false;  // a point that has passed it is inside
    const MovingPlane& shape;
    Lanes thickness;

    PlaneLanes(const MovingPlane& moving, float total_thickness)
        : shape(moving), thickness(set(total_thickness)) {}

    [[nodiscard]] HWY_INLINE Lanes distance(const Lanes3& p) const {
        return hn::Sub(dot(set3(shape.normal), p), set(shape.offset));
    }
    [[nodiscard]] HWY_INLINE Lanes speed(const Lanes3& p) const {
        return hn::Sub(set(shape.advance), dot(set3(shape.turn), p));
    }
    /// See RoundLanes.
    [[nodiscard]] HWY_INLINE Lanes3 carried(const Lanes3& p) const {
        return mul_add(hn::Mul(set(shape.h), speed(p)), set3(shape.normal), p);
    }
    [[nodiscard]] HWY_INLINE auto near(const Lanes3& p) const { return hn::Lt(distance(p), thickness); }
    template <class Mask>
    [[nodiscard]] HWY_INLINE SurfaceLanes<Mask> surface(const Lanes3& p, Mask is_near) const {
        const Lanes3 normal = set3(shape.normal);
        const Lanes limited = hn::Min(hn::Max(speed(p), set(-shape.fastest)), set(shape.fastest));
        return {is_near, hn::Sub(thickness, distance(p)), normal, limited * normal};
    }
};

}  // namespace weft::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
