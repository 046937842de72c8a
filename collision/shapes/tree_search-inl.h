// Points against a bounding volume hierarchy, in registers. Included as engine/simd/lanes-inl.h is.

#if defined(WEFT_COLLISION_SHAPES_TREE_SEARCH_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef WEFT_COLLISION_SHAPES_TREE_SEARCH_INL_H
#undef WEFT_COLLISION_SHAPES_TREE_SEARCH_INL_H
#else
#define WEFT_COLLISION_SHAPES_TREE_SEARCH_INL_H
#endif

#include <array>
#include <bit>
#include <cmath>
#include <limits>

#include "collision/geometry/closest-inl.h"
#include "collision/shapes/round_lanes-inl.h"
#include "collision/shapes/triangles/triangle_tree.h"

HWY_BEFORE_NAMESPACE();
namespace weft::HWY_NAMESPACE {

/// The nearest triangle so far, lane by lane. Ties go to the lower number: a lane's result does not depend on
/// the order in which other lanes make it search.
struct NearestTriangle {
    Lanes squared;            // squared distance [m^2]; at first its upper bound
    Lanes number = set(-1);   // triangle number, exact below 2^24
    Lanes3 gap = zero3();     // from the triangle to the point [m]
    Lanes s = set(0), t = s;  // weights of its second and third corner

    HWY_INLINE void look_at(const Lanes3& q, Lanes triangle, const Lanes3& a, const Lanes3& b,
                            const Lanes3& c) {
        const ClosestLanes closest = closest_of_vertex_and_triangle(a - q, b - q, c - q);
        const Lanes distance = dot(closest.gap, closest.gap);
        const auto is_first = hn::And(hn::Eq(distance, squared), hn::Lt(triangle, number));
        const auto nearer = hn::Or(hn::Lt(distance, squared), is_first);
        squared = hn::IfThenElse(nearer, distance, squared);
        number = hn::IfThenElse(nearer, triangle, number);
        gap = either(nearer, closest.gap, gap);
        s = hn::IfThenElse(nearer, hn::Neg(closest.weights.z), s);
        t = hn::IfThenElse(nearer, hn::Neg(closest.weights.w), t);
    }
    /// The lanes in which a triangle may be as near, by a lower bound of its squared distance; more than
    /// rounding is left for the triangle's own closest point.
    [[nodiscard]] HWY_INLINE auto may_be(Lanes bound) const {
        return hn::Le(bound, hn::Mul(squared, set(1.0001f)));
    }
};

HWY_INLINE Lanes squared_distance(const Lanes3& q, const TriangleTree::Node& node) {
    const auto beyond = [](Lanes at, float lower, float upper) HWY_ATTR {
        return hn::Max(hn::Max(hn::Sub(set(lower), at), hn::Sub(at, set(upper))), set(0));
    };
    const Lanes3 out{beyond(q.x, node.lower.x, node.upper.x), beyond(q.y, node.lower.y, node.upper.y),
                     beyond(q.z, node.lower.z, node.upper.z)};
    return dot(out, out);
}

/// A triangle of a leaf, for all lanes.
HWY_INLINE Lanes3 set_row(const TriangleLeaf::Row3& rows, std::uint32_t k) {
    return {set(rows[0][k]), set(rows[1][k]), set(rows[2][k])};
}
HWY_INLINE void look_at(const TriangleLeaf& leaf, std::uint32_t k, float number, const Lanes3& q,
                        NearestTriangle& best) {
    best.look_at(q, set(number), set_row(leaf.corners[0], k), set_row(leaf.corners[1], k),
                 set_row(leaf.corners[2], k));
}

/// Lower bound of the squared distance from a triangle: by the plane that it lies in, and by the planes
/// through its edges. It is the distance but for rounding, and where a corner is nearest.
HWY_INLINE Lanes least_squared(const TriangleLeaf& leaf, std::uint32_t k, const Lanes3& q) {
    const Lanes3 from_a = q - set_row(leaf.corners[0], k);
    const Lanes along = hn::Abs(dot(set_row(leaf.normal, k), from_a));
    const Lanes of_bc = hn::Sub(dot(set_row(leaf.out[1], k), from_a), set(leaf.beyond[k]));
    const Lanes beyond =
        hn::Max(dot(set_row(leaf.out[0], k), from_a), hn::Max(of_bc, dot(set_row(leaf.out[2], k), from_a)));
    const Lanes slack = set(leaf.slack[k]);
    const Lanes least = hn::Max(hn::Sub(along, slack), set(0)),
                side = hn::Max(hn::Sub(beyond, slack), set(0));
    return hn::MulAdd(side, side, hn::Mul(least, least));
}

/// Bounding box of lanes; of negative infinite size while empty.
struct LaneBox {
    Lanes3 lower, upper;

