// Shapes that a World holds: where their surfaces are, what they refuse, and that particles meet them.

#include <gtest/gtest.h>

#include <cstring>
#include <random>
#include <string>

#include "collision/shapes/held_shape.h"
#include "tests/collision/colliders/solids.h"
#include "tests/collision/colliders/swept_way.h"
#include "tests/collision/particle_cloud.h"
#include "tests/must.h"

namespace weft::test {
namespace {

HeldShape hold(const Shape& shape) {
    return must(HeldShape::make(shape));
}

std::vector<Vec3> points_about(const Vector3& size, std::size_t count, std::uint32_t seed = 7) {
    std::mt19937 random(seed);
    std::uniform_real_distribution<float> uniform(-1, 1);
    std::vector<Vec3> points(count);
    for (Vec3& p : points)
        p = {size.x() * uniform(random), size.y() * uniform(random), size.z() * uniform(random)};
    return points;
}

std::vector<Vec4> surfaces_of(const HeldShape& shape, std::span<const Vec3> points, float sight = inf) {
    std::vector<Vec4> surfaces(points.size());
    find_surfaces(shape, points, sight, surfaces);
    return surfaces;
}

/// A spike with angles so sharp that the nearest triangle's own normal gives the wrong side of it.
Solid spike() {
    return {{{0, 0, 0}, {1, 0.05f, 0}, {1, -0.05f, 0.05f}, {1, -0.05f, -0.05f}},
            {{0, 2, 1}, {0, 3, 2}, {0, 1, 3}, {1, 2, 3}}};
}

TEST(HeldShapes, DistancesAreBruteForcesWithItsSign) {
    for (const Solid& solid : {torus(0.5f, 0.2f, 24, 12), box_mesh({0.5f, 0.1f, 0.3f}), spike()}) {
        const HeldShape held = hold(solid.mesh());
        std::vector<Vec3> points = points_about({1, 0.4f, 1}, 600);
        for (const Vec3& v : solid.vertices)  // beside corners and edges
            points.push_back({v.x + 1e-3f, v.y - 2e-3f, v.z + 5e-4f});
        for (const Vec3& v : solid.vertices) points.push_back({0.9f * v.x + 0.075f, 0.9f * v.y, 0.9f * v.z});
        const std::vector<Vec4> surfaces = surfaces_of(held, points), near = surfaces_of(held, points, 0.02f);
        std::size_t inside = 0;
        for (std::size_t i = 0; i < points.size(); ++i) {
            const double distance = distance_to(solid, to_vector(points[i]));
            EXPECT_NEAR(static_cast<double>(surfaces[i].w), distance, 2e-6) << i;
            EXPECT_NEAR(xyz(surfaces[i]).norm(), 1, 1e-5f);
            // Along the normal by as much it is on the surface.
            const Vector3 foot = to_vector(points[i]) - surfaces[i].w * xyz(surfaces[i]);
            EXPECT_NEAR(distance_to(solid, foot), 0, 1e-5) << i;
            inside += distance < 0 ? 1 : 0;
            // What looks no farther finds the same, and is inside however deep.
            if (std::abs(distance - 0.02) < 1e-4) continue;
            EXPECT_EQ(near[i].w, distance < 0.02 ? surfaces[i].w : 0.02f) << i;
        }
        EXPECT_GT(inside, solid.vertices.size() == 4 ? 2u : 20u);
    }
}

/// Triangles at random, of sizes from 1 mm to 1 m and of any width, which share no corners.
Solid splinters(std::size_t count) {
    std::mt19937 random(11);
    std::uniform_real_distribution<float> uniform(-1, 1);
    const auto vector = [&] { return Vector3(uniform(random), uniform(random), uniform(random)); };
    Solid made;
    for (std::size_t t = 0; t < count; ++t) {
        const float size = std::pow(10.0f, 1.5f * uniform(random) - 1.5f);
        const float width = std::pow(10.0f, 2.0f * uniform(random) - 2.0f);
        const Vector3 a = vector(), along = size * vector();
        const auto first = static_cast<std::uint32_t>(made.vertices.size());
        for (const Vector3& corner :
             {a, Vector3(a + along), Vector3(a + 0.6f * along + size * width * vector())})
            made.vertices.push_back(to_vec3(corner));
        made.triangles.push_back({first, first + 1, first + 2});
    }
    return made;
}

TEST(HeldShapes, NoBoundLeavesOutTheNearestTriangle) {
    const Solid solid = splinters(400);
    const HeldShape held = hold(solid.mesh(false));
    std::vector<Vec3> points = points_about({1.2f, 1.2f, 1.2f}, 400);
    std::mt19937 random(5);
    std::uniform_real_distribution<float> uniform(-1, 1);
    for (const auto& t : solid.triangles)  // beside each, as far as it is long and much nearer
        for (const float far : {1.0f, 0.1f, 1e-3f}) {
            const Vector3 a = to_vector(solid.vertices[t[0]]), b = to_vector(solid.vertices[t[1]]);
            const Vector3 away(uniform(random), uniform(random), uniform(random));
            points.push_back(
                to_vec3(Vector3(a + 0.5f * (uniform(random) + 1) * (b - a) + far * (b - a).norm() * away)));
        }
    const std::vector<Vec4> surfaces = surfaces_of(held, points), near = surfaces_of(held, points, 0.05f);
    for (std::size_t i = 0; i < points.size(); ++i) {
        const double distance = std::abs(distance_to(solid, to_vector(points[i])));
        EXPECT_NEAR(static_cast<double>(std::abs(surfaces[i].w)), distance, 2e-6) << i;
        EXPECT_EQ(near[i].w, surfaces[i].w < 0.05f ? surfaces[i].w : 0.05f) << i;
    }
}

TEST(HeldShapes, AnOpenMeshHasTwoSides) {
    const Solid sheet{{{0, 0, 0}, {1, 0, 0}, {0, 0, 1}}, {{0, 2, 1}}};
    const HeldShape held = hold(sheet.mesh(false));
    const std::vector<Vec3> points{{0.2f, 0.3f, 0.2f}, {0.2f, -0.3f, 0.2f}, {-0.5f, 0, 0}};
    const std::vector<Vec4> surfaces = surfaces_of(held, points);
    EXPECT_FLOAT_EQ(surfaces[0].w, 0.3f);
    EXPECT_FLOAT_EQ(surfaces[0].y, 1);
    EXPECT_FLOAT_EQ(surfaces[1].w, 0.3f);
    EXPECT_FLOAT_EQ(surfaces[1].y, -1);
    EXPECT_FLOAT_EQ(surfaces[2].x, -1);
}

TEST(HeldShapes, AHullIsTheLeastConvexSolidAroundItsPoints) {
    const std::vector<Vec3> points = points_about({0.5f, 0.2f, 0.4f}, 300);
    const HeldShape held = hold(ConvexHull{points});
    EXPECT_LT(held.info().triangles, 200u);
    EXPECT_TRUE(held.is_convex());
    std::size_t corners = 0;
    for (const Vec4& surface : surfaces_of(held, points)) {
        EXPECT_LT(surface.w, 3e-6f);
        corners += std::abs(surface.w) < 3e-6f ? 1 : 0;
    }
    EXPECT_EQ(held.info().triangles, 2 * corners - 4);  // Euler: all of its corners are points
    // Of any two points the middle is inside.
    for (std::size_t i = 1; i < points.size(); ++i) {
        const Vec3 middle = to_vec3(Vector3(0.5f * (to_vector(points[i]) + to_vector(points[i - 1]))));
        EXPECT_LT(surfaces_of(held, {&middle, 1})[0].w, 3e-6f);
    }
    // A box with points on its faces and edges has eight corners.
    std::vector<Vec3> grid;
    for (int k = 0; k < 125; ++k)
        grid.push_back(
            {static_cast<float>(k % 5), static_cast<float>(k / 5 % 5), static_cast<float>(k / 25)});
    const HeldShape box = hold(ConvexHull{grid});
    const Vec3 above{2, 4.5f, 1.3f};
    EXPECT_FLOAT_EQ(surfaces_of(box, {&above, 1})[0].w, 0.5f);
}

struct Hills {
    static constexpr std::uint32_t rows = 9, columns = 12;
    std::vector<float> heights = [] {
        std::vector<float> made;
        for (std::uint32_t r = 0; r < rows; ++r)
            for (std::uint32_t c = 0; c < columns; ++c)
                made.push_back(0.1f * std::sin(1.3f * static_cast<float>(r)) *
                               std::cos(0.9f * static_cast<float>(c)));
        return made;
    }();
    [[nodiscard]] HeightField field() const { return {rows, columns, 0.1f, heights}; }
    [[nodiscard]] Solid triangles() const {
        Solid made;
        for (std::uint32_t r = 0; r < rows; ++r)
            for (std::uint32_t c = 0; c < columns; ++c) {
                made.vertices.push_back(
                    {0.1f * static_cast<float>(c), heights[r * columns + c], 0.1f * static_cast<float>(r)});
                const std::uint32_t v = r * columns + c;
                if (r + 1 == rows || c + 1 == columns) continue;
                made.triangles.push_back({v, v + columns + 1, v + 1});
                made.triangles.push_back({v, v + columns, v + columns + 1});
            }
        return made;
    }
};

/// Of the triangles' front at (x, z); not a number beside them.
float height_at(const Solid& ground, float x, float z) {
    for (const auto& t : ground.triangles) {
        const Vector3 a = to_vector(ground.vertices[t[0]]), u = to_vector(ground.vertices[t[1]]) - a,
                      v = to_vector(ground.vertices[t[2]]) - a, p = Vector3(x, 0, z) - a;
        const float area = u.z() * v.x() - u.x() * v.z();
        const float of_u = (p.z() * v.x() - p.x() * v.z()) / area,
                    of_v = (u.z() * p.x() - u.x() * p.z()) / area;
        if (of_u >= 0 && of_v >= 0 && of_u + of_v <= 1) return a.y() + of_u * u.y() + of_v * v.y();
    }
    return nan;
}

TEST(HeldShapes, AHeightFieldIsItsTrianglesAndSolidBelow) {
    const Hills hills;
    const HeldShape field = hold(hills.field()), mesh = hold(hills.triangles().mesh(false));
    std::vector<Vec3> points = points_about({0.7f, 0.2f, 0.5f}, 2000);
    for (Vec3& p : points) p = {p.x + 0.55f, p.y, p.z + 0.4f};
    const std::vector<Vec4> of_field = surfaces_of(field, points, 0.3f),
                            of_mesh = surfaces_of(mesh, points, 0.3f);
    std::size_t below = 0, beside = 0;
    for (std::size_t i = 0; i < points.size(); ++i) {
        EXPECT_NEAR(std::abs(of_field[i].w), of_mesh[i].w, 2e-6f) << i;
        EXPECT_NEAR(of_field[i].w < 0 ? -xyz(of_field[i]).dot(xyz(of_mesh[i]))
                                      : xyz(of_field[i]).dot(xyz(of_mesh[i])),
                    1, 1e-2f);
        const Vec3& p = points[i];
        const bool is_over = p.x > 0 && p.x < 1.1f && p.z > 0 && p.z < 0.8f;
        if (std::abs(of_field[i].w) > 1e-6f) {
            const float height = height_at(hills.triangles(), p.x, p.z);  // nothing is below no number
            EXPECT_EQ(of_field[i].w < 0, p.y < height) << i;
        }
        below += of_field[i].w < 0 ? 1 : 0;
        beside += is_over ? 0 : 1;
    }
    EXPECT_GT(below, 300u);
    EXPECT_GT(beside, 100u);
    // However deep.
    const Vec3 deep{0.5f, -30, 0.3f};
    const Vec4 surface = surfaces_of(field, {&deep, 1}, 0.02f)[0];
    EXPECT_LT(surface.w, -20);
    EXPECT_GT(surface.y, 0.5f);
}

TEST(HeldShapes, ADistanceFieldIsWithinItsStatedError) {
    const Solid solid = torus(0.5f, 0.2f, 32, 16);
    const HeldShape mesh = hold(solid.mesh()), field = hold(DistanceField{solid.mesh(), 0.04f});
    const float stated = field.info().error;
    EXPECT_FLOAT_EQ(stated, 0.87f * 0.04f);
    const std::vector<Vec3> points = points_about({0.8f, 0.25f, 0.8f}, 3000);
    const std::vector<Vec4> exact = surfaces_of(mesh, points), found = surfaces_of(field, points);
    double sum = 0;
    std::size_t near = 0;
    for (std::size_t i = 0; i < points.size(); ++i) {
        EXPECT_NEAR(found[i].w, exact[i].w, stated + 1e-6f);
        if (std::abs(exact[i].w) > 0.05f) continue;
        sum += static_cast<double>(std::abs(found[i].w - exact[i].w));
        EXPECT_GT(xyz(found[i]).dot(xyz(exact[i])), 0.8f);
        ++near;
    }
    EXPECT_LT(sum / static_cast<double>(near), 2e-3);
    EXPECT_GT(near, 300u);
}

TEST(HeldShapes, AMeshThatDeformsIsLikeOneMadeSo) {
    Solid solid = torus(0.5f, 0.2f, 24, 12);
    HeldShape held = hold(solid.mesh());
    for (Vec3& v : solid.vertices) v = {1.2f * v.x + 0.1f, 0.7f * v.y + 0.2f * v.x, v.z};
    ASSERT_TRUE(held.deform(solid.vertices, 1).ok());
    const HeldShape anew = hold(solid.mesh());
    const std::vector<Vec3> points = points_about({1, 0.5f, 1}, 800);
    const std::vector<Vec4> deformed = surfaces_of(held, points), expected = surfaces_of(anew, points);
    for (std::size_t i = 0; i < points.size(); ++i) EXPECT_NEAR(deformed[i].w, expected[i].w, 1e-6f);
    const std::vector<Vec4> seen = surfaces_of(held, points, 0.02f);
    std::size_t deep = 0;
    for (std::size_t i = 0; i < points.size(); ++i) {
        EXPECT_NEAR(seen[i].w, std::min(expected[i].w, 0.02f), 1e-6f) << "however short its sight";
        deep += expected[i].w < -0.02f ? 1 : 0;
    }
    EXPECT_GT(deep, 30u);
    held.prepare_deformation();
    held.put_back({});
    const std::vector<Vec4> back = surfaces_of(held, points, 0.02f);
    const HeldShape original = hold(torus(0.5f, 0.2f, 24, 12).mesh());
    const std::vector<Vec4> first = surfaces_of(original, points);
    for (std::size_t i = 0; i < points.size(); ++i)
        EXPECT_NEAR(back[i].w, std::min(first[i].w, 0.02f), 1e-6f) << "as it was made";
    ASSERT_TRUE(held.deform(solid.vertices, 1).ok());

    solid.vertices.pop_back();
    EXPECT_FALSE(held.deform(solid.vertices, 2).ok());
    solid.vertices.push_back({nan, 0, 0});
    EXPECT_FALSE(held.deform(solid.vertices, 2).ok());
    for (Vec3& v : solid.vertices) v = {-v.x, v.y, v.z};
    solid.vertices.back() = {};
    EXPECT_FALSE(held.deform(solid.vertices, 2).ok());  // inside out
    const std::vector<Vec4> after = surfaces_of(held, points);
    EXPECT_EQ(std::memcmp(after.data(), deformed.data(), after.size() * sizeof(Vec4)), 0);
    EXPECT_FALSE(hold(ConvexHull{points}).deform(points, 1).ok());
}

TEST(HeldShapes, CellsOutsideADeformedMeshRuleOutNothingInside) {
    Solid solid = torus(0.5f, 0.2f, 24, 12);
    HeldShape held = hold(solid.mesh());
    for (Vec3& v : solid.vertices) v = {1.2f * v.x + 0.1f, 0.7f * v.y + 0.2f * v.x, v.z};
    ASSERT_TRUE(held.deform(solid.vertices, 1).ok());
    std::size_t inside = 0, outside = 0, ruled_out = 0;
    for (const Vec3& p : points_about({1, 0.4f, 1}, 3000)) {
        const double distance = distance_to(solid, to_vector(p));
        for (const float depth : {2e-3f, 0.01f, 0.05f}) {
            const bool may_be = held.may_be_deeper(to_vector(p), depth);
            if (distance < -static_cast<double>(depth)) {
                EXPECT_TRUE(may_be) << distance;
                ++inside;
            }
            if (distance > 0.03) {
                ++outside;
                ruled_out += may_be ? 0 : 1;
            }
        }
    }
    EXPECT_GT(inside, 500u);
    EXPECT_GT(ruled_out, outside - outside / 20);
}

TEST(HeldShapes, RefuseWhatIsNotWhatItSays) {
    const auto refused = [](const Shape& shape) {
        const auto held = HeldShape::make(shape);
        return held ? std::string("taken") : held.error().message;
    };
    const auto expect_says = [&](const Shape& shape, const std::string& words) {
        EXPECT_NE(refused(shape).find(words), std::string::npos) << refused(shape);
    };
    Solid solid = box_mesh({1, 1, 1});
    expect_says(TriangleMesh{}, "triangles has 0");
    solid.triangles.pop_back();
    expect_says(solid.mesh(), "is open");
    EXPECT_EQ(refused(solid.mesh(false)), "taken");
    expect_says(DistanceField{solid.mesh(false), 0.1f}, "not closed");
    solid.triangles.push_back({4, 6, 7});
    expect_says(solid.mesh(), "wound alike");
    solid = box_mesh({1, 1, 1});
    for (auto& t : solid.triangles) std::swap(t[0], t[1]);
    expect_says(solid.mesh(), "inside out");
    solid = box_mesh({1, 1, 1});
    solid.triangles[3][1] = 8;
    expect_says(solid.mesh(), "triangles[3] has the vertex 8");
    solid = box_mesh({1, 1, 1});
    solid.triangles[2][1] = solid.triangles[2][0];
    expect_says(solid.mesh(), "triangles[2] has two corners");
    solid = box_mesh({1, 1, 1});
    solid.vertices[5].y = nan;
    expect_says(solid.mesh(), "vertices[5]");
    solid.vertices[5].y = 2e5f;
    expect_says(solid.mesh(), "vertices[5]");

    std::vector<Vec3> flat = points_about({1, 0, 1}, 30);
    expect_says(ConvexHull{flat}, "lie in a plane");
    for (Vec3& p : flat) p.z = 0;
    expect_says(ConvexHull{flat}, "lie in a plane");
    expect_says(ConvexHull{{flat.data(), 3}}, "has 3");
    flat[4].x = inf;
    expect_says(ConvexHull{flat}, "points[4]");

    Hills hills;
    HeightField field = hills.field();
    field.spacing = 0;
    expect_says(field, "spacing is 0");
    field = hills.field();
    field.rows = 8;
    expect_says(field, "heights has 108");
    field.rows = 1;
    expect_says(field, "1 rows");
    hills.heights[17] = nan;
    expect_says(hills.field(), "heights[17] is nan");
    expect_says(DistanceField{box_mesh({1, 1, 1}).mesh(), 1e-3f}, "cell is 0.001");
}

/// A box, and the same as a mesh and as a hull: particles meet them alike, also on their way.
TEST(HeldShapes, AMeshAndAHullOfABoxAreMetAsTheBoxIs) {
    const Vec3 half{0.3f, 0.02f, 0.2f};
    const Solid solid = box_mesh(half);
    const HeldShape mesh = hold(solid.mesh()), hull = hold(ConvexHull{solid.vertices});
    const Placed start{Eigen::Quaternionf(Eigen::AngleAxisf(0.4f, Vector3(1, 2, 3).normalized())),
                       {0.1f, -0.2f, 0}},
        end{Eigen::Quaternionf(Eigen::AngleAxisf(0.9f, Vector3(1, 2, 3).normalized())), {0.1f, 0.2f, 0.1f}};
    const auto turn = [](const Placed& p) {
        return Rotation{p.turn.x(), p.turn.y(), p.turn.z(), p.turn.w()};
    };
    const auto box_at = [&](const Placed& p) {
        return Collider{Box{to_vec3(p.origin), turn(p), half}, 0.3f};
    };
    const auto instance_at = [&](const Placed& p) {
        return Collider{PlacedShape{{}, to_vec3(p.origin), turn(p)}, 0.3f};
    };
    const Particles before = [&] {
        Particles made;
        for (const Vec4& p : cloud(3000).positions) {
            made.positions.push_back({0.5f * p.x, 0.5f * p.y, 0.5f * p.z, 1});
            made.velocities.push_back({});
        }
        return made;
    }();
    for (const HeldShape* held : {&mesh, &hull}) {
        Particles of_box = before, of_held = before;
        meet_on_the_way(of_box, before.positions, {box_at(start), box_at(end)});
        ColliderMotion motion{instance_at(start), instance_at(end)};
        motion.held = held;
        const std::uint32_t met = meet_on_the_way(of_held, before.positions, motion);
        EXPECT_GT(met, 200u);
        std::size_t alike = 0;
        for (std::size_t i = 0; i < before.positions.size(); ++i) {
            const Vector3 apart = xyz(of_box.positions[i]) - xyz(of_held.positions[i]);
            const Vector3 faster = xyz(of_box.velocities[i]) - xyz(of_held.velocities[i]);
            alike += apart.norm() < 5e-3f && faster.norm() < 0.05f * (1 + xyz(of_box.velocities[i]).norm())
                         ? 1
                         : 0;
            // Out of it, whichever way, but for what began in it.
            const Vec3 began = to_vec3(start.back(xyz(before.positions[i])));
            if (surfaces_of(*held, {&began, 1})[0].w < thickness) continue;
            const Vector3 q = end.back(xyz(of_held.positions[i]));
            const Vec3 own = to_vec3(q);
            EXPECT_GT(surfaces_of(*held, {&own, 1})[0].w, 0.9f * thickness) << i;
        }
        // Those that began inside, in the thickness or in a corner's way may differ.
        EXPECT_GT(alike, before.positions.size() * 97 / 100);
    }
}

TEST(HeldShapes, ADeformingMeshDragsWhatItMeets) {
    Solid solid = box_mesh({0.5f, 0.1f, 0.5f});
    HeldShape held = hold(solid.mesh());
    for (Vec3& v : solid.vertices) v.y += 0.01f * (1 + v.x);
    ASSERT_TRUE(held.deform(solid.vertices, 1).ok());
    const Collider at{PlacedShape{}, 0};
    ColliderMotion motion{at, at};
    motion.held = &held;
    for (const bool moves : {false, true}) {
        motion.rate = moves ? 1 / h : 0;
        Particles particles{{{0.25f, 0.105f, 0, 1}}, {{}}};
        meet(particles, {motion}, 0.001f, 0);
        EXPECT_NEAR(particles.positions[0].y, 0.1f + 0.0125f + 0.001f, 1e-4f);
        EXPECT_NEAR(particles.velocities[0].y, moves ? 0.0125f / h : 0, 0.02f);
    }
}

/// A square of 2 m without thickness, at y = 0, that stands still.
struct OpenSheet {
    Solid square{{{-1, 0, -1}, {1, 0, -1}, {1, 0, 1}, {-1, 0, 1}}, {{0, 2, 1}, {0, 3, 2}}};
    HeldShape held = hold(square.mesh(false));
    ColliderMotion motion{{PlacedShape{}, 0}, {PlacedShape{}, 0}};

