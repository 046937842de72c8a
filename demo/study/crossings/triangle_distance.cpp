#include "demo/study/crossings/triangle_distance.h"

#include <algorithm>
#include <Eigen/Geometry>

namespace weft::study {

namespace {

using Eigen::Vector3d;

double to_segment(const Vector3d& p, const Vector3d& a, const Vector3d& b) {
    const Vector3d along = b - a;
    const double length = along.squaredNorm();
    const double t = length > 0 ? std::clamp((p - a).dot(along) / length, 0.0, 1.0) : 0;
    return (a + t * along - p).squaredNorm();
}

}  // namespace

double squared_distance(const Vector3d& p, const Corners3& triangle) {
    const auto& [a, b, c] = triangle;
    const Vector3d normal = (b - a).cross(c - a);
    const double area = normal.squaredNorm();
    const auto inside = [&](const Vector3d& from, const Vector3d& to) {
        return normal.dot((to - from).cross(p - from)) >= 0;
    };
    if (area > 0 && inside(a, b) && inside(b, c) && inside(c, a)) {
        const double height = normal.dot(p - a);
        return height * height / area;
    }
    return std::min({to_segment(p, a, b), to_segment(p, b, c), to_segment(p, c, a)});
}

// The least distance is between the lines' closest points, if both are inside, or at one of the four ends.
double squared_distance(const Vector3d& a, const Vector3d& b, const Vector3d& c, const Vector3d& d) {
    const Vector3d u = b - a, v = d - c, w = a - c;
    const double uu = u.squaredNorm(), uv = u.dot(v), vv = v.squaredNorm(), uw = u.dot(w), vw = v.dot(w);
    const double sine = uu * vv - uv * uv;
    if (sine > 0) {
        const double s = (uv * vw - vv * uw) / sine, t = (uu * vw - uv * uw) / sine;
        if (s >= 0 && s <= 1 && t >= 0 && t <= 1) return (w + s * u - t * v).squaredNorm();
    }
    return std::min({to_segment(a, c, d), to_segment(b, c, d), to_segment(c, a, b), to_segment(d, a, b)});
}

double squared_distance(const Corners3& first, const Corners3& second) {
    double least = squared_distance(first[0], second);
    for (std::size_t i = 0; i < 3; ++i) {
        least = std::min({least, squared_distance(first[i], second), squared_distance(second[i], first)});
        for (std::size_t k = 0; k < 3; ++k) {
            least = std::min(least,
                             squared_distance(first[i], first[(i + 1) % 3], second[k], second[(k + 1) % 3]));
        }
    }
    return least;
}

}  // namespace weft::study
