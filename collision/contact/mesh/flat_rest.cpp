#include "collision/contact/mesh/flat_rest.h"

#include <algorithm>
#include <cmath>
#include <Eigen/Core>
#include <Eigen/Geometry>
#include <limits>
#include <numeric>
#include <optional>
#include <vector>

#include "collision/contact/mesh/contact_mesh.h"
#include "engine/memory/list_checks.h"

namespace weft {

namespace {

using Point = Eigen::Vector2d;
using Triangle = std::array<std::uint32_t, 3>;

double cross(const Point& a, const Point& b) {
    return a.x() * b.y() - a.y() * b.x();
}
double twice_area(const std::vector<Point>& chart, const Triangle& t) {
    return cross(chart[t[1]] - chart[t[0]], chart[t[2]] - chart[t[0]]);
}

/// Projects the corners of the triangles along their mean normal into the chart, by vertex. Returns false if
/// there is no mean normal.
bool project(std::span<const Vec4> positions, std::span<const Triangle> triangles,
             std::vector<Point>& chart) {
    const auto at = [&](std::uint32_t i) {
        const Vec4& from = positions[triangles[0][0]];
        return Eigen::Vector3d(double{positions[i].x} - double{from.x},
                               double{positions[i].y} - double{from.y},
                               double{positions[i].z} - double{from.z});
    };
    Eigen::Vector3d normal(0, 0, 0);
    for (const Triangle& t : triangles) normal += (at(t[1]) - at(t[0])).cross(at(t[2]) - at(t[0]));
    if (!(normal.norm() > 0) || !std::isfinite(normal.norm())) return false;
    normal.normalize();
    const Eigen::Vector3d u = normal.unitOrthogonal(), v = normal.cross(u);
    for (const Triangle& t : triangles)
        for (const std::uint32_t i : t) chart[i] = {u.dot(at(i)), v.dot(at(i))};
    return true;
}

/// Lowers least_at[vertex] to the least altitude of its triangles, and returns the least of all. A triangle
/// without area, or turned over, has none above 0.
double take_altitudes(const std::vector<Point>& chart, std::span<const Triangle> triangles,
                      std::vector<double>& least_at) {
    double least = std::numeric_limits<double>::infinity();
    for (const Triangle& t : triangles) {
        double longest = 0;
        for (std::size_t k = 0; k < 3; ++k)
            longest = std::max(longest, (chart[t[(k + 1) % 3]] - chart[t[k]]).norm());
        const double altitude = longest > 0 ? twice_area(chart, t) / longest : 0;
        for (const std::uint32_t i : t) least_at[i] = std::min(least_at[i], altitude);
        least = std::min(least, altitude);
    }
    return least;
}

/// The edges of a single triangle, in its direction. None if two triangles run along a side the same way, or
/// if a side has more than two.
std::optional<std::vector<std::array<std::uint32_t, 2>>> border_of(std::span<const Triangle> triangles) {
    std::vector<std::array<std::uint32_t, 2>> sides;
    for (const Triangle& t : triangles)
        for (std::size_t k = 0; k < 3; ++k) sides.push_back({t[k], t[(k + 1) % 3]});
    std::ranges::sort(sides);
    if (std::ranges::adjacent_find(sides) != sides.end()) return std::nullopt;
    std::vector<std::array<std::uint32_t, 2>> border;
    for (const auto& [from, to] : sides)
        if (!std::ranges::binary_search(sides, std::array{to, from})) border.push_back({from, to});
    return border;
}

/// By particle, the number of a particle that represents its connected piece.
std::vector<std::uint32_t> pieces_of(std::span<const Triangle> triangles, std::size_t particles) {
    std::vector<std::uint32_t> parent(particles);
    std::iota(parent.begin(), parent.end(), 0u);
    const auto root = [&](std::uint32_t i) {
        while (parent[i] != i) i = parent[i] = parent[parent[i]];
        return i;
    };
    for (const Triangle& t : triangles) {
        parent[root(t[1])] = root(t[0]);
        parent[root(t[2])] = root(t[0]);
    }
    for (std::uint32_t i = 0; i < particles; ++i) parent[i] = root(i);
    return parent;
}

/// The convex hull, counter-clockwise (Andrew 1979).
std::vector<Point> convex_hull(std::vector<Point> points) {
    std::ranges::sort(points, [](const Point& a, const Point& b) {
        return a.x() < b.x() || (a.x() == b.x() && a.y() < b.y());
    });
    std::vector<Point> hull;
    for (int half = 0; half < 2; ++half) {
        const std::size_t first = hull.size();
        for (const Point& p : points) {
            while (hull.size() >= first + 2 &&
                   cross(hull.back() - hull[hull.size() - 2], p - hull.back()) <= 0)
                hull.pop_back();
            hull.push_back(p);
        }
        hull.pop_back();
        std::ranges::reverse(points);
    }
    return hull;
}

/// Whether triangles of one piece fill the hull of their border once. If all have one orientation and the
/// border runs along the hull, they cover it a whole number of times, given by the sum of their areas. The
/// border may depart from it by 0.01 of the least altitude, which the margins in are_calm() allow for.
bool fills_its_hull(const std::vector<Point>& chart, std::span<const Triangle> triangles, double altitude) {
    const auto border = border_of(triangles);
    if (!border || border->empty()) return false;
    std::vector<Point> ends;
    for (const auto& side : *border) ends.push_back(chart[side[0]]);
    const std::vector<Point> hull = convex_hull(ends);
    if (hull.size() < 3) return false;

    double area = 0, hull_area = 0;
    for (const Triangle& t : triangles) area += twice_area(chart, t);
    for (std::size_t k = 1; k + 1 < hull.size(); ++k)
        hull_area += cross(hull[k] - hull[0], hull[k + 1] - hull[0]);
    if (area > 1.5 * hull_area) return false;

    const auto is_at_hull = [&](const Point& p) {
        for (std::size_t k = 0; k < hull.size(); ++k) {
            const Point along = hull[(k + 1) % hull.size()] - hull[k];
            if (cross(along, p - hull[k]) <= 0.01 * altitude * along.norm()) return true;
        }
        return false;
    };
    return std::ranges::all_of(*border, [&](const auto& side) {
        const Point a = chart[side[0]], b = chart[side[1]];
        return is_at_hull(a) && is_at_hull(b) && is_at_hull(0.5 * (a + b));
    });
}

struct Rectangle {
    Eigen::Array2d lower = Eigen::Array2d::Constant(std::numeric_limits<double>::infinity());
    Eigen::Array2d upper = -lower;

