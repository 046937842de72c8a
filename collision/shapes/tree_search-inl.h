// Points against a bounding volume hierarchy, in registers. Included as engine/simd/lanes-inl.h is.

#if defined(WEFT_COLLISION_SHAPES_TREE_SEARCH_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef WEFT_COLLISION_SHAPES_TREE_SEARCH_INL_H
#undef WEFT_COLLISION_SHAPES_TREE_SEARCH_INL_H
#else
#define WEFT_COLLISION_SHAPES_TREE_SEARCH_INL_H
#endif

#include <array>
#include <bit>
#include <cstring>
#include <limits>

#include "collision/geometry/closest-inl.h"
#include "collision/shapes/round_lanes-inl.h"
#include "collision/shapes/triangle_tree.h"

HWY_BEFORE_NAMESPACE();
namespace weft::HWY_NAMESPACE {

/// The nearest triangle so far, lane by lane. Ties go to the lower number: a lane's result does not depend on
/// the order in which other lanes make it search.
struct NearestTriangle {
    Lanes squared;            // squared distance [m^2]; at first its upper bound
    Lanes number = set(-1);   // triangle number, exact below 2^24
    Lanes3 gap = zero3();     // from the triangle to the point [m]
    Lanes s = set(0), t = s;  // weights of its second and third corner

