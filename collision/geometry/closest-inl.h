// Closest points of a vertex and a triangle, and of two edges: a pair to a lane. Included as
// engine/simd/lanes-inl.h is.

#if defined(WEFT_COLLISION_GEOMETRY_CLOSEST_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef WEFT_COLLISION_GEOMETRY_CLOSEST_INL_H
#undef WEFT_COLLISION_GEOMETRY_CLOSEST_INL_H
#else
#define WEFT_COLLISION_GEOMETRY_CLOSEST_INL_H
#endif

#include <limits>

#include "engine/simd/lanes-inl.h"

HWY_BEFORE_NAMESPACE();
namespace weft::HWY_NAMESPACE {

/// Number of a pair's four corners that make side A.
inline constexpr std::uint32_t vertex_and_triangle = 1, edge_and_edge = 2;

/// Corners of pairs, relative to the first corner, so that pairs far from the origin lose no more precision
/// than rounding took from their coordinates.
struct CornerLanes {
    Lanes3 point[4], motion[4];
};

/// PairShape in lanes, and its gap over the motion (PairFinder::find).
struct ShapeLanes {
    Lanes4 weights;
    Lanes3 normal;
    Lanes gap, swept_gap;
};

HWY_INLINE Lanes3 cross(const Lanes3& a, const Lanes3& b) {
    return {hn::MulSub(a.y, b.z, hn::Mul(a.z, b.y)), hn::MulSub(a.z, b.x, hn::Mul(a.x, b.z)),
            hn::MulSub(a.x, b.y, hn::Mul(a.y, b.x))};
}
HWY_INLINE Lanes clamp_to_one(Lanes t) {
    return hn::Min(hn::Max(t, set(0)), set(1));
}
/// a / positive, where 0 / 0 is 0.
HWY_INLINE Lanes quotient(Lanes a, Lanes positive) {
    return hn::Div(a, hn::Max(positive, set(std::numeric_limits<float>::min())));
}

/// The shortest vector so far from B to A, and the parameters s and t of its ends, from which the weights
/// follow.
class BestGap {
  public:
    HWY_INLINE BestGap()
        : s(set(0)),
          t(set(0)),
          vector_(zero3()),
          edge_(zero3()),
          squared_(set(std::numeric_limits<float>::infinity())) {}

    /// `foot`: fraction of `edge` at which the vector ends. Rounding of lengths hides whether a foot lies at
    /// an edge's end or just beside it, but normals differ: the foot beside the end is right.
    HWY_INLINE void take(const Lanes3& gap, const Lanes3& edge, Lanes foot, Lanes other_s, Lanes other_t) {
        const auto within = hn::And(hn::Gt(foot, set(0)), hn::Lt(foot, set(1)));
        const Lanes exact = dot(gap, gap);
        const Lanes other = hn::IfThenElse(within, exact, hn::Mul(exact, set(1 + 5e-7f)));
        const auto nearer = hn::Lt(other, squared_);
        vector_ = either(nearer, gap, vector_);
        edge_ = either(nearer, keep_where(within, edge), edge_);
        squared_ = hn::IfThenElse(nearer, other, squared_);
        s = hn::IfThenElse(nearer, other_s, s);
        t = hn::IfThenElse(nearer, other_t, t);
    }

    /// The vector without its component along the edge that it ends within. On edges much longer than the
    /// gap, rounding leaves one: the normal tilts, and loses more of the gap between its planes than the
    /// length lost.
    [[nodiscard]] HWY_INLINE Lanes3 vector() const {
        return vector_ - quotient(dot(vector_, edge_), dot(edge_, edge_)) * edge_;
    }

    Lanes s, t;

