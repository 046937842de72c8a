// The mouse, played frame by frame against a scene; keys and camera.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <numbers>
#include <optional>

#include "demo/character/character.h"
#include "demo/character/garment/painted_maps.h"
#include "demo/cutting/cut_scene.h"
#include "demo/hands/hands.h"
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

const std::vector<float>* map_of(const Simulation& simulation, Map map) {
    const std::vector<PaintedMap>& maps = simulation.content().cloths.front().maps;
    const auto found = std::ranges::find(maps, map, &PaintedMap::map);
    return found == maps.end() ? nullptr : &found->values;
}

TEST_F(Mouse, PaintsWhatIsNearItsWayWhileTheBrushIsInHand) {
    Hands hands;
    WindControl wind(simulation.world().settings().wind.velocity);
    hands.brush.is_in_hand = true;
    hands.brush.map = Map::stiffness;
    hands.brush.value = 5;
    const auto positions = vertex_positions(simulation.world(), simulation.content().cloths.front().id);
    ASSERT_TRUE(positions.ok());
    const auto point = [&](std::size_t vertex, bool pressed) {
        const Vec2 at = *project(camera, (*positions)[vertex], aspect);
        (void)hands.update({.x = at.x / aspect, .y = at.y, .left_button = pressed}, aspect, simulation,
                           camera, wind);
    };
    const std::size_t from = positions->size() / 3, to = 2 * positions->size() / 3;
    point(from, false);
    EXPECT_TRUE(hands.brush.place().has_value());
    EXPECT_EQ(map_of(simulation, Map::stiffness), nullptr) << "nothing is pressed";
    point(from, true);
    point(to, true);
    EXPECT_FALSE(hands.interaction().grab().active());
    const std::vector<float>* const painted = map_of(simulation, Map::stiffness);
    ASSERT_NE(painted, nullptr);
    const Vector3 a = to_vector((*positions)[from]), b = to_vector((*positions)[to]);
    int inside = 0;
    for (std::size_t v = 0; v < painted->size(); ++v) {
        const Vector3 p = to_vector((*positions)[v]);
        const float along = std::clamp((p - a).dot(b - a) / (b - a).squaredNorm(), 0.0f, 1.0f);
        const float away = (p - a - along * (b - a)).norm();
        if (away < 0.9f * hands.brush.radius) {
            EXPECT_EQ((*painted)[v], 5) << v;
            ++inside;
        }
        if (away > 1.1f * hands.brush.radius) {
            EXPECT_EQ((*painted)[v], 1) << v;
        }
    }
    EXPECT_GT(inside, 8) << "the way between two pictures is painted, too";
    hands.brush.map = Map::leash;
    point(from, true);
    EXPECT_NE(hands.take_complaint().find("wears"), std::string::npos) << "nobody wears a flag";
}

TEST(Brush, PaintMovesTheClothAndOutlivesARestart) {
    Simulation simulation = simulation_of("flag", 400);
    Simulation plain = simulation_of("flag", 400);
    Brush brush;
    brush.value = 10;
    ASSERT_TRUE(brush.fill(simulation, false).ok());
    ASSERT_TRUE(simulation.restart().ok());
    ASSERT_NE(map_of(simulation, Map::mass), nullptr);
    EXPECT_EQ(map_of(simulation, Map::mass)->front(), 10);
    const auto mean_height = [](Simulation& of) {
        const ClothView& view = *of.world().cloth(of.content().cloths.front().id);
        float sum = 0;
        for (const Vec4& p : view.positions) sum += p.y;
        return sum / static_cast<float>(view.positions.size());
    };
    float painted = 0, light = 0;
    for (int step = 0; step < 360; ++step) {
        for (Simulation* const each : {&simulation, &plain}) each->step(1.0f / 60);
        if (step < 120) continue;
        painted += mean_height(simulation) / 240;
        light += mean_height(plain) / 240;
    }
    EXPECT_LT(painted, light - 0.05f) << "ten times as heavy, it does not fly [m]";
    ASSERT_TRUE(brush.fill(simulation, true).ok());
    EXPECT_EQ(map_of(simulation, Map::mass)->front(), 1);
    EXPECT_NE(save_maps(simulation).error().message.find("drop a file"), std::string::npos);
}

