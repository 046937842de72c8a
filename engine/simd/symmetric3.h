#pragma once
// Symmetric 3x3 blocks.

#include "engine/vector.h"

namespace weft {

/// A symmetric 3x3 matrix.
struct Symmetric3 {
    float xx = 0, yy = 0, zz = 0, xy = 0, xz = 0, yz = 0;

    [[nodiscard]] Vector3 operator*(const Vector3& v) const {
        return {xx * v.x() + xy * v.y() + xz * v.z(), xy * v.x() + yy * v.y() + yz * v.z(),
                xz * v.x() + yz * v.y() + zz * v.z()};
    }
    [[nodiscard]] Eigen::Matrix3d full() const {
        return Eigen::Matrix3f{{xx, xy, xz}, {xy, yy, yz}, {xz, yz, zz}}.cast<double>();
    }
    void add(const Symmetric3& more) {
        xx += more.xx;
        yy += more.yy;
        zz += more.zz;
        xy += more.xy;
        xz += more.xz;
        yz += more.yz;
    }
    /// Adds a I + d d^T.
    void add(float a, const Vector3& d) {
        xx += a + d.x() * d.x();
        yy += a + d.y() * d.y();
        zz += a + d.z() * d.z();
        xy += d.x() * d.y();
        xz += d.x() * d.z();
        yz += d.y() * d.z();
    }
};

[[nodiscard]] inline Symmetric3 operator*(float factor, const Symmetric3& m) {
    return {factor * m.xx, factor * m.yy, factor * m.zz, factor * m.xy, factor * m.xz, factor * m.yz};
}

/// Rounding error of a sum of a dozen springs, relative to its trace.
inline constexpr float inverse_rounding = 3e-7f;

/// The inverse of a matrix whose eigenvalues are at least `least` > 0. Single precision loses directions that
/// are very much softer than the stiffest one. Those count as heavier than they are, never as lighter, so
/// that the inverse stays positive definite and at most about 1 / least, at any stiffness.
[[nodiscard]] Symmetric3 inverse(const Symmetric3& m, float least);

}  // namespace weft