    void add(const Point& p) {
        lower = lower.min(p.array());
        upper = upper.max(p.array());
    }
    [[nodiscard]] Rectangle joined(const Rectangle& other) const {
        Rectangle both;
        both.lower = lower.min(other.lower);
        both.upper = upper.max(other.upper);
        return both;
    }
    /// Whether the overlap is more than `least` along both axes.
    [[nodiscard]] bool overlaps(const Rectangle& other, double least) const {
        return (lower + least < other.upper).all() && (other.lower + least < upper).all();
    }
};

/// All corners of a patch's features.
std::span<const std::uint32_t> corners_of(const FlatRest::Features& of, const ContactPatch& patch) {
    return of.corner_slots.corners[0].span().subspan(patch.corners.first, patch.corners.count);
}

/// By patch, the patches that share a corner with it, itself among them.
std::vector<std::vector<std::uint32_t>> patches_beside(const FlatRest::Features& of) {
    std::vector<std::vector<std::uint32_t>> patches_at(of.rest_positions.size()), beside(of.patches.size());
    const auto add = [](std::vector<std::uint32_t>& list, std::uint32_t value) {
        if (list.empty() || list.back() != value) list.push_back(value);
    };
    for (std::uint32_t p = 0; p < of.patches.size(); ++p)
        for (const std::uint32_t i : corners_of(of, of.patches[p])) add(patches_at[i], p);
    for (std::uint32_t p = 0; p < of.patches.size(); ++p) {
        for (const std::uint32_t i : corners_of(of, of.patches[p]))
            for (const std::uint32_t q : patches_at[i]) beside[p].push_back(q);
        std::ranges::sort(beside[p]);
        const auto spare = std::ranges::unique(beside[p]);
        beside[p].erase(spare.begin(), spare.end());
    }
    return beside;
}

/// The charts of the pieces of a mesh that have one.
struct Charts {
    static constexpr std::uint32_t none = ~0u;

    std::vector<Point> at;                                   // by particle: the place in the chart
    std::vector<double> altitude_at;                         // by particle: the least of its triangles
    double least = std::numeric_limits<double>::infinity();  // the least of all charts
    std::vector<std::uint32_t> piece;                        // by particle
    std::vector<bool> is_flat;                               // by piece

