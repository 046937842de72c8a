#include "render/view/matrices.h"

#include <cmath>
#include <Eigen/Geometry>

namespace weft::render {

Matrix4f look_at(const Vector3& eye, const Vector3& target, const Vector3& up) {
    const Vector3 back = (eye - target).normalized();
    const Vector3 right = up.cross(back).normalized();
    Matrix4f m = Matrix4f::Identity();
    m.block<1, 3>(0, 0) = right.transpose();
    m.block<1, 3>(1, 0) = back.cross(right).transpose();
    m.block<1, 3>(2, 0) = back.transpose();
    m.block<3, 1>(0, 3) = -(m.block<3, 3>(0, 0) * eye);
    return m;
}

Matrix4f perspective(float vertical_fov, float aspect, float near, float far) {
    const float scale = 1.0f / std::tan(0.5f * vertical_fov);
    Matrix4f m = Matrix4f::Zero();
    m(0, 0) = scale / aspect;
    m(1, 1) = scale;
    m(2, 2) = (far + near) / (near - far);
    m(2, 3) = 2.0f * far * near / (near - far);
    m(3, 2) = -1.0f;
    return m;
}

Matrix4f orthographic(float half_width, float near, float far) {
    Matrix4f m = Matrix4f::Identity();
    m(0, 0) = m(1, 1) = 1.0f / half_width;
    m(2, 2) = 2.0f / (near - far);
    m(2, 3) = (far + near) / (near - far);
    return m;
}

Matrix4 to_matrix4(const Matrix4f& m) {
    Matrix4 result;
    Eigen::Map<Matrix4f>(result.data()) = m;
    return result;
}

LightFrame fit_light(const Vector3& direction, const Box& casters, int texels) {
    constexpr float growth = 1.25f;
    const float enclosing = std::max(0.5f * casters.diagonal().norm(), 0.05f);
    const float radius = std::pow(growth, std::ceil(std::log(enclosing) / std::log(growth)));
    const float half_side = 1.05f * radius;  // the filter's taps stay inside

    const Vector3 up = std::abs(direction.y()) > 0.99f ? Vector3::UnitZ() : Vector3::UnitY();
    Matrix4f light_from_world = look_at(direction, Vector3::Zero(), up);
    const float texel = 2.0f * half_side / static_cast<float>(texels);
    const Vector3 center = (light_from_world * casters.center().homogeneous()).head<3>();
    light_from_world(0, 3) -= std::round(center.x() / texel) * texel;
    light_from_world(1, 3) -= std::round(center.y() / texel) * texel;
    light_from_world(2, 3) -= center.z();

    return {orthographic(half_side, -radius, radius) * light_from_world, 2.0f * half_side, 2.0f * radius};
}

}  // namespace weft::render
