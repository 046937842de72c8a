// The tests of physics, tested: specimens, the World around them, what an error is, the table.

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <numbers>
#include <set>

#include "demo/study/physics/experiment.h"
#include "demo/study/physics/physics_table.h"
#include "demo/study/physics/physics_test.h"

namespace weft::study {
namespace {

double area_of(const Mesh& mesh) {
    double sum = 0;
    for (const auto& [a, b, c] : mesh.triangles) {
        const Vec2 &p = mesh.pattern[a], &q = mesh.pattern[b], &r = mesh.pattern[c];
        const double twice = static_cast<double>((q.x - p.x) * (r.y - p.y) - (q.y - p.y) * (r.x - p.x));
        sum += twice / 2;
    }
    return std::abs(sum);
}

Vec3 flat(Vec2 p) {
    return {p.x, 0, p.y};
}

TEST(Specimens, CoverTheirPatternOnce) {
    for (const ForceModel model : force_models) {
        for (const Strip& strip : {Strip{0.2, 0.05, 8}, Strip{0.25, 1.5, 16}, Strip{1, 0.1, 17}}) {
            const Mesh mesh = strip_mesh(model, strip, flat);
            EXPECT_NEAR(area_of(mesh), strip.length * strip.width, 1e-5) << name_of(model);
            const Experiment experiment(mesh, made_of(model, Fabric{}));
            double mass = 0;
            for (std::uint32_t i = 0; i < mesh.pattern.size(); ++i) mass += experiment.mass(i);
            EXPECT_NEAR(mass, 0.2 * strip.length * strip.width, 1e-5) << name_of(model);
        }
    }
    const Mesh disc = disc_mesh(0.15, 20, flat);
    EXPECT_EQ(disc.pattern.size(), 1261u);
    EXPECT_NEAR(area_of(disc), 60 * 0.15 * 0.15 * std::sin(2 * std::numbers::pi / 120), 1e-6);
}

TEST(Specimens, AreOneConnectedClothWithoutFaults) {
    for (const Mesh& mesh : {strip_mesh(ForceModel::mesh, {0.2, 0.05, 9}, flat), disc_mesh(0.15, 6, flat)}) {
        auto world = World::create();
        const auto info = world->measure_cloth(mesh);
        ASSERT_TRUE(info.ok()) << info.error().message;
        EXPECT_EQ(info->components, 1u);
        EXPECT_EQ(info->particles, mesh.positions.size());
        EXPECT_EQ(info->misoriented_edges + info->dropped_triangles + info->loose_particles, 0u);
    }
}

TEST(Specimens, HaveTwoStraightColumnsToClamp) {
    for (const ForceModel model : force_models) {
        const Experiment strip(strip_mesh(model, {0.2, 0.05, 16}, flat), made_of(model, Fabric{}));
        std::set<float> columns;
        for (const std::uint32_t i : strip.vertices([](Vec2 p) { return p.x < 0.0126f; }))
            columns.insert(strip.mesh().pattern[i].x);
        EXPECT_EQ(columns.size(), 2u) << name_of(model);
    }
}

TEST(Experiment, FallsFreelyAndComesToRestWhenHeld) {
    Experiment cloth(strip_mesh(ForceModel::sheet, {1, 1, 4}, flat), made_of(ForceModel::sheet, Fabric{}));
    const double start = cloth.energy();
    cloth.run(0.5);
    EXPECT_NEAR(cloth.rms_speed(), 0.5 * Experiment::gravity, 1e-3);
    EXPECT_NEAR(cloth.energy(), start, 0.05 * Experiment::gravity);
    EXPECT_FALSE(cloth.come_to_rest(0, 0.5)) << "it falls on";
    cloth.pin([](Vec2 p) { return p.x == 0; });
    EXPECT_TRUE(cloth.come_to_rest(5, 30, 1e-4f));
    EXPECT_LT(cloth.rms_speed(), 1e-3);
}

TEST(Findings, AreAsFarOffAsTheyAre) {
    EXPECT_DOUBLE_EQ(error_of(finding("", "", 11, 10)), 0.1);
    EXPECT_DOUBLE_EQ(error_of(finding("", "", 9, 10)), -0.1);
    EXPECT_DOUBLE_EQ(error_of(finding("", "", -9, -10)), 0.1);
    EXPECT_DOUBLE_EQ(error_of(finding("", "", 0.3, 0)), 0.3);
    EXPECT_DOUBLE_EQ(error_of({"", "", 0.3, 0.15, 0.4}), 0);
    EXPECT_DOUBLE_EQ(error_of({"", "", 0.8, 0.15, 0.4}), 1);
    EXPECT_DOUBLE_EQ(error_of({"", "", 0.075, 0.15, 0.4}), -0.5);
    EXPECT_TRUE(std::isnan(error_of({"", "", 3})));
    EXPECT_FALSE(std::isfinite(error_of(finding("", "", std::numeric_limits<double>::infinity(), 1))));
}

TEST(PhysicsTable, ShowsMeasuredBesideKnown) {
    const PhysicsTest test{"cantilever, Gamma 5", ForceModel::mesh, 16, true, {}};
    const Finding drop = finding("drop", "lengths", 0.5, 0.4), range{"folds", "", 7, 6, 8, 1261},
                  unknown{"f", "Hz", 3};
    CsvTable table{physics_columns(), {}};
    for (const Finding& each : {drop, range, unknown}) {
        CsvRow row = physics_row(test, &each);
        for (const std::string& column : table.columns) row.try_emplace(column, "");
        for (const auto& [column, text] : row) EXPECT_EQ(text.find(','), std::string::npos) << column;
        table.rows.push_back(row);
    }
    EXPECT_TRUE(is_physics_table(table));
    const std::string text = physics_markdown(table);
    EXPECT_NE(
        text.find("| cantilever Gamma 5 | springs mesh | 16 | drop [lengths] | 0.5 | 0.4 | +25.0 % |\n"),
        std::string::npos)
        << text;
    EXPECT_NE(text.find("| 1261 vertices | folds | 7 | 6 to 8 | within |\n"), std::string::npos) << text;
    EXPECT_NE(text.find("| f [Hz] | 3 | - | - |\n"), std::string::npos) << text;
}

TEST(PhysicsTests, HaveNamesOfTheirOwnAndAQuickRunOfEveryKindAndModel) {
    std::set<std::string> names, kinds, quick;
    for (const PhysicsTest& test : all_physics_tests()) {
        const std::string model = name_of(test.model);
        EXPECT_TRUE(names.insert(test.name + model + std::to_string(test.cells)).second) << test.name;
        const std::string kind = test.name.substr(0, test.name.find(',')) + model;
        kinds.insert(kind);
        if (test.quick) quick.insert(kind);
    }
    EXPECT_EQ(kinds, quick);
    EXPECT_GE(kinds.size(), 3u * 10);
}

}  // namespace
}  // namespace weft::study
