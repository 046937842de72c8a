// Shapes with a local frame, in registers. Included as engine/simd/lanes-inl.h is.

#if defined(WEFT_COLLISION_SHAPES_BODY_LANES_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef WEFT_COLLISION_SHAPES_BODY_LANES_INL_H
#undef WEFT_COLLISION_SHAPES_BODY_LANES_INL_H
#else
#define WEFT_COLLISION_SHAPES_BODY_LANES_INL_H
#endif

#include "collision/shapes/round_lanes-inl.h"

HWY_BEFORE_NAMESPACE();
namespace weft::HWY_NAMESPACE {

/// The surface nearest to points in a shape's local frame, lane by lane.
struct OwnSurface {
    Lanes distance;  // below 0 inside [m]
    Lanes3 normal;   // of unit length, outward
    Lanes3 growth;   // velocity of the surface in the frame [m/s]
};

/// Own: the shape in its local frame. Its functions:
///   convex()             whether the shape is convex
///   near(q, thickness)   whether a point may be nearer than that; conservative
///   nearest(q, asked)    the nearest surface, in the lanes that are asked for
///   carried(q)           where a start's point is at the end, moved along with the shape as it grows
template <class Own>
struct BodyLanes {
    static constexpr bool is_swept = Own::is_swept, has_faces = true;
    const MovingSpace& space;
    Own own;
    Lanes thickness;

    BodyLanes(const MovingSpace& moving_space, const Own& own_shape, float total_thickness)
        : space(moving_space), own(own_shape), thickness(set(total_thickness)) {}

    [[nodiscard]] bool convex() const { return own.convex(); }
    [[nodiscard]] HWY_INLINE Lanes3 seen(const Lanes3& p) const {
        return turned(space.to_own, p - set3(space.origin));
    }
    [[nodiscard]] HWY_INLINE Lanes3 carried(const Lanes3& p) const {
        const Lanes3 q = own.carried(turned(space.to_own_at_start, p - set3(space.start_origin)));
        return set3(space.origin) + turned(space.from_own, q);
    }
    [[nodiscard]] HWY_INLINE auto near(const Lanes3& p) const { return own.near(seen(p), thickness); }
    template <class Mask>
    [[nodiscard]] HWY_INLINE SurfaceLanes<Mask> surface(const Lanes3& p, Mask is_near) const {
        const OwnSurface nearest = own.nearest(seen(p), is_near);
        const Lanes penetration = hn::Sub(thickness, nearest.distance);
        const Lanes3 rigid = set3(space.velocity) + turned(space.spin, p - set3(space.origin));
        return {hn::And(is_near, hn::Gt(penetration, set(0))), penetration,
                turned(space.from_own, nearest.normal),
                limited(rigid + turned(space.from_own, nearest.growth))};
    }

  private:
    [[nodiscard]] HWY_INLINE Lanes3 limited(const Lanes3& velocity) const {
        const Lanes squared = dot(velocity, velocity), most = set(space.fastest);
        const auto too_fast = hn::Gt(squared, hn::Mul(most, most));
        return either(too_fast, hn::Div(most, hn::Sqrt(squared)) * velocity, velocity);
    }
};

struct OwnBox {
    static constexpr bool is_swept = true;
    const MovingBox& box;

    [[nodiscard]] static constexpr bool convex() { return true; }
    [[nodiscard]] HWY_INLINE Lanes3 beyond_faces(const Lanes3& q) const {
        return Lanes3{hn::Abs(q.x), hn::Abs(q.y), hn::Abs(q.z)} - set3(box.half);
    }
    /// A point's coordinates over the half extents, clamped to [-1, 1].
    [[nodiscard]] HWY_INLINE Lanes3 outward(const Lanes3& q, const Vector3& half) const {
        const auto of = [](Lanes along, float face) HWY_ATTR {
            return hn::Min(hn::Max(hn::Mul(along, set(1 / face)), set(-1)), set(1));
        };
        return {of(q.x, half.x()), of(q.y, half.y()), of(q.z, half.z())};
    }
    [[nodiscard]] HWY_INLINE static Lanes3 times(const Lanes3& a, const Vector3& b) {
        return {hn::Mul(a.x, set(b.x())), hn::Mul(a.y, set(b.y())), hn::Mul(a.z, set(b.z()))};
    }
    [[nodiscard]] HWY_INLINE Lanes3 carried(const Lanes3& q) const {
        return q + times(outward(q, box.half - box.wider), box.wider);
    }
    [[nodiscard]] HWY_INLINE auto near(const Lanes3& q, Lanes thickness) const {
        const Lanes3 e = beyond_faces(q);
        return hn::Lt(hn::Max(e.x, hn::Max(e.y, e.z)), thickness);
    }
    /// Outside, distance and normal refer to the nearest point; inside, to the nearest face.
    template <class Mask>
    [[nodiscard]] HWY_INLINE OwnSurface nearest(const Lanes3& q, Mask) const {
        const Lanes zero = set(0), one = set(1);
        const Lanes3 e = beyond_faces(q);
        const Lanes3 out{hn::Max(e.x, zero), hn::Max(e.y, zero), hn::Max(e.z, zero)};
        const Lanes length = hn::Sqrt(dot(out, out));
        const Lanes least = hn::Max(e.x, hn::Max(e.y, e.z));
        const auto is_outside = hn::Gt(length, zero);
        const auto by_x = hn::Eq(e.x, least), by_y = hn::AndNot(by_x, hn::Eq(e.y, least));
        const Lanes3 face{hn::IfThenElseZero(by_x, one), hn::IfThenElseZero(by_y, one),
                          hn::IfThenElse(hn::Or(by_x, by_y), zero, one)};
        const Lanes3 n = either(is_outside, hn::Div(one, length) * out, face);
        const Lanes distance = hn::IfThenElse(is_outside, length, least);
        const Lanes3 normal{hn::CopySign(n.x, q.x), hn::CopySign(n.y, q.y), hn::CopySign(n.z, q.z)};
        return {distance, normal, times(outward(q - distance * normal, box.half), box.growth)};
    }
};

}  // namespace weft::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
