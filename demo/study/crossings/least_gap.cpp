#include <algorithm>
#include <cmath>

#include "demo/study/crossings/box_tree.h"
#include "demo/study/crossings/crossings.h"
#include "demo/study/crossings/triangle_distance.h"

namespace weft::study {

namespace {

Corners3 exact_corners(const TriangleSoup& soup, std::uint32_t triangle) {
    Corners3 corners;
    for (std::size_t k = 0; k < 3; ++k) {
        const Vec3& p = soup.points[soup.triangles[triangle][k]];
        corners[k] = Eigen::Vector3f(p.x, p.y, p.z).cast<double>();
    }
    return corners;
}

double squared_distance(const Box& a, const Box& b) {
    double sum = 0;
    for (std::size_t k = 0; k < 3; ++k) {
        const double apart = std::max({0.0, static_cast<double>(a.low[k]) - static_cast<double>(b.high[k]),
                                       static_cast<double>(b.low[k]) - static_cast<double>(a.high[k])});
        sum += apart * apart;
    }
    return sum;
}

}  // namespace

// The tree skips boxes that are farther apart than the closest pair so far.
double least_gap(const TriangleSoup& soup, double bound) {
    double least = bound * bound;
    const auto near = [&](const Box& a, const Box& b) { return squared_distance(a, b) < least; };
    BoxTree(soup).pairs(near, [&](std::uint32_t first, std::uint32_t second) {
        if (soup.share_a_vertex(first, second)) return;
        const bool cross = triangles_cross(soup, first, second);
        const double apart =
            cross ? 0 : squared_distance(exact_corners(soup, first), exact_corners(soup, second));
        least = std::min(least, apart);
    });
    return std::sqrt(least);
}

}  // namespace weft::study