TEST(Brush, ADressIsTiedToWhoeverWearsItByALeash) {
    Simulation simulation = simulation_of("character", 300);
    simulation.step(1.0f / 60);
    Brush brush;
    brush.map = Map::leash;
    brush.value = 0.01f;
    const auto filled = brush.fill(simulation, false);
    ASSERT_TRUE(filled.ok()) << filled.error().message;

    CharacterSettings settings;
    settings.particles = 300;
    auto dressed = Character::create(settings);
    auto world = World::create({.threads = 1});
    ASSERT_TRUE(dressed->enter(*world).ok());
    EXPECT_TRUE(dressed->skin_targets().empty());
    float farthest = 0;
    for (int step = 0; step < 90; ++step) {
        dressed->before_step(*world, step / 60.0, 1.0f / 60);
        world->step(1.0f / 60);
        if (step < 30) continue;
        const ClothView& view = *world->cloth(dressed->cloth());
        if (step == 30) {
            const std::vector<float> leashes(view.vertex_to_particle.size(), brush.value);
            ASSERT_TRUE(world->set_map(dressed->cloth(), Map::leash, leashes).ok());
            ASSERT_TRUE(dressed->give_skin(*world).ok());
            continue;
        }
        for (std::size_t v = 0; v < dressed->skin_targets().size(); ++v) {
            const Vec4& p = view.positions[view.vertex_to_particle[v]];
            if (p.w > 0)
                farthest = std::max(farthest, (xyz(p) - to_vector(dressed->skin_targets()[v])).norm());
        }
    }
    EXPECT_LT(farthest, brush.value + 1e-4f);
    EXPECT_GT(farthest, 0.5f * brush.value) << "it moves within its leash [m]";
}

TEST(Brush, WhatIsSavedBesideAGarmentIsReadWithIt) {
    const std::filesystem::path file = std::filesystem::path(testing::TempDir()) / "weft_painted_sheet.obj";
    ASSERT_TRUE(save_obj(file, *make_sheet({.rows = 12, .columns = 9})).ok());
    SceneOptions options;
    options.garment = file;
    options.y_is_up = true;
    auto simulation = Simulation::create(*find_scene("garment"), options, {.threads = 1});
    ASSERT_TRUE(simulation.ok()) << simulation.error().message;
    Brush brush;
    brush.map = Map::friction;
    brush.radius = 0.25f;
    const Vec3 middle = simulation->content().camera.target;
    brush.aim(simulation->world(), {{middle.x, middle.y + 2, middle.z}, {0, -1, 0}});
    ASSERT_TRUE(brush.place().has_value());
    ASSERT_TRUE(brush.stroke(*simulation).ok());
    const auto saved = save_maps(*simulation);
    ASSERT_TRUE(saved.ok()) << saved.error().message;
    EXPECT_NE(saved->find("weft_painted_sheet.maps"), std::string::npos);
    auto again = Simulation::create(*find_scene("garment"), options, {.threads = 1});
    ASSERT_TRUE(again.ok());
    ASSERT_NE(map_of(*again, Map::friction), nullptr);
    EXPECT_EQ(*map_of(*again, Map::friction), *map_of(*simulation, Map::friction));
    EXPECT_EQ(std::ranges::count(*map_of(*again, Map::friction), 4.0f),
              std::ranges::count_if(again->content().cloths.front().mesh.positions, [&](const Vec3& p) {
                  return (to_vector(p) - to_vector(*brush.place())).norm() <= 0.25f;
              }));
    std::filesystem::remove(file);
    std::filesystem::remove(maps_file(file));
}

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
