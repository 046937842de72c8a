// Settings that change before the first step leave the cloth as if it had had them from the start.

#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "tests/cloth/fixtures.h"
#include "tests/cloth/meshes.h"

namespace weft::test {
namespace {

struct Kind {
    std::string name;
    ClothSettings settings;
};

std::vector<Kind> kinds() {
    const auto elements = [](float bending, bool dihedral, bool consistent_mass) {
        ClothSettings settings;
        settings.fabric.bending = bending;
        settings.finite_elements = {
            .enabled = true, .dihedral = dihedral, .consistent_mass = consistent_mass};
        return settings;
    };
    const auto stiff_weft = [](ClothSettings settings) {
        settings.fabric.bending_ratio = 30;
        settings.fabric.bending = 1e-3f;
        return settings;
    };
    ClothSettings jacobi;
    jacobi.method = Jacobi{};
    return {{"springs", {}},
            {"Jacobi", jacobi},
            {"quadratic", elements(1e-3f, false, false)},
            {"dihedral", elements(1e-3f, true, false)},
            {"consistent mass", elements(1e-3f, false, true)},
            {"membrane only", elements(0, false, false)},
            {"stiff weft", stiff_weft({})},
            {"stiff weft of elements", stiff_weft(elements(1e-3f, false, false))}};
}

/// Where a sheet that starts curved and hangs by two corners is after some steps.
std::vector<Vec4> after_steps(const ClothSettings& first, const ClothSettings& then) {
    Mesh mesh = sheet(9, 9);
    mesh.rows = mesh.columns = 0;
    for (Vec3& p : mesh.positions) p.y = 0.3f * p.x * p.x - 0.2f * p.z * p.x;
    World world = World::create(vacuum({0, -9.81f, 0})).value();
    const ClothId id = world.add_cloth(mesh, first).value();
    EXPECT_TRUE(world.set_cloth_settings(id, then));
    EXPECT_TRUE(world.pin(id, 0));
    EXPECT_TRUE(world.pin(id, 8));
    for (int step = 0; step < 15; ++step) world.step(1.0f / 60);
    const ClothView view = world.cloth(id).value();
    return {view.positions.begin(), view.positions.end()};
}

float farthest(const std::vector<Vec4>& a, const std::vector<Vec4>& b) {
    float most = 0;
    for (std::size_t i = 0; i < a.size(); ++i) most = std::max(most, (xyz(a[i]) - xyz(b[i])).norm());
    return most;
}

TEST(ChangedSettings, AreAsIfTheyHadBeenThereFromTheStart) {
    const std::vector<Kind> all = kinds();
    for (const Kind& to : all) {
        const std::vector<Vec4> expected = after_steps(to.settings, to.settings);
        for (const Kind& from : all) {
            EXPECT_EQ(farthest(after_steps(from.settings, to.settings), expected), 0)
                << from.name << " to " << to.name;
            if (from.name == to.name) continue;
            EXPECT_GT(farthest(after_steps(from.settings, from.settings), expected), 1e-6f)
                << from.name << " and " << to.name << " are alike: the test sees nothing";
        }
    }
}

/// Where a sheet is that flutters in a strong wind for `seconds`.
std::vector<Vec4> in_wind(int substeps, int steps, float dt, int of_the_cloth = 1) {
    WorldSettings settings = vacuum({0, -9.81f, 0});
    settings.wind = {.velocity = {3, 2, 9}, .air_density = 1.2f};
    settings.substeps = substeps;
    World world = World::create(settings).value();
    ClothSettings cloth;
    cloth.substeps = of_the_cloth;
    const ClothId id = world.add_cloth(sheet(9, 9), cloth).value();
    EXPECT_TRUE(world.pin(id, 0));
    EXPECT_TRUE(world.pin(id, 8));
    for (int step = 0; step < steps; ++step) world.step(dt);
    const ClothView view = world.cloth(id).value();
    return {view.positions.begin(), view.positions.end()};
}

// So much is near then that the list of pairs is full: were all to stand still, it would never come home.
TEST(ChangedSettings, ClothThatWasDrawnOutComesHome) {
    ClothSettings settings;
    settings.self_collision = {.method = SelfCollisionMethod::contact};
    World world = World::create().value();
    const Mesh mesh =
        make_sheet({.rows = 20, .columns = 20, .origin = {-0.5f, 1, -0.5f}, .u = {1, 0, 0}, .v = {0, 0, 1}})
            .value();
    const ClothId id = world.add_cloth(mesh, settings).value();
    ASSERT_TRUE(world.pin(id, std::vector<std::uint32_t>{0, 19}));
    ASSERT_TRUE(world.add_collider({.shape = Sphere{{0, 0.5f, 0.3f}, 0.1f}}));
    const auto longest_edge = [&] {
        const ClothView view = world.cloth(id).value();
        float longest = 0;
        for (const Triangle& t : view.triangles)
            for (std::size_t k = 0; k < 3; ++k)
                longest = std::max(longest,
                                   (xyz(view.positions[t[k]]) - xyz(view.positions[t[(k + 1) % 3]])).norm());
        return longest;
    };
    const float cell = 1.0f / 19;
    float drawn_out = 0;
    bool was_full = false;
    for (const float shear : {0.0f, 1e9f, 100.0f}) {
        settings.fabric.shear = shear;
        ASSERT_TRUE(world.set_cloth_settings(id, settings));
        for (int k = 0; k < 90; ++k) {
            const StepReport& report = world.step(1.0f / 60);
            was_full |= has(report.flags, StepFlags::contacts_dropped);
            ASSERT_EQ(report.crossings, 0u) << shear << ", step " << k;
            if (shear > 100) drawn_out = std::max(drawn_out, longest_edge());
        }
    }
    EXPECT_TRUE(was_full) << "by this it is tested";
    EXPECT_GT(drawn_out, 3 * cell);
    EXPECT_LT(longest_edge(), 2.5f * cell);
}

TEST(Substeps, AirActsOnTheClothAsItLiesInEachOfThem) {
    const std::vector<Vec4> one_by_one = in_wind(1, 64, 1.0f / 128), by_eight = in_wind(8, 8, 1.0f / 16);
    EXPECT_LT(farthest(one_by_one, by_eight), 1e-4f);
    EXPECT_LT(farthest(one_by_one, in_wind(1, 8, 1.0f / 16, 8)), 1e-4f) << "of the cloth's own";
    EXPECT_LT(farthest(one_by_one, in_wind(2, 8, 1.0f / 16, 4)), 1e-4f) << "of both";
}

}  // namespace
}  // namespace weft::test
