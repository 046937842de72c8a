// Maps per vertex: a map of one value is that setting; and each vertex has its own.

#include <gtest/gtest.h>

#include <string>

#include "tests/cloth/worn/worn.h"

namespace weft::test::worn {
namespace {

/// A sheet that hangs from two corners onto a ball, after a second. The ball is off the middle: to which side
/// a fold goes in a scene that is as in a mirror, the last digit says.
struct Draped {
    Draped(const ClothSettings& settings, bool grid, bool with_ball = true)
        : world(World::create(vacuum(downwards)).value()) {
        Mesh mesh = hanging(9, 8);
        if (!grid) mesh.rows = mesh.columns = 0;
        cloth = world.add_cloth(mesh, settings).value();
        EXPECT_TRUE(world.pin(cloth, std::vector<std::uint32_t>{0, 7}));
        if (!with_ball) return;
        EXPECT_TRUE(world.add_collider({.shape = Sphere{{0.04f, 0.3f, 0.1f}, 0.15f}, .friction = 0.4f}));
    }
    void set(Map map, float value) { EXPECT_TRUE(world.set_map(cloth, map, std::vector<float>(72, value))); }
    void run(int steps) {
        for (int k = 0; k < steps; ++k) world.step(h);
    }
    World world;
    ClothId cloth;
};

void expect_same(const Draped& a, const Draped& b, float within, const char* what) {
    EXPECT_LT(farthest(places_of(a.world, a.cloth), {}, places_of(b.world, b.cloth)), within) << what;
}

struct MapCase {
    std::string name;
    ClothSettings settings;
    bool grid = true;
};
void PrintTo(const MapCase& of, std::ostream* out) {
    *out << of.name;
}
std::vector<MapCase> map_cases() {
    std::vector<MapCase> result;
    const auto add = [&](const char* name, bool grid, const auto& change) {
        change(result.emplace_back(MapCase{name, {}, grid}).settings);
    };
    // Solved well: with a map levels are others, and what is left unsolved is.
    const auto solved = [](ClothSettings& s) { s.method = Multilevel{.passes = 100}; };
    add("Sheet", true, solved);
    add("Mesh", false, solved);
    add("Stiffening", true, [&](ClothSettings& s) {
        solved(s);
        s.fabric.stiffening = 4;
    });
    add("Xpbd", true, [](ClothSettings& s) { s.method = Xpbd{}; });
    add("Elements", false, [&](ClothSettings& s) {
        solved(s);
        s.finite_elements.enabled = true;
    });
    add("Contact", true,
        [](ClothSettings& s) { s.self_collision = {.method = SelfCollisionMethod::contact}; });
    return result;
}
class MapOf : public testing::TestWithParam<MapCase> {};
INSTANTIATE_TEST_SUITE_P(, MapOf, testing::ValuesIn(map_cases()),
                         [](const auto& info) { return info.param.name; });

TEST_P(MapOf, OneValueIsTheSetting) {
    if (GetParam().name == "Contact") GTEST_SKIP() << "folds where the last digit tells it to";
    const auto compare = [&](Map map, float value, const char* what, const auto& change, bool mid_run) {
        ClothSettings changed = GetParam().settings;
        change(changed);
        const bool by_contact = map == Map::friction || map == Map::thickness;
        Draped with(GetParam().settings, GetParam().grid, by_contact),
            set(GetParam().settings, GetParam().grid, by_contact);
        if (mid_run) {
            with.run(10);
            set.run(10);
        }
        with.set(map, value);
        ASSERT_TRUE(set.world.set_cloth_settings(set.cloth, changed));
        with.run(20);
        set.run(20);
        EXPECT_EQ(with.world.report().collider_contacts > 0, by_contact);
        expect_same(with, set, by_contact ? 1e-2f : 1e-3f, what);
    };
    for (const bool mid_run : {false, true}) {
        compare(
            Map::mass, 3, "mass", [](ClothSettings& s) { s.fabric.areal_density *= 3; }, mid_run);
        compare(
            Map::stiffness, 0.2f, "stiffness",
            [](ClothSettings& s) {
                s.fabric.warp *= 0.2f;
                s.fabric.weft *= 0.2f;
                s.fabric.shear *= 0.2f;
            },
            mid_run);
        compare(
            Map::friction, 0.25f, "friction", [](ClothSettings& s) { s.friction = 0.25f; }, mid_run);
        compare(
            Map::thickness, 0.2f, "thickness", [](ClothSettings& s) { s.thickness *= 0.2f; }, mid_run);
    }
}

TEST_P(MapOf, TakenAwayNothingIsLeft) {
    Draped with(GetParam().settings, GetParam().grid), plain(GetParam().settings, GetParam().grid);
    const ClothInfo before = plain.world.cloth_info(plain.cloth).value();
    for (const Map map : {Map::mass, Map::stiffness, Map::friction, Map::thickness}) with.set(map, 0.5f);
    EXPECT_NEAR(with.world.cloth_info(with.cloth)->mass, before.mass / 2, 1e-5f);
    for (const Map map : {Map::mass, Map::stiffness, Map::friction, Map::thickness})
        ASSERT_TRUE(with.world.set_map(with.cloth, map, {}));
    EXPECT_EQ(with.world.cloth_info(with.cloth).value(), before);
    with.run(20);
    plain.run(20);
    EXPECT_EQ(with.world.state_hash(), plain.world.state_hash());
}

// Two halves of a sheet, each on its own: on the ground they lie as high as their thickness.
TEST(Maps, EachVertexHasItsThickness) {
    World world = World::create(vacuum(downwards)).value();
    const ClothId cloth = world.add_cloth(sheet(6, 6)).value();
    ASSERT_TRUE(world.add_collider({.shape = Plane{}}));
    std::vector<float> thickness(36, 1);
    for (std::size_t v = 0; v < 18; ++v) thickness[v] = 0.2f;
    ASSERT_TRUE(world.set_map(cloth, Map::thickness, thickness));
    ASSERT_TRUE(world.move_cloth(cloth, {.translation = {0, 0.02f, 0}}));
    for (int k = 0; k < 60; ++k) world.step(h);
    const ClothView view = *world.cloth(cloth);
    for (const std::size_t v : {0u, 5u, 7u}) EXPECT_NEAR(view.positions[v].y, 0.001f, 2e-4f);
    for (const std::size_t v : {30u, 35u, 28u}) EXPECT_NEAR(view.positions[v].y, 0.005f, 2e-4f);
}

// Particles on a slope of 0.4: those of friction 0.6 stay, those of 0.2 slide by (sin - 0.2 cos) g t^2 / 2.
TEST(Maps, EachVertexHasItsFriction) {
    for (const Method& method : {Method(Multilevel{}), Method(Xpbd{})}) {
        World world = World::create(vacuum({0.4f * g, -g, 0})).value();
        Mesh mesh;  // two triangles, far apart
        for (const float z : {0.0f, 1.0f}) {
            const auto first = static_cast<std::uint32_t>(mesh.positions.size());
            for (const Vec3& p : {Vec3{0, 0.005f, z}, Vec3{0, 0.005f, z + 0.1f}, Vec3{0.1f, 0.005f, z}})
                mesh.positions.push_back(p);
            mesh.triangles.push_back({first, first + 1, first + 2});
        }
        ClothSettings settings;
        settings.method = method;
        settings.air_damping = 0;
        const ClothId cloth = world.add_cloth(mesh, settings).value();
        ASSERT_TRUE(world.add_collider({.shape = Plane{}, .friction = 0.6f}));
        const float third = 1.0f / 3;
        ASSERT_TRUE(world.set_map(cloth, Map::friction, std::vector<float>{1, 1, 1, third, third, third}));
        for (int k = 0; k < 60; ++k) world.step(h);
        const ClothView view = *world.cloth(cloth);
        const auto x = [&](std::size_t v) { return view.positions[view.vertex_to_particle[v]].x; };
        EXPECT_NEAR(x(0), 0, 0.005f);
        EXPECT_NEAR(x(3), 0.2f * g / 2, 0.1f);
    }
}

// A strip hung by one end: a soft half and a stiff one, in series.
TEST(Maps, EachVertexHasItsStiffness) {
    for (const bool grid : {true, false}) {
        World world = World::create(vacuum()).value();
        Mesh mesh = make_sheet({.rows = 9, .columns = 2, .u = {0.1f, 0, 0}, .v = {0, 0, 0.8f}}).value();
        if (!grid) mesh.rows = mesh.columns = 0;
        const ClothId cloth = world.add_cloth(mesh).value();
        std::vector<float> stiffness(18, 1);
        for (std::size_t v = 0; v < 10; ++v) stiffness[v] = 0.25f;
        ASSERT_TRUE(world.set_map(cloth, Map::stiffness, stiffness));
        ASSERT_TRUE(world.pin(cloth, std::vector<std::uint32_t>{0, 1, 16, 17}));
        for (const std::uint32_t v : {16u, 17u})
            ASSERT_TRUE(world.move_pin(cloth, v, {v == 16 ? -0.5f : -0.4f, 0, -0.5f + 0.82f}));
        for (int k = 0; k < 200; ++k) world.step(h);
        const ClothView view = *world.cloth(cloth);
        const auto strain = [&](std::uint32_t a, std::uint32_t b) {
            return (view.positions[view.vertex_to_particle[b]].z -
                    view.positions[view.vertex_to_particle[a]].z) /
                       0.1f -
                   1;
        };
        EXPECT_NEAR(strain(2, 4) / strain(12, 14), 4, 0.4f) << (grid ? "sheet" : "mesh");
    }
}

TEST(Maps, EachVertexHasItsMass) {
    World world = World::create(vacuum()).value();
    const ClothId cloth = world.add_cloth(sheet(5, 5)).value();
    std::vector<float> mass(25, 1);
    mass[12] = 7;
    const float before = world.cloth(cloth)->positions[12].w, other = world.cloth(cloth)->positions[11].w;
    ASSERT_TRUE(world.set_map(cloth, Map::mass, mass));
    EXPECT_FLOAT_EQ(world.cloth(cloth)->positions[12].w, before / 7);
    EXPECT_EQ(world.cloth(cloth)->positions[11].w, other);
}

TEST(Maps, PinsFromOneHalfOn) {
    World world = World::create(vacuum(downwards)).value();
    const ClothId cloth = world.add_cloth(sheet(3, 3)).value();
    ASSERT_TRUE(world.pin(cloth, std::vector<std::uint32_t>{0, 8}));
    ASSERT_TRUE(world.move_pin(cloth, 0, {-0.5f, 0.01f, -0.5f}));
    ASSERT_TRUE(world.set_map(cloth, Map::pin, std::vector<float>{1, 0.5f, 0.49f, 0, 0, 0, 0, 0, 0}));
    world.step(h);
    const ClothView view = *world.cloth(cloth);
    EXPECT_EQ(view.positions[0].w, 0);
    EXPECT_EQ(view.positions[0].y, 0.01f) << "it still goes where it was told to";
    EXPECT_EQ(view.positions[1].y, 0);
    EXPECT_GT(view.positions[2].w, 0);
    EXPECT_GT(view.positions[8].w, 0) << "let go";
}

TEST(Maps, RefuseWhatTheyCannotBe) {
    World world = World::create(vacuum()).value();
    const ClothId cloth = world.add_cloth(sheet(3, 3)).value();
    const std::uint64_t before = world.state_hash();
    const auto message = [](const Result<void>& result) {
        EXPECT_FALSE(result);
        return result ? std::string() : result.error().message;
    };
    std::vector<float> values(9, 1);
    values[4] = 0;
    EXPECT_NE(message(world.set_map(cloth, Map::mass, values)).find("Map::mass[4] is 0"), std::string::npos);
    values.pop_back();
    EXPECT_NE(message(world.set_map(cloth, Map::friction, values)).find("Map::friction has 8 values"),
              std::string::npos);
    EXPECT_EQ(world.state_hash(), before);
    ClothSettings consistent;
    consistent.finite_elements = {.enabled = true, .consistent_mass = true};
    ASSERT_TRUE(world.set_map(cloth, Map::mass, std::vector<float>(9, 2.0f)));
    EXPECT_NE(message(world.set_cloth_settings(cloth, consistent)).find("consistent_mass"),
              std::string::npos);
    ASSERT_TRUE(world.set_map(cloth, Map::mass, {}));
    ASSERT_TRUE(world.set_cloth_settings(cloth, consistent));
    EXPECT_NE(
        message(world.set_map(cloth, Map::stiffness, std::vector<float>(9, 2.0f))).find("consistent_mass"),
        std::string::npos);
}

}  // namespace
}  // namespace weft::test::worn
