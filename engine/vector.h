#pragma once
// Arithmetic on the rows of per-particle buffers: Eigen's fixed-size vectors, read from and written to Vec4.

#include <Eigen/Core>
#include <Eigen/Geometry>

#include "weft/types.h"

namespace weft {

using Vector3 = Eigen::Vector3f;
using Matrix3 = Eigen::Matrix3f;

/// A row as one SIMD register. In kernels that use it w is a fourth lane that costs nothing; say what it
/// holds.
using Vector4 = Eigen::Vector4f;
inline Vector4 load(const Vec4& v) {
    return Eigen::Map<const Vector4, Eigen::Aligned16>(&v.x);
}
inline void store(Vec4& target, const Vector4& v) {
    Eigen::Map<Vector4, Eigen::Aligned16>(&target.x) = v;
}

inline Vector3 xyz(const Vec4& v) {
    return {v.x, v.y, v.z};
}
inline Vector3 to_vector(const Vec3& v) {
    return {v.x, v.y, v.z};
}
inline Vec3 to_vec3(const Vector3& v) {
    return {v.x(), v.y(), v.z()};
}
inline Vec4 to_vec4(const Vector3& v, float w) {
    return {v.x(), v.y(), v.z(), w};
}

/// Replaces x, y, z and keeps w.
inline void set_xyz(Vec4& target, const Vector3& v) {
    target.x = v.x();
    target.y = v.y();
    target.z = v.z();
}

}  // namespace weft
