// Fabrics by name: all can be had, worn and told apart.

#include "weft/fabrics.h"

#include <gtest/gtest.h>

#include <cmath>
#include <set>
#include <string>

#include "weft/weft.h"

namespace weft {
namespace {

TEST(Fabrics, AreFoundByName) {
    std::set<std::string> names;
    for (const NamedFabric& each : fabrics()) {
        const auto found = Fabric::named(each.name);
        ASSERT_TRUE(found.ok()) << each.name;
        EXPECT_EQ(*found, each.fabric) << each.name;
        EXPECT_FALSE(std::string(each.source).empty()) << each.name;
        names.insert(each.name);
    }
    const std::set<std::string> expected{"silk",       "cotton",       "t-shirt", "trousers", "denim",
                                         "tablecloth", "light-jacket", "flag",    "leather"};
    EXPECT_EQ(names, expected);
}

TEST(Fabrics, ThatAreNotThereAreRefusedWithTheNamesThereAre) {
    for (const char* name : {"", "Denim", "felt", "denim "}) {
        const auto found = Fabric::named(name);
        ASSERT_FALSE(found.ok()) << name;
        EXPECT_EQ(found.error().code, ErrorCode::invalid_argument);
        EXPECT_NE(found.error().message.find(std::string("no fabric ") + name), std::string::npos);
        for (const NamedFabric& each : fabrics())
            EXPECT_NE(found.error().message.find(each.name), std::string::npos) << each.name;
    }
}

/// Length of a strip that a fabric's weight bends as much as it bends [m].
float bending_length(const Fabric& fabric) {
    return std::cbrt(fabric.bending / (fabric.areal_density * 9.81f));
}

TEST(Fabrics, BendAsTextilesDo) {
    for (const NamedFabric& each : fabrics()) {
        EXPECT_GT(bending_length(each.fabric), 0.01f) << each.name;
        EXPECT_LT(bending_length(each.fabric), 0.05f) << each.name;
    }
    const auto stiffness = [](const char* name) { return Fabric::named(name)->bending; };
    EXPECT_LT(stiffness("cotton"), stiffness("t-shirt"));
    EXPECT_LT(stiffness("t-shirt"), stiffness("denim"));
    EXPECT_LT(stiffness("denim"), stiffness("leather"));
}

/// A hung square of 20 cm stays whole at the default method.
TEST(Fabrics, HangWithoutStretchingBeyondTheirMeasure) {
    for (const NamedFabric& each : fabrics()) {
        auto world = World::create();
        ASSERT_TRUE(world.ok());
        const auto mesh = make_sheet({.rows = 17, .columns = 17, .u = {0.2f, 0, 0}, .v = {0, 0, 0.2f}});
        ClothSettings settings;
        settings.fabric = each.fabric;
        settings.air_damping = 5;  // for rest sooner
        const auto cloth = world->add_cloth(*mesh, settings);
        ASSERT_TRUE(cloth.ok()) << each.name << ": " << cloth.error().message;
        ASSERT_TRUE(world->pin(*cloth, std::vector<std::uint32_t>{0, 16}).ok());
        for (int k = 0; k < 600; ++k) {
            EXPECT_EQ(world->step(1.0f / 60).flags, StepFlags::none) << each.name;
        }
        EXPECT_LT(world->report().peak_speed, 0.01f) << each.name << " comes to rest";
        const ClothView view = *world->cloth(*cloth);
        const auto at = [&](std::uint32_t vertex) { return view.positions[view.vertex_to_particle[vertex]]; };
        for (std::uint32_t row = 0; row + 1 < 17; ++row) {
            const Vec4 a = at(row * 17 + 8), b = at(row * 17 + 25);
            const float length = std::hypot(a.x - b.x, a.y - b.y, a.z - b.z);
            EXPECT_NEAR(length, 0.0125f, 0.0125f * 0.05f) << each.name << " row " << row;
        }
    }
}

}  // namespace
}  // namespace weft
