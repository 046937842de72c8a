#include "demo/scene_simulation.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>
#include <fstream>

#include "demo/character/garment/garment_mesh.h"
#include "demo/options/method_table.h"
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

}  // namespace
}  // namespace weft::demo
