// Shapes that the World holds, in registers. Included as engine/simd/lanes-inl.h is.

#if defined(WEFT_COLLISION_SHAPES_HELD_LANES_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef WEFT_COLLISION_SHAPES_HELD_LANES_INL_H
#undef WEFT_COLLISION_SHAPES_HELD_LANES_INL_H
#else
#define WEFT_COLLISION_SHAPES_HELD_LANES_INL_H
#endif

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "collision/shapes/body_lanes-inl.h"
#include "collision/shapes/held_shape.h"
#include "collision/shapes/tree_search-inl.h"

HWY_BEFORE_NAMESPACE();
namespace weft::HWY_NAMESPACE {

/// Lanes in memory, for work lane by lane.
struct LaneByLane {
    alignas(64) float x[group_lanes] = {}, y[group_lanes] = {}, z[group_lanes] = {}, w[group_lanes] = {};

    LaneByLane() = default;
    explicit HWY_INLINE LaneByLane(const Lanes3& v, Lanes of_w) {
        const Tag d;
        hn::Store(v.x, d, x);
        hn::Store(v.y, d, y);
        hn::Store(v.z, d, z);
        hn::Store(of_w, d, w);
    }
    [[nodiscard]] HWY_INLINE Lanes4 lanes() const {
        return {load_lanes(x), load_lanes(y), load_lanes(z), load_lanes(w)};
    }
    [[nodiscard]] Vector3 vector(std::uint32_t lane) const { return {x[lane], y[lane], z[lane]}; }
    void set_lane(std::uint32_t lane, const Vector3& v, float of_w) {
        x[lane] = v.x();
        y[lane] = v.y();
        z[lane] = v.z();
        w[lane] = of_w;
    }
};

/// Upper bounds of the squared distances: sight^2 in lanes that are asked for; -1, met by none, in others.
template <class Mask>
HWY_INLINE Lanes within(Mask asked, float sight) {
    return hn::IfThenElse(asked, set(sight * sight), set(-1));
}

/// Normal and signed distance of a point's nearest surface.
struct Seen {
    Vector3 normal;
    float distance;
};
/// `front`: the outward direction, of any length. It becomes the normal of a point that is almost on the
/// surface, where rounding decides the direction of the gap.
inline Seen seen_from(const Vector3& gap, const Vector3& front, bool is_solid, const Vector3& q) {
    const float length = gap.norm();
    const bool is_inside = is_solid && gap.dot(front) < 0;
    const bool is_on = length <= 4e-6f * (1e-3f + q.cwiseAbs().maxCoeff());
    Vector3 normal = is_on ? front.stableNormalized() : Vector3((is_inside ? -1 : 1) / length * gap);
    if (normal.isZero(0)) normal = Vector3::UnitY();  // triangles without area have no front
    return {normal, is_inside ? -length : length};
}

/// Search distance [m], and whether a point inside finds the surface at any depth.
struct Sight {
    float far;
    bool deep = true;
};

/// HeldShape::may_be_deeper() of the lanes that are lost.
template <class Mask>
inline Mask may_be_deeper(const HeldShape& shape, const Lanes3& q, Mask lost, float sight) {
    const LaneByLane points(q, hn::IfThenElse(lost, set(1), set(0)));
    LaneByLane answers;
    for (std::uint32_t lane = 0; lane < part_lanes; ++lane)
        if (points.w[lane] != 0 && shape.may_be_deeper(points.vector(lane), sight)) answers.w[lane] = 1;
    return hn::Gt(load_lanes(answers.w), set(0));
}

/// Seen from points beside a triangle's face, farther off than rounding: the lanes, and what seen_from()
/// finds.
struct SeenLanes {
    hn::Mask<Tag> known;
    Lanes3 normal;
    Lanes distance;
};
HWY_INLINE SeenLanes seen_beside_faces(const TriangleTree& tree, const Lanes3& q, const NearestTriangle& best,
                                       const Lanes3& face, Lanes least_weight) {
    const auto squared = [](const Lanes3& v) HWY_ATTR {  // as Eigen sums them
        return hn::Add(hn::Mul(v.x, v.x), hn::Add(hn::Mul(v.y, v.y), hn::Mul(v.z, v.z)));
    };
    const Lanes length = hn::Sqrt(squared(best.gap));
    const Lanes farthest = hn::Max(hn::Abs(q.x), hn::Max(hn::Abs(q.y), hn::Abs(q.z)));
    const auto is_off = hn::Gt(length, hn::Mul(set(4e-6f), hn::Add(set(1e-3f), farthest)));
    const auto is_beside =
        hn::And(hn::Ge(least_weight, set(TriangleTree::on_border)), hn::Gt(squared(face), set(0)));
    const auto is_inside =
        hn::Lt(dot(best.gap, face), set(tree.is_closed() ? 0.0f : -std::numeric_limits<float>::infinity()));
    const Lanes sign = hn::IfThenElse(is_inside, set(-1), set(1));
    return {hn::And(hn::Ge(best.number, set(0)), hn::And(is_off, is_beside)),
            hn::Div(sign, length) * best.gap, hn::IfThenElse(is_inside, hn::Neg(length), length)};
}

/// Normals, signed distances and velocities of the nearest triangles; where there is none, `sight` away.
inline OwnSurface surface_at(const TriangleTree& tree, const Lanes3& q, const NearestTriangle& best,
                             float sight, float rate) {
    const Tag d;
    const hn::RebindToSigned<Tag> di;
    const auto found = hn::Ge(best.number, set(0));
    const auto number = hn::ConvertTo(di, hn::IfThenElseZero(found, best.number));
    const Lanes third[3] = {hn::Sub(hn::Sub(set(1), best.s), best.t), best.s, best.t};
    const auto gather = [&](const Vec3* from, auto rows) HWY_ATTR {
        const auto first = hn::Mul(rows, hn::Set(di, 3));
        return Lanes3{hn::GatherIndex(d, &from->x, first), hn::GatherIndex(d, &from->y, first),
                      hn::GatherIndex(d, &from->z, first)};
    };
    const SeenLanes seen = seen_beside_faces(tree, q, best, gather(tree.face_normals().data(), number),
                                             hn::Min(third[0], hn::Min(third[1], third[2])));
    const auto is_within = hn::And(seen.known, hn::Lt(seen.distance, set(sight)));
    OwnSurface surface{hn::IfThenElse(is_within, seen.distance, set(sight)),
                       either(is_within, seen.normal, {set(0), set(1), set(0)}), zero3()};
    const auto others = hn::AndNot(seen.known, found);
    if (!hn::AllFalse(d, others)) {  // at edges and corners
        const LaneByLane points(q, best.number), gaps(best.gap, best.s), thirds(zero3(), best.t);
        LaneByLane surfaces(surface.normal, surface.distance);
        for (std::uint32_t bits = bits_of(others); bits != 0; bits &= bits - 1) {
            const auto lane = static_cast<std::uint32_t>(std::countr_zero(bits));
            const auto triangle = static_cast<std::uint32_t>(points.w[lane]);
            const std::array<float, 3> weights{1 - gaps.w[lane] - thirds.w[lane], gaps.w[lane],
                                               thirds.w[lane]};
            const Seen at = seen_from(gaps.vector(lane), tree.pseudo_normal(triangle, weights),
                                      tree.is_closed(), points.vector(lane));
            if (at.distance < sight) surfaces.set_lane(lane, at.normal, at.distance);
        }
        const Lanes4 all = surfaces.lanes();
        surface.normal = xyz(all);
        surface.distance = all.w;
    }
    if (rate == 0) return surface;
    for (std::size_t k = 0; k < 3; ++k) {
        static_assert(sizeof(Corners) == 3 * sizeof(std::int32_t));
        const auto* const corners = reinterpret_cast<const std::int32_t*>(&tree.triangle(0));
        const auto corner = hn::GatherIndex(di, corners + k, hn::Mul(number, hn::Set(di, 3)));
        surface.growth = surface.growth + third[k] * gather(tree.displacements().data(), corner);
    }
    surface.growth = keep_where(found, set(rate) * surface.growth);
    return surface;
}

/// A surface that is not found within sight counts as that far away.
template <class Mask>
inline OwnSurface nearest_in(const HeldShape& shape, const TriangleTree& tree, const NearLeaves* leaves,
                             const Lanes3& q, Mask asked, const Sight& sight_of, float rate) {
    const Tag d;
    const float sight = sight_of.far;
    NearestTriangle best{within(asked, sight)};
    if (hn::AllFalse(d, asked)) return {set(sight), {set(0), set(1), set(0)}, zero3()};
    if (leaves == nullptr || !leaves->search(tree, q, asked, sight, best)) search(tree, q, best);
    if (tree.is_closed() && sight_of.deep) {  // points deeper inside than the sight
        const Lanes in_box = squared_distance(q, tree.nodes()[0]);
        auto lost = hn::And(asked, hn::And(hn::Lt(best.number, set(0)), hn::Eq(in_box, set(0))));
        if (!hn::AllFalse(d, lost)) lost = hn::And(lost, may_be_deeper(shape, q, lost, sight));
        if (!hn::AllFalse(d, lost)) {
            NearestTriangle all{within(lost, std::numeric_limits<float>::infinity())};
            search(tree, q, all);
            best.squared = hn::IfThenElse(lost, all.squared, best.squared);
            best.number = hn::IfThenElse(lost, all.number, best.number);
            best.gap = either(lost, all.gap, best.gap);
            best.s = hn::IfThenElse(lost, all.s, best.s);
            best.t = hn::IfThenElse(lost, all.t, best.t);
        }
    }
    return surface_at(tree, q, best, sight, rate);
}

/// Cells of a field from `first` to `last`, both included.
struct CellRange {
    std::array<std::uint32_t, 2> first, last;  // row, column
    [[nodiscard]] std::size_t count() const {
        return std::size_t{last[0] - first[0] + 1} * (last[1] - first[1] + 1);
    }
};
inline CellRange cells_about(const HeldHeights& field, const Vector3& q, float sight) {
    const auto cell = [&](float at, std::uint32_t vertices) {
        const float most = static_cast<float>(vertices - 2);
        return static_cast<std::uint32_t>(std::clamp(std::floor(at / field.spacing), 0.0f, most));
    };
    return {{cell(q.z() - sight, field.rows), cell(q.x() - sight, field.columns)},
            {cell(q.z() + sight, field.rows), cell(q.x() + sight, field.columns)}};
}

inline void search(const HeldHeights& field, const CellRange& range, const Lanes3& q, NearestTriangle& best) {
    for (std::uint32_t row = range.first[0]; row <= range.last[0]; ++row)
        for (std::uint32_t column = range.first[1]; column <= range.last[1]; ++column)
            for (int half = 0; half < 2; ++half) {
                const std::size_t number =
                    2 * (std::size_t{row} * (field.columns - 1) + column) + static_cast<std::size_t>(half);
                const std::array<Vector3, 3> x = field.triangle(row, column, half);
                best.look_at(q, set(static_cast<float>(number)), set3(x[0]), set3(x[1]), set3(x[2]));
            }
}

/// The triangle above or below the point, if there is one: its normal, and the point's distance from its
/// plane, negative below.
inline bool find_column(const HeldHeights& field, const Vector3& q, Seen& seen) {
    const float column = q.x() / field.spacing, row = q.z() / field.spacing;
    if (!(column >= 0 && row >= 0 && column <= static_cast<float>(field.columns - 1) &&
          row <= static_cast<float>(field.rows - 1)))
        return false;
    const CellRange cell = cells_about(field, q, 0);
    const bool is_along_row =
        column - static_cast<float>(cell.first[1]) > row - static_cast<float>(cell.first[0]);
    const std::array<Vector3, 3> x = field.triangle(cell.first[0], cell.first[1], is_along_row ? 0 : 1);
    seen.normal = (x[1] - x[0]).cross(x[2] - x[0]).stableNormalized();
    seen.distance = seen.normal.dot(q - x[0]);
    return true;
}

template <class Mask>
inline OwnSurface nearest_in(const HeldHeights& field, const Lanes3& q, Mask asked, float sight, float) {
    const float finite_sight = std::min(sight, 1e6f);
    const LaneByLane points(q, hn::IfThenElse(asked, set(1), set(0)));
    NearestTriangle best{within(asked, finite_sight)};
    CellRange all{{~0u, ~0u}, {0, 0}};
    std::size_t apart = 0;
    for (std::uint32_t lane = 0; lane < part_lanes; ++lane) {
        if (points.w[lane] == 0 || !points.vector(lane).allFinite()) continue;
        const CellRange own = cells_about(field, points.vector(lane), finite_sight);
        apart += own.count();
        for (std::size_t k = 0; k < 2; ++k) {
            all.first[k] = std::min(all.first[k], own.first[k]);
            all.last[k] = std::max(all.last[k], own.last[k]);
        }
    }
    const bool are_together = apart > 0 && all.count() <= apart;
    if (are_together) search(field, all, q, best);
    for (std::uint32_t lane = 0; lane < part_lanes && apart > 0 && !are_together; ++lane)
        if (points.w[lane] != 0 && points.vector(lane).allFinite())
            search(field, cells_about(field, points.vector(lane), finite_sight), q, best);

    const LaneByLane gaps(best.gap, best.number);
    LaneByLane surfaces;
    for (std::uint32_t lane = 0; lane < part_lanes; ++lane) {
        surfaces.set_lane(lane, Vector3::UnitY(), sight);
        const Vector3 point = points.vector(lane);
        if (points.w[lane] == 0 || !point.allFinite()) continue;
        Seen column{};
        const bool is_over = find_column(field, point, column);
        const bool is_below = is_over && column.distance < 0;
        if (gaps.w[lane] >= 0) {
            const Vector3 gap = gaps.vector(lane);
            const Vector3 front = is_over ? column.normal : gap;
            Seen seen = seen_from(gap, front, false, point);
            if (is_below) seen = {gap.norm() <= 1e-6f ? front : Vector3(-seen.normal), -seen.distance};
            surfaces.set_lane(lane, seen.normal, seen.distance);
        } else if (is_below) {
            surfaces.set_lane(lane, column.normal, column.distance);
        }
    }
    const Lanes4 surface = surfaces.lanes();
    return {surface.w, xyz(surface), zero3()};
}

/// Trilinear distance, and the direction of its gradient; beyond the cells, plus the way to them.
inline Seen distance_at(const HeldDistances& field, const Vector3& q) {
    std::array<std::size_t, 3> first{};
    Vector3 part;
    for (int axis = 0; axis < 3; ++axis) {
        const auto k = static_cast<std::size_t>(axis);
        const float most = static_cast<float>(field.corners[k] - 1);
        const float at = std::clamp((q[axis] - field.origin[axis]) / field.cell, 0.0f, most);
        first[k] = static_cast<std::size_t>(std::min(std::floor(at), most - 1));
        part[axis] = at - static_cast<float>(first[k]);
    }
    float distance = 0;
    Vector3 gradient = Vector3::Zero();
    for (std::size_t corner = 0; corner < 8; ++corner) {
        const std::array<std::size_t, 3> up{corner & 1, corner >> 1 & 1, corner >> 2};
        const std::size_t index =
            first[0] + up[0] +
            field.corners[0] * (first[1] + up[1] + std::size_t{field.corners[1]} * (first[2] + up[2]));
        std::array<float, 3> w{}, slope{};
        for (std::size_t k = 0; k < 3; ++k) {
            const float along = part[static_cast<int>(k)];
            w[k] = up[k] == 1 ? along : 1 - along;
            slope[k] = up[k] == 1 ? 1.0f : -1.0f;
        }
        const float value = field.distances[index];
        distance += w[0] * w[1] * w[2] * value;
        gradient += value * Vector3(slope[0] * w[1] * w[2], w[0] * slope[1] * w[2], w[0] * w[1] * slope[2]);
    }
    const Vector3 cells(static_cast<float>(first[0]), static_cast<float>(first[1]),
                        static_cast<float>(first[2]));
    const float beyond = (q - field.origin - field.cell * (cells + part)).norm();
    const Vector3 normal = gradient.stableNormalized();
    return {normal.isZero(0) ? Vector3(Vector3::UnitY()) : normal,
            beyond > 1e-3f * field.cell ? distance + beyond : distance};
}

template <class Mask>
inline OwnSurface nearest_in(const HeldDistances& field, const Lanes3& q, Mask asked, float sight, float) {
    const LaneByLane points(q, hn::IfThenElse(asked, set(1), set(0)));
    LaneByLane surfaces;
    for (std::uint32_t lane = 0; lane < part_lanes; ++lane) {
        surfaces.set_lane(lane, Vector3::UnitY(), sight);
        if (points.w[lane] == 0 || !points.vector(lane).allFinite()) continue;
        const Seen seen = distance_at(field, points.vector(lane));
        if (seen.distance < sight) surfaces.set_lane(lane, seen.normal, seen.distance);
    }
    const Lanes4 surface = surfaces.lanes();
    return {surface.w, xyz(surface), zero3()};
}

struct OwnHeld {
    static constexpr bool is_swept = true;
    const HeldShape& shape;
    Sight sight;
    float rate;                          // host steps a second, if the shape deforms; else 0
    const NearLeaves* leaves = nullptr;  // leaves near the points; null: search the tree

