#include "collision/contact/flat_rest.h"

#include <algorithm>
#include <cmath>
#include <Eigen/Core>
#include <Eigen/Geometry>
#include <limits>
#include <numeric>
#include <optional>

#include "collision/contact/contact_mesh.h"

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

/// Points seen along the mean normal of the triangles. None if that is no direction.
std::optional<std::vector<Point>> project(std::span<const Vec4> positions,
                                          std::span<const Triangle> triangles) {
    const auto at = [&](std::uint32_t i) {
        const Vec4& from = positions[triangles[0][0]];
        return Eigen::Vector3d(double{positions[i].x} - double{from.x},
                               double{positions[i].y} - double{from.y},
                               double{positions[i].z} - double{from.z});
    };
    Eigen::Vector3d normal(0, 0, 0);
    for (const Triangle& t : triangles) normal += (at(t[1]) - at(t[0])).cross(at(t[2]) - at(t[0]));
    if (!(normal.norm() > 0) || !std::isfinite(normal.norm())) return std::nullopt;
    normal.normalize();
    const Eigen::Vector3d u = normal.unitOrthogonal(), v = normal.cross(u);
    std::vector<Point> chart(positions.size(), Point(0, 0));
    for (const Triangle& t : triangles)
        for (const std::uint32_t i : t) chart[i] = {u.dot(at(i)), v.dot(at(i))};
    return chart;
}

/// By vertex: the least altitude of its triangles. A triangle without area, or turned over, has none above 0.
std::vector<double> altitudes(const std::vector<Point>& chart, std::span<const Triangle> triangles) {
    std::vector<double> least(chart.size(), std::numeric_limits<double>::infinity());
    for (const Triangle& t : triangles) {
        double longest = 0;
        for (std::size_t k = 0; k < 3; ++k)
            longest = std::max(longest, (chart[t[(k + 1) % 3]] - chart[t[k]]).norm());
        const double altitude = longest > 0 ? twice_area(chart, t) / longest : 0;
        for (const std::uint32_t i : t) least[i] = std::min(least[i], altitude);
    }
    return least;
}

/// Edges of one triangle, in its direction. None if a side is of two triangles that both run along it the
/// same way, or of more.
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

bool is_connected(std::span<const Triangle> triangles, std::size_t particles) {
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
    const std::uint32_t one = root(triangles[0][0]);
    return std::ranges::all_of(triangles, [&](const Triangle& t) { return root(t[0]) == one; });
}

/// Counter-clockwise (Andrew 1979).
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

/// Triangles that all turn one way, side on side, with a border that runs along the hull, cover the hull a
/// whole number of times: the sum of their areas says how often. The border may miss it by a hundredth of the
/// least altitude, which the margins of keeps_apart() make good.
bool fills_its_hull(const std::vector<Point>& chart, std::span<const Triangle> triangles, double altitude) {
    const auto border = border_of(triangles);
    if (!border || border->empty() || !is_connected(triangles, chart.size())) return false;
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
    /// By more than `least`.
    [[nodiscard]] bool overlaps(const Rectangle& other, double least) const {
        return (lower + least < other.upper).all() && (other.lower + least < upper).all();
    }
};

/// visit(particle) for all corners of a patch's features.
template <class Visit>
void for_each_corner(const FlatRest::Features& of, const ContactPatch& patch, const Visit& visit) {
    const std::uint32_t* const corners = &of.corner_slots.corners[0][patch.corners.first];
    for (std::uint32_t k = 0; k < patch.corners.count; ++k) visit(corners[k]);
}

/// By patch, those that share a corner with it, itself among them.
std::vector<std::vector<std::uint32_t>> patches_beside(const FlatRest::Features& of) {
    std::vector<std::vector<std::uint32_t>> patches_at(of.rest_positions.size()), beside(of.patches.size());
    const auto add = [](std::vector<std::uint32_t>& list, std::uint32_t value) {
        if (list.empty() || list.back() != value) list.push_back(value);
    };
    for (std::uint32_t p = 0; p < of.patches.size(); ++p)
        for_each_corner(of, of.patches[p], [&](std::uint32_t i) { add(patches_at[i], p); });
    for (std::uint32_t p = 0; p < of.patches.size(); ++p) {
        for_each_corner(of, of.patches[p], [&](std::uint32_t i) {
            for (const std::uint32_t q : patches_at[i]) beside[p].push_back(q);
        });
        std::ranges::sort(beside[p]);
        const auto spare = std::ranges::unique(beside[p]);
        beside[p].erase(spare.begin(), spare.end());
    }
    return beside;
}

}  // namespace