    OpenSheet() { motion.held = &held; }
};

// Particles are shot through it.
TEST(HeldShapes, NothingPassesAnOpenSheet) {
    const OpenSheet sheet;
    Particles particles = cloud(500);
    std::vector<Vec4> starts = particles.positions;
    for (std::size_t i = 0; i < starts.size(); ++i) {
        starts[i].y = i % 2 == 0 ? 0.3f : -0.3f;
        particles.positions[i] = starts[i];
        particles.positions[i].y = -starts[i].y * static_cast<float>(i) / 500.0f;
        particles.velocities[i] = {0, (particles.positions[i].y - starts[i].y) / h, 0, 0};
    }
    EXPECT_EQ(meet_on_the_way(particles, starts, sheet.motion), 500u);
    for (std::size_t i = 0; i < starts.size(); ++i) {
        EXPECT_NEAR(particles.positions[i].y, i % 2 == 0 ? thickness : -thickness, 2e-4f) << i;
        EXPECT_NEAR(particles.velocities[i].y, 0, 1e-3f);
    }
}

// Too slow for its whole way to be looked at: it ends within the thickness of the other side.
TEST(HeldShapes, WhatCreepsThroughAnOpenSheetGoesBack) {
    const OpenSheet sheet;
    Particles particles = cloud(100);
    std::vector<Vec4> starts = particles.positions;
    for (std::size_t i = 0; i < starts.size(); ++i) {
        const float side = i % 2 == 0 ? 1.0f : -1.0f;
        starts[i].y = 1.05f * thickness * side;
        particles.positions[i] = starts[i];
        particles.positions[i].y = -0.9f * thickness * side * static_cast<float>(i + 1) / 100.0f;
    }
    EXPECT_EQ(meet_on_the_way(particles, starts, sheet.motion), 100u);
    for (std::size_t i = 0; i < starts.size(); ++i)
        EXPECT_NEAR(particles.positions[i].y, i % 2 == 0 ? thickness : -thickness, 3e-4f) << i;
}

TEST(HeldShapes, BytesDoNotDependOnWhatElseIsAskedFor) {
    const HeldShape mesh = hold(torus(0.5f, 0.2f, 24, 12).mesh()), field = hold(Hills().field());
    const std::vector<Vec3> points = points_about({0.8f, 0.3f, 0.8f}, 500);
    for (const HeldShape* held : {&mesh, &field}) {
        const std::vector<Vec4> together = surfaces_of(*held, points, 0.4f);
        for (std::size_t i = 0; i < points.size(); ++i) {
            const Vec4 alone = surfaces_of(*held, {&points[i], 1}, 0.4f)[0];
            EXPECT_EQ(std::memcmp(&alone, &together[i], sizeof alone), 0) << i;
        }
    }
}

TEST(HeldShapes, WhatIsNotANumberMeetsNothing) {
    const HeldShape mesh = hold(torus(0.5f, 0.2f, 24, 12).mesh()), field = hold(Hills().field()),
                    distances = hold(DistanceField{torus(0.5f, 0.2f, 24, 12).mesh(), 0.05f});
    for (const HeldShape* held : {&mesh, &field, &distances})
        for (const float value : {nan, inf, -inf}) {
            const Collider at{PlacedShape{{}, {}, {0.6f, 0, 0, 0.8f}}, 0};
            ColliderMotion motion{at, at};
            motion.held = held;
            Particles particles{{{value, 0, 0, 1}, {0, value, 0, 1}, {0.5f, value, value, 1}},
                                std::vector<Vec4>(3)};
            EXPECT_EQ(meet(particles, {motion}, 0.1f), 0u);
            const std::vector<Vec4> starts{{0, 1, 0, 1}, {0, 1, 0, 1}, {0, 1, 0, 1}};
            EXPECT_EQ(meet_on_the_way(particles, starts, motion), 0u);
        }
}

}  // namespace
}  // namespace weft::test
