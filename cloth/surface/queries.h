#pragma once
// Rays and distances against a cloth's triangles, one by one.

#include <array>
#include <cstdint>
#include <optional>
#include <span>

#include "engine/vector.h"
#include "weft/types.h"

namespace weft {

/// The triangles that are asked about.
struct TriangleList {
    std::span<const Vec4> positions;
    std::span<const Triangle> triangles;

    [[nodiscard]] std::array<Vector3, 3> corners(std::uint32_t triangle) const {
        const Triangle& t = triangles[triangle];
        return {xyz(positions[t[0]]), xyz(positions[t[1]]), xyz(positions[t[2]])};
    }
};

/// A place on one of them.
struct PlaceOnTriangle {
    std::uint32_t triangle = 0;
    Vector3 weights = Vector3::Zero();  ///< of its corners
    double distance = 0;                ///< [m]
};

/// A ray of unit direction.
struct Ray {
    Eigen::Vector3d from, direction;
};

/// Whether the ray meets the box within `reach` [m].
[[nodiscard]] bool may_hit(const Ray& ray, const Bounds& box, double reach);
/// The place where a ray first meets a triangle, from either side, within `reach`; of equally near ones that
/// of the lowest number. It misses no edge that two triangles share: both compute the same sign there.
[[nodiscard]] std::optional<PlaceOnTriangle> first_hit(const Ray& ray, const TriangleList& of, double reach);

/// The place of a triangle that is nearest to a point.
[[nodiscard]] PlaceOnTriangle nearest_place(const Vector3& point, const TriangleList& of,
                                            std::uint32_t triangle);

}  // namespace weft
