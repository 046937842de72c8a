#pragma once
// What tests of worn cloth share: poses, and shapes to compare.

#include <algorithm>
#include <cmath>
#include <vector>

#include "cloth/motion/rigid_motion.h"
#include "tests/cloth/fixtures.h"
#include "weft/weft.h"

namespace weft::test::worn {

inline constexpr float g = 9.81f;  ///< [m/s^2]

inline Rotation turn(const Vector3& axis, double angle) {
    return rotation_of(Eigen::Quaterniond(Eigen::AngleAxisd(angle, axis.cast<double>().normalized())));
}

inline std::vector<Vector3> places_of(const World& world, ClothId id) {
    std::vector<Vector3> places;
    for (const Vec4& x : world.cloth(id)->positions) places.push_back(xyz(x));
    return places;
}

/// The farthest that one is from where the motion puts the other [m].
inline float farthest(const std::vector<Vector3>& from, const RigidMotion& by,
                      const std::vector<Vector3>& to) {
    float most = 0;
    for (std::size_t i = 0; i < from.size(); ++i) most = std::max(most, (by.point(from[i]) - to[i]).norm());
    return most;
}

/// The largest strain of an edge against its length in `rest`.
inline float largest_strain(const ClothView& view, const std::vector<Vector3>& rest) {
    float most = 0;
    for (const Triangle& t : view.triangles)
        for (std::size_t k = 0; k < 3; ++k) {
            const std::uint32_t i = t[k], j = t[(k + 1) % 3];
            const float length = (xyz(view.positions[i]) - xyz(view.positions[j])).norm();
            most = std::max(most, std::abs(length / (rest[i] - rest[j]).norm() - 1));
        }
    return most;
}

inline Mesh hanging(std::uint32_t rows, std::uint32_t columns, float size = 0.6f) {
    return make_sheet({.rows = rows,
                       .columns = columns,
                       .origin = {-size / 2, size, 0},
                       .u = {size, 0, 0},
                       .v = {0, 0, size}})
        .value();
}

}  // namespace weft::test::worn
