// Surfaces that begin exactly on one another, as layers that were exported flat: contact parts them.

#include <gtest/gtest.h>

#include <cmath>
#include <Eigen/Geometry>
#include <numbers>
#include <numeric>
#include <string>
#include <utility>
#include <vector>

#include "tests/cloth/contact/crossing_count.h"
#include "tests/cloth/fixtures.h"
#include "tests/cloth/meshes.h"

namespace weft::test {
namespace {

constexpr std::uint32_t side = 13;
constexpr float size = 0.3f, thickness = 0.006f;

Mesh level(float x = 0, float z = 0, std::uint32_t particles = side) {
    return make_sheet({.rows = particles,
                       .columns = particles,
                       .origin = {x, 0, z},
                       .u = {size, 0, 0},
                       .v = {0, 0, size}})
        .value();
}

/// Along x in the middle of level(), upwards.
Mesh upright() {
    return make_sheet({.rows = side,
                       .columns = side,
                       .origin = {0, 0, 0.5f * size},
                       .u = {size, 0, 0},
                       .v = {0, size, 0}})
        .value();
}

Mesh wound_the_other_way(Mesh mesh) {
    mesh.rows = mesh.columns = 0;
    for (Triangle& t : mesh.triangles) std::swap(t[1], t[2]);
    return mesh;
}

/// A sheet folded over in its middle, layer on layer.
Mesh folded() {
    Mesh mesh =
        make_sheet({.rows = 2 * side - 1, .columns = side, .u = {size, 0, 0}, .v = {0, 0, 2 * size}}).value();
    mesh.rows = mesh.columns = 0;
    for (const Vec3& p : mesh.positions) mesh.pattern.push_back({p.x, p.z});
    const float first = mesh.positions.front().z;
    for (Vec3& p : mesh.positions)
        if (p.z > first + size) p.z = 2 * (first + size) - p.z;
    return mesh;
}

/// Front and back of one outline, sewn along the border.
Mesh flat_cushion() {
    Mesh mesh = level();
    const Mesh back = wound_the_other_way(mesh);
    mesh.rows = mesh.columns = 0;
    mesh.texcoords.clear();
    const auto first = static_cast<std::uint32_t>(mesh.positions.size());
    mesh.positions.insert(mesh.positions.end(), back.positions.begin(), back.positions.end());
    for (const Triangle& t : back.triangles)
        mesh.triangles.push_back({first + t[0], first + t[1], first + t[2]});
    return mesh;
}

/// Two sheets beside each other as one mesh: vertices at one place are two particles, as along a cut.
Mesh cut_in_two() {
    Mesh mesh = level();
    const Mesh other = level(0, size);
    mesh.rows = mesh.columns = 0;
    mesh.texcoords.clear();
    const auto first = static_cast<std::uint32_t>(mesh.positions.size());
    mesh.positions.insert(mesh.positions.end(), other.positions.begin(), other.positions.end());
    for (const Triangle& t : other.triangles)
        mesh.triangles.push_back({first + t[0], first + t[1], first + t[2]});
    mesh.welds.resize(mesh.positions.size());
    std::iota(mesh.welds.begin(), mesh.welds.end(), 0u);
    return mesh;
}

struct Case {
    std::string name;
    std::vector<Mesh> meshes;
};

std::vector<Case> cases() {
    return {{"TwoSheets", {level(), level()}},
            {"SixSheets", std::vector<Mesh>(6, level())},
            {"WoundTheOtherWay", {level(), wound_the_other_way(level())}},
            {"FineOnCoarse", {level(0, 0, 4), level()}},
            {"HalfACellAside", {level(), level(0.5f * size / (side - 1), 0.5f * size / (side - 1))}},
            {"Beside", {level(), level(size)}},
            {"Standing", {level(), upright()}},
            {"StandingFirst", {upright(), level()}},
            {"StandingOnCoarse", {level(0, 0, 2), upright()}},
            {"Folded", {folded()}},
            {"FlatCushion", {flat_cushion()}},
            {"CutInTwo", {cut_in_two()}},
            {"TwoSpheres", {sphere(2), sphere(2)}},
            {"TwoTubes", {tube(6, 16), tube(6, 16)}}};
}

ClothSettings with_contact() {
    ClothSettings settings;
    settings.air_damping = 0;
    settings.self_collision = {.method = SelfCollisionMethod::contact, .distance = thickness};
    return settings;
}

/// Cloths of these meshes, each turned and moved alike.
struct Scene {
    World world;
    std::vector<ClothId> cloths;