  private:
    Lanes3 vector_, edge_;
    Lanes squared_;
};

/// Fraction of `edge`, from `from` on, of the point closest to `point`, 0 to 1 (Ericson 2004, 5.1.2).
HWY_INLINE Lanes closest_on_edge(const Lanes3& point, const Lanes3& from, const Lanes3& edge,
                                 Lanes length_squared) {
    return clamp_to_one(quotient(dot(point - from, edge), length_squared));
}

/// Squared sine between two directions at and below which their cross product is mostly rounding.
inline constexpr float least_squared_sine = 1e-6f;

/// A vector across `v`.
HWY_INLINE Lanes3 perpendicular(const Lanes3& v) {
    const auto is_steep = hn::Gt(hn::Abs(v.y), hn::Max(hn::Abs(v.x), hn::Abs(v.z)));
    const Lanes zero = set(0);
    return either(is_steep, Lanes3{v.y, hn::Neg(v.x), zero}, Lanes3{hn::Neg(v.z), zero, v.x});
}

/// Gap vector and weights, and a second axis: across the triangle or both edges, of any length.
struct ClosestLanes {
    Lanes3 gap, across;
    Lanes4 weights;
};

/// The vertex is the origin. As in Ericson 2004, 5.1.5, but for all features of the triangle at once: the
/// nearest of its edges' closest points and, where the vertex is over the triangle, the point below it. So
/// triangles without area need no case of their own.
HWY_INLINE ClosestLanes closest_of_vertex_and_triangle(const Lanes3& a, const Lanes3& b, const Lanes3& c) {
    const Lanes3 ab = b - a, bc = c - b, ca = a - c, vertex = zero3();
    const Lanes ab2 = dot(ab, ab), bc2 = dot(bc, bc), ca2 = dot(ca, ca);
    // s and t: weights of b and c.
    const Lanes zero = set(0), one = set(1);
    const Lanes on_ab = closest_on_edge(vertex, a, ab, ab2);
    const Lanes on_bc = closest_on_edge(vertex, b, bc, bc2);
    const Lanes on_ca = closest_on_edge(vertex, c, ca, ca2);
    BestGap best;
    best.take(mul_add(on_ab, ab, a), ab, on_ab, on_ab, zero);
    best.take(mul_add(on_bc, bc, b), bc, on_bc, hn::Sub(one, on_bc), on_bc);
    best.take(mul_add(on_ca, ca, c), ca, on_ca, zero, hn::Sub(one, on_ca));

    const Lanes3 across = cross(ca, ab);  // = ab x ac
    const Lanes across2 = dot(across, across);
    const Lanes u = dot(across, cross(b, c)), v = dot(across, cross(c, a)), w = dot(across, cross(a, b));
    const Lanes sum = hn::Add(u, hn::Add(v, w));
    const auto flat = hn::Le(across2, hn::Mul(set(least_squared_sine), hn::Mul(ab2, ca2)));
    const auto over = hn::AndNot(flat, hn::And(hn::Gt(hn::Min(u, hn::Min(v, w)), zero), hn::Gt(sum, zero)));
    const Lanes scale = hn::Div(one, hn::IfThenElse(over, sum, one));
    const Lanes3 below = hn::Div(dot(across, a), hn::IfThenElse(over, across2, one)) * across;
    const Lanes t = hn::IfThenElse(over, hn::Mul(w, scale), best.t);
    const Lanes s = hn::IfThenElse(over, hn::Mul(v, scale), best.s);
    const Lanes3 nearest = either(over, below, best.vector());
    const Lanes3 longest = either(hn::Lt(ab2, ca2), ca, ab);
    return {zero3() - nearest,
            either(flat, perpendicular(longest), across),
            {one, hn::Sub(hn::Add(s, t), one), hn::Neg(s), hn::Neg(t)}};
}

/// The edges are p0 p1 and q0 q1; p0 is the origin. As in Ericson 2004, 5.1.9, but the nearest of five
/// candidates: each end with the other edge, and the insides of both edges. So nearly parallel edges, for
/// which the last is mostly rounding, are as exact as others.
HWY_INLINE ClosestLanes closest_of_edges(const Lanes3& p1, const Lanes3& q0, const Lanes3& q1) {
    const Lanes3 p0 = zero3(), p = p1, q = q1 - q0;
    const Lanes p2 = dot(p, p), q2 = dot(q, q);
    const Lanes zero = set(0), one = set(1);
    const Lanes t0 = closest_on_edge(p0, q0, q, q2), t1 = closest_on_edge(p1, q0, q, q2);
    const Lanes s0 = closest_on_edge(q0, p0, p, p2), s1 = closest_on_edge(q1, p0, p, p2);
    BestGap best;
    best.take(zero3() - mul_add(t0, q, q0), q, t0, zero, t0);
    best.take(p1 - mul_add(t1, q, q0), q, t1, one, t1);
    best.take(s0 * p - q0, p, s0, s0, zero);
    best.take(s1 * p - q1, p, s1, s1, one);

    // s p - t q - q0 is parallel to p x q: its cross product with q eliminates t, that with p eliminates s.
    const Lanes3 across = cross(p, q);
    const Lanes across2 = dot(across, across);
    const Lanes s = quotient(dot(cross(q0, q), across), across2);
    const Lanes t = quotient(dot(cross(q0, p), across), across2);
    const auto within = [&](Lanes r) HWY_ATTR { return hn::And(hn::Gt(r, zero), hn::Lt(r, one)); };
    const auto skew = hn::Gt(across2, hn::Mul(set(least_squared_sine), hn::Mul(p2, q2)));
    const auto between = hn::And(skew, hn::And(within(s), within(t)));
    const Lanes3 straight = hn::Neg(hn::Div(dot(across, q0), hn::IfThenElse(between, across2, one))) * across;
    ClosestLanes closest{either(between, straight, best.vector()), across, {}};
    Lanes weight_s = hn::IfThenElse(between, s, best.s), weight_t = hn::IfThenElse(between, t, best.t);

    if (HWY_UNLIKELY(!hn::AllTrue(Tag(), skew))) {
        // Nearly parallel edges: the foot on q of a point of p is exact even if that point is not.
        const Lanes s_within = clamp_to_one(s);
        const Lanes foot = closest_on_edge(s_within * p, q0, q, q2);
        best.take(s_within * p - mul_add(foot, q, q0), q, foot, s_within, foot);
        closest.gap = either(skew, closest.gap, best.vector());
        closest.across = either(skew, across, perpendicular(either(hn::Lt(p2, q2), q, p)));
        weight_s = hn::IfThenElse(skew, weight_s, best.s);
        weight_t = hn::IfThenElse(skew, weight_t, best.t);
    }
    closest.weights = {hn::Sub(one, weight_s), weight_s, hn::Sub(weight_t, one), hn::Neg(weight_t)};
    return closest;
}

/// min over A - max over B of n . x.
template <std::uint32_t of_a>
HWY_INLINE Lanes gap_along(const Lanes3& n, const CornerLanes& corners) {
    Lanes along[4];
    for (std::uint32_t k = 0; k < 4; ++k) along[k] = dot(n, corners.point[k]);
    return of_a == vertex_and_triangle ? hn::Sub(along[0], hn::Max(along[1], hn::Max(along[2], along[3])))
                                       : hn::Sub(hn::Min(along[0], along[1]), hn::Max(along[2], along[3]));
}

/// The same over the motion: min over A - max over B of n . x and n . (x + m).
template <std::uint32_t of_a>
HWY_INLINE Lanes swept_gap_along(const Lanes3& n, const CornerLanes& corners) {
    Lanes least[4], most[4];
    for (std::uint32_t k = 0; k < 4; ++k) {
        const Lanes before = dot(n, corners.point[k]);
        const Lanes change = dot(n, corners.motion[k]);
        least[k] = hn::Add(before, hn::Min(change, set(0)));
        most[k] = hn::Add(before, hn::Max(change, set(0)));
    }
    return of_a == vertex_and_triangle ? hn::Sub(least[0], hn::Max(most[1], hn::Max(most[2], most[3])))
                                       : hn::Sub(hn::Min(least[0], least[1]), hn::Max(most[2], most[3]));
}

HWY_INLINE Lanes3 unit(const Lanes3& v) {
    const Lanes squared = dot(v, v);
    const auto some = hn::Gt(squared, set(std::numeric_limits<float>::min()));
    return keep_where(some, hn::Div(set(1), hn::Sqrt(hn::IfThenElse(some, squared, set(1)))) * v);
}

/// The normal along the gap of the closest points. If it does not separate the two, because they touch or
/// cross or by rounding, the better of it and the second axis.
template <std::uint32_t of_a>
HWY_INLINE void choose_normal(const ClosestLanes& closest, const CornerLanes& corners, ShapeLanes& shape) {
    shape.normal = unit(closest.gap);
    shape.gap = gap_along<of_a>(shape.normal, corners);
    const auto apart = hn::Gt(shape.gap, set(0));
    if (HWY_LIKELY(hn::AllTrue(Tag(), apart))) return;
    const auto is_zero = hn::Eq(dot(shape.normal, shape.normal), set(0));
    const Lanes3 some = {set(0), set(1), set(0)};  // arbitrary: all corners lie in one line
    Lanes3 across = unit(closest.across);
    across = either(hn::And(is_zero, hn::Eq(dot(across, across), set(0))), some, across);
    const auto consider = [&](const Lanes3& axis) HWY_ATTR {
        const Lanes gap = gap_along<of_a>(axis, corners);
        const auto usable = hn::Gt(dot(axis, axis), set(0));
        const auto none = hn::Eq(dot(shape.normal, shape.normal), set(0));
        const auto better = hn::AndNot(apart, hn::And(usable, hn::Or(none, hn::Gt(gap, shape.gap))));
        shape.normal = either(better, axis, shape.normal);
        shape.gap = hn::IfThenElse(better, gap, shape.gap);
    };
    consider(across);
    consider(zero3() - across);
}

template <std::uint32_t of_a>
HWY_INLINE ShapeLanes shape_of(const CornerLanes& corners) {
    ClosestLanes closest;
    if constexpr (of_a == vertex_and_triangle)
        closest = closest_of_vertex_and_triangle(corners.point[1], corners.point[2], corners.point[3]);
    else
        closest = closest_of_edges(corners.point[1], corners.point[2], corners.point[3]);
    ShapeLanes shape;
    shape.weights = closest.weights;
    choose_normal<of_a>(closest, corners, shape);
    shape.swept_gap = swept_gap_along<of_a>(shape.normal, corners);
    return shape;
}

/// PairShape::is_at_border, lane by lane.
template <std::uint32_t of_a>
HWY_INLINE hn::Mask<Tag> is_at_border(const Lanes4& w) {
    const auto in_triangle = hn::Or(hn::Eq(w.y, set(0)), hn::Or(hn::Eq(w.z, set(0)), hn::Eq(w.w, set(0))));
    return of_a == vertex_and_triangle ? in_triangle : hn::Or(in_triangle, hn::Eq(w.x, set(0)));
}

/// shape_moving_pairs, lane by lane.
template <std::uint32_t of_a>
HWY_INLINE ShapeLanes shape_over_motion(const CornerLanes& corners, const ShapeLanes& at_start) {
    CornerLanes ends;
    for (std::uint32_t c = 0; c < 4; ++c)
        ends.point[c] = corners.point[c] + (corners.motion[c] - corners.motion[0]);
    Lanes least = hn::Min(at_start.gap, gap_along<of_a>(at_start.normal, ends));
    const auto may_turn = hn::And(is_at_border<of_a>(at_start.weights), hn::Lt(least, at_start.gap));
    if (hn::AllFalse(Tag(), may_turn)) return at_start;
    ShapeLanes shape = at_start;
    const auto consider = [&](const Lanes3& normal, const Lanes4& weights) HWY_ATTR {
        const Lanes gap = gap_along<of_a>(normal, corners);
        const Lanes least_along = hn::Min(gap, gap_along<of_a>(normal, ends));
        const auto better = hn::And(may_turn, hn::Gt(least_along, hn::Max(least, set(0))));
        shape.weights = either(better, weights, shape.weights);
        shape.normal = either(better, normal, shape.normal);
        shape.gap = hn::IfThenElse(better, gap, shape.gap);
        least = hn::IfThenElse(better, least_along, least);
    };
    const ShapeLanes at_end = shape_of<of_a>(ends);
    consider(at_end.normal, at_end.weights);
    consider(unit(at_start.normal + at_end.normal), at_start.weights);
    return shape;
}

}  // namespace weft::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
