// The mouse, played frame by frame against a scene; keys and camera.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>

#include "demo/hands/project.h"
#include "demo/window/camera_drift.h"
#include "demo/window/interaction.h"
#include "demo/window/wind_control.h"
#include "engine/vector.h"
#include "tests/demo/small_world.h"

namespace weft::demo {

// The mouse, played frame by frame against a scene.

namespace {

constexpr float aspect = 1.6f;

class Mouse : public testing::Test {
  protected:
    Mouse() : simulation(make()), camera(simulation.content().camera) {}

    static Simulation make() { return simulation_of("flag", 400); }

    void press(float x, float y) { drag(x, y, 0, 0); }
    void drag(float x, float y, float right, float down) {
        Pointer pointer;
        pointer.x = x;
        pointer.y = y;
        pointer.right = right;
        pointer.down = down;
        pointer.left_button = true;
        interaction.update(pointer, aspect, simulation, camera);
    }
    void release() { interaction.update({}, aspect, simulation, camera); }

    /// Some place of the picture where there is cloth.
    std::optional<Vec2> cloth_in_picture() {
        for (float x = 0.05f; x < 1; x += 0.05f) {
            for (float y = 0.05f; y < 1; y += 0.05f) {
                const auto hit = pointed_cloth(simulation.world(), camera.ray(x, y, aspect));
                if (hit && !hit->is_pinned) return Vec2{x, y};
            }
        }
        return std::nullopt;
    }