    LaneBox() {
        const Lanes infinity = set(std::numeric_limits<float>::infinity()), none = hn::Neg(infinity);
        lower = {infinity, infinity, infinity};
        upper = {none, none, none};
    }
    template <class Mask>
    HWY_INLINE void add(const Lanes3& q, Mask which) {
        lower = either(which, minimum(lower, q), lower);
        upper = either(which, maximum(upper, q), upper);
    }
    [[nodiscard]] Eigen::AlignedBox3f box() const {
        const Tag d;
        const auto least = [&](Lanes v) HWY_ATTR { return hn::GetLane(hn::MinOfLanes(d, v)); };
        const auto most = [&](Lanes v) HWY_ATTR { return hn::GetLane(hn::MaxOfLanes(d, v)); };
        return {Vector3(least(lower.x), least(lower.y), least(lower.z)),
                Vector3(most(upper.x), most(upper.y), most(upper.z))};
    }
};

/// Triangles whose boxes come near a register of points. Lower bounds of all distances come first; exact
/// distances are found of the triangle with the least bound, lane by lane, and of those whose bounds are not
/// above its distance.
class NearTriangles {
  public:
    NearTriangles() : least_(set(std::numeric_limits<float>::infinity())), likely_(set(0)) {}
    void look_at(const TriangleTree& tree, std::uint32_t leaf, std::uint32_t k, const Lanes3& q,
                 NearestTriangle& best) {
        if (count_ == most) look_at_all(tree, q, best);
        const Lanes bound = least_squared(tree.leaves()[leaf], k, q);
        const auto less = hn::Lt(bound, least_);
        least_ = hn::IfThenElse(less, bound, least_);
        likely_ = hn::IfThenElse(less, set(static_cast<float>(count_)), likely_);
        hn::Store(bound, Tag(), bounds_[count_]);
        numbers_[count_++] = static_cast<std::int32_t>(TriangleLeaf::size * leaf + k);
    }
    void look_at_all(const TriangleTree& tree, const Lanes3& q, NearestTriangle& best) {
        if (count_ == 0) return;
        const Tag d;
        const hn::RebindToSigned<Tag> di;
        const auto is_near = best.may_be(least_);
        if (!hn::AllFalse(d, is_near)) {
            const auto number = hn::GatherIndex(di, numbers_, hn::ConvertTo(di, likely_));
            look_at_own(tree, hn::IfThenElseZero(hn::RebindMask(di, is_near), number), q, best);
        }
        for (std::uint32_t n = 0; n < count_; ++n) {
            const auto other = hn::Ne(likely_, set(static_cast<float>(n)));
            if (hn::AllFalse(d, hn::And(other, best.may_be(load_lanes(bounds_[n]))))) continue;
            const auto number = static_cast<std::uint32_t>(numbers_[n]);
            weft::HWY_NAMESPACE::look_at(tree.leaves()[number / TriangleLeaf::size],
                                         number % TriangleLeaf::size, static_cast<float>(number), q, best);
        }
        count_ = 0;
        least_ = set(std::numeric_limits<float>::infinity());
    }

  private:
    static constexpr std::uint32_t most = 64;  // bounds that are kept at a time

