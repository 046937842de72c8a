#include "collision/contact/pairs/crossings.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstring>
#include <limits>
#include <set>

#include "collision/contact/pairs/pair_finder.h"
#include "collision/geometry/volume_sign.h"
#include "tests/collision/contact/contact_reference.h"
#include "tests/collision/contact/cuts.h"
#include "tests/laid_out.h"
#include "tests/targets/targets.h"

namespace weft::test {
namespace {

LaidOut<CrossingList> crossings_of(const ContactScene& scene, int threads = 1,
                                   std::size_t capacity = 1 << 18) {
    LaidOut<PairFinder> finder;
    finder.reserve(scene.bodies, room_for_pairs);
    Parallel parallel(threads);
    LaidOut<CrossingList> list(capacity);
    finder.find_crossings(parallel, scene.bodies, scene.positions, list);
    return list;
}

using Five = std::array<std::uint32_t, 5>;

std::set<Five> set_of(const CrossingList& list) {
    std::set<Five> found;
    for (const Crossing& c : list.crossings.span().first(list.size)) {
        Five five = {c.edge[0], c.edge[1], c.triangle[0], c.triangle[1], c.triangle[2]};
        std::sort(five.begin(), five.begin() + 2);
        std::sort(five.begin() + 2, five.end());
        EXPECT_TRUE(found.insert(five).second) << "listed twice";
    }
    return found;
}

/// For scenes in which nothing touches.
bool cross(const Vec4& p, const Vec4& q, const Vec4& a, const Vec4& b, const Vec4& c) {
    const auto at = [](const Vec4& v) { return Eigen::Matrix<long double, 3, 1>(v.x, v.y, v.z); };
    return cuts(at(p), at(q), at(a), at(b), at(c));
}

void expect_as_reference(const ContactScene& scene, std::size_t at_least) {
    std::set<Five> expected;
    for (const ContactBody& a : scene.bodies)
        for (const ContactBody& b : scene.bodies) {
            if (!meet(a, b)) continue;
            for (const auto& edge : a.mesh->edges())
                for (const Triangle& t : b.mesh->triangles()) {
                    Five five = {a.first + edge[0], a.first + edge[1], b.first + t[0], b.first + t[1],
                                 b.first + t[2]};
                    if (std::find_first_of(five.begin(), five.begin() + 2, five.begin() + 2, five.end()) !=
                        five.begin() + 2)
                        continue;
                    const std::vector<Vec4>& x = scene.positions;
                    if (!cross(x[five[0]], x[five[1]], x[five[2]], x[five[3]], x[five[4]])) continue;
                    std::sort(five.begin(), five.begin() + 2);
                    std::sort(five.begin() + 2, five.end());
                    expected.insert(five);
                }
        }
    EXPECT_GE(expected.size(), at_least);
    EXPECT_EQ(set_of(crossings_of(scene)), expected);
}

std::vector<Vec4> level_grid(std::uint32_t side) {
    return grid_positions(side, side, [](float u, float v) { return Vec4{0.01f * u, 0, 0.01f * v, 0}; });
}

ContactScene crumpled(std::uint32_t side) {
    ContactScene scene;
    scene.add(level_grid(side), level_grid(side), grid_triangles(side, side), 0.003f);
    scene.jitter(0.015f);
    return scene;
}

TEST(Crossings, AsReference) {
    expect_as_reference(crumpled(20), 500);
    ContactScene far = crumpled(20);
    for (Vec4& p : far.positions) p = {p.x - 1000, p.y + 900, p.z + 1000, 0};
    far.jitter(0.01f, 3);
    expect_as_reference(far, 500);
    for (std::uint32_t seed = 1; seed < 4; ++seed) {
        const std::vector<Vec4> points = random_vectors(120, 1, seed);
        std::mt19937 random(seed);
        std::vector<Triangle> triangles(100);
        for (Triangle& t : triangles)
            for (std::uint32_t& i : t) i = std::uint32_t(random() % points.size());
        ContactScene scene;
        scene.add(points, points, triangles, 1);
        expect_as_reference(scene, 100);
    }
}

TEST(Crossings, OfBodiesThatMeet) {
    ContactScene scene;
    for (std::uint32_t k = 0; k < 3; ++k) {
        scene.add(level_grid(12), level_grid(12), grid_triangles(12, 12), 0.003f);
        scene.bodies[k].meets_itself = k != 1;
    }
    scene.jitter(0.008f);
    expect_as_reference(scene, 1000);
    scene.bodies[0].layer = 2;
    scene.bodies[2].mask = 1;
    expect_as_reference(scene, 500);
}

TEST(Crossings, WhatLiesInAPlaneDoesNotCross) {
    ContactScene scene;
    for (int k = 0; k < 2; ++k) {
        std::vector<Vec4> now = level_grid(12);
        for (Vec4& p : now) p.x += 0.0037f * float(k);
        scene.add(level_grid(12), now, grid_triangles(12, 12), 0.003f);
    }
    EXPECT_EQ(crossings_of(scene).size, 0u);
}

/// Surfaces of a modeller's "add" menu, none of which passes through itself: flat pieces side by side, in one
/// plane or across shared edges.
struct Surface {
    const char* name;
    std::vector<Vec4> points;
    std::vector<Triangle> triangles;
};

/// A closed band of `around` columns; point(u, v), u and v from 0 to 1.
template <class Point>
Surface band(const char* name, std::uint32_t around, std::uint32_t rows, const Point& point) {
    Surface surface{name, {}, {}};
    for (std::uint32_t r = 0; r < rows; ++r)
        for (std::uint32_t k = 0; k < around; ++k)
            surface.points.push_back(point(float(k) / float(around), float(r) / float(rows - 1)));
    for (std::uint32_t r = 0; r + 1 < rows; ++r)
        for (std::uint32_t k = 0; k < around; ++k) {
            const std::uint32_t a = r * around + k, b = r * around + (k + 1) % around;
            surface.triangles.push_back({a, b, a + around});
            surface.triangles.push_back({b, b + around, a + around});
        }
    return surface;
}

std::vector<Surface> plain_surfaces() {
    constexpr float turn = 6.28318531f;
    std::vector<Surface> all;
    for (std::uint32_t around = 4; around <= 26; around += 2)
        for (std::uint32_t rows = 3; rows <= 12; rows += 5) {
            const auto ring = [](float u, float radius, float y) {
                return Vec4{radius * std::cos(turn * u), y, radius * std::sin(turn * u), 0};
            };
            all.push_back(band("tube", around, rows,
                               [&](float u, float v) { return ring(u, 0.237f, 0.4f - 0.53f * v); }));
            all.push_back(band("cone", around, rows,
                               [&](float u, float v) { return ring(u, 0.1f + 0.3f * v, -0.47f * v); }));
            all.push_back(band("sphere", around, rows + 3, [&](float u, float v) {
                const float latitude = 3.14159265f * (0.02f + 0.96f * v);
                return ring(u, 0.31f * std::sin(latitude), 0.31f * std::cos(latitude));
            }));
            all.push_back(band("box", around, rows, [&](float u, float v) {
                const float at = 4 * u, along = at - std::floor(at), half = 0.35f;
                const float x[4] = {half - 0.7f * along, -half, -half + 0.7f * along, half};
                const auto side = std::min(std::size_t(at), std::size_t{3});
                return Vec4{x[side], 0.61f * v, x[(side + 3) % 4], 0};
            }));
            all.push_back(band("extrusion", around, rows, [&](float u, float v) {
                return ring(u, 0.3f + 0.05f * std::sin(3 * turn * u), 0.7f * v);
            }));
        }
    return all;
}

TEST(Crossings, PlainSurfacesCrossNowhereHoweverTurnedAndFarOff) {
    for (const Surface& surface : plain_surfaces()) {
        for (const float far : {0.0f, 1000.0f}) {
            for (const float angle : {0.0f, 0.7f, 1.5707963f}) {
                const Eigen::AngleAxisf turned(angle, Eigen::Vector3f(1, 2, -0.5f).normalized());
                std::vector<Vec4> points;
                for (const Vec4& p : surface.points) {
                    const Eigen::Vector3f x = turned * Eigen::Vector3f(p.x, p.y, p.z);
                    points.push_back({x.x() + far, x.y() - far, x.z() + far, 0});
                }
                ContactScene scene;
                scene.add(surface.points, points, surface.triangles, 0.003f);
                ASSERT_EQ(crossings_of(scene).size, 0u) << surface.name << " of " << surface.points.size()
                                                        << ", turned by " << angle << ", " << far << " m off";
            }
        }
    }
}

// In a plane that is not level no coordinate is the same for all, and every volume is all rounding.
TEST(Crossings, AnEdgeCrossesAsSoonAsItsEndIsBeyondTheSlantedPlane) {
    const std::vector<Vec4> plane = {{0, 0, 0, 0}, {0.1f, 0.1f, 0, 0}, {0, 0.1f, 0.1f, 0}};  // y = x + z
    for (const float shift : {0.0f, 64.0f}) {
        for (const int steps : {-1, 0, 1}) {
            const float on = 0.0625f + shift;
            float end = on;
            if (steps != 0) end = std::nextafter(on, float(steps) * 1e3f);
            std::vector<Vec4> needle = {{0.03125f, end, 0.03125f, 0},
                                        {0.03125f, on + 0.25f, 0.03125f, 0},
                                        {0.5f, on + 0.5f, 0.03125f, 0}};
            std::vector<Vec4> there = plane;
            for (Vec4& p : there) p.y += shift;
            there[1].y = there[1].x + shift;
            there[2].y = there[2].z + shift;
            ContactScene scene;
            scene.add(there, there, {{0, 1, 2}}, 0.003f);
            scene.add(needle, needle, {{0, 1, 2}}, 0.003f);
            // 64.1f is not 64 + 0.1f: the exact volume says on which side the end is.
            const bool crosses_exactly =
                cross(scene.positions[3], scene.positions[4], there[0], there[1], there[2]);
            EXPECT_EQ(set_of(crossings_of(scene)).contains(Five{3, 4, 0, 1, 2}), crosses_exactly);
            EXPECT_TRUE(shift != 0 || crosses_exactly == (steps < 0));
        }
    }
}

TEST(Crossings, WhatEndsOnATriangleTouchesIt) {
    const std::vector<Vec4> sheet = level_grid(6);
    for (const float up : {-1.0f, 1.0f}) {
        ContactScene scene;
        scene.add(sheet, sheet, grid_triangles(6, 6), 0.003f);
        const std::vector<Vec4> needle = {{0.023f, 0, 0.021f, 0}, {0.023f, up, 0.021f, 0}, {1, up, 0.3f, 0}};
        scene.add(needle, needle, {{0, 1, 2}}, 0.003f);
        EXPECT_EQ(crossings_of(scene).size, 0u) << up;
    }
}

TEST(Crossings, SignsOfVolumesAreExact) {
    std::mt19937 random(7);
    std::uniform_int_distribution<int> small(-2000, 2000);
    for (int k = 0; k < 20000; ++k) {
        // Integers below 2^12: the volume is exact in 64 bits, however the four are scaled.
        std::array<std::array<long long, 3>, 4> x{};
        for (auto& point : x)
            for (long long& c : point) c = small(random);
        if (k % 2 == 0)  // in one plane
            for (std::size_t i = 0; i < 3; ++i) x[3][i] = x[0][i] + x[1][i] - x[2][i];
        if (k % 4 == 0) x[3][std::size_t(k / 4 % 3)] += k % 8 == 0 ? 1 : -1;
        const auto edge = [&](std::size_t p, std::size_t i) { return x[p][i] - x[0][i]; };
        long long volume = 0;
        for (std::size_t i = 0; i < 3; ++i) {
            const std::size_t j = (i + 1) % 3, l = (i + 2) % 3;
            volume += edge(1, i) * (edge(2, j) * edge(3, l) - edge(2, l) * edge(3, j));
        }
        const int sign = volume > 0 ? 1 : volume < 0 ? -1 : 0;
        for (const float scale : {1.0f, 0x1p-60f, 0x1p+50f, 0x1p-140f}) {
            std::array<Vec4, 4> p;
            for (std::size_t i = 0; i < 4; ++i)
                p[i] = {scale * float(x[i][0]), scale * float(x[i][1]), scale * float(x[i][2]), 0};
            ASSERT_EQ(volume_sign(p[0], p[1], p[2], p[3]), sign) << k << " " << scale;
            ASSERT_EQ(volume_sign(p[1], p[0], p[2], p[3]), -sign) << k << " " << scale;
        }
    }
}

TEST(Crossings, SignsOfAreasAreExact) {
    std::mt19937 random(11);
    for (int k = 0; k < 2000; ++k) {
        std::array<std::array<long long, 3>, 4> x;  // a, b, c and the normal
        for (auto& p : x)
            for (long long& coordinate : p) coordinate = static_cast<int>(random() % 2001) - 1000;
        if (k % 2 == 0)  // on one line, as seen along the normal
            for (std::size_t i = 0; i < 3; ++i) x[2][i] = 3 * x[1][i] - 2 * x[0][i] + (k % 4) / 2 * x[3][i];
        if (k % 3 == 0) ++x[2][std::size_t(k / 3 % 3)];
        const auto edge = [&](std::size_t p, std::size_t i) { return x[p][i] - x[0][i]; };
        long long area = 0;
        for (std::size_t i = 0; i < 3; ++i) {
            const std::size_t j = (i + 1) % 3, l = (i + 2) % 3;
            area += x[3][i] * (edge(1, j) * edge(2, l) - edge(1, l) * edge(2, j));
        }
        const int sign = area > 0 ? 1 : area < 0 ? -1 : 0;
        for (const float scale : {1.0f, 0x1p-60f, 0x1p+50f, 0x1p-140f}) {
            std::array<Vec3, 4> p;
            for (std::size_t i = 0; i < 4; ++i)
                p[i] = {scale * float(x[i][0]), scale * float(x[i][1]), scale * float(x[i][2])};
            ASSERT_EQ(area_sign(p[0], p[1], p[2], p[3]), sign) << k << " " << scale;
            ASSERT_EQ(area_sign(p[2], p[0], p[1], p[3]), sign) << k << " " << scale;
            ASSERT_EQ(area_sign(p[1], p[0], p[2], p[3]), -sign) << k << " " << scale;
        }
    }
}

TEST(Crossings, SignsOfVolumesAreExactWhereDoubleRoundsDifferences) {
    const float far = 0x1p+40f;
    const Vec4 a = {0, 0, 0, 0}, b = {far, far, 0, 0}, c = {0, far, far, 0};  // plane x - y + z = 0
    const Vec4 on = {1, 3, 2, 0};
    EXPECT_EQ(volume_sign(a, b, c, on), 0);
    EXPECT_EQ(volume_sign(a, b, c, {std::nextafter(1.0f, 2.0f), 3, 2, 0}), 1);
    EXPECT_EQ(volume_sign(a, b, c, {std::nextafter(1.0f, 0.0f), 3, 2, 0}), -1);
}

TEST(Crossings, ALineThroughSidesAndCornersIsSeen) {
    const std::vector<Vec4> sheet = level_grid(6);
    for (const auto& [x, z] : {std::pair(0.02f, 0.02f), {0.025f, 0.02f}, {0.02f, 0.035f}, {0.025f, 0.025f}}) {
        ContactScene scene;
        scene.add(sheet, sheet, grid_triangles(6, 6), 0.003f);
        const std::vector<Vec4> needle = {{x, -0.1f, z, 0}, {x, 0.1f, z, 0}, {x + 1, 0.1f, z, 0}};
        scene.add(needle, needle, {{0, 1, 2}}, 0.003f);
        EXPECT_TRUE(std::ranges::any_of(set_of(crossings_of(scene)),
                                        [](const Five& c) { return c[0] == 36 && c[1] == 37; }))
            << x << " " << z;
    }
}

TEST(Crossings, TheListDoesNotDependOnThreadsAndEndsWhereRoomDoes) {
    const ContactScene scene = crumpled(48);
    const LaidOut<CrossingList> all = crossings_of(scene);
    ASSERT_GT(all.size, 2000u);
    for (const std::uint32_t capacity : {0u, 1u, 1000u, all.size - 1, all.size}) {
        for (const int threads : {1, 2, 4}) {
            const LaidOut<CrossingList> list = crossings_of(scene, threads, capacity);
            EXPECT_EQ(list.overflowed, capacity < all.size);
            ASSERT_EQ(list.size, capacity);
            EXPECT_EQ(std::memcmp(list.crossings.data(), all.crossings.data(), capacity * sizeof(Crossing)),
                      0);
        }
    }
}

TEST(Crossings, WhatIsNotFiniteCrossesNothing) {
    constexpr float nan = std::numeric_limits<float>::quiet_NaN(),
                    inf = std::numeric_limits<float>::infinity();
    const ContactScene scene = crumpled(16);
    ContactScene spoilt = scene;
    spoilt.positions[40] = {nan, 0, 0, 0};
    spoilt.positions[99] = {0, 0, -inf, 0};
    std::set<Five> expected = set_of(crossings_of(scene));
    std::erase_if(expected, [](const Five& c) {
        return std::ranges::any_of(c, [](std::uint32_t i) { return i == 40 || i == 99; });
    });
    EXPECT_EQ(set_of(crossings_of(spoilt)), expected);
}

TEST(Crossings, AsReferenceOnEveryVectorTarget) {
    for (const std::int64_t target : vector_targets()) {
        use_target(target);
        expect_as_reference(crumpled(16), 300);
    }
    use_target(0);
}

}  // namespace
}  // namespace weft::test