    HWY_INLINE void look_at(const Lanes3& q, float triangle, const Vector3& a, const Vector3& b,
                            const Vector3& c) {
        const ClosestLanes closest = closest_of_vertex_and_triangle(set3(a) - q, set3(b) - q, set3(c) - q);
        const Lanes distance = dot(closest.gap, closest.gap), other = set(triangle);
        const auto is_first = hn::And(hn::Eq(distance, squared), hn::Lt(other, number));
        const auto nearer = hn::Or(hn::Lt(distance, squared), is_first);
        squared = hn::IfThenElse(nearer, distance, squared);
        number = hn::IfThenElse(nearer, other, number);
        gap = either(nearer, closest.gap, gap);
        s = hn::IfThenElse(nearer, hn::Neg(closest.weights.z), s);
        t = hn::IfThenElse(nearer, hn::Neg(closest.weights.w), t);
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

inline void look_at_leaf(const TriangleTree& tree, const TriangleTree::Node& node, const Lanes3& q,
                         NearestTriangle& best) {
    const std::span<const Vec3> x = tree.vertices();
    for (std::uint32_t t = node.first; t < node.first + node.count; ++t) {
        const Corners& c = tree.triangle(t);
        best.look_at(q, static_cast<float>(t), to_vector(x[c[0]]), to_vector(x[c[1]]), to_vector(x[c[2]]));
    }
}

/// Depth-first search; the child that is nearer to some lane comes first.
inline void search(const TriangleTree& tree, const Lanes3& q, NearestTriangle& best) {
    const Tag d;
    const std::span<const TriangleTree::Node> nodes = tree.nodes();
    std::array<std::uint32_t, 64> open{0};
    std::uint32_t count = 1;
    while (count > 0) {
        const TriangleTree::Node& node = nodes[open[--count]];
        if (hn::AllFalse(d, hn::Le(squared_distance(q, node), best.squared))) continue;
        look_at_leaf(tree, node, q, best);
        if (node.count > 0) continue;
        const auto least = [&](const TriangleTree::Node& child) HWY_ATTR {
            const Lanes squared = squared_distance(q, child);
            const auto may_hold = hn::Le(squared, best.squared);
            const Lanes infinity = set(std::numeric_limits<float>::infinity());
            return hn::GetLane(hn::MinOfLanes(d, hn::IfThenElse(may_hold, squared, infinity)));
        };
        const bool second_is_nearer = least(nodes[node.first + 1]) < least(nodes[node.first]);
        open[count++] = node.first + (second_is_nearer ? 0 : 1);
        open[count++] = node.first + (second_is_nearer ? 1 : 0);
    }
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
        lower = either(which, {hn::Min(lower.x, q.x), hn::Min(lower.y, q.y), hn::Min(lower.z, q.z)}, lower);
        upper = either(which, {hn::Max(upper.x, q.x), hn::Max(upper.y, q.y), hn::Max(upper.z, q.z)}, upper);
    }
    [[nodiscard]] Eigen::AlignedBox3f box() const {
        const Tag d;
        const auto least = [&](Lanes v) HWY_ATTR { return hn::GetLane(hn::MinOfLanes(d, v)); };
        const auto most = [&](Lanes v) HWY_ATTR { return hn::GetLane(hn::MaxOfLanes(d, v)); };
        return {Vector3(least(lower.x), least(lower.y), least(lower.z)),
                Vector3(most(upper.x), most(upper.y), most(upper.z))};
    }
};

/// The leaves of a tree within sight of a block of points. They are found once, so that the few points of a
/// register need not descend the tree each time.
class NearLeaves {
  public:
    /// Lists leaves for points in the box. If they do not fit or the sight is unbounded, search() declines.
    NearLeaves(const TriangleTree& tree, const Eigen::AlignedBox3f& box, float sight) : box_(box) {
        if (box.isEmpty() || !(sight < 1e6f)) return;
        const Vector3 margin = Vector3::Constant(1.0001f * sight);
        const Vector3 lower = box.min() - margin, upper = box.max() + margin;
        const std::span<const TriangleTree::Node> nodes = tree.nodes();
        std::array<std::uint32_t, 64> open{0};
        std::uint32_t waiting = 1;
        while (waiting > 0) {
            const std::uint32_t number = open[--waiting];
            const TriangleTree::Node& node = nodes[number];
            if (node.lower.x > upper.x() || node.upper.x < lower.x() || node.lower.y > upper.y() ||
                node.upper.y < lower.y() || node.lower.z > upper.z() || node.upper.z < lower.z())
                continue;
            if (node.count == 0) {
                open[waiting++] = node.first;
                open[waiting++] = node.first + 1;
            } else if (count_ == most) {
                return;
            } else {
                add(node, number);
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
        if (box.isEmpty() || !box_.contains(box)) return false;
        const Tag d;
        const float beyond = 1.0001f * sight;
        const Lanes3 lower = set3(Vector3(box.min() - Vector3::Constant(beyond)));
        const Lanes3 upper = set3(Vector3(box.max() + Vector3::Constant(beyond)));
        for (std::uint32_t first = 0; first < count_; first += part_lanes) {
            const auto overlaps = [&](const float* of_lower, const float* of_upper, Lanes low, Lanes high) {
                return hn::And(hn::Le(load_lanes(of_lower + first), high),
                               hn::Ge(load_lanes(of_upper + first), low));
            };
            const auto near = hn::And(overlaps(lower_[0], upper_[0], lower.x, upper.x),
                                      hn::And(overlaps(lower_[1], upper_[1], lower.y, upper.y),
                                              overlaps(lower_[2], upper_[2], lower.z, upper.z)));
            std::uint8_t bytes[8] = {};
            hn::StoreMaskBits(d, near, bytes);
            std::uint32_t bits = 0;
            std::memcpy(&bits, bytes, sizeof bits);
            if (count_ - first < part_lanes) bits &= (1u << (count_ - first)) - 1;
            for (; bits != 0; bits &= bits - 1) {
                const TriangleTree::Node& node =
                    tree.nodes()[nodes_[first + static_cast<std::uint32_t>(std::countr_zero(bits))]];
                if (!hn::AllFalse(d, hn::Le(squared_distance(q, node), best.squared)))
                    look_at_leaf(tree, node, q, best);
            }
        }
        return true;
    }

  private:
    static constexpr std::uint32_t most = 512;

    void add(const TriangleTree::Node& node, std::uint32_t number) {
        const Vector3 lower = to_vector(node.lower), upper = to_vector(node.upper);
        for (int k = 0; k < 3; ++k) {
            lower_[k][count_] = lower[k];
            upper_[k][count_] = upper[k];
        }
        nodes_[count_++] = number;
    }

    Eigen::AlignedBox3f box_;
    float sight_ = -1;  // negative: the list is incomplete
    std::uint32_t count_ = 0;
    alignas(64) float lower_[3][most], upper_[3][most];
    std::uint32_t nodes_[most];
};

}  // namespace weft::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