    /// Looks at a triangle of its own in each lane.
    template <class Numbers>
    static HWY_INLINE void look_at_own(const TriangleTree& tree, Numbers number, const Lanes3& q,
                                       NearestTriangle& best) {
        const Tag d;
        const hn::RebindToSigned<Tag> di;
        constexpr int per_leaf = sizeof(TriangleLeaf) / sizeof(float);
        static_assert(TriangleLeaf::size == 16);
        const auto lane = hn::And(number, hn::Set(di, 15));
        const auto place = hn::Add(hn::Mul(hn::ShiftRight<4>(number), hn::Set(di, per_leaf)), lane);
        Lanes3 corners[3];
        for (std::size_t k = 0; k < 3; ++k) {
            const TriangleLeaf::Row3& rows = tree.leaves()[0].corners[k];
            corners[k] = {hn::GatherIndex(d, rows[0].data(), place),
                          hn::GatherIndex(d, rows[1].data(), place),
                          hn::GatherIndex(d, rows[2].data(), place)};
        }
        best.look_at(q, hn::ConvertTo(d, number), corners[0], corners[1], corners[2]);
    }

    Lanes least_, likely_;  // least bound, and its place in the list
    std::uint32_t count_ = 0;
    std::int32_t numbers_[most];
    alignas(64) float bounds_[most][part_lanes];
};

/// The space around a register of points.
struct Around {
    Eigen::AlignedBox3f box;
    Lanes3 lower, upper;

    Around(const Eigen::AlignedBox3f& points, float distance) {
        const float farthest = points.min().cwiseAbs().cwiseMax(points.max().cwiseAbs()).maxCoeff();
        const float beyond = 1.0001f * distance + 2e-6f * farthest;  // more than rounding, as of nodes
        box = {points.min() - Vector3::Constant(beyond), points.max() + Vector3::Constant(beyond)};
        lower = set3(Vector3(box.min()));
        upper = set3(Vector3(box.max()));
    }
    /// A bit for each of the boxes that overlap it.
    [[nodiscard]] HWY_INLINE std::uint32_t overlapping(const Lanes3& least, const Lanes3& greatest) const {
        const auto along = [](Lanes from, Lanes to, Lanes low, Lanes high)
                               HWY_ATTR { return hn::And(hn::Le(from, high), hn::Ge(to, low)); };
        return bits_of(hn::And(along(least.x, greatest.x, lower.x, upper.x),
                               hn::And(along(least.y, greatest.y, lower.y, upper.y),
                                       along(least.z, greatest.z, lower.z, upper.z))));
    }
};

/// Lists the triangles of a leaf whose boxes come near.
inline void look_at_leaf(const TriangleTree& tree, std::uint32_t number, const Around& around,
                         const Lanes3& q, NearTriangles& near, NearestTriangle& best) {
    const TriangleLeaf& leaf = tree.leaves()[number];
    for (std::uint32_t first = 0; first < TriangleLeaf::size; first += part_lanes) {
        const auto corners = [&](std::size_t k) HWY_ATTR {
            const TriangleLeaf::Row3& rows = leaf.corners[k];
            return Lanes3{load_lanes(&rows[0][first]), load_lanes(&rows[1][first]),
                          load_lanes(&rows[2][first])};
        };
        const Lanes3 a = corners(0), b = corners(1), c = corners(2);
        std::uint32_t bits = around.overlapping(minimum(a, minimum(b, c)), maximum(a, maximum(b, c)));
        for (; bits != 0; bits &= bits - 1)
            near.look_at(tree, number, first + static_cast<std::uint32_t>(std::countr_zero(bits)), q, best);
    }
}

/// Depth-first search; the child that is nearer to more lanes comes first.
inline void search(const TriangleTree& tree, const Lanes3& q, NearestTriangle& best) {
    const Tag d;
    const std::span<const TriangleTree::Node> nodes = tree.nodes();
    NearTriangles near;
    // Without a bound every leaf narrows the search; with one, leaves wait for one another.
    const bool is_unbounded = !(hn::GetLane(hn::MaxOfLanes(d, best.squared)) < 1e12f);
    std::array<std::uint32_t, 64> open{0};
    std::uint32_t count = 1;
    while (count > 0) {
        const TriangleTree::Node& node = nodes[open[--count]];
        if (node.count > 0) {
            if (hn::AllFalse(d, hn::Le(squared_distance(q, node), best.squared))) continue;
            for (std::uint32_t k = 0; k < node.count; ++k)
                near.look_at(tree, node.first / TriangleLeaf::size, k, q, best);
            if (is_unbounded) near.look_at_all(tree, q, best);
            continue;
        }
        const Lanes first = squared_distance(q, nodes[node.first]),
                    second = squared_distance(q, nodes[node.first + 1]);
        const auto in_first = hn::Le(first, best.squared), in_second = hn::Le(second, best.squared);
        const auto by_second = hn::And(in_second, hn::Or(hn::Lt(second, first), hn::Not(in_first)));
        const bool second_is_nearer =
            2 * hn::CountTrue(d, by_second) > hn::CountTrue(d, hn::Or(in_first, in_second));
        const bool any[2] = {!hn::AllFalse(d, in_first), !hn::AllFalse(d, in_second)};
        for (const std::uint32_t child : {second_is_nearer ? 0u : 1u, second_is_nearer ? 1u : 0u})
            if (any[child]) open[count++] = node.first + child;
    }
    near.look_at_all(tree, q, best);
}

/// The leaves of a tree within sight of a block of points. They are found once, so that the few points of a
/// register need not descend the tree each time.
class NearLeaves {
  public:
    /// Lists leaves for points in the box. If they do not fit or the sight is unbounded, search() declines.
    NearLeaves(const TriangleTree& tree, const Eigen::AlignedBox3f& box, float sight) : box_(box) {
        if (box.isEmpty() || !(sight < 1e6f)) return;
        const Around around(box, sight);
        const Vector3 lower = around.box.min(), upper = around.box.max();
        const std::span<const TriangleTree::Node> nodes = tree.nodes();
        std::array<std::uint32_t, 64> open{0};
        std::uint32_t waiting = 1;
        while (waiting > 0) {
            const TriangleTree::Node& node = nodes[open[--waiting]];
            if (node.lower.x > upper.x() || node.upper.x < lower.x() || node.lower.y > upper.y() ||
                node.upper.y < lower.y() || node.lower.z > upper.z() || node.upper.z < lower.z())
                continue;
            if (node.count == 0) {
                open[waiting++] = node.first;
                open[waiting++] = node.first + 1;
            } else if (count_ == most) {
                return;
            } else {
                add(node);
            }
        }
        sight_ = sight;
    }

