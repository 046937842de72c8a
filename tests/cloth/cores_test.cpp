// Whole triangles are kept out of what is thin or sharp, by contact: its edges and points, not only the
// corners of cloth, are met.

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <numbers>
#include <vector>

#include "../collision/cuts.h"
#include "../collision/solids.h"
#include "crossing_count.h"
#include "struck_sheet.h"

namespace weft::test {
namespace {

using Point = Eigen::Vector3d;

/// A collider's surface, or triangles within it.
struct Surface {
    std::vector<Point> points;
    std::vector<std::array<std::uint32_t, 3>> triangles;

    explicit Surface(const Box& box) {
        const Solid solid = box_mesh(box.half_extents);
        const Eigen::Quaternionf turn(box.rotation.w, box.rotation.x, box.rotation.y, box.rotation.z);
        for (const Vec3& v : solid.vertices)
            points.emplace_back((turn * to_vector(v) + to_vector(box.center)).cast<double>());
        triangles = solid.triangles;
    }
    /// A prism in it, with points at its ends.
    explicit Surface(const Capsule& capsule) {
        constexpr std::uint32_t sides = 8;
        const Point a = to_vector(capsule.a).cast<double>(), b = to_vector(capsule.b).cast<double>();
        const Point along = (b - a).normalized(), u = along.unitOrthogonal(), v = along.cross(u);
        const auto radius = static_cast<double>(capsule.radius);
        for (std::uint32_t k = 0; k < sides; ++k) {
            const double angle = 2 * std::numbers::pi * k / sides;
            const Point out = radius * (std::cos(angle) * u + std::sin(angle) * v);
            points.emplace_back(a + out);
            points.emplace_back(b + out);
        }
        points.emplace_back(a - radius * along);
        points.emplace_back(b + radius * along);
        for (std::uint32_t k = 0; k < sides; ++k) {
            const std::uint32_t i = 2 * k, j = 2 * ((k + 1) % sides);
            triangles.push_back({i, j, j + 1});
            triangles.push_back({i, j + 1, i + 1});
            triangles.push_back({i, 2 * sides, j});
            triangles.push_back({i + 1, j + 1, 2 * sides + 1});
        }
    }
};

/// Edges of either through triangles of the other.
int crossings_with(const ClothView& cloth, const Surface& shape) {
    std::vector<Point> x;
    for (const Vec4& p : cloth.positions) x.emplace_back(p.x, p.y, p.z);
    const auto crosses = [](const Point& p, const Point& q, const Point& a, const Point& b, const Point& c) {
        const Point lower = p.cwiseMin(q), upper = p.cwiseMax(q);
        const Point low = a.cwiseMin(b).cwiseMin(c), high = a.cwiseMax(b).cwiseMax(c);
        return (lower.array() <= high.array()).all() && (low.array() <= upper.array()).all() &&
               cuts(p, q, a, b, c);
    };
    int count = 0;
    for (const Triangle& t : cloth.triangles)
        for (const auto& s : shape.triangles)
            for (std::size_t k = 0; k < 3; ++k) {
                const std::size_t next = (k + 1) % 3;
                const auto& p = shape.points;
                count += crosses(x[t[k]], x[t[next]], p[s[0]], p[s[1]], p[s[2]]) ? 1 : 0;
                count += crosses(p[s[k]], p[s[next]], x[t[0]], x[t[1]], x[t[2]]) ? 1 : 0;
            }
    return count;
}

constexpr std::uint32_t side = 24;
constexpr float h = 1.0f / 60;

ClothSettings with_contact() {
    ClothSettings settings;
    settings.thickness = 0.005f;
    settings.self_collision = {.enabled = true, .method = SelfCollisionMethod::contact};
    return settings;
}

/// A level sheet of 1 m, or one that hangs by a side, and one collider.
struct Scene {
    World world;
    ClothId cloth;
    ColliderId collider;