FlatRest::FlatRest(const Features& features) {
    if (features.triangles.empty()) return;
    const auto chart = project(features.rest_positions, features.triangles);
    if (!chart) return;
    const std::vector<double> altitude_at = altitudes(*chart, features.triangles);
    const double least = *std::ranges::min_element(altitude_at);
    if (!(least > 0) || !fills_its_hull(*chart, features.triangles, least)) return;

    const auto& corners = features.triangle_slots.corners;
    for (AlignedBuffer<float>& values : inverse_) values = AlignedBuffer<float>(corners[0].size());
    for (std::uint32_t s = 0; s < corners[0].size(); ++s) {
        Eigen::Matrix2d sides;
        sides << (*chart)[corners[1][s]] - (*chart)[corners[0][s]],
            (*chart)[corners[2][s]] - (*chart)[corners[0][s]];
        const Eigen::Matrix2d inverse = sides.inverse();
        for (std::uint32_t k = 0; k < 4; ++k) inverse_[k][s] = static_cast<float>(inverse(k / 2, k % 2));
    }

    const std::size_t count = features.patches.size();
    std::vector<Rectangle> rectangles(count);
    std::vector<double> heights(count, std::numeric_limits<double>::infinity());
    for (std::size_t p = 0; p < count; ++p)
        for_each_corner(features, features.patches[p], [&](std::uint32_t i) {
            rectangles[p].add((*chart)[i]);
            heights[p] = std::min(heights[p], altitude_at[i]);
        });

    const auto beside = patches_beside(features);
    // Not below p, and no farther than some reach: patches may face one another across a corner of others.
    std::vector<std::uint32_t> near;
    const auto patches_near = [&](std::uint32_t p) -> const std::vector<std::uint32_t>& {
        near.clear();
        for (const std::uint32_t q : beside[p])
            for (const std::uint32_t r : beside[q])
                if (r >= p && rectangles[p].overlaps(rectangles[r], -heights[p])) near.push_back(r);
        std::ranges::sort(near);
        const auto spare = std::ranges::unique(near);
        near.erase(spare.begin(), spare.end());
        return near;
    };

    std::vector<std::uint32_t> seen_for(count);
    std::uint32_t pair = 0;
    starts_.push_back(0);
    for (std::uint32_t p = 0; p < count; ++p) {
        for (const std::uint32_t q : patches_near(p)) {
            const auto begin = static_cast<std::uint32_t>(covers_.size());
            const Rectangle around = rectangles[p].joined(rectangles[q]);
            // Triangles under a convex region hang together: from patch to patch all are found.
            ++pair;
            covers_.push_back(p);
            seen_for[p] = pair;
            for (std::size_t k = begin; k < covers_.size(); ++k)
                for (const std::uint32_t r : beside[covers_[k]]) {
                    if (seen_for[r] == pair) continue;
                    seen_for[r] = pair;
                    if (around.overlaps(rectangles[r], 1e-4 * least)) covers_.push_back(r);
                }
            neighbours_.push_back({q, begin, static_cast<std::uint32_t>(covers_.size()),
                                   static_cast<float>(std::min(heights[p], heights[q]))});
        }
        starts_.push_back(static_cast<std::uint32_t>(neighbours_.size()));
    }
}

bool FlatRest::keeps_apart(const PatchNeighbours& pair, std::uint32_t patch, float reach,
                           const PatchStrain* strains) const noexcept {
    using Six = Eigen::Array<float, 6, 1>;
    using Three = Eigen::Array3f;
    const auto six = [](const std::array<float, 6>& a) { return Eigen::Map<const Six>(a.data()); };
    const auto three = [](const std::array<float, 3>& a) { return Eigen::Map<const Three>(a.data()); };
    Six lower = six(strains[patch].lower), upper = six(strains[patch].upper);
    for (std::uint32_t k = pair.begin; k < pair.end; ++k) {
        const PatchStrain& strain = strains[covers_[k]];
        lower = lower.min(six(strain.lower));
        upper = upper.max(six(strain.upper));
    }
    const Six mean = 0.5f * (lower + upper);
    const float deviation = (0.5f * (upper - lower)).matrix().norm();
    const auto along_u = mean.head<3>().matrix(), along_v = mean.tail<3>().matrix();
    const float uu = along_u.squaredNorm(), vv = along_v.squaredNorm(), uv = along_u.dot(along_v);
    const float half = 0.5f * (uu - vv);
    const float least_squared = 0.5f * (uu + vv) - std::sqrt(half * half + uv * uv);

    const PatchStrain &a = strains[patch], &b = strains[pair.other];
    const Three least = three(a.least_motion).min(three(b.least_motion)).min(0.0f);
    const Three most = three(a.most_motion).max(three(b.most_motion)).max(0.0f);
    const float spread = (most - least).matrix().norm();

    // Margins: for rounding, for a border that is not quite convex, for patches that cover by next to
    // nothing.
    const float shrunk = std::sqrt(std::max(least_squared, 0.0f)) - 1.05f * deviation;
    return uu + vv < 400 && 0.97f * shrunk * pair.height > 1.001f * (reach + spread);
}

std::size_t FlatRest::bytes() const noexcept {
    std::size_t sum = (starts_.size() + covers_.size()) * sizeof(std::uint32_t) +
                      neighbours_.size() * sizeof(PatchNeighbours);
    for (const AlignedBuffer<float>& values : inverse_) sum += values.bytes();
    return sum;
}

}  // namespace weft