    [[nodiscard]] bool convex() const { return shape.is_convex(); }
    [[nodiscard]] HWY_INLINE Lanes3 carried(const Lanes3& q) const { return q; }
    /// Whether a point is within sight of the bounding box; the sight includes the length of swept paths.
    [[nodiscard]] HWY_INLINE auto near(const Lanes3& q, Lanes) const {
        const auto beyond = [](Lanes at, float lower, float upper) HWY_ATTR {
            return hn::Max(hn::Sub(set(lower), at), hn::Sub(at, set(upper)));
        };
        const Vector3 &lower = shape.box().min(), &upper = shape.box().max();
        const Lanes of_x = beyond(q.x, lower.x(), upper.x()), of_y = beyond(q.y, lower.y(), upper.y()),
                    of_z = beyond(q.z, lower.z(), upper.z());
        return hn::Lt(hn::Max(of_x, hn::Max(of_y, of_z)), set(sight.far));
    }
    template <class Mask>
    [[nodiscard]] OwnSurface nearest(const Lanes3& q, Mask asked) const {
        const Lanes size = hn::Add(hn::Abs(q.x), hn::Add(hn::Abs(q.y), hn::Abs(q.z)));
        const auto numbers = hn::And(asked, hn::Lt(size, set(1e30f)));
        const HeldShape::Data& data = shape.data();
        if (const auto* const tree = std::get_if<TriangleTree>(&data))
            return nearest_in(shape, *tree, leaves, q, numbers, sight, rate);
        if (const auto* const ground = std::get_if<HeldHeights>(&data))
            return nearest_in(*ground, q, numbers, sight.far, rate);
        return nearest_in(*std::get_if<HeldDistances>(&data), q, numbers, sight.far, rate);
    }
};

}  // namespace weft::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
