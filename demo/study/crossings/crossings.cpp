#include "demo/study/crossings/crossings.h"

#include <algorithm>
#include <array>

#include "demo/study/crossings/box_tree.h"
#include "demo/study/crossings/orientation.h"

namespace weft::study {

namespace {

using Corners = std::array<Vec3, 3>;
using Sides = std::array<int, 3>;

Corners corners_of(const TriangleSoup& soup, std::uint32_t triangle) {
    const auto& [a, b, c] = soup.triangles[triangle];
    return {soup.points[a], soup.points[b], soup.points[c]};
}

/// For each of `other`'s corners, its side of the triangle's plane.
Sides sides_of(const Corners& triangle, const Corners& other) {
    Sides sides;
    for (std::size_t k = 0; k < 3; ++k)
        sides[k] = orientation(triangle[0], triangle[1], triangle[2], other[k]);
    return sides;
}

bool on_both_sides(const Sides& sides) {
    const auto [least, most] = std::ranges::minmax(sides);
    return least < 0 && most > 0;
}

/// Rotates the corners so that the first one is alone on its side of the other triangle's plane. The other
/// triangle is flipped if that is not its positive side. Where sides are -1, 0 and 1, either end counts as
/// alone.
void put_lone_corner_first(Corners& corners, const Sides& sides, Corners& other) {
    const auto is_alone = [&](std::size_t k) {
        return sides[k] != 0 && sides[(k + 1) % 3] != sides[k] && sides[(k + 2) % 3] != sides[k];
    };
    std::size_t lone = 0;
    while (!is_alone(lone)) ++lone;
    std::ranges::rotate(corners, corners.begin() + static_cast<std::ptrdiff_t>(lone));
    if (sides[lone] < 0) std::swap(other[1], other[2]);
}

// Each triangle cuts an interval out of the planes' common line, at the two edges of its lone corner. The
// ends' order along the line is the sign of a volume (Guigue and Devillers, "Fast and Robust
// Triangle-Triangle Overlap Test", 2003). With < for their <=, intervals that only touch do not overlap.
bool cross(Corners a, Corners b) {
    const Sides of_b = sides_of(a, b);
    if (!on_both_sides(of_b)) return false;
    const Sides of_a = sides_of(b, a);
    if (!on_both_sides(of_a)) return false;
    put_lone_corner_first(a, of_a, b);
    // The swap above may have moved b's corners.
    put_lone_corner_first(b, sides_of(a, b), a);
    return orientation(a[0], a[1], b[0], b[1]) < 0 && orientation(a[0], a[2], b[2], b[0]) < 0;
}

/// Whether the boxes' interiors overlap: boxes that only touch hold no triangles that cross.
bool overlap(const Box& a, const Box& b) {
    for (std::size_t k = 0; k < 3; ++k)
        if (a.high[k] <= b.low[k] || b.high[k] <= a.low[k]) return false;
    return true;
}

template <class Visit>
void for_crossings(const TriangleSoup& soup, const Visit& visit) {
    BoxTree(soup).pairs(overlap, [&](std::uint32_t first, std::uint32_t second) {
        if (triangles_cross(soup, first, second)) visit(first, second);
    });
}

}  // namespace

bool triangles_cross(const TriangleSoup& soup, std::uint32_t first, std::uint32_t second) {
    return !soup.share_a_vertex(first, second) && cross(corners_of(soup, first), corners_of(soup, second));
}

std::vector<std::pair<std::uint32_t, std::uint32_t>> crossing_pairs(const TriangleSoup& soup) {
    std::vector<std::pair<std::uint32_t, std::uint32_t>> pairs;
    for_crossings(soup,
                  [&](std::uint32_t first, std::uint32_t second) { pairs.emplace_back(first, second); });
    std::ranges::sort(pairs);
    return pairs;
}

CrossingCount count_crossings(const TriangleSoup& soup) {
    CrossingCount count;
    for_crossings(soup, [&](std::uint32_t first, std::uint32_t second) {
        ++count.all;
        if (soup.bodies[first] != soup.bodies[second]) ++count.between_bodies;
    });
    return count;
}

}  // namespace weft::study
