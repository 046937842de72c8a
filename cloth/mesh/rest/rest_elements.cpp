#include "cloth/mesh/rest/rest_elements.h"

#include <algorithm>
#include <cmath>
#include <span>
#include <tuple>

#include "cloth/mesh/rest/bending.h"

namespace weft {

namespace {

/// The direction in space whose projection onto a triangle is its warp.
Vector3 warp_direction(const ClothModel& model, std::uint32_t triangle, const Vector3& normal) {
    const Triangle& corners = model.triangles[triangle];
    if (model.columns > 0) {
        for (std::size_t k = 0; k < 3; ++k) {
            const std::uint32_t a = corners[k], b = corners[(k + 1) % 3];
            if (a / model.columns == b / model.columns)
                return xyz(model.positions[std::max(a, b)]) - xyz(model.positions[std::min(a, b)]);
        }
    }
    return std::abs(normal.y()) < 0.9f ? Vector3::UnitY() : Vector3::UnitX();
}

/// One side of a triangle, which begins at `corner`.
struct TriangleSide {
    std::uint32_t low, high;  ///< particles, low < high
    std::uint32_t triangle, corner;
};

std::vector<TriangleSide> sides_by_edge(const ClothModel& model) {
    std::vector<TriangleSide> sides;
    sides.reserve(3 * model.triangles.size());
    for (std::uint32_t t = 0; t < model.triangles.size(); ++t) {
        for (std::uint32_t k = 0; k < 3; ++k) {
            const std::uint32_t a = model.triangles[t][k], b = model.triangles[t][(k + 1) % 3];
            sides.push_back({std::min(a, b), std::max(a, b), t, k});
        }
    }
    std::ranges::sort(sides, [](const TriangleSide& p, const TriangleSide& q) {
        return std::tie(p.low, p.high, p.triangle) < std::tie(q.low, q.high, q.triangle);
    });
    return sides;
}

/// A side and the triangle's apex above it, at rest.
struct RestSide {
    float length, area, cot_start, cot_end;
    std::uint32_t start, end, apex;  ///< particles
    float factor;                    ///< sliver_factor
    Eigen::Vector2d warp;            ///< unit: along the side, and from it towards the apex
};

RestSide rest_side(const ClothModel& model, std::uint32_t triangle, std::uint32_t corner) {
    const RestSides sides = rest_sides(model, triangle);
    const std::array<Eigen::Vector2f, 3> at{Eigen::Vector2f::Zero(), sides.to1, sides.to2};
    const std::uint32_t end = (corner + 1) % 3, apex = (corner + 2) % 3;
    const Eigen::Vector2f side = at[end] - at[corner], to_apex = at[apex] - at[corner];
    const float turn = side.x() * to_apex.y() - side.y() * to_apex.x(), twice_area = std::abs(turn);
    const Eigen::Vector2d along = side.cast<double>().normalized();
    const Triangle& particles = model.triangles[triangle];
    return {.length = side.norm(),
            .area = 0.5f * twice_area,
            .cot_start = side.dot(to_apex) / twice_area,
            .cot_end = side.dot(side - to_apex) / twice_area,
            .start = particles[corner],
            .end = particles[end],
            .apex = particles[apex],
            .factor = static_cast<float>(sliver_factor(sides)),
            .warp = {along.x(), turn > 0 ? -along.y() : along.y()}};
}

/// The fabric's rigidity at a hinge, whose x runs along the first triangle's side: the mean over both.
Rigidity rigidity_at(const RestSide& a, const RestSide& b, float ratio) {
    // The second apex is on the other side of the edge. Its side runs against the first one or along it.
    const double turned = a.start == b.end ? 1 : -1;
    const auto about = [&](const Eigen::Vector2d& warp) {
        return rigidity_about(warp, static_cast<double>(ratio));
    };
    const double one = static_cast<double>(a.area), other = static_cast<double>(b.area);
    return (one * about(a.warp) + other * about({b.warp.x(), turned * b.warp.y()})) / (one + other);
}

/// Makes a hinge. If its triangles are wound against each other, the second counts as seen from behind.
Hinge make_hinge(const ClothModel& model, const RestSide& a, const RestSide& b, double rigidity) {
    const bool agree = a.start == b.end;
    const float b_at_start = agree ? b.cot_end : b.cot_start, b_at_end = agree ? b.cot_start : b.cot_end;
    const float length = 0.5f * (a.length + b.length);
    Hinge hinge{.particles = {a.start, a.end, a.apex, b.apex},
                .q = {-(a.cot_end + b_at_end), -(a.cot_start + b_at_start), a.cot_start + a.cot_end,
                      b.cot_start + b.cot_end},
                .feet = {a.cot_start, b_at_start},
                .length = length,
                .least_height = 2 * std::min(a.area, b.area) / length,
                .angle = 0,
                .rigidity = static_cast<float>(rigidity),
                .weight = 1 / (a.area + b.area),
                .softening = std::min(a.factor, b.factor)};
    hinge.weight *= hinge.softening * hinge.rigidity;
    if (model.panel_sides.empty()) {
        std::array<Vector3, 4> x;
        std::ranges::transform(hinge.particles, x.begin(),
                               [&](std::uint32_t i) { return xyz(model.positions[i]); });
        hinge.angle = dihedral(x, 0.0f).angle;
    }
    return hinge;
}

/// m m^T : D n n^T of the normals of a triangle's two sides at a corner. These enclose the angle that the
/// sides do.
float coupling_at(const ClothModel& model, std::uint32_t triangle, std::uint32_t corner,
                  const RestSide& side) {
    if (model.bending_ratio == 1) {
        const float squared = side.cot_start * side.cot_start;
        return squared / (1 + squared);
    }
    const auto normal_of = [&](std::uint32_t from) {
        const Eigen::Vector2d warp = rest_side(model, triangle, from).warp;
        return squared({-warp.y(), warp.x()});
    };
    const Rigidity rigidity =
        rigidity_about(Eigen::Vector2d::UnitX(), static_cast<double>(model.bending_ratio));
    return static_cast<float>(normal_of(corner).dot(rigidity * normal_of((corner + 2) % 3)));
}

/// Appends the pairs among one triangle's hinges, given by its sides: side k runs from corner k to the next.
void append_pairs(const ClothModel& model, std::uint32_t triangle, std::span<const std::uint32_t> of_sides,
                  Bending& bending) {
    for (std::uint32_t k = 0; k < 3; ++k) {
        const std::uint32_t one = of_sides[k], other = of_sides[(k + 2) % 3];
        if (one == Bending::no_hinge || other == Bending::no_hinge) continue;
        // Both sides meet at corner k.
        const RestSide side = rest_side(model, triangle, k);
        const auto weight_of = [&](const Hinge& hinge) { return hinge.weight / hinge.rigidity; };
        const float share = side.area * weight_of(bending.hinges[one]) * weight_of(bending.hinges[other]);
        bending.pairs.push_back({one, other, coupling_at(model, triangle, k, side) * share});
    }
}

}  // namespace

RestSides rest_sides(const ClothModel& model, std::uint32_t triangle) {
    if (!model.panel_sides.empty()) {
        const auto& sides = model.panel_sides[triangle];
        return {{sides[0].x, sides[0].y}, {sides[1].x, sides[1].y}};
    }
    const Triangle& corners = model.triangles[triangle];
    const Vector3 origin = xyz(model.positions[corners[0]]);
    const Vector3 to1 = xyz(model.positions[corners[1]]) - origin,
                  to2 = xyz(model.positions[corners[2]]) - origin;
    const Vector3 normal = to1.cross(to2).normalized(), along = warp_direction(model, triangle, normal);
    const Vector3 warp = (along - along.dot(normal) * normal).normalized(), weft = normal.cross(warp);
    return {{to1.dot(warp), to1.dot(weft)}, {to2.dot(warp), to2.dot(weft)}};
}

double sliver_factor(const RestSides& sides) {
    const Eigen::Vector2d to1 = sides.to1.cast<double>(), to2 = sides.to2.cast<double>();
    const double twice_area = std::abs(to1.x() * to2.y() - to1.y() * to2.x());
    const double longest = std::max({to1.squaredNorm(), to2.squaredNorm(), (to2 - to1).squaredNorm()});
    if (!(twice_area < least_bending_height * longest)) return 1;
    const double part = twice_area / (least_bending_height * longest);
    return part * part * part;
}

std::array<Eigen::Vector2d, 4> flat_hinge(const Hinge& hinge) {
    // q_2 and q_3 are the sums of a triangle's two cotangents: length over height. The cotangent at the
    // edge's start is where the apex stands over it.
    const double length = static_cast<double>(hinge.length);
    const auto apex = [&](std::size_t k, double side) {
        const double height = length / static_cast<double>(hinge.q[k]);
        return Eigen::Vector2d(static_cast<double>(hinge.feet[k - 2]) * height, side * height);
    };
    return {Eigen::Vector2d(0, 0), Eigen::Vector2d(length, 0), apex(2, 1), apex(3, -1)};
}

Bending bending_elements(const ClothModel& model) {
    const std::vector<TriangleSide> sides = sides_by_edge(model);
    Bending result;
    result.of_sides.assign(sides.size(), Bending::no_hinge);
    for (std::size_t s = 1; s < sides.size(); ++s) {
        const TriangleSide &one = sides[s - 1], &other = sides[s];
        if (one.low != other.low || one.high != other.high) continue;
        for (const TriangleSide& side : {one, other})
            result.of_sides[3 * std::size_t{side.triangle} + side.corner] =
                static_cast<std::uint32_t>(result.hinges.size());
        const RestSide a = rest_side(model, one.triangle, one.corner),
                       b = rest_side(model, other.triangle, other.corner);
        double across = 1;
        if (model.bending_ratio != 1)
            across = result.rigidities.emplace_back(rigidity_at(a, b, model.bending_ratio))(1, 1);
        result.hinges.push_back(make_hinge(model, a, b, across));
    }
    for (std::uint32_t t = 0; t < model.triangles.size(); ++t)
        append_pairs(model, t, std::span(std::as_const(result.of_sides)).subspan(3 * std::size_t{t}, 3),
                     result);
    return result;
}

}  // namespace weft