    /// Searches these leaves as search() does the tree. False, with nothing done, for points outside the box
    /// or of a longer sight.
    template <class Mask>
    [[nodiscard]] bool search(const TriangleTree& tree, const Lanes3& q, Mask asked, float sight,
                              NearestTriangle& best) const {
        if (!(sight <= sight_)) return false;
        LaneBox of_lanes;
        of_lanes.add(q, asked);
        const Eigen::AlignedBox3f box = of_lanes.box();
        if (box.isEmpty()) return true;
        if (!box_.contains(box)) return false;
        const Around around(box, sight);
        NearTriangles near;
        for (std::uint32_t first = 0; first < count_; first += part_lanes) {
            std::uint32_t bits = around.overlapping(
                {load_lanes(lower_[0] + first), load_lanes(lower_[1] + first), load_lanes(lower_[2] + first)},
                {load_lanes(upper_[0] + first), load_lanes(upper_[1] + first),
                 load_lanes(upper_[2] + first)});
            if (count_ - first < part_lanes) bits &= (1u << (count_ - first)) - 1;
            for (; bits != 0; bits &= bits - 1)
                look_at_leaf(tree, leaves_[first + static_cast<std::uint32_t>(std::countr_zero(bits))],
                             around, q, near, best);
        }
        near.look_at_all(tree, q, best);
        return true;
    }

  private:
    static constexpr std::uint32_t most = 128;

    void add(const TriangleTree::Node& node) {
        const Vector3 lower = to_vector(node.lower), upper = to_vector(node.upper);
        for (int k = 0; k < 3; ++k) {
            lower_[k][count_] = lower[k];
            upper_[k][count_] = upper[k];
        }
        leaves_[count_++] = node.first / TriangleLeaf::size;
    }

    Eigen::AlignedBox3f box_;
    float sight_ = -1;  // negative: the list is incomplete
    std::uint32_t count_ = 0;
    alignas(64) float lower_[3][most], upper_[3][most];
    std::uint32_t leaves_[most];
};

}  // namespace weft::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