    Simulation simulation;
    render::OrbitCamera camera;
    Interaction interaction;
};

TEST_F(Mouse, DragsClothUntilTheButtonIsUp) {
    const auto place = cloth_in_picture();
    ASSERT_TRUE(place);
    const render::OrbitCamera before = camera;
    press(place->x, place->y);
    ASSERT_TRUE(interaction.grab().active());
    const Vec3 start = interaction.grab().hand();
    for (int i = 0; i < 60; ++i) {
        drag(place->x + 0.05f, place->y, 0.01f, 0);
        interaction.before_step(simulation, 1.0f / 60.0f);
        simulation.step(1.0f / 60.0f);
    }
    EXPECT_GT((to_vector(interaction.grab().hand()) - to_vector(start)).norm(), 0.02f);
    EXPECT_EQ(camera.yaw, before.yaw) << "the camera stays while cloth is dragged";
    release();
    EXPECT_FALSE(interaction.grab().active());
}

TEST_F(Mouse, OrbitsBesideTheCloth) {
    const render::OrbitCamera before = camera;
    press(0.01f, 0.01f);
    EXPECT_FALSE(interaction.grab().active());
    drag(0.1f, 0.01f, 0.1f, 0);
    EXPECT_LT(camera.yaw, before.yaw) << "the scene turns with the pointer";
    EXPECT_EQ(camera.distance, before.distance);
    // A drag that began beside the cloth never grabs, wherever it goes.
    const auto place = cloth_in_picture();
    ASSERT_TRUE(place);
    drag(place->x, place->y, 0, 0);
    EXPECT_FALSE(interaction.grab().active());
}

TEST_F(Mouse, PansWithTheOtherButtonAndZoomsWithTheWheel) {
    const render::OrbitCamera before = camera;
    Pointer pointer;
    pointer.other_button = true;
    pointer.right = 0.1f;
    interaction.update(pointer, aspect, simulation, camera);
    EXPECT_GT((to_vector(camera.target) - to_vector(before.target)).norm(), 0.01f);
    release();

    pointer = {};
    pointer.wheel = 1;
    interaction.update(pointer, aspect, simulation, camera);
    EXPECT_LT(camera.distance, before.distance);
}

TEST_F(Mouse, LeavesToPanelsWhatBeginsOnThem) {
    const render::OrbitCamera before = camera;
    Pointer pointer;
    pointer.left_button = pointer.over_panel = true;
    pointer.wheel = 1;
    interaction.update(pointer, aspect, simulation, camera);
    drag(0.1f, 0.1f, 0.2f, 0.2f);
    EXPECT_EQ(camera.yaw, before.yaw);
    EXPECT_EQ(camera.distance, before.distance);
    EXPECT_FALSE(interaction.grab().active());
}

TEST_F(Mouse, CutsWithTheKnifeAllAlongItsWay) {
    const render::OrbitCamera before = camera;
    const ClothId cloth = simulation.content().cloths.front().id;
    const std::size_t vertices = simulation.content().cloths.front().mesh.positions.size();
    for (int i = 0; i < 60; ++i) simulation.step(1.0f / 60.0f);
    // From above the cloth to below it. Cloth that flies meanwhile goes round the blade between two pictures.
    Pointer pointer;
    pointer.left_button = pointer.has_knife = true;
    for (int i = 0; i <= 40; ++i) {
        pointer.x = 0.5f;
        pointer.y = static_cast<float>(i) / 40;
        pointer.down = 1.0f / 40;
        interaction.update(pointer, aspect, simulation, camera);
        EXPECT_TRUE(interaction.cuts());
    }
    EXPECT_TRUE(interaction.take_complaint().empty());
    release();
    EXPECT_FALSE(interaction.cuts());
    EXPECT_EQ(simulation.world().cloth_info(cloth)->components, 2u);
    EXPECT_GT(simulation.content().cloths.front().mesh.positions.size(), vertices + 5);
    EXPECT_GT(simulation.cuts(), 3u) << "it cuts while it is drawn";
    EXPECT_EQ(camera.yaw, before.yaw);
    EXPECT_FALSE(interaction.grab().active());
    for (int i = 0; i < 60; ++i)
        EXPECT_FALSE(has(simulation.step(1.0f / 60.0f).flags, StepFlags::state_restored));

    // Whole again from the start, and drawn so.
    const std::uint32_t cuts = simulation.cuts();
    ASSERT_TRUE(simulation.restart());
    EXPECT_NE(simulation.cuts(), cuts);
    EXPECT_EQ(simulation.content().cloths.front().mesh.positions.size(), vertices);
}

constexpr float dt = 1.0f / 60.0f;
constexpr Vec3 forward{0, 0, -1};

TEST(Grab, HoldsTheParticleUnderTheRay) {
    SmallWorld small;
    Grab grab;
    ASSERT_TRUE(grab.begin(small.world, SmallWorld::straight_at(0.31f, 0.58f), forward));
    EXPECT_EQ(grab.vertex(), SmallWorld::vertex(4, 3));
    EXPECT_EQ(small.position(grab.vertex()).w, 0);

    const Vec4 before = small.position(grab.vertex());
    for (int i = 0; i < 10; ++i) {
        grab.before_step(small.world, dt);
        small.world.step(dt);
    }
    const Vec4 after = small.position(grab.vertex());
    EXPECT_EQ(xyz(after), xyz(before)) << "a still hand holds still";
}

TEST(Grab, FollowsThePointerAtItsDepthAndNoFasterThanAHand) {
    SmallWorld small;
    Grab grab;
    ASSERT_TRUE(grab.begin(small.world, SmallWorld::straight_at(0.5f, 0.5f), forward));
    grab.aim(SmallWorld::straight_at(0.9f, 0.8f));
    Vec4 last = small.position(grab.vertex());
    for (int i = 0; i < 30; ++i) {
        grab.before_step(small.world, dt);
        small.world.step(dt);
        const Vec4 now = small.position(grab.vertex());
        EXPECT_LE((xyz(now) - xyz(last)).norm(), 1.001f * Grab::max_speed * dt);
        last = now;
    }
    EXPECT_NEAR(last.x, 0.9f, 1e-5);
    EXPECT_NEAR(last.y, 0.8f, 1e-5);
    EXPECT_NEAR(last.z, 0, 1e-5);
}

TEST(Grab, LeavesPinnedWhatTheScenePinned) {
    SmallWorld small;
    const std::uint32_t corner = SmallWorld::vertex(0, 0);
    ASSERT_TRUE(small.world.pin(small.cloths.front().id, corner).ok());
    Grab grab;
    ASSERT_TRUE(grab.begin(small.world, SmallWorld::straight_at(0.01f, 0.99f), forward));
    ASSERT_EQ(grab.vertex(), corner);
    grab.end(small.world);
    small.world.step(dt);
    EXPECT_EQ(small.position(corner).w, 0);
}

TEST(WindControl, GivesBackTheWindThatItTook) {
    for (const Vec3 wind :
         {Vec3{3, 0.5f, -4}, Vec3{-1, 0, 0}, Vec3{0, -2, 7}, Vec3{0, 1, 0}, Vec3{60, 5, -70}}) {
        const Vec3 back = WindControl(wind).velocity();
        EXPECT_NEAR(back.x, wind.x, 1e-5);
        EXPECT_EQ(back.y, wind.y);
        EXPECT_NEAR(back.z, wind.z, 1e-5);
    }
}

TEST(WindControl, HeadingIsAnticlockwiseSeenFromAbove) {
    constexpr float pi = std::numbers::pi_v<float>;
    EXPECT_NEAR(WindControl({5, 0, 0}).heading(), 0, 1e-6);
    // From above, with +X to the right, -Z is away from the viewer: a quarter turn to the left.
    EXPECT_NEAR(WindControl({0, 0, -5}).heading(), pi / 2, 1e-6);
    EXPECT_NEAR(WindControl({0, 0, 5}).heading(), -pi / 2, 1e-6);
}

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
    drift.update(flag(1), aspect, dt, camera);
    EXPECT_EQ(to_vector(camera.target), to_vector(first)) << "it is in the picture";
    EXPECT_FALSE(is_in_picture(camera, flag(-1)));
    float fastest = 0;
    for (int i = 0; i < 400; ++i) {
        const Vector3 before = to_vector(camera.target);
        drift.update(flag(-1), aspect, dt, camera);
        fastest = std::max(fastest, (to_vector(camera.target) - before).norm() / dt);
    }
    EXPECT_TRUE(is_in_picture(camera, flag(-1)));
    EXPECT_LT(fastest, 2) << "[m/s]: gently";
    for (int i = 0; i < 600; ++i) drift.update(flag(1), aspect, dt, camera);
    EXPECT_LT((to_vector(camera.target) - to_vector(first)).norm(), 0.02f) << "the view that was given";
}

TEST(CameraDrift, LeavesTheUsersViewAlone) {
    render::OrbitCamera camera = beside_the_pole();
    CameraDrift drift;
    drift.update(flag(1), aspect, dt, camera);
    camera.zoom(6);  // onto a part of the flag
    const Vec3 given = camera.target;
    for (int i = 0; i < 300; ++i) drift.update(flag(1), aspect, dt, camera);
    EXPECT_LT((to_vector(camera.target) - to_vector(given)).norm(), 1e-5f);
}

TEST(CameraDrift, GoesRoundWhileNobodyDoesAnything) {
    render::OrbitCamera camera = beside_the_pole();
    const float yaw = camera.yaw;
    CameraDrift drift;
    const auto wait = [&](float seconds) {
        for (float t = 0; t < seconds; t += dt) drift.update(flag(1), aspect, dt, camera);
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
