// Rays, nearest places and balls against a World's cloths: as a plain search over all triangles finds them.

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <Eigen/Dense>
#include <limits>
#include <optional>
#include <random>
#include <vector>

#include "tests/cloth/fixtures.h"
#include "tests/cloth/meshes.h"
#include "weft/weft.h"

namespace weft::test {
namespace {

using Vector3d = Eigen::Vector3d;
constexpr float infinity = std::numeric_limits<float>::infinity();

/// Three cloths that have fallen over a ball, and one that is disabled.
struct Heap {
    Heap() : world(World::create({.threads = 1}).value()) {
        EXPECT_TRUE(world.add_collider({.shape = Sphere{{0, 0.1f, 0}, 0.3f}, .friction = 0.5f}).ok());
        for (const float y : {0.5f, 0.7f})
            cloths.push_back(world
                                 .add_cloth(make_sheet({.rows = 14,
                                                        .columns = 12,
                                                        .origin = {-0.5f, y, -0.5f},
                                                        .u = {1, 0, 0},
                                                        .v = {0, 0, 1}})
                                                .value(),
                                            {.self_collision = {.method = SelfCollisionMethod::contact}})
                                 .value());
        cloths.push_back(world.add_cloth(tube(6, 8)).value());
        for (int k = 0; k < 40; ++k) world.step(h);
        off = world.add_cloth(sheet(4, 4), {.enabled = false}).value();
    }
    template <class Visit>
    void for_each_triangle(const Visit& visit) const {
        for (const ClothId id : cloths) {
            const ClothView view = *world.cloth(id);
            for (std::uint32_t t = 0; t < view.triangles.size(); ++t) {
                std::array<Vector3d, 3> x;
                for (std::size_t k = 0; k < 3; ++k)
                    x[k] = xyz(view.positions[view.triangles[t][k]]).cast<double>();
                visit(id, t, x);
            }
        }
    }
    World world;
    std::vector<ClothId> cloths;
    ClothId off;
};

/// The solution (s, u, v) of the ray's equation: from + s direction = x0 + u (x1 - x0) + v (x2 - x0).
std::optional<double> hit(const Vector3d& from, const Vector3d& direction, const std::array<Vector3d, 3>& x) {
    Eigen::Matrix3d columns;
    columns << x[1] - x[0], x[2] - x[0], -direction;
    const Vector3d uvs = columns.fullPivLu().solve(from - x[0]);
    if (uvs.x() < 0 || uvs.y() < 0 || uvs.x() + uvs.y() > 1 || uvs.z() < 0) return std::nullopt;
    return uvs.z();
}

/// The least distance from a triangle, by its plane, its edges and its corners.
double distance_from(const Vector3d& p, const std::array<Vector3d, 3>& x) {
    double least = std::numeric_limits<double>::infinity();
    for (std::size_t k = 0; k < 3; ++k) {
        const Vector3d a = x[k], edge = x[(k + 1) % 3] - a;
        const double s = std::clamp((p - a).dot(edge) / edge.squaredNorm(), 0.0, 1.0);
        least = std::min(least, (a + s * edge - p).norm());
    }
    const Vector3d normal = (x[1] - x[0]).cross(x[2] - x[0]).normalized();
    if (const auto s = hit(p, normal, x)) least = std::min(least, *s);
    if (const auto s = hit(p, -normal, x)) least = std::min(least, *s);
    return least;
}

void expect_sound(const World& world, const ClothPoint& point) {
    const ClothView view = *world.cloth(point.cloth);
    ASSERT_LT(point.triangle, view.triangles.size());
    const Triangle& t = view.triangles[point.triangle];
    const std::array<float, 3> weights{point.weights.x, point.weights.y, point.weights.z};
    Vector3 there = Vector3::Zero();
    for (std::size_t k = 0; k < 3; ++k) {
        EXPECT_GE(weights[k], 0);
        there += weights[k] * xyz(view.positions[t[k]]);
    }
    EXPECT_NEAR(weights[0] + weights[1] + weights[2], 1, 1e-6f);
    EXPECT_LT((there - to_vector(point.position)).norm(), 1e-6f);
    const Vector3 side = xyz(view.positions[t[1]]) - xyz(view.positions[t[0]]),
                  other = xyz(view.positions[t[2]]) - xyz(view.positions[t[0]]);
    EXPECT_LT((side.cross(other).normalized() - to_vector(point.normal)).norm(), 1e-4f);
}

Vec3 random_point(std::mt19937& random, float size) {
    std::uniform_real_distribution<float> at(-size, size);
    const float x = at(random), y = at(random), z = at(random);
    return {x, y, z};
}

TEST(Queries, ARayStopsAtTheFirstTriangle) {
    const Heap heap;
    std::mt19937 random(5);
    int hits = 0;
    for (int k = 0; k < 500; ++k) {
        const Vec3 from = random_point(random, 1.5f), towards = random_point(random, 0.6f);
        const Vector3d start = to_vector(from).cast<double>(),
                       way = to_vector(towards).cast<double>() - start;
        double first = std::numeric_limits<double>::infinity();
        heap.for_each_triangle([&](ClothId, std::uint32_t, const std::array<Vector3d, 3>& x) {
            if (const auto s = hit(start, way.normalized(), x)) first = std::min(first, *s);
        });
        const auto found = heap.world.cast_ray(from, to_vec3(Vector3((3 * way).cast<float>()))).value();
        ASSERT_EQ(found.has_value(), std::isfinite(first)) << "ray " << k;
        if (!found) continue;
        ++hits;
        EXPECT_NEAR(static_cast<double>(found->distance), first, 1e-5);
        EXPECT_NEAR(((to_vector(found->position).cast<double>() - start).cross(way.normalized())).norm(), 0,
                    1e-5);
        expect_sound(heap.world, *found);
        const float less = found->distance * 0.999f;
        EXPECT_FALSE(heap.world.cast_ray(from, to_vec3(Vector3(way.cast<float>())), less)->has_value());
    }
    EXPECT_GT(hits, 200);
}

// Rays at the edges and corners of a closed surface, from within: none slips through.
TEST(Queries, NoRaySlipsThroughAnEdge) {
    const Mesh ball = sphere(2);
    World world = World::create({}).value();
    const ClothView view = *world.cloth(world.add_cloth(ball).value());
    std::mt19937 random(8);
    for (int k = 0; k < 20; ++k) {
        const Vec3 from = random_point(random, 0.3f);
        for (const Triangle& t : view.triangles)
            for (const float s : {0.0f, 0.3f, 0.5f}) {
                const Vector3 a = xyz(view.positions[t[0]]), b = xyz(view.positions[t[1]]);
                const Vector3 way = a + s * (b - a) - to_vector(from);
                const auto found = world.cast_ray(from, to_vec3(way)).value();
                ASSERT_TRUE(found);
                EXPECT_NEAR(found->distance, way.norm(), 1e-5f);
            }
    }
}

TEST(Queries, ThePlaceNearestToAPointIsThatOfAllTriangles) {
    const Heap heap;
    std::mt19937 random(6);
    for (int k = 0; k < 200; ++k) {
        const Vec3 point = random_point(random, 1);
        const Vector3d at = to_vector(point).cast<double>();
        double least = std::numeric_limits<double>::infinity();
        std::size_t in_ball = 0, on_its_rim = 0;
        heap.for_each_triangle([&](ClothId, std::uint32_t, const std::array<Vector3d, 3>& x) {
            const double distance = distance_from(at, x);
            least = std::min(least, distance);
            in_ball += distance <= 0.3 ? 1 : 0;
            on_its_rim += std::abs(distance - 0.3) < 1e-5 ? 1 : 0;
        });
        const auto found = heap.world.closest_point(point).value();
        ASSERT_TRUE(found);
        EXPECT_NEAR(static_cast<double>(found->distance), least, 1e-5);
        EXPECT_NEAR((to_vector(found->position).cast<double>() - at).norm(), least, 1e-5);
        expect_sound(heap.world, *found);
        EXPECT_FALSE(heap.world.closest_point(point, 0.99f * found->distance)->has_value());
        EXPECT_TRUE(heap.world.closest_point(point, 1.01f * found->distance)->has_value());

        std::vector<ClothPoint> touched(2000);
        const std::size_t count = heap.world.triangles_in_ball(point, 0.3f, touched).value();
        EXPECT_NEAR(static_cast<double>(count), static_cast<double>(in_ball),
                    static_cast<double>(on_its_rim));
        for (std::size_t i = 0; i < count; ++i) EXPECT_LE(touched[i].distance, 0.3f);
    }
}

TEST(Queries, AskOneClothOnlyAndNoneThatIsOff) {
    const Heap heap;
    const Vec3 above{0.02f, 3, 0.03f}, down{0, -1, 0};
    const ClothPoint first = *heap.world.cast_ray(above, down).value();
    EXPECT_EQ(first.cloth, heap.cloths[1]) << "the upper sheet";
    const ClothPoint second = *heap.world.cast_ray(above, down, infinity, heap.cloths[0]).value();
    EXPECT_EQ(second.cloth, heap.cloths[0]);
    EXPECT_GT(second.distance, first.distance);
    EXPECT_EQ(heap.world.closest_point(above, infinity, heap.cloths[0]).value()->cloth, heap.cloths[0]);
    EXPECT_FALSE(heap.world.closest_point(above, infinity, heap.off)->has_value());
    std::vector<ClothPoint> few(3);
    EXPECT_GT(heap.world.triangles_in_ball({0, 0.4f, 0}, 0.3f, few, heap.cloths[0]).value(), 3u);
    EXPECT_EQ(heap.world.triangles_in_ball({0, 0.4f, 0}, 0.3f, {}, heap.off).value(), 0u);
}

TEST(Queries, NameWhatIsWrong) {
    Heap heap;
    constexpr float nan = std::numeric_limits<float>::quiet_NaN();
    const auto refused = [](const auto& answer, const char* words) {
        ASSERT_FALSE(answer.ok());
        EXPECT_NE(answer.error().message.find(words), std::string::npos) << answer.error().message;
    };
    refused(heap.world.cast_ray({nan, 0, 0}, {0, 1, 0}), "from");
    refused(heap.world.cast_ray({}, {0, 0, 0}), "direction");
    refused(heap.world.cast_ray({}, {0, infinity, 0}), "direction");
    refused(heap.world.cast_ray({}, {0, 1, 0}, -1), "reach is -1");
    refused(heap.world.cast_ray({}, {0, 1, 0}, 1, {77, 3}), "ClothId");
    refused(heap.world.closest_point({0, 2e5f, 0}), "to");
    refused(heap.world.closest_point({}, nan), "within");
    refused(heap.world.triangles_in_ball({nan, 0, 0}, 1, {}), "center");
    refused(heap.world.triangles_in_ball({}, -1, {}), "radius is -1");
    ASSERT_TRUE(heap.world.begin_step(h));
    refused(heap.world.cast_ray({}, {0, 1, 0}), "cast_ray");
    ASSERT_TRUE(heap.world.end_step());
}

}  // namespace
}  // namespace weft::test
