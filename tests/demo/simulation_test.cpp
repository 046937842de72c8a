// A scene in a World: its settings, its files, and how it describes itself.

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>
#include <string>

#include "demo/character/garment/garment_mesh.h"
#include "demo/options/method_table.h"
#include "demo/scene_simulation.h"
#include "tests/demo/small_world.h"

namespace weft::demo {

namespace {

Simulation small_flag(const Overrides& overrides = {}) {
    return simulation_of("flag", 300, overrides);
}

std::uint64_t hash_after(Simulation& simulation, int steps) {
    for (int i = 0; i < steps; ++i) simulation.step(1.0f / 60.0f);
    return simulation.world().state_hash();
}

TEST(Simulation, TakesOverrides) {
    Overrides overrides;
    overrides.wind = Vec3{1, 2, 3};
    overrides.method = Chebyshev{};
    overrides.iterations = 3;
    overrides.fabric = *Fabric::named("denim");
    overrides.substeps = 5;
    overrides.contact = SelfCollisionMethod::off;
    overrides.threads = 2;
    const Simulation simulation = small_flag(overrides);
    const WorldSettings& world = simulation.world().settings();
    EXPECT_EQ(world.wind.velocity.x, 1);
    EXPECT_EQ(world.wind.velocity.y, 2);
    EXPECT_EQ(world.wind.velocity.z, 3);
    EXPECT_EQ(world.substeps, 5);
    EXPECT_EQ(world.threads, 2);
    const auto cloth = simulation.world().cloth_settings(simulation.content().cloths.front().id);
    EXPECT_EQ(iterations_of(cloth->method), 3);
    EXPECT_TRUE(std::holds_alternative<Chebyshev>(cloth->method));
    EXPECT_EQ(cloth->fabric, *Fabric::named("denim"));
    EXPECT_EQ(cloth->self_collision.method, SelfCollisionMethod::off);
}

TEST(Simulation, RefusesWhatTheWorldRefuses) {
    Overrides overrides;
    overrides.substeps = 0;
    EXPECT_FALSE(Simulation::create(*find_scene("flag"), {}, overrides).ok());
    overrides = {};
    overrides.iterations = -1;
    EXPECT_FALSE(Simulation::create(*find_scene("flag"), {}, overrides).ok());
}

TEST(Simulation, RunsTheSameWayAfterARestart) {
    Simulation simulation = small_flag();
    const std::uint64_t first = hash_after(simulation, 20);
    ASSERT_TRUE(simulation.restart().ok());
    EXPECT_EQ(simulation.time(), 0);
    EXPECT_EQ(hash_after(simulation, 20), first);
}

/// A tube of cloth, standing along +Z, as a garment file.
void write_tube(const std::filesystem::path& file) {
    constexpr int around = 12, rings = 6;
    std::ofstream out(file);
    for (int ring = 0; ring < rings; ++ring) {
        for (int i = 0; i < around; ++i) {
            const double angle = 6.283185307 * i / around, height = 0.1 * ring;
            out << "v " << 0.2 * std::cos(angle) << ' ' << 0.2 * std::sin(angle) << ' ' << height << "\nvt "
                << 0.2 * angle << ' ' << height << '\n';
        }
    }
    const auto triangle = [&](int a, int b, int c) {
        out << "f " << a << '/' << a << ' ' << b << '/' << b << ' ' << c << '/' << c << '\n';
    };
    for (int ring = 0; ring + 1 < rings; ++ring) {
        for (int i = 0; i < around; ++i) {
            const int a = ring * around + i + 1, b = ring * around + (i + 1) % around + 1;
            triangle(a, b, b + around);
            triangle(a, b + around, a + around);
        }
    }
}

TEST(Simulation, GoesOnAsItWasWhereARestartFails) {
    const std::filesystem::path file = std::filesystem::path(testing::TempDir()) / "weft_restarted_tube.obj";
    write_tube(file);
    SceneOptions options;
    options.garment = file;
    auto made = Simulation::create(*find_scene("garment"), options, {});
    auto twin = Simulation::create(*find_scene("garment"), options, {});
    ASSERT_TRUE(made.ok() && twin.ok()) << made.error().message;
    EXPECT_EQ(hash_after(*made, 5), hash_after(*twin, 5));

    std::filesystem::remove(file);
    const auto restarted = made->restart();
    ASSERT_FALSE(restarted.ok());
    EXPECT_NE(restarted.error().message.find(file.string()), std::string::npos) << restarted.error().message;
    EXPECT_EQ(made->time(), twin->time());
    EXPECT_TRUE(made->world().cloth(made->content().cloths.front().id).ok());
    EXPECT_EQ(hash_after(*made, 5), hash_after(*twin, 5));

    write_tube(file);
    EXPECT_TRUE(made->restart().ok());
    EXPECT_EQ(made->time(), 0);
    std::filesystem::remove(file);
}

/// A tube with three pleats that stand out by 6 cm, their sides 2 mm apart, as a garment file.
void write_pleated_tube(const std::filesystem::path& file) {
    std::vector<std::array<double, 2>> ring;
    for (int pleat = 0; pleat < 3; ++pleat) {
        const double middle = 2.0943951 * pleat;
        for (const auto& [radius, aside] :
             {std::array{0.2, -0.001}, {0.26, -0.001}, {0.26, 0.001}, {0.2, 0.001}})
            ring.push_back({radius * std::cos(middle) - aside * std::sin(middle),
                            radius * std::sin(middle) + aside * std::cos(middle)});
        for (int i = 1; i < 8; ++i) {
            const double angle = middle + 2.0943951 * i / 8;
            ring.push_back({0.2 * std::cos(angle), 0.2 * std::sin(angle)});
        }
    }
    constexpr std::size_t rows = 9;
    std::ofstream out(file);
    for (std::size_t row = 0; row < rows; ++row)
        for (const auto& [x, y] : ring)
            out << "v " << x << ' ' << y << ' ' << 0.06 * static_cast<double>(row) << '\n';
    for (std::size_t row = 0; row + 1 < rows; ++row)
        for (std::size_t i = 0; i < ring.size(); ++i) {
            const std::size_t a = row * ring.size() + i + 1,
                              b = row * ring.size() + (i + 1) % ring.size() + 1;
            out << "f " << a << ' ' << b << ' ' << b + ring.size() << "\nf " << a << ' ' << b + ring.size()
                << ' ' << a + ring.size() << '\n';
        }
}

/// The most by which an edge is longer than at rest [m].
float most_stretched(const Mesh& now, const Mesh& rest) {
    float most = 0;
    for (const Triangle& t : rest.triangles)
        for (std::size_t k = 0; k < 3; ++k) {
            const auto length = [&](const Mesh& mesh) {
                return (to_vector(mesh.positions[t[k]]) - to_vector(mesh.positions[t[(k + 1) % 3]])).norm();
            };
            most = std::max(most, length(now) - length(rest));
        }
    return most;
}

TEST(Simulation, AGarmentsOwnMeshIsDrawnOverAProxy) {
    const std::filesystem::path file = std::filesystem::path(testing::TempDir()) / "weft_pleated_tube.obj";
    write_pleated_tube(file);
    SceneOptions options;
    options.garment = file;
    options.unit = 1;
    options.particles = 6000;
    options.simulated = 500;
    auto made = Simulation::create(*find_scene("garment"), options, {});
    std::filesystem::remove(file);
    ASSERT_TRUE(made.ok()) << made.error().message;
    const SceneCloth& cloth = made->content().cloths.front();
    ASSERT_TRUE(cloth.drawn);
    EXPECT_NEAR(made->world().cloth_info(cloth.id)->particles, 500, 50);
    EXPECT_EQ(count_openings(cloth.mesh), 2u) << "pleats are no second layer: the proxy is not torn";
    const Mesh start = current_mesh(made->world(), made->content());
    ASSERT_GT(start.positions.size(), 3000u);
    ASSERT_EQ(start.triangles, cloth.fine.triangles);
    for (std::size_t v = 0; v < start.positions.size(); ++v)
        ASSERT_LT((to_vector(start.positions[v]) - to_vector(cloth.fine.positions[v])).norm(), 1e-5f) << v;
    for (int step = 0; step < 60; ++step) made->step(1.0f / 60);
    const Mesh after = current_mesh(made->world(), made->content());
    EXPECT_LT(most_stretched(after, start), 0.05f) << "nothing drawn is left behind";
    const ClothView& view = *made->world().cloth(cloth.id);
    for (const Vec3& p : after.positions) {
        ASSERT_GT(p.y, view.bounds.lower.y - 0.02f);
        ASSERT_LT(p.y, view.bounds.upper.y + 0.02f);
    }
}

TEST(Simulation, KeepsSettingsOverARestart) {
    Simulation simulation = small_flag();
    WorldSettings world = simulation.world().settings();
    world.wind.gust = 0.125f;
    ASSERT_TRUE(simulation.world().set_settings(world).ok());
    ClothSettings cloth = *simulation.world().cloth_settings(simulation.content().cloths.front().id);
    cloth.fabric.warp = 123;
    ASSERT_TRUE(simulation.world().set_cloth_settings(simulation.content().cloths.front().id, cloth).ok());

    ASSERT_TRUE(simulation.restart().ok());
    EXPECT_EQ(simulation.world().settings().wind.gust, 0.125f);
    EXPECT_EQ(simulation.world().cloth_settings(simulation.content().cloths.front().id)->fabric.warp, 123);
}

TEST(Simulation, WritesItsClothsAsOneMesh) {
    Simulation simulation = small_flag();
    const Mesh before = current_mesh(simulation.world(), simulation.content());
    const Mesh& start = simulation.content().cloths.front().mesh;
    ASSERT_EQ(before.positions.size(), start.positions.size());
    EXPECT_EQ(before.triangles, start.triangles);
    for (std::size_t i = 0; i < start.positions.size(); ++i) {
        EXPECT_EQ(before.positions[i].x, start.positions[i].x);
        EXPECT_EQ(before.positions[i].y, start.positions[i].y);
        EXPECT_EQ(before.positions[i].z, start.positions[i].z);
    }
}

// World::describe as JSON, parsed and held against what the World says call by call.

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
