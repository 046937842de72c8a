// The edges that a blade cuts along.

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <string>
#include <tuple>

#include <Eigen/Geometry>

#include "cloth/mesh/cutting/check_positions.h"
#include "engine/memory/without_exceptions.h"
#include "engine/vector.h"

namespace weft {

namespace {

using Point = Eigen::Vector3d;

Point point(const Vec3& p) {
    return to_vector(p).cast<double>();
}

/// Six times the volume of a tetrahedron. Its sign is the side of (a, b, c) that d is on.
double volume(const Point& a, const Point& b, const Point& c, const Point& d) {
    return (b - a).cross(c - a).dot(d - a);
}

/// One of the two triangles of the surface that a blade sweeps.
struct Patch {
    Point a, b, c;
    [[nodiscard]] bool has_area() const { return !(b - a).cross(c - a).isZero(0); }

    /// Where the segment from p to q crosses the patch, as a part of the segment. A touch is a crossing.
    [[nodiscard]] std::optional<double> crosses(const Point& p, const Point& q) const {
        const double from = volume(a, b, c, p), to = volume(a, b, c, q);
        if (from == to || from * to > 0) return std::nullopt;
        // The line p q crosses the patch if all three sides of the patch turn the same way about the line.
        const std::array sides{volume(p, q, a, b), volume(p, q, b, c), volume(p, q, c, a)};
        const bool inside = std::ranges::all_of(sides, [](double side) { return side >= 0; }) ||
                            std::ranges::all_of(sides, [](double side) { return side <= 0; });
        if (!inside) return std::nullopt;
        return from / (from - to);
    }
};

class Passed {
  public:
    explicit Passed(const Blade& blade)
        : patches_{Patch{point(blade.was_a), point(blade.was_b), point(blade.is_b)},
                   Patch{point(blade.was_a), point(blade.is_b), point(blade.is_a)}} {}

    /// Whether the end of the edge nearer to the crossing is its first; none: the edge is not crossed.
    [[nodiscard]] std::optional<bool> nearer_is_first(const Vec3& first, const Vec3& second) const {
        // Ends are compared in one order, so that both triangles of an edge get the same answer.
        const auto key = [](const Vec3& p) { return std::tie(p.x, p.y, p.z); };
        if (key(second) < key(first)) {
            const std::optional<bool> turned = nearer_is_first(second, first);
            return turned ? std::optional(!*turned) : std::nullopt;
        }
        const Point p = point(first), q = point(second);
        for (const Patch& patch : patches_)
            if (patch.has_area())
                if (const std::optional<double> at = patch.crosses(p, q)) return *at < 0.5;
        return std::nullopt;
    }

  private:
    std::array<Patch, 2> patches_;
};

Result<void> check_blade(const Blade& blade) {
    for (const Vec3* end : {&blade.was_a, &blade.was_b, &blade.is_a, &blade.is_b})
        if (!to_vector(*end).allFinite())
            return Error{ErrorCode::invalid_argument,
                         "the blade has an end that is not finite; each of its four needs three numbers"};
    return {};
}

/// The path of a cut over the sides of a triangle.
struct Crossings {
    std::array<bool, 3> corners{};  ///< that the cut goes through
    std::uint32_t sides = 0;        ///< number of sides crossed; odd: the cut ends inside
};

Crossings crossings_of(const Passed& passed, const Triangle& triangle, std::span<const Vec3> positions) {
    Crossings found;
    for (std::size_t k = 0; k < 3; ++k) {
        const std::size_t next = (k + 1) % 3;
        const std::optional<bool> first =
            passed.nearer_is_first(positions[triangle[k]], positions[triangle[next]]);
        if (!first) continue;
        found.corners[*first ? k : next] = true;
        ++found.sides;
    }
    return found;
}

/// Moves the stroke's ends in a triangle into the triangle's crossings.
void go_on(CutStroke& stroke, std::uint32_t triangle, Crossings& crossings) {
    std::erase_if(stroke.ends, [&](const CutStroke::Corners& end) {
        if (end.triangle != triangle) return false;
        crossings.corners[end.first] = true;
        ++crossings.sides;
        return true;
    });
}

/// Adds an edge to the stroke, unless it has the edge. Returns whether it was added.
bool add_edge(CutStroke& stroke, const CutStroke::Corners& edge) {
    if (std::ranges::find(stroke.edges, edge) != stroke.edges.end()) return false;
    stroke.edges.push_back(edge);
    return true;
}

/// Adds the edges of a triangle that the cut goes along. Returns whether any is new.
bool pass(CutStroke& stroke, std::uint32_t triangle, Crossings crossings) {
    if (crossings.sides == 0) return false;
    go_on(stroke, triangle, crossings);
    const std::array<bool, 3>& through = crossings.corners;
    bool any = false;
    for (std::uint8_t k = 0; k < 3; ++k) {
        const auto next = static_cast<std::uint8_t>((k + 1) % 3);
        if (through[k] && through[next]) any |= add_edge(stroke, {triangle, k, next});
    }
    if (crossings.sides % 2 == 1) {
        const auto first = std::ranges::find(through, true) - through.begin();
        stroke.ends.push_back({triangle, static_cast<std::uint8_t>(first), 0});
    }
    return any;
}

}  // namespace

Result<std::vector<MeshEdge>> edges_along(const Mesh& mesh, std::span<const Vec3> positions,
                                          const Blade& blade, CutStroke& stroke) {
    return without_exceptions([&]() -> Result<std::vector<MeshEdge>> {
        if (auto checked = check_positions(mesh, positions); !checked) return checked.error();
        if (auto checked = check_blade(blade); !checked) return checked.error();
        const Passed passed(blade);
        CutStroke longer = stroke;
        std::erase_if(longer.edges, [&](const auto& edge) { return edge.triangle >= mesh.triangles.size(); });
        bool goes_on = false;
        for (std::uint32_t t = 0; t < mesh.triangles.size(); ++t)
            goes_on |= pass(longer, t, crossings_of(passed, mesh.triangles[t], positions));
        std::vector<MeshEdge> edges;
        if (goes_on)
            for (const CutStroke::Corners& edge : longer.edges)
                edges.push_back(
                    {mesh.triangles[edge.triangle][edge.first], mesh.triangles[edge.triangle][edge.second]});
        stroke = std::move(longer);
        return edges;
    });
}

}  // namespace weft
