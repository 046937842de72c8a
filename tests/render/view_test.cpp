// The camera, the light's map, and what shaders get of them.

#include <glad/gl.h>
#include <gtest/gtest.h>

#include <array>
#include <cstddef>
#include <Eigen/Geometry>
#include <random>

#include "render/gl/programs.h"
#include "render/view/matrices.h"
#include "tests/render/drawing.h"
#include "weft/render/camera.h"

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

Box random_box(std::mt19937& random) {
    std::uniform_real_distribution<float> unit(-1, 1);
    const Vector3 center = 10 * Vector3(unit(random), unit(random), unit(random));
    const Vector3 half = 2 * Vector3(unit(random), unit(random), unit(random)).cwiseAbs();
    return {center - half, center + half};
}

TEST(LightFrame, HoldsEveryCornerOfTheCasters) {
    std::mt19937 random(4);
    std::uniform_real_distribution<float> unit(-1, 1);
    for (int trial = 0; trial < 300; ++trial) {
        const Box box = random_box(random);
        const Vector3 direction = Vector3(unit(random), unit(random), unit(random)).normalized();
        const LightFrame light = fit_light(direction, box, 2048);
        for (int corner = 0; corner < 8; ++corner) {
            const Vector3 point = box.corner(static_cast<Box::CornerType>(corner));
            const Vector3 clip = (light.clip_from_world * point.homogeneous()).head<3>();
            EXPECT_LE(clip.cwiseAbs().maxCoeff(), 1.0f) << clip.transpose();
        }
    }
}

TEST(LightFrame, MovesByWholeTexels) {
    const int texels = 1024;
    const Vector3 direction = Vector3(0.5f, 0.7f, 0.3f).normalized();
    const Box box(Vector3(-1, 0, -1), Vector3(1, 1, 1));
    const Vector3 fixed_point(0.3f, 0.2f, 0.1f);
    const auto texel_of = [&](const Box& casters) {
        const LightFrame light = fit_light(direction, casters, texels);
        return Eigen::Vector2f(0.5f * texels * (light.clip_from_world * fixed_point.homogeneous()).head<2>());
    };
    const Eigen::Vector2f before = texel_of(box);
    for (int step = 1; step < 40; ++step) {
        const Vector3 shift = 0.0013f * static_cast<float>(step) * Vector3(1, 0.2f, -0.6f);
        const Eigen::Vector2f moved = texel_of({box.min() + shift, box.max() + shift}) - before;
        EXPECT_NEAR(moved.x(), std::round(moved.x()), 0.01f);
        EXPECT_NEAR(moved.y(), std::round(moved.y()), 0.01f);
    }
}

// The uniform block of frame.glsl has the layout of the struct that is uploaded.

using FrameBlock = Drawing;

TEST_F(FrameBlock, IsLaidOutAsItsStruct) {
    const auto programs = Programs::build();
    ASSERT_TRUE(programs) << programs.error().message;
    programs->ground.use();
    GLint id = 0, size = 0;
    glGetIntegerv(GL_CURRENT_PROGRAM, &id);
    const auto program = static_cast<GLuint>(id);
    glGetActiveUniformBlockiv(program, glGetUniformBlockIndex(program, "Frame"), GL_UNIFORM_BLOCK_DATA_SIZE,
                              &size);
    EXPECT_EQ(static_cast<std::size_t>(size), sizeof(FrameUniforms));
    const std::pair<const char*, std::size_t> members[] = {
        {"Frame.clip_from_world", offsetof(FrameUniforms, clip_from_world)},
        {"Frame.world_from_clip", offsetof(FrameUniforms, world_from_clip)},
        {"Frame.sun_from_world", offsetof(FrameUniforms, sun_from_world)},
        {"Frame.sky_from_world", offsetof(FrameUniforms, sky_from_world)},
        {"Frame.eye", offsetof(FrameUniforms, eye)},
        {"Frame.sun_direction", offsetof(FrameUniforms, sun_direction)},
        {"Frame.sun_extent", offsetof(FrameUniforms, sun_extent)},
        {"Frame.sky_extent", offsetof(FrameUniforms, sky_extent)},
        {"Frame.ground", offsetof(FrameUniforms, ground)},
        {"Frame.arrow", offsetof(FrameUniforms, arrow)},
        {"Frame.quality", offsetof(FrameUniforms, quality)}};
    for (const auto& [name, offset] : members) {
        GLuint index = GL_INVALID_INDEX;
        glGetUniformIndices(program, 1, &name, &index);
        ASSERT_NE(index, GL_INVALID_INDEX) << name;
        GLint at = -1;
        glGetActiveUniformsiv(program, 1, &index, GL_UNIFORM_OFFSET, &at);
        EXPECT_EQ(static_cast<std::size_t>(at), offset) << name;
    }
    glUseProgram(0);
}

}  // namespace

}  // namespace weft::render
