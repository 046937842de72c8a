#pragma once
// The three matrices of a picture, in OpenGL's conventions: the camera looks along its own -Z, clip space is
// [-1, 1] on every axis.

#include <Eigen/Core>

#include "engine/vector.h"
#include "weft/render/camera.h"

namespace weft::render {

using Matrix4f = Eigen::Matrix4f;  // column-major, as Matrix4 is

[[nodiscard]] Matrix4f look_at(const Vector3& eye, const Vector3& target, const Vector3& up);
[[nodiscard]] Matrix4f perspective(float vertical_fov, float aspect, float near, float far);
/// The box |x| <= half_width, |y| <= half_width, -far <= z <= -near of camera space.
[[nodiscard]] Matrix4f orthographic(float half_width, float near, float far);
[[nodiscard]] Matrix4 to_matrix4(const Matrix4f& m);

}  // namespace weft::render
