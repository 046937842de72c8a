#pragma once
// The three matrices of a picture, in OpenGL's conventions: the camera looks along its own -Z, clip space is
// [-1, 1] on every axis.

#include <Eigen/Core>
#include <Eigen/Geometry>

#include "engine/vector.h"
#include "weft/render/camera.h"

namespace weft::render {

using Matrix4f = Eigen::Matrix4f;  // column-major, as Matrix4 is

[[nodiscard]] Matrix4f look_at(const Vector3& eye, const Vector3& target, const Vector3& up);
[[nodiscard]] Matrix4f perspective(float vertical_fov, float aspect, float near, float far);
/// The box |x| <= half_width, |y| <= half_width, -far <= z <= -near of camera space.
[[nodiscard]] Matrix4f orthographic(float half_width, float near, float far);
[[nodiscard]] Matrix4 to_matrix4(const Matrix4f& m);

/// The frame of a light's depth map: the box, seen from the light, that holds everything that casts a shadow.
using Box = Eigen::AlignedBox3f;

struct LightFrame {
    Matrix4f clip_from_world;
    float side;   ///< of the square map [m]
    float depth;  ///< from its near to its far plane [m]
};

/// Fits a map of `texels` on a side round the casters; `direction`: unit, towards the parallel light. The map
/// moves by whole texels and grows by steps of a quarter, so that shadows do not crawl.
[[nodiscard]] LightFrame fit_light(const Vector3& direction, const Box& casters, int texels);

}  // namespace weft::render
