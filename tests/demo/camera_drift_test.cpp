#include "demo/window/camera_drift.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "demo/hands/project.h"
#include "engine/vector.h"

namespace weft::demo {
namespace {

constexpr float aspect = 1.6f, tick = 1.0f / 60;

bool is_in_picture(const render::OrbitCamera& camera, const Bounds& box) {
    for (const Vec3& corner : {box.lower, box.upper}) {
        const auto place = project(camera, corner, aspect);
        if (!place || place->x < 0 || place->x > aspect || place->y < 0 || place->y > 1) return false;
    }
    return true;
}

/// A flag of 1.5 m at a pole in the origin, blown to that side.
Bounds flag(float side) {
    return {{std::min(0.0f, 1.5f * side), 1.5f, -0.1f}, {std::max(0.0f, 1.5f * side), 2.4f, 0.1f}};
}

render::OrbitCamera beside_the_pole() {
    return {.target = {0.8f, 1.8f, 0}, .distance = 2.6f, .yaw = 0.2f, .pitch = 0.1f};
}

TEST(CameraDrift, FollowsAFlagThatTurnsAndComesBack) {
    render::OrbitCamera camera = beside_the_pole();
    const Vec3 first = camera.target;
    CameraDrift drift;
    drift.update(flag(1), aspect, tick, camera);
    EXPECT_EQ(to_vector(camera.target), to_vector(first)) << "it is in the picture";
    EXPECT_FALSE(is_in_picture(camera, flag(-1)));
    float fastest = 0;
    for (int i = 0; i < 400; ++i) {
        const Vector3 before = to_vector(camera.target);
        drift.update(flag(-1), aspect, tick, camera);
        fastest = std::max(fastest, (to_vector(camera.target) - before).norm() / tick);
    }
    EXPECT_TRUE(is_in_picture(camera, flag(-1)));
    EXPECT_LT(fastest, 2) << "[m/s]: gently";
    for (int i = 0; i < 600; ++i) drift.update(flag(1), aspect, tick, camera);
    EXPECT_LT((to_vector(camera.target) - to_vector(first)).norm(), 0.02f) << "the view that was given";
}

TEST(CameraDrift, LeavesTheUsersViewAlone) {
    render::OrbitCamera camera = beside_the_pole();
    CameraDrift drift;
    drift.update(flag(1), aspect, tick, camera);
    camera.zoom(6);  // onto a part of the flag
    const Vec3 given = camera.target;
    for (int i = 0; i < 300; ++i) drift.update(flag(1), aspect, tick, camera);
    EXPECT_LT((to_vector(camera.target) - to_vector(given)).norm(), 1e-5f);
}

TEST(CameraDrift, GoesRoundWhileNobodyDoesAnything) {
    render::OrbitCamera camera = beside_the_pole();
    const float yaw = camera.yaw;
    CameraDrift drift;
    const auto wait = [&](float seconds) {
        for (float t = 0; t < seconds; t += tick) drift.update(flag(1), aspect, tick, camera);
    };
    wait(CameraDrift::idle_after - 1);
    EXPECT_EQ(camera.yaw, yaw);
    wait(11);
    EXPECT_NEAR(camera.yaw, yaw + 10 * CameraDrift::turn_rate, 0.02f);
    drift.wake();
    const float there = camera.yaw;
    wait(10);
    EXPECT_EQ(camera.yaw, there);
}

}  // namespace
}  // namespace weft::demo
