// World::describe as JSON, parsed and held against what the World says call by call.

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <string>

#include "demo/scene_simulation.h"
#include "tests/demo/small_world.h"

namespace weft::demo {
namespace {

using Json = nlohmann::json;

Json described(const World& world) {
    const auto text = world.describe(DescriptionFormat::json);
    EXPECT_TRUE(text) << text.error().message;
    Json json = Json::parse(*text, nullptr, false);
    EXPECT_FALSE(json.is_discarded()) << *text;
    return json;
}

/// Two flags of which one is asked for more speed than there may be, a ball, a shape and a body.
struct Things {
    Things() : world(World::create({.wind = {.velocity = {1, 0, 0}}, .max_speed = 3, .threads = 1}).value()) {
        ClothSettings slow;
        slow.method = Fibres{.iterations = 2, .shear = Fibres::SetSolver::ldlt};
        slow.enabled = false;
        ClothSettings contact;
        contact.self_collision = {.method = SelfCollisionMethod::contact};
        cloths = {world.add_cloth(*make_sheet({.rows = 8, .columns = 8}), contact).value(),
                  world.add_cloth(*make_sheet({.rows = 4, .columns = 4, .origin = {3, 0, 0}}), slow).value()};
        EXPECT_TRUE(world.pin(cloths[0], std::vector<std::uint32_t>{0, 1}));
        EXPECT_TRUE(world.move_pin(cloths[0], 0, {-0.5f, 2, -0.5f}));
        const std::array<Vec3, 4> corners{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}}};
        shape = world.add_shape(ConvexHull{corners}).value();
        ball = world.add_collider({.shape = Sphere{{0, -1, 0.25f}, 0.125f}, .friction = 0.75f}).value();
        placed = world.add_collider({.shape = PlacedShape{shape, {9, 0, 0}, {}}}).value();
        body = world.add_body({.mass = 2.5f}, {.position = {0, 5, 0}}).value();
        EXPECT_TRUE(world.attach_collider(body, ball));
        world.step(1.0f / 60);
    }
    World world;
    std::vector<ClothId> cloths;
    ColliderId ball, placed;
    ShapeId shape;
    BodyId body;
};

template <class Id>
Json json_of(Id id) {
    return Json::array({id.index, id.generation});
}

TEST(Describe, SaysOfEachClothWhatItsCallsSay) {
    const Things things;
    const Json json = described(things.world);
    ASSERT_EQ(json["cloths"].size(), 2u);
    for (std::size_t i = 0; i < 2; ++i) {
        const Json& cloth = json["cloths"][i];
        const ClothInfo info = things.world.cloth_info(things.cloths[i]).value();
        const ClothSettings settings = things.world.cloth_settings(things.cloths[i]).value();
        const ClothReport report = things.world.cloth_report(things.cloths[i]).value();
        EXPECT_EQ(cloth["id"], json_of(things.cloths[i]));
        EXPECT_EQ(cloth["pins"], i == 0 ? 2 : 0);
        EXPECT_EQ(cloth["info"]["particles"], info.particles);
        EXPECT_EQ(cloth["info"]["bytes"], info.bytes);
        EXPECT_EQ(cloth["info"]["mass"].get<float>(), info.mass);
        EXPECT_EQ(cloth["settings"]["fabric"]["warp"].get<float>(), settings.fabric.warp);
        EXPECT_EQ(cloth["settings"]["fabric"]["bending"].get<float>(), settings.fabric.bending);
        EXPECT_EQ(cloth["settings"]["collider_mask"], settings.collider_mask);
        EXPECT_EQ(cloth["settings"]["enabled"], settings.enabled);
        EXPECT_EQ(cloth["report"]["collider_contacts"], report.collider_contacts);
        EXPECT_EQ(cloth["report"]["milliseconds"].get<float>(), report.milliseconds);
        EXPECT_EQ(cloth["report"]["residual"].get<float>(), report.residual);
    }
    EXPECT_EQ(json["cloths"][0]["settings"]["method"]["kind"], "Multilevel");
    EXPECT_EQ(json["cloths"][0]["settings"]["self_collision"]["method"], "contact");
    EXPECT_EQ(json["cloths"][1]["settings"]["method"]["kind"], "Fibres");
    EXPECT_EQ(json["cloths"][1]["settings"]["method"]["shear"], "ldlt");
    EXPECT_EQ(json["cloths"][1]["settings"]["method"]["iterations"], 2);
    EXPECT_EQ(json["cloths"][1]["settings"]["time_scheme"], "of_method");
}

TEST(Describe, SaysWhichClothRaisedWhichFlag) {
    const Things things;
    const Json json = described(things.world);
    ASSERT_TRUE(has(things.world.report().flags, StepFlags::speed_limited));
    EXPECT_EQ(json["report"]["flags"], Json::array({"speed_limited"}));
    EXPECT_EQ(json["cloths"][0]["report"]["flags"], Json::array({"speed_limited"}));
    EXPECT_EQ(json["cloths"][1]["report"]["flags"], Json::array());
    EXPECT_EQ(things.world.cloth_report(things.cloths[0])->flags, StepFlags::speed_limited);
    EXPECT_EQ(things.world.cloth_report(things.cloths[1])->flags, StepFlags::none);
    EXPECT_GT(things.world.cloth_report(things.cloths[0])->milliseconds, 0);
    EXPECT_EQ(things.world.cloth_report(things.cloths[1])->milliseconds, 0) << "it is switched off";
    EXPECT_FALSE(things.world.cloth_report(things.cloths[1])->enabled);
    EXPECT_FALSE(things.world.cloth_report({}));
}

