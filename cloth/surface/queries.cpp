#include "cloth/surface/queries.h"

#include <algorithm>

#include "collision/geometry/nearest_on_triangle.h"

namespace weft {

namespace {

using Vector3d = Eigen::Vector3d;

Vector3d wide(const Vec3& v) {
    return to_vector(v).cast<double>();
}

}  // namespace

// Ericson 2004, 5.3.3. The box is widened by rounding, since it bounds floats.
bool may_hit(const Ray& ray, const Bounds& box, double reach) {
    const Vector3d lower = wide(box.lower), upper = wide(box.upper);
    const double rounding = 1e-6 * lower.cwiseAbs().cwiseMax(upper.cwiseAbs()).maxCoeff();
    double begin = 0, end = reach;
    for (Eigen::Index k = 0; k < 3; ++k) {
        const double to_lower = lower[k] - rounding - ray.from[k],
                     to_upper = upper[k] + rounding - ray.from[k];
        if (ray.direction[k] == 0) {
            if (to_lower > 0 || to_upper < 0) return false;
            continue;
        }
        const double a = to_lower / ray.direction[k], b = to_upper / ray.direction[k];
        begin = std::max(begin, std::min(a, b));
        end = std::min(end, std::max(a, b));
    }
    return begin <= end;
}

// The ray passes a triangle on the side of all edges or of none, by the volumes that it spans with them.
std::optional<PlaceOnTriangle> first_hit(const Ray& ray, const TriangleList& of, double reach) {
    std::optional<PlaceOnTriangle> first;
    for (std::uint32_t t = 0; t < of.triangles.size(); ++t) {
        const auto corners = of.corners(t);
        const Vector3d a = corners[0].cast<double>() - ray.from, b = corners[1].cast<double>() - ray.from,
                       c = corners[2].cast<double>() - ray.from;
        const Vector3d volumes(ray.direction.dot(b.cross(c)), ray.direction.dot(c.cross(a)),
                               ray.direction.dot(a.cross(b)));
        if (volumes.minCoeff() < 0 && volumes.maxCoeff() > 0) continue;
        const double whole = volumes.sum();
        if (whole == 0) continue;  // edge-on, or without area
        const Vector3d weights = volumes / whole;
        const double distance = ray.direction.dot(weights.x() * a + weights.y() * b + weights.z() * c);
        if (!(distance >= 0 && distance <= reach) || (first && !(distance < first->distance))) continue;
        first = PlaceOnTriangle{t, weights.cast<float>(), distance};
    }
    return first;
}

PlaceOnTriangle nearest_place(const Vector3& point, const TriangleList& of, std::uint32_t triangle) {
    const auto corners = of.corners(triangle);
    const std::array<float, 3> weights = nearest_on_triangle(point, corners);
    const Vector3 way = weights[0] * (corners[0] - point) + weights[1] * (corners[1] - point) +
                        weights[2] * (corners[2] - point);
    return {triangle, Vector3(weights[0], weights[1], weights[2]), static_cast<double>(way.norm())};
}

}  // namespace weft