    Scene(const WorldSettings& settings, const std::vector<Mesh>& meshes, float turn = 0,
          const Vec3& offset = {})
        : world(World::create(settings).value()) {
        const Eigen::AngleAxisf turned(turn, Eigen::Vector3f(1, 2, -1).normalized());
        for (Mesh mesh : meshes) {
            if (turn != 0) mesh.rows = mesh.columns = 0;
            for (Vec3& p : mesh.positions) {
                const Eigen::Vector3f x = turned * Eigen::Vector3f(p.x, p.y, p.z);
                p = {x.x() + offset.x, x.y() + offset.y, x.z() + offset.z};
            }
            cloths.push_back(world.add_cloth(mesh, with_contact()).value());
        }
    }
    [[nodiscard]] const ClothView& view(std::size_t cloth) const {
        return world.cloth(cloths[cloth]).value();
    }
    [[nodiscard]] double mean_height(std::size_t cloth) const {
        double sum = 0;
        for (const Vec4& x : view(cloth).positions) sum += double{x.y};
        return sum / static_cast<double>(view(cloth).positions.size());
    }
};

class TouchingSurfaces : public testing::TestWithParam<Case> {};
INSTANTIATE_TEST_SUITE_P(, TouchingSurfaces, testing::ValuesIn(cases()),
                         [](const auto& info) { return info.param.name; });

TEST_P(TouchingSurfaces, PartWithoutCrossingHoweverTheyAreTurned) {
    for (const auto& [turn, far] : {std::pair(0.0f, 0.0f), {0.7f, 20.0f}, {2.0f, 0.0f}}) {
        Scene scene(vacuum(), GetParam().meshes, turn, {far, 0, -far});
        std::uint32_t truncated = 0;
        for (int step = 0; step < 40; ++step) {
            const StepReport& report = scene.world.step(h);
            if (step >= 20) truncated = std::max(truncated, report.truncated_particles);
            EXPECT_LT(report.peak_speed, 3) << step;
        }
        EXPECT_EQ(crossings(scene.world, scene.cloths), 0) << turn << ", " << far;
        EXPECT_EQ(truncated, 0u) << "contact no longer has to hold anything: " << turn << ", " << far;
    }
}

TEST_P(TouchingSurfaces, FallAsOne) {
    WorldSettings settings;
    settings.wind.air_density = 0;
    Scene scene(settings, GetParam().meshes);
    double before = 0, after = 0, particles = 0;
    const auto add = [&](double& sum) {
        for (std::size_t k = 0; k < scene.cloths.size(); ++k)
            sum += scene.mean_height(k) * static_cast<double>(scene.view(k).positions.size());
    };
    for (std::size_t k = 0; k < scene.cloths.size(); ++k)
        particles += static_cast<double>(scene.view(k).positions.size());
    add(before);
    for (int step = 0; step < 30; ++step) scene.world.step(h);
    add(after);
    EXPECT_NEAR((before - after) / particles, 0.5 * 9.81 * 0.25, 0.04 * 9.81 * 0.25);
}

TEST(TouchingLayers, LieInTheOrderInWhichTheyWereAdded) {
    constexpr std::size_t layers = 5;
    WorldSettings settings;
    settings.threads = 1;
    Scene scene(settings, std::vector<Mesh>(layers, level()), 0, {0, 0.02f, 0});
    ASSERT_TRUE(scene.world.add_collider({.shape = Plane{}}));
    for (int step = 0; step < 240; ++step) scene.world.step(h);
    for (std::size_t k = 1; k < layers; ++k)
        EXPECT_GT(scene.mean_height(k), scene.mean_height(k - 1) + 0.8 * double{thickness}) << k;
}

TEST(TouchingLayers, StayOnTheSideOnWhichTheyStandOrHang) {
    for (const bool level_first : {false, true})
        for (const bool hangs : {false, true}) {
            Mesh other = upright();
            if (hangs)
                for (Vec3& p : other.positions) p.y -= size;
            std::vector<Mesh> meshes = {level(), other};
            if (!level_first) std::swap(meshes[0], meshes[1]);
            Scene scene(vacuum(), meshes);
            for (int step = 0; step < 40; ++step) scene.world.step(h);
            const double above =
                scene.mean_height(level_first ? 1 : 0) - scene.mean_height(level_first ? 0 : 1);
            EXPECT_GT(hangs ? -above : above, 0.4 * double{size}) << level_first << hangs;
            EXPECT_EQ(crossings(scene.world, scene.cloths), 0) << level_first << hangs;
        }
}

// Layers of a skirt that share their waist touch there for ever. Contact lifts their first rows off each
// other, so what hangs is measured from there.
TEST(TouchingLayers, HangFromPinsAtOnePlace) {
    constexpr std::uint32_t around = 24, rows = 10;
    const auto skirt = [&](float flare) {
        Mesh mesh;
        for (std::uint32_t r = 0; r < rows; ++r)
            for (std::uint32_t c = 0; c < around; ++c) {
                const float angle = 2 * std::numbers::pi_v<float> * static_cast<float>(c) / around;
                const float down = 0.04f * static_cast<float>(r), wide = 0.15f + flare * down;
                mesh.positions.push_back({wide * std::sin(angle), -down, wide * std::cos(angle)});
                if (r + 1 == rows) continue;
                const std::uint32_t i = r * around + c, j = r * around + (c + 1) % around;
                mesh.triangles.push_back({i, i + around, j});
                mesh.triangles.push_back({j, i + around, j + around});
            }
        return mesh;
    };
    std::vector<std::uint32_t> waist(around);
    std::iota(waist.begin(), waist.end(), 0u);
    const auto height_of = [](const Scene& scene, std::uint32_t row) {
        const ClothView view = scene.view(0);
        double sum = 0;
        for (std::uint32_t c = 0; c < around; ++c)
            sum += double{view.positions[view.vertex_to_particle[row * around + c]].y};
        return sum / around;
    };
    for (const float outer : {0.3f, 0.6f, 0.1f}) {
        WorldSettings settings;
        settings.wind.air_density = 0;
        Scene alone(settings, {skirt(0.3f)}), both(settings, {skirt(0.3f), skirt(outer)});
        for (Scene* scene : {&alone, &both})
            for (const ClothId id : scene->cloths) ASSERT_TRUE(scene->world.pin(id, waist));
        for (int step = 0; step < 12; ++step) {  // until the one alone begins to buckle
            alone.world.step(h);
            const StepReport& report = both.world.step(h);
            EXPECT_LT(report.pin_lag, 1e-4f) << outer << ", step " << step;
        }
        EXPECT_EQ(crossings(both.world, both.cloths), 0) << outer;
        const double rest = -0.04 * (rows - 2);
        const auto sag = [&](const Scene& scene) {
            return height_of(scene, 1) + rest - height_of(scene, rows - 1);
        };
        EXPECT_GT(sag(both), 0.5 * sag(alone)) << outer;
    }
}

}  // namespace
}  // namespace weft::test