TEST(Describe, SaysNothingOfClothThatTheLastStepLeftOut) {
    Things things;
    ASSERT_NE(things.world.cloth_report(things.cloths[0])->flags, StepFlags::none);
    ASSERT_TRUE(things.world.set_enabled(things.cloths[0], false));
    things.world.step(1.0f / 60);
    const ClothReport report = things.world.cloth_report(things.cloths[0]).value();
    EXPECT_EQ(report.flags, StepFlags::none);
    EXPECT_EQ(report.milliseconds, 0);
    EXPECT_EQ(report.peak_speed, 0);
}

TEST(Describe, HasCollidersBodiesAndShapes) {
    const Things things;
    const Json json = described(things.world);
    ASSERT_EQ(json["colliders"].size(), 2u);
    const Json& ball = json["colliders"][0];
    EXPECT_EQ(ball["id"], json_of(things.ball));
    EXPECT_EQ(ball["body"], json_of(things.body));
    EXPECT_EQ(ball["shape"]["kind"], "Sphere");
    EXPECT_EQ(ball["shape"]["radius"], 0.125);
    EXPECT_EQ(ball["friction"], 0.75);
    EXPECT_EQ(json["colliders"][1]["shape"]["shape"], json_of(things.shape));
    EXPECT_FALSE(json["colliders"][1].contains("body"));
    ASSERT_EQ(json["bodies"].size(), 1u);
    EXPECT_EQ(json["bodies"][0]["settings"]["mass"], 2.5);
    EXPECT_EQ(json["bodies"][0]["state"]["position"][1].get<float>(),
              things.world.body_state(things.body)->position.y);
    ASSERT_EQ(json["shapes"].size(), 1u);
    EXPECT_EQ(json["shapes"][0]["triangles"], 4);
    EXPECT_EQ(json["settings"]["max_speed"], 3.0);
    EXPECT_EQ(json["settings"]["wind"]["velocity"], Json::array({1.0, 0.0, 0.0}));
    EXPECT_EQ(json["report"]["step"], 1);
}

TEST(Describe, CountsTheMemoryOfAllCloths) {
    const Things things;
    const Json json = described(things.world);
    std::uint64_t bytes = things.world.shape_info(things.shape)->bytes;
    for (const ClothId id : things.cloths) bytes += things.world.cloth_info(id)->bytes;
    EXPECT_EQ(json["bytes"], bytes);
}

TEST(Describe, HasTheSameLinesForPeople) {
    const Things things;
    const std::string text = things.world.describe().value();
    for (const char* line : {"\nreport:\n  flags: speed_limited\n", "\ncloths:\n  -\n    id: [",
                             "\n      method:\n        kind: Fibres\n        iterations: 2\n",
                             "\n      flags: none\n", "\ncolliders:\n", "\nbodies:\n", "\nshapes:\n"})
        EXPECT_NE(text.find(line), std::string::npos) << line << text;
    EXPECT_EQ(text.find('{'), std::string::npos);
    EXPECT_EQ(described(World::create().value())["cloths"].size(), 0u);
}

// Sums and greatest values of the cloths' are the step's.
TEST(Describe, HasReportsOfClothsThatAddUpToTheSteps) {
    Simulation simulation = simulation_of("stack", 1000, {.threads = 2});
    for (int k = 0; k < 40; ++k) simulation.step(1.0f / 60);
    const World& world = simulation.world();
    ClothReport sum;
    for (const SceneCloth& cloth : simulation.content().cloths) {
        const ClothReport report = world.cloth_report(cloth.id).value();
        sum.flags = sum.flags | report.flags;
        sum.particles += report.particles;
        sum.self_contacts += report.self_contacts;
        sum.collider_contacts += report.collider_contacts;
        sum.peak_speed = std::max(sum.peak_speed, report.peak_speed);
        sum.residual = std::max(sum.residual, report.residual);
        sum.milliseconds += report.milliseconds;
    }
    const StepReport& step = world.report();
    EXPECT_EQ(sum.flags, step.flags);
    EXPECT_EQ(sum.particles, step.particles);
    EXPECT_EQ(sum.self_contacts, step.self_contacts);
    EXPECT_EQ(sum.collider_contacts, step.collider_contacts);
    EXPECT_EQ(sum.peak_speed, step.peak_speed);
    EXPECT_EQ(sum.residual, step.residual);
    EXPECT_GT(step.self_contacts, 0u);
    EXPECT_GT(sum.milliseconds, 0.3f * step.milliseconds);
    EXPECT_LT(sum.milliseconds, 2.5f * step.milliseconds);
}

}  // namespace
}  // namespace weft::demo
