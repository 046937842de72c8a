#include "weft/render/camera.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <random>

#include "render/view/matrices.h"

namespace weft::render {
namespace {

constexpr float pi = 3.14159265f;

Matrix4f matrix(const Matrix4& m) {
    return Matrix4f(m.data());
}

OrbitCamera random_camera(std::mt19937& random) {
    std::uniform_real_distribution<float> unit(-1, 1);
    OrbitCamera camera;
    camera.target = {3 * unit(random), 3 * unit(random), 3 * unit(random)};
    camera.distance = 3 + 2.5f * unit(random);
    camera.yaw = pi * unit(random);
    camera.pitch = 1.45f * unit(random);
    camera.vertical_fov = 0.8f + 0.4f * unit(random);
    return camera;
}

TEST(Camera, PointsAlongARayProjectToItsPixel) {
    std::mt19937 random(1);
    std::uniform_real_distribution<float> unit(0, 1);
    for (int trial = 0; trial < 200; ++trial) {
        const OrbitCamera camera = random_camera(random);
        const float x = unit(random), y = unit(random), aspect = 0.5f + 2 * unit(random);
        const Ray ray = camera.ray(x, y, aspect);
        const Vector3 point = to_vector(ray.origin) + (0.5f + 9 * unit(random)) * to_vector(ray.direction);
        const Eigen::Vector4f clip =
            matrix(camera.projection(aspect)) * matrix(camera.view()) * point.homogeneous();
        EXPECT_NEAR(0.5f + 0.5f * clip.x() / clip.w(), x, 1e-4f);
        EXPECT_NEAR(0.5f - 0.5f * clip.y() / clip.w(), y, 1e-4f);
        EXPECT_NEAR(to_vector(ray.direction).norm(), 1, 1e-6f);
    }
}

TEST(Camera, ViewIsARigidRightHandedMotionThatPutsTheTargetAhead) {
    std::mt19937 random(2);
    for (int trial = 0; trial < 100; ++trial) {
        const OrbitCamera camera = random_camera(random);
        const Matrix4f view = matrix(camera.view());
        const Matrix3 rotation = view.topLeftCorner<3, 3>();
        EXPECT_TRUE((rotation * rotation.transpose()).isIdentity(1e-5f));
        EXPECT_NEAR(rotation.determinant(), 1, 1e-5f);
        const Vector3 target = (view * to_vector(camera.target).homogeneous()).head<3>();
        EXPECT_TRUE(target.isApprox(Vector3(0, 0, -camera.distance), 1e-4f)) << target.transpose();
        EXPECT_GT(rotation(1, 1), 0) << "the world's up must point upwards in the picture";
    }
}

TEST(Camera, OrbitKeepsTheDistanceAndStaysUpright) {
    OrbitCamera camera;
    for (int i = 0; i < 50; ++i) {
        camera.orbit(0.37f, 0.11f);
        EXPECT_NEAR((to_vector(camera.eye()) - to_vector(camera.target)).norm(), camera.distance, 1e-5f);
        EXPECT_LE(camera.pitch, 1.5f);
        EXPECT_LE(std::abs(camera.yaw), 1.001f * pi);
    }
    camera.orbit(0, -100);
    EXPECT_FLOAT_EQ(camera.pitch, -1.5f);
}

}  // namespace
}  // namespace weft::render
