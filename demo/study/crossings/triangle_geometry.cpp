#include "demo/study/crossings/triangle_geometry.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <Eigen/Geometry>
#include <limits>

namespace weft::study {

namespace {

/// A sum of doubles without rounding, as an expansion (Shewchuk, "Adaptive Precision Floating-Point
/// Arithmetic", 1997): parts that do not overlap, the greatest last, so that this one has the sum's sign.
class ExactSum {
  public:
    void add(double value) {
        std::size_t kept = 0;
        for (std::size_t i = 0; i < size_; ++i) {
            const double part = parts_[i], sum = value + part, virtual_part = sum - value;
            const double rest = (value - (sum - virtual_part)) + (part - virtual_part);
            if (rest != 0) parts_[kept++] = rest;
            value = sum;
        }
        if (value != 0 || kept == 0) parts_[kept++] = value;
        size_ = kept;
    }
    /// A product of two floats is exact as a double. The product with a third is rounded, and fma gives the
    /// rounding error. Three floats' exponents add up to far less than a double's range.
    void add_product(float a, float b, float c) {
        const double ab = static_cast<double>(a) * static_cast<double>(b), third = static_cast<double>(c);
        const double product = ab * third;
        add(product);
        add(std::fma(ab, third, -product));
    }
    [[nodiscard]] int sign() const {
        const double greatest = size_ == 0 ? 0 : parts_[size_ - 1];
        return (greatest > 0) - (greatest < 0);
    }

  private:
    std::array<double, 49> parts_;
    std::size_t size_ = 0;
};

/// det(p, q, r), times `sign`.
void add_determinant(ExactSum& sum, float sign, const Vec3& p, const Vec3& q, const Vec3& r) {
    sum.add_product(sign * p.x, q.y, r.z);
    sum.add_product(sign * p.y, q.z, r.x);
    sum.add_product(sign * p.z, q.x, r.y);
    sum.add_product(-sign * p.x, q.z, r.y);
    sum.add_product(-sign * p.y, q.x, r.z);
    sum.add_product(-sign * p.z, q.y, r.x);
}

}  // namespace

// The determinant of differences is expanded into four of the points themselves: differences may be inexact.
int exact_orientation(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d) {
    ExactSum sum;
    add_determinant(sum, 1, a, b, c);
    add_determinant(sum, -1, a, b, d);
    add_determinant(sum, 1, a, c, d);
    add_determinant(sum, -1, b, c, d);
    return sum.sign();
}

int orientation(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d) {
    const auto less = [](float p, float q) { return static_cast<double>(p) - static_cast<double>(q); };
    const double ax = less(a.x, d.x), ay = less(a.y, d.y), az = less(a.z, d.z);
    const double bx = less(b.x, d.x), by = less(b.y, d.y), bz = less(b.z, d.z);
    const double cx = less(c.x, d.x), cy = less(c.y, d.y), cz = less(c.z, d.z);
    const double bc_x = by * cz, bc_y = bz * cx, bc_z = bx * cy;
    const double cb_x = bz * cy, cb_y = bx * cz, cb_z = by * cx;
    const double volume = ax * (bc_x - cb_x) + ay * (bc_y - cb_y) + az * (bc_z - cb_z);
    const double permanent = std::abs(ax) * (std::abs(bc_x) + std::abs(cb_x)) +
                             std::abs(ay) * (std::abs(bc_y) + std::abs(cb_y)) +
                             std::abs(az) * (std::abs(bc_z) + std::abs(cb_z));
    // Shewchuk's bound is a bit over 7 of these half units in the last place.
    const double bound = 8 * (std::numeric_limits<double>::epsilon() / 2) * permanent;
    if (volume > bound) return 1;
    if (volume < -bound) return -1;
    return permanent == 0 ? 0 : exact_orientation(a, b, c, d);
}

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
