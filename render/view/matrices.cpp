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

}  // namespace weft::render