    Scene(const Collider& shape, bool is_hung, int threads = 1)
        : world(World::create({.threads = threads}).value()) {
        const SheetSettings level{
            .rows = side, .columns = side, .origin = {-0.5f, 0.6f, -0.5f}, .u = {0, 0, 1}, .v = {1, 0, 0}};
        const SheetSettings hung{
            .rows = side, .columns = side, .origin = {-0.5f, 1, 0}, .u = {1, 0, 0}, .v = {0, -1, 0}};
        cloth = world.add_cloth(make_sheet(is_hung ? hung : level).value(), with_contact()).value();
        std::vector<std::uint32_t> top(is_hung ? side : 0);
        for (std::uint32_t k = 0; k < top.size(); ++k) top[k] = k;
        EXPECT_TRUE(world.pin(cloth, top));
        collider = world.add_collider(shape).value();
    }
    [[nodiscard]] float lowest() const {
        return std::ranges::min(world.cloth(cloth).value().positions, {}, &Vec4::y).y;
    }
    template <class Kind>
    [[nodiscard]] int crossings_with_collider() const {
        const Collider now = world.collider(collider).value();
        return crossings_with(world.cloth(cloth).value(), Surface(std::get<Kind>(now.shape)));
    }
};

Rotation on_its_corner() {
    const auto turn = Eigen::Quaternionf::FromTwoVectors(Vector3(1, 1, 1), Vector3(0, 1, 0));
    return {turn.x(), turn.y(), turn.z(), turn.w()};
}

TEST(Cores, ClothOverABoxsEdgesAndCornerNeverCrossesIt) {
    for (const Box& box : {Box{{0.01f, 0.3f, 0.02f}, {}, {0.2f, 0.2f, 0.2f}},
                           Box{{0.01f, 0.2f, 0.02f}, on_its_corner(), {0.15f, 0.15f, 0.15f}}}) {
        Scene scene({box, 0.4f}, false);
        for (int step = 0; step < 70; ++step) {
            scene.world.step(h);
            ASSERT_EQ(scene.crossings_with_collider<Box>(), 0) << "step " << step;
        }
        EXPECT_GT(scene.lowest(), -0.3f) << "it is held up";
        EXPECT_EQ(crossings(scene.world, {&scene.cloth, 1}), 0);
    }
}

TEST(Cores, ClothHangsOverAThinBar) {
    const Capsule bar{{-0.8f, 0.5f, 0.013f}, {0.8f, 0.5f, 0.013f}, 0.005f};
    Scene scene({bar, 0.8f}, false);
    for (int step = 0; step < 90; ++step) {
        scene.world.step(h);
        ASSERT_EQ(scene.crossings_with_collider<Capsule>(), 0) << "step " << step;
    }
    EXPECT_GT(scene.lowest(), -0.1f);
}

TEST(Cores, ANeedleDoesNotStickThrough) {
    const auto needle = [](float way) {
        return Capsule{{0.013f, 0.513f, -0.4f + way}, {0.013f, 0.513f, -0.1f + way}, 0.002f};
    };
    Scene scene({needle(0), 0.4f}, true);
    for (int step = 1; step <= 80; ++step) {
        const float way = std::min(0.5f, 0.5f * h * static_cast<float>(step));
        ASSERT_TRUE(scene.world.move_collider(scene.collider, {needle(way), 0.4f}));
        scene.world.step(h);
        ASSERT_EQ(scene.crossings_with_collider<Capsule>(), 0) << "step " << step;
    }
    EXPECT_EQ(crossings(scene.world, {&scene.cloth, 1}), 0);
}

TEST(Cores, ThinBarsAndSwordsCarryASheet) {
    for (const float phase : {0.0f, 0.35f, 0.7f}) {
        EXPECT_EQ(strike({Striker::Kind::bar, 1, 0.005f}, 32, phase, 1, true).carried, 1) << phase;
        EXPECT_EQ(strike({Striker::Kind::bar, 5, 0.005f}, 32, phase, 1, true).carried, 1) << phase;
        EXPECT_EQ(strike({Striker::Kind::ball, 50, 0.05f}, 32, phase, 1, true).carried, 1) << phase;
        EXPECT_EQ(strike({Striker::Kind::sword, 5, 0.005f}, 32, phase, 1, true).carried, 1) << phase;
    }
}

TEST(Cores, TheSameBytesOnAnyNumberOfThreads) {
    std::uint64_t first = 0;
    for (const int threads : {1, 3}) {
        Scene scene({Box{{0.01f, 0.3f, 0.02f}, on_its_corner(), {0.2f, 0.2f, 0.2f}}, 0.4f}, false, threads);
        for (int step = 0; step < 30; ++step) scene.world.step(h);
        if (threads == 1) first = scene.world.state_hash();
        EXPECT_EQ(scene.world.state_hash(), first);
    }
}

// What is put into cloth passes it: nothing is thrown, and it comes out again.
TEST(Cores, WhatIsPutThroughClothIsLetAlone) {
    const Capsule far{{0.013f, 0.5f, 2}, {0.013f, 0.5f, 2.4f}, 0.005f};
    const Capsule through{{0.013f, 0.5f, -0.2f}, {0.013f, 0.5f, 0.2f}, 0.005f};
    Scene scene({far, 0.4f}, true);
    scene.world.step(h);
    ASSERT_TRUE(scene.world.place_collider(scene.collider, {through, 0.4f}));
    EXPECT_GT(scene.world.step(h).crossings, 0u) << "it is counted";
    for (int step = 0; step < 30; ++step) {
        const StepReport& report = scene.world.step(h);
        EXPECT_FALSE(has(report.flags, StepFlags::state_restored));
        EXPECT_LT(report.peak_speed, 10);
    }
    ASSERT_TRUE(scene.world.place_collider(scene.collider, {far, 0.4f}));
    for (int step = 0; step < 5; ++step) scene.world.step(h);
    EXPECT_EQ(scene.world.report().crossings, 0u);
}

TEST(Cores, MemoryIsTakenWhereAColliderIsThinAgainstTheCloth) {
    const auto bytes_with = [](const Collider& collider) {
        Scene scene({Sphere{{0, -50, 0}, 1}, 0.4f}, false);
        const std::uint64_t before = scene.world.cloth_info(scene.cloth).value().bytes;
        EXPECT_TRUE(scene.world.add_collider(collider));
        return scene.world.cloth_info(scene.cloth).value().bytes - before;
    };
    EXPECT_EQ(bytes_with({Sphere{{0, -50, 0}, 1}}), 0u);
    EXPECT_EQ(bytes_with({Capsule{{0, -50, 0}, {1, -50, 0}, 0.2f}}), 0u);
    EXPECT_GT(bytes_with({Capsule{{0, -50, 0}, {1, -50, 0}, 0.01f}}), 0u);
    EXPECT_LT(bytes_with({Box{{0, -50, 0}}}), 40000u);
}

}  // namespace
}  // namespace weft::test
