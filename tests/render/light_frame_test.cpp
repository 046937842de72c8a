#include "render/view/light_frame.h"

#include <gtest/gtest.h>

#include <random>

namespace weft::render {
namespace {

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

}  // namespace
}  // namespace weft::render
