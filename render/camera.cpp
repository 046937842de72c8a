#include "weft/render/camera.h"

#include <algorithm>
#include <cmath>
#include <Eigen/Geometry>

#include "render/view/matrices.h"

namespace weft::render {

namespace {

constexpr float steepest_pitch = 1.5f;               // [rad]; beyond it the horizon would roll
constexpr float nearest = 0.05f, farthest = 100.0f;  // orbit distance [m]

/// Unit vectors of the camera, in the world.
struct Axes {
    Vector3 right, up, back;
};

Axes axes_of(const OrbitCamera& camera) {
    const float sin_yaw = std::sin(camera.yaw), cos_yaw = std::cos(camera.yaw);
    const float sin_pitch = std::sin(camera.pitch), cos_pitch = std::cos(camera.pitch);
    Axes axes;
    axes.back = {sin_yaw * cos_pitch, sin_pitch, cos_yaw * cos_pitch};
    axes.right = {cos_yaw, 0, -sin_yaw};
    axes.up = axes.back.cross(axes.right);
    return axes;
}

Vector3 eye_of(const OrbitCamera& camera) {
    return to_vector(camera.target) + camera.distance * axes_of(camera).back;
}

float half_height(const OrbitCamera& camera) {
    return std::tan(0.5f * camera.vertical_fov);
}

}  // namespace

Vec3 OrbitCamera::eye() const {
    return to_vec3(eye_of(*this));
}

Matrix4 OrbitCamera::view() const {
    return to_matrix4(look_at(eye_of(*this), to_vector(target), axes_of(*this).up));
}

Matrix4 OrbitCamera::projection(float aspect) const {
    const float near = std::clamp(0.02f * distance, 0.002f, 0.5f);
    const float far = 400.0f + 4.0f * distance;
    Matrix4f matrix = perspective(vertical_fov, aspect, near, far);
    matrix.topRows<2>() *= shrink;
    matrix(0, 2) = shift;
    return to_matrix4(matrix);
}

Ray OrbitCamera::ray(float x, float y, float aspect) const {
    const Axes axes = axes_of(*this);
    const float unit = half_height(*this) / shrink;
    const float across = (2.0f * x - 1.0f + shift) * unit * aspect;
    const float upward = (1.0f - 2.0f * y) * unit;
    const Vector3 direction = across * axes.right + upward * axes.up - axes.back;
    return {eye(), to_vec3(direction.normalized())};
}

void OrbitCamera::orbit(float yaw_change, float pitch_change) {
    yaw = std::remainder(yaw + yaw_change, 6.2831853f);
    pitch = std::clamp(pitch + pitch_change, -steepest_pitch, steepest_pitch);
}

void OrbitCamera::zoom(float factor) {
    distance = std::clamp(distance / factor, nearest, farthest);
}

void OrbitCamera::pan(float right, float up) {
    const Axes axes = axes_of(*this);
    const float height = 2.0f * distance * half_height(*this) / shrink;
    target = to_vec3(to_vector(target) + height * (right * axes.right + up * axes.up));
}

}  // namespace weft::render