    explicit Charts(const FlatRest::Features& of)
        : at(of.rest_positions.size(), Point(0, 0)),
          altitude_at(at.size(), std::numeric_limits<double>::infinity()),
          piece(pieces_of(of.triangles, at.size())),
          is_flat(at.size()) {
        std::vector<Triangle> triangles(of.triangles.begin(), of.triangles.end());
        const auto of_triangle = [&](const Triangle& t) { return piece[t[0]]; };
        std::ranges::stable_sort(triangles, {}, of_triangle);
        for (std::size_t begin = 0; begin < triangles.size();) {
            const std::uint32_t here = of_triangle(triangles[begin]);
            std::size_t end = begin;
            while (end < triangles.size() && of_triangle(triangles[end]) == here) ++end;
            const auto own = std::span<const Triangle>(triangles).subspan(begin, end - begin);
            begin = end;
            if (!project(of.rest_positions, own, at)) continue;
            const double altitude = take_altitudes(at, own, altitude_at);
            if (!(altitude > 0) || !fills_its_hull(at, own, altitude)) continue;
            is_flat[here] = true;
            least = std::min(least, altitude);
        }
    }
    [[nodiscard]] bool empty() const { return !std::isfinite(least); }
    [[nodiscard]] bool has(std::uint32_t particle) const { return is_flat[piece[particle]]; }
    /// The piece that has all these particles, if there is one and it has a chart.
    [[nodiscard]] std::uint32_t piece_of(std::span<const std::uint32_t> particles) const {
        const std::uint32_t here = piece[particles[0]];
        const auto is_here = [&](std::uint32_t i) { return piece[i] == here; };
        return is_flat[here] && std::ranges::all_of(particles, is_here) ? here : none;
    }
};

}  // namespace

FlatRest::FlatRest(const Features& features) {
    const Charts charts(features);
    if (charts.empty()) return;
    const auto& corners = features.triangle_slots.corners;
    for (SharedBuffer<float>& values : inverse_) values = SharedBuffer<float>(corners[0].size());
    for (std::uint32_t s = 0; s < corners[0].size(); ++s) {
        if (!charts.has(corners[0][s])) continue;
        Eigen::Matrix2d sides;
        sides << charts.at[corners[1][s]] - charts.at[corners[0][s]],
            charts.at[corners[2][s]] - charts.at[corners[0][s]];
        const Eigen::Matrix2d inverse = sides.inverse();
        for (std::uint32_t k = 0; k < 4; ++k) inverse_[k][s] = static_cast<float>(inverse(k / 2, k % 2));
    }

    const std::size_t count = features.patches.size();
    std::vector<Rectangle> rectangles(count);
    std::vector<double> heights(count, std::numeric_limits<double>::infinity());
    // By patch, the piece if it has a chart; a patch of several pieces has none.
    std::vector<std::uint32_t> pieces(count);
    for (std::size_t p = 0; p < count; ++p) {
        pieces[p] = charts.piece_of(corners_of(features, features.patches[p]));
        for (const std::uint32_t i : corners_of(features, features.patches[p])) {
            rectangles[p].add(charts.at[i]);
            heights[p] = std::min(heights[p], charts.altitude_at[i]);
        }
    }

    const auto beside = patches_beside(features);
    // Patches not below p and within its height: they may face one another across a corner of others.
    std::vector<std::uint32_t> near;
    const auto patches_near = [&](std::uint32_t p) -> const std::vector<std::uint32_t>& {
        near.clear();
        if (pieces[p] == Charts::none) return near;
        for (const std::uint32_t q : beside[p])
            for (const std::uint32_t r : beside[q])
                if (r >= p && pieces[r] == pieces[p] && rectangles[p].overlaps(rectangles[r], -heights[p]))
                    near.push_back(r);
        std::ranges::sort(near);
        const auto spare = std::ranges::unique(near);
        near.erase(spare.begin(), spare.end());
        return near;
    };

    // Adds the triangles of a patch that overlap a region of a chart. The margins in are_calm() allow for an
    // overlap below 1e-4 of the least altitude.
    std::vector<TriangleGroup> covers;
    const auto cover = [&](const Rectangle& region, std::uint32_t piece, const SlotSpan& triangles) {
        const std::size_t begin = covers.size();
        for (std::uint32_t k = 0; k < triangles.count; ++k) {
            const std::uint32_t slot = triangles.first + k;
            Rectangle triangle;
            for (const auto& corner : corners) triangle.add(charts.at[corner[slot]]);
            if (charts.piece[corners[0][slot]] != piece || !region.overlaps(triangle, 1e-4 * charts.least))
                continue;
            if (covers.size() == begin || covers.back().number != slot / 16) covers.push_back({slot / 16, 0});
            covers.back().triangles |= 1u << slot % 16;
        }
    };

    std::vector<std::uint32_t> seen_for(count), walk, starts{0};
    std::vector<PatchNeighbours> neighbours;
    std::uint32_t pair = 0;
    for (std::uint32_t p = 0; p < count; ++p) {
        for (const std::uint32_t q : patches_near(p)) {
            const auto begin = static_cast<std::uint32_t>(covers.size());
            const Rectangle around = rectangles[p].joined(rectangles[q]);
            // Triangles in a convex region are connected: a walk from patch to patch finds all.
            ++pair;
            walk.assign(1, p);
            seen_for[p] = pair;
            for (std::size_t k = 0; k < walk.size(); ++k) {
                cover(around, pieces[p], features.patches[walk[k]].triangles);
                for (const std::uint32_t r : beside[walk[k]]) {
                    if (seen_for[r] == pair) continue;
                    seen_for[r] = pair;
                    if (around.overlaps(rectangles[r], 1e-4 * charts.least)) walk.push_back(r);
                }
            }
            neighbours.push_back({q, begin, static_cast<std::uint32_t>(covers.size()),
                                  static_cast<float>(std::min(heights[p], heights[q]))});
        }
        starts.push_back(static_cast<std::uint32_t>(neighbours.size()));
    }
    starts_ = SharedBuffer<std::uint32_t>(starts);
    neighbours_ = SharedBuffer<PatchNeighbours>(neighbours);
    covers_ = SharedBuffer<TriangleGroup>(covers);
}

bool FlatRest::is_sound(std::size_t patches, std::size_t triangle_slots) const {
    const bool is_empty = starts_.empty() && neighbours_.empty() && covers_.empty();
    const auto fits = [&](const SharedBuffer<float>& values) {
        return values.size() == (is_empty ? 0 : triangle_slots);
    };
    const auto is_of_patches = [&](const PatchNeighbours& pair) {
        return pair.other < patches && pair.begin <= pair.end && pair.end <= covers_.size();
    };
    return std::ranges::all_of(inverse_, fits) &&
           (is_empty || are_offsets(starts_.span(), patches, neighbours_.size())) &&
           std::ranges::all_of(neighbours_, is_of_patches) &&
           std::ranges::all_of(
               covers_, [&](const TriangleGroup& group) { return group.number < triangle_slots / 16; });
}

bool FlatRest::has_all_triangles() const noexcept {
    for (std::size_t s = 0; s < inverse_[0].size(); ++s)
        if (inverse_[0][s] == 0 && inverse_[1][s] == 0) return false;
    return !is_empty();
}

// The isometry of the polar decomposition, G (G^T G)^(-1/2).
ChartFrame nearest_frame(const ChartFrame& gradient) noexcept {
    const auto& [ux, uy, uz, vx, vy, vz] = gradient;
    const float uu = ux * ux + uy * uy + uz * uz, vv = vx * vx + vy * vy + vz * vz;
    const float uv = ux * vx + uy * vy + uz * vz;
    const float area = std::sqrt(uu * vv - uv * uv);
    constexpr float none = std::numeric_limits<float>::infinity();
    // For a gradient that is nearly a line, the frame would be all rounding.
    if (!(area > 0.01f * (uu + vv))) return {none, none, none, none, none, none};
    const float scale = 1 / (area * std::sqrt(uu + vv + 2 * area));
    const float a = scale * (vv + area), b = -scale * uv, d = scale * (uu + area);
    return {a * ux + b * vx, a * uy + b * vy, a * uz + b * vz,
            b * ux + d * vx, b * uy + d * vy, b * uz + d * vz};
}

float PatchStrain::spread_with(const PatchStrain& other) const noexcept {
    float squared = 0;
    for (std::size_t k = 0; k < 3; ++k) {
        const float least = std::min({least_motion[k], other.least_motion[k], 0.0f});
        const float most = std::max({most_motion[k], other.most_motion[k], 0.0f});
        squared += (most - least) * (most - least);
    }
    return std::sqrt(squared);
}

std::size_t FlatRest::bytes() const noexcept {
    std::size_t sum = starts_.bytes() + covers_.bytes() + neighbours_.bytes();
    for (const SharedBuffer<float>& values : inverse_) sum += values.bytes();
    return sum;
}

}  // namespace weft
