// The mouse, played frame by frame against a scene.

#include "demo/window/interaction.h"

#include <gtest/gtest.h>

#include <cmath>
#include <optional>

#include "demo/hands/project.h"
#include "engine/vector.h"

namespace weft::demo {
namespace {

constexpr float aspect = 1.6f;

class Mouse : public testing::Test {
  protected:
    Mouse() : simulation(make()), camera(simulation.content().camera) {}

    static Simulation make() {
        SceneOptions options;
        options.particles = 400;
        return std::move(*Simulation::create(*find_scene("flag"), options, {}));
    }

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

}  // namespace
}  // namespace weft::demo
