// A brush that paints maps on cloth.

#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>

#include "demo/character/character.h"
#include "demo/character/garment/painted_maps.h"
#include "demo/cutting/cut_scene.h"
#include "demo/hands/hands.h"
#include "demo/hands/project.h"
#include "engine/vector.h"
#include "tests/demo/small_world.h"

namespace weft::demo {

namespace {

const std::vector<float>* map_of(const Simulation& simulation, Map map) {
    const std::vector<PaintedMap>& maps = simulation.content().cloths.front().maps;
    const auto found = std::ranges::find(maps, map, &PaintedMap::map);
    return found == maps.end() ? nullptr : &found->values;
}

TEST(Brush, PaintsWhatIsNearItsWayWhileItIsInHand) {
    constexpr float aspect = 1.6f;
    Simulation simulation = simulation_of("flag", 400);
    render::OrbitCamera camera = simulation.content().camera;
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

}  // namespace

}  // namespace weft::demo
