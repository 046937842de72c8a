// Slivers: triangles of next to no height, as exporters and decimators leave them.

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <random>
#include <set>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "engine/vector.h"
#include "tests/must.h"
#include "weft/weft.h"

namespace weft {
namespace {

constexpr std::uint32_t columns = 9;  // of the sound sheet's vertices, and rows

/// A general mesh, its vertices moved by up to 0.15 of a cell, hanging in the plane z = 0 from y = 0 or
/// lying.
Mesh sound_sheet(float side, bool hangs, std::mt19937& random) {
    const float cell = side / (columns - 1);
    const auto jitter = [&] { return cell * (0.3f * static_cast<float>(random() % 1024) / 1024 - 0.15f); };
    Mesh mesh;
    for (std::uint32_t row = 0; row < columns; ++row) {
        for (std::uint32_t column = 0; column < columns; ++column) {
            const bool is_inner = row % (columns - 1) != 0 && column % (columns - 1) != 0;
            const float u = cell * static_cast<float>(column) + (is_inner ? jitter() : 0);
            const float v = cell * static_cast<float>(row) + (is_inner ? jitter() : 0);
            mesh.positions.push_back(hangs ? Vec3{u, -v, 0} : Vec3{u, 0, v});
        }
    }
    for (std::uint32_t row = 0; row + 1 < columns; ++row) {
        for (std::uint32_t column = 0; column + 1 < columns; ++column) {
            const std::uint32_t a = row * columns + column, b = a + 1, c = a + columns, d = c + 1;
            mesh.triangles.push_back({a, c, d});
            mesh.triangles.push_back({a, d, b});
        }
    }
    return mesh;
}

Vec3 between(const Vec3& a, const Vec3& b, float part) {
    return {a.x + part * (b.x - a.x), a.y + part * (b.y - a.y), a.z + part * (b.z - a.z)};
}

float length(const Vec3& a, const Vec3& b) {
    return std::hypot(a.x - b.x, a.y - b.y, a.z - b.z);
}

/// A vertex `height` of an edge's length beside it, in triangle t; a sliver fills what is between.
void add_t_junction(Mesh& mesh, std::uint32_t t, std::size_t k, float height, float part) {
    const Triangle corners = mesh.triangles[t];
    const std::uint32_t a = corners[k], b = corners[(k + 1) % 3], c = corners[(k + 2) % 3];
    const Vec3 foot = between(mesh.positions[a], mesh.positions[b], part);
    const float to_apex = length(foot, mesh.positions[c]),
                edge = length(mesh.positions[a], mesh.positions[b]);
    const auto v = static_cast<std::uint32_t>(mesh.positions.size());
    mesh.positions.push_back(between(foot, mesh.positions[c], height * edge / to_apex));
    mesh.triangles[t] = {a, v, c};
    mesh.triangles.push_back({v, b, c});
    mesh.triangles.push_back({a, b, v});
}

/// Divides an edge at `part` of it, and so its triangles: near its start that leaves needles.
std::uint32_t divide(Mesh& mesh, std::uint32_t a, std::uint32_t b, float part) {
    const auto v = static_cast<std::uint32_t>(mesh.positions.size());
    mesh.positions.push_back(between(mesh.positions[a], mesh.positions[b], part));
    for (std::size_t t = 0, count = mesh.triangles.size(); t < count; ++t) {
        const Triangle corners = mesh.triangles[t];
        for (std::size_t k = 0; k < 3; ++k) {
            const std::uint32_t p = corners[k], q = corners[(k + 1) % 3], c = corners[(k + 2) % 3];
            if (!(p == a && q == b) && !(p == b && q == a)) continue;
            mesh.triangles[t] = {p, v, c};
            mesh.triangles.push_back({v, q, c});
        }
    }
    return v;
}

using Spoil = std::function<void(Mesh&, float height, std::mt19937&)>;
struct Kind {
    const char* name;
    Spoil spoil;
};
std::uint32_t any_triangle(const Mesh& mesh, std::mt19937& random) {
    return static_cast<std::uint32_t>(random() % mesh.triangles.size());
}
const std::vector<Kind>& kinds() {
    constexpr std::uint32_t sound = 2 * (columns - 1) * (columns - 1);
    static const std::vector<Kind> all{
        {"T-junctions inside",
         [](Mesh& mesh, float height, std::mt19937& random) {
             for (std::uint32_t t = 5; t < sound; t += 15)
                 add_t_junction(mesh, t, random() % 3, height,
                                0.2f + 0.6f * static_cast<float>(random() % 1024) / 1024);
         }},
        {"a row of them at one edge",
         [](Mesh& mesh, float height, std::mt19937&) {
             const Triangle corners = mesh.triangles[sound / 2];
             const std::uint32_t a = corners[0], b = corners[1], c = corners[2];
             std::vector<std::uint32_t> row;
             for (const float part : {0.25f, 0.5f, 0.75f}) {
                 const Vec3 foot = between(mesh.positions[a], mesh.positions[b], part);
                 row.push_back(static_cast<std::uint32_t>(mesh.positions.size()));
                 mesh.positions.push_back(between(foot, mesh.positions[c], height * part * (1 - part)));
             }
             row.push_back(b);
             mesh.triangles[sound / 2] = {a, row[0], c};
             for (std::size_t k = 0; k + 1 < row.size(); ++k) {
                 mesh.triangles.push_back({row[k], row[k + 1], c});
                 mesh.triangles.push_back({a, row[k + 1], row[k]});
             }
         }},
        {"slivers at the lower border",
         [](Mesh& mesh, float height, std::mt19937&) {
             for (std::uint32_t t = 0; t < sound; ++t)
                 if (mesh.triangles[t][1] / columns == columns - 1 &&
                     mesh.triangles[t][2] / columns == columns - 1)
                     add_t_junction(mesh, t, 1, height, 0.5f);
         }},
        {"needles",
         [](Mesh& mesh, float height, std::mt19937& random) {
             for (int k = 0; k < 5; ++k) {
                 const Triangle& corners = mesh.triangles[any_triangle(mesh, random) % sound];
                 divide(mesh, corners[0], corners[1], height);
             }
         }},
        {"a fan of needles",
         [](Mesh& mesh, float height, std::mt19937&) {
             const std::uint32_t a = mesh.triangles[sound / 2][0];
             std::uint32_t b = mesh.triangles[sound / 2][2];
             float there = 1;
             for (const float part : {4 * height, 3 * height, 2 * height, height})
                 b = divide(mesh, a, b, part / std::exchange(there, part));
         }},
    };
    return all;
}

std::vector<ClothSettings> models() {
    std::vector<ClothSettings> models(3);
    models[1].finite_elements.enabled = true;
    models[2].method = Jacobi{};
    return models;
}

/// How far the mean of the lower row is below where it starts [m], after four seconds.
double sag(const Mesh& mesh, ClothSettings settings, float side) {
    settings.air_damping = 3;
    World world = World::create({.threads = 1}).value();
    const ClothId cloth = test::must(world.add_cloth(mesh, settings));
    std::vector<std::uint32_t> pins;
    for (std::uint32_t v = 0; v < mesh.positions.size(); ++v)
        if (mesh.positions[v].y == 0) pins.push_back(v);
    for (const std::uint32_t v : pins) EXPECT_TRUE(world.pin(cloth, v));
    for (int step = 0; step < 240; ++step) world.step(1.0f / 60);
    const auto view = world.cloth(cloth);
    double mean = 0;
    for (std::uint32_t v = columns * (columns - 1); v < columns * columns; ++v)
        mean -= static_cast<double>(view->positions[view->vertex_to_particle[v]].y) / columns;
    return mean - static_cast<double>(side);
}

TEST(Sliver, LeavesTheRestItsStiffness) {
    const float side = 1;
    for (const ClothSettings& model : {models()[0], models()[1]}) {
        std::mt19937 random(1);
        const double sound = sag(sound_sheet(side, true, random), model, side);
        ASSERT_GT(sound, 0);
        for (const Kind& kind : kinds()) {
            for (const float height : {1e-2f, 1e-3f, 1e-5f, 0.0f}) {
                const bool is_needle = std::string(kind.name).ends_with("needles");
                if (is_needle && height < 1e-3f) continue;
                std::mt19937 same(1);
                Mesh mesh = sound_sheet(side, true, same);
                kind.spoil(mesh, height, same);
                EXPECT_NEAR(sag(mesh, model, side), sound, 0.01 * sound) << kind.name << ", " << height;
            }
        }
    }
}

TEST(Sliver, FallsAsTheClothAroundItDoes) {
    for (const float side : {0.01f, 0.1f, 1.0f}) {
        for (const float height : {1e-1f, 1e-2f, 1e-3f, 1e-4f, 1e-5f, 1e-6f, 0.0f}) {
            std::size_t number = 0;
            for (const ClothSettings& model : models()) {
                for (std::size_t k = 0; k < 3; ++k) {
                    std::mt19937 random(2);
                    Mesh mesh = sound_sheet(side, false, random);
                    kinds()[k].spoil(mesh, height, random);
                    World world = World::create({.threads = 1}).value();
                    (void)test::must(world.add_cloth(mesh, model));
                    float beyond = 0;
                    for (int i = 1; i <= 60; ++i)
                        beyond = std::max(
                            beyond, world.step(1.0f / 60).peak_speed - 9.81f * static_cast<float>(i) / 60);
                    EXPECT_LT(beyond, 0.04f)
                        << kinds()[k].name << ", " << height << " of " << side << " m, model " << number;
                }
                ++number;
            }
        }
    }
}

/// A square of four triangles whose diagonal has a point in its middle, `height` of the side beside it.
Mesh square_with_sliver(float height, float side) {
    const float beside = height * side * std::sqrt(0.5f);
    Mesh mesh;
    mesh.positions = {
        {0, 0, 0}, {side, 0, 0}, {side, 0, side}, {0, 0, side}, {side / 2 + beside, 0, side / 2 - beside}};
    mesh.triangles = {{0, 3, 2}, {0, 2, 4}, {0, 4, 1}, {1, 4, 2}};
    return mesh;
}

TEST(Sliver, OfAMillimetreFallsToo) {
    for (const float height : {1e-2f, 1e-3f, 1e-4f, 1e-5f, 0.0f}) {
        for (const ClothSettings& model : models()) {
            World world = World::create({.threads = 1}).value();
            const ClothId cloth = test::must(world.add_cloth(square_with_sliver(height, 1e-3f), model));
            float beyond = 0, stretch = 1;
            for (int i = 1; i <= 120; ++i) {
                beyond =
                    std::max(beyond, world.step(1.0f / 60).peak_speed - 9.81f * static_cast<float>(i) / 60);
                const auto view = world.cloth(cloth);
                const auto at = [&](std::size_t v) {
                    return xyz(view->positions[view->vertex_to_particle[v]]);
                };
                stretch = std::max(stretch, (at(1) - at(0)).norm() / 1e-3f);
            }
            EXPECT_LT(beyond, 0.01f) << height;
            EXPECT_LT(stretch, 1.05f) << height;
        }
    }
}

TEST(Sliver, IsFlippedWhereThatMakesItSound) {
    for (const float height : {5e-2f, 1e-3f, 1e-6f, 0.0f}) {
        const CookedCloth cooked = test::must(CookedCloth::create(square_with_sliver(height, 0.1f)));
        EXPECT_EQ(cooked.report().flipped, (std::vector<std::uint32_t>{0, 1})) << height;
        EXPECT_TRUE(cooked.report().softened.empty()) << height;
        EXPECT_TRUE(cooked.report().dropped.empty()) << height;
        EXPECT_EQ(cooked.info().triangles, 4u);
        EXPECT_EQ(cooked.info().flipped_triangles, 2u);
        EXPECT_EQ(cooked.info().border_edges, 4u) << "a slit along the diagonal";
        EXPECT_EQ(cooked.info().misoriented_edges, 0u);
    }
    const CookedCloth sound = test::must(CookedCloth::create(square_with_sliver(0.2f, 0.1f)));
    EXPECT_TRUE(sound.report().flipped.empty());
    EXPECT_TRUE(sound.report().softened.empty());
}

TEST(Sliver, ThatStaysIsReportedWithWhatIsLeftOfIt) {
    Mesh mesh = square_with_sliver(1e-3f, 0.1f);
    mesh.triangles.erase(mesh.triangles.begin());  // the sliver lies at the border
    const CookedCloth cooked = test::must(CookedCloth::create(mesh));
    ASSERT_EQ(cooked.report().softened.size(), 1u);
    EXPECT_EQ(cooked.report().softened[0].triangle, 0u);
    EXPECT_GT(cooked.report().softened[0].left, 0.0f);
    EXPECT_LT(cooked.report().softened[0].left, 1e-3f);
    EXPECT_TRUE(cooked.report().flipped.empty());
    EXPECT_EQ(cooked.info().softened_triangles, 1u);

    World world = World::create({.threads = 1}).value();
    (void)test::must(world.add_cloth(cooked));
    EXPECT_NE(test::must(world.describe()).find("softened_triangles: 1"), std::string::npos);
}

TEST(Sliver, IsFlippedWithoutChangingTheSurface) {
    for (const Kind& kind : kinds()) {
        for (const float height : {1e-3f, 0.0f}) {
            if (height == 0 && std::string(kind.name).ends_with("needles")) continue;
            std::mt19937 random(3);
            Mesh mesh = sound_sheet(1, true, random);
            kind.spoil(mesh, height, random);
            const CookedCloth cooked = test::must(CookedCloth::create(mesh));
            World world = World::create({.threads = 1}).value();
            const ClothId cloth = test::must(world.add_cloth(cooked));
            const auto view = world.cloth(cloth);
            double area = 0;
            for (const Triangle& t : view->triangles) {
                const Vector3 a = xyz(view->positions[t[0]]), b = xyz(view->positions[t[1]]),
                              c = xyz(view->positions[t[2]]);
                const Vector3 twice = (b - a).cross(c - a);
                EXPECT_GT(twice.z(), 0) << kind.name;
                area += static_cast<double>(twice.norm()) / 2;
            }
            EXPECT_NEAR(area, 1, 1e-5) << kind.name << ", " << height;
        }
    }
}

// Needles rest nearer to one another than contact lets features come.
TEST(Sliver, FallsInContactWithoutBeingDrawnOut) {
    for (const unsigned seed : {1u, 2u, 3u}) {
        std::mt19937 random(seed);
        Mesh mesh = sound_sheet(0.5f, false, random);
        for (int fan = 0; fan < 4; ++fan) {
            const Triangle corners = mesh.triangles[16 + 32 * fan + random() % 8];
            const std::uint32_t a = corners[0];
            std::uint32_t b = corners[1];
            float there = 1;
            for (int k = 8; k > 0; --k) {
                const float part = 1e-3f * static_cast<float>(k);
                b = divide(mesh, a, b, part / std::exchange(there, part));
            }
        }
        ClothSettings settings;
        settings.self_collision = {.method = SelfCollisionMethod::contact};
        World world = World::create({.threads = 1}).value();
        (void)test::must(world.add_cloth(mesh, settings));
        float beyond = 0;
        for (int i = 1; i <= 120; ++i)
            beyond = std::max(beyond, world.step(1.0f / 60).peak_speed - 9.81f * static_cast<float>(i) / 60);
        EXPECT_LT(beyond, 0.04f) << seed;
    }
}

TEST(Sliver, CutAlongTheEdgeThatWasFlippedParts) {
    for (const float height : {1e-2f, 0.0f}) {
        const Mesh mesh = square_with_sliver(height, 1);
        const MeshEdge diagonal{0, 2};
        const MeshCut cut = test::must(cut_mesh(mesh, std::span(&diagonal, 1)));
        EXPECT_EQ(cut.added_particles, 3u) << "two halves";
        EXPECT_EQ(test::must(CookedCloth::create(cut.mesh)).info().components, 2u);
    }
}

}  // namespace
}  // namespace weft
