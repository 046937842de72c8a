// Whole triangles against thin and sharp colliders over one substep.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <random>
#include <vector>

#include "collision/thin/collide.h"
#include "collision/thin/cores.h"
#include "collision/thin/first_approach.h"
#include "collision/thin/whole_triangles.h"
#include "tests/collision/colliders/swept_way.h"
#include "tests/collision/contact/cuts.h"

namespace weft::test {
namespace {

constexpr float part = 1.0f / 480;

/// A bent sheet of cells of 3 cm over a substep, and something that flies through it.
struct Crash {
    static constexpr std::uint32_t side = 16;
    std::vector<WholeTriangles::Triangle> triangles;
    std::vector<Vec4> starts, positions, velocities;
    Placed start, end;

    explicit Crash(std::uint32_t seed) {
        std::mt19937 random(seed);
        std::uniform_real_distribution<float> uniform(-1, 1);
        const auto vector = [&](float size) -> Vector3 {
            return size * Vector3(uniform(random), uniform(random), uniform(random));
        };
        const Vector3 drift = vector(0.05f);
        for (std::uint32_t i = 0; i < side * side; ++i) {
            const Vector3 flat(0.03f * (static_cast<float>(i % side) - 7.5f), 0,
                               0.03f * (static_cast<float>(i / side) - 7.5f));
            starts.push_back(to_vec4(flat + vector(0.006f), 1000 * (1.5f + uniform(random))));
            positions.push_back(to_vec4(xyz(starts.back()) + drift + vector(0.004f), starts.back().w));
            velocities.push_back(to_vec4((xyz(positions.back()) - xyz(starts.back())) / part, 0));
        }
        for (std::uint32_t i = 0; i + side < side * side; ++i) {
            if (i % side + 1 == side) continue;
            triangles.push_back({i, i + side, i + 1});
            triangles.push_back({i + 1, i + side, i + side + 1});
        }
        const Vector3 axis = vector(1).normalized();
        const float angle = 0.3f * uniform(random);
        start.turn = Eigen::Quaternionf(Eigen::AngleAxisf(3 * uniform(random), vector(1).normalized()));
        end.turn = Eigen::Quaternionf(Eigen::AngleAxisf(angle, axis)) * start.turn;
        start.origin = vector(0.1f);
        start.origin.y() = 0.2f + 0.1f * std::abs(uniform(random));
        end.origin = start.origin + vector(0.05f);
        end.origin.y() -= 0.4f * std::abs(uniform(random));
    }
    std::uint32_t keep_out(const ColliderMotion& motion, int threads = 1, bool with_whole = true) {
        Parallel parallel(threads);
        WholeTriangles whole(triangles, side * side, 0.03f);
        std::vector<std::uint32_t> partials(1);
        return collide(parallel, std::span(&motion, 1), EvenSide(positions.size(), 0.005f, 1), part,
                       {.positions = positions,
                        .velocities = velocities,
                        .starts = starts,
                        .whole = with_whole ? &whole : nullptr},
                       partials);
    }
    /// Whether it begins where cloth should not be.
    [[nodiscard]] bool begins_near(const Vector3& p, const Vector3& q) const {
        const Vector3 along = q - p;
        return std::ranges::any_of(starts, [&](const Vec4& x) {
            const Vector3 seen = start.back(xyz(x)) - p;
            const float s = std::clamp(along.dot(seen) / along.squaredNorm(), 0.0f, 1.0f);
            return (seen - s * along).norm() < 0.01f;
        });
    }
    /// Whether a segment of the collider goes through a triangle on its way, as the collider sees it.
    [[nodiscard]] bool passes(const Vector3& p, const Vector3& q, int first, int last) const {
        constexpr int parts = 50;
        for (int k = first; k <= last; ++k) {
            const float t = static_cast<float>(k) / parts;
            const auto seen = [&](std::uint32_t i) {
                const Vector3 from = start.back(xyz(starts[i]));
                const Vector3 to = end.back(xyz(positions[i]));
                return Vector3(from + t * (to - from)).cast<double>().eval();
            };
            for (const auto& [a, b, c] : triangles)
                if (cuts<Eigen::Vector3d>(p.cast<double>(), q.cast<double>(), seen(a), seen(b), seen(c)))
                    return true;
        }
        return false;
    }
};

struct Thing {
    const char* name;
    std::vector<std::pair<Vector3, Vector3>> segments;
    Collider (*at)(const Placed& place);
};

std::vector<Thing> things() {
    const auto needle = [](const Placed& place) {
        return Collider{
            TaperedCapsule{to_vec3(place({0, 0, 0})), to_vec3(place({0.2f, 0, 0})), 0.001f, 0.004f}};
    };
    const auto bar = [](const Placed& place) {
        return Collider{Capsule{to_vec3(place({-0.5f, 0, 0})), to_vec3(place({0.5f, 0, 0})), 0.005f}};
    };
    const auto box = [](const Placed& place) {
        const Eigen::Quaternionf& q = place.turn;
        return Collider{Box{to_vec3(place.origin), {q.x(), q.y(), q.z(), q.w()}, {0.1f, 0.06f, 0.04f}}};
    };
    Thing sharp{"box", {}, box};
    for (const float y : {-0.06f, 0.06f})
        for (const float z : {-0.04f, 0.04f}) {
            sharp.segments.push_back({{-0.1f, y, z}, {0.1f, y, z}});
            sharp.segments.push_back({{0.1f, y, -z}, {0.1f, y, z}});
            sharp.segments.push_back({{-0.1f, -y, z}, {-0.1f, y, z}});
        }
    return {{"bar", {{{-0.5f, 0, 0}, {0.5f, 0, 0}}}, bar},
            {"needle", {{{0, 0, 0}, {0.2f, 0, 0}}}, needle},
            sharp};
}

TEST(WholeTriangles, NothingThinOrSharpGoesThroughOne) {
    for (const Thing& thing : things()) {
        int would = 0, does = 0;
        for (std::uint32_t seed = 1; seed <= 40; ++seed) {
            Crash crash(seed);
            const ColliderMotion motion{thing.at(crash.start), thing.at(crash.end)};
            const auto any = [&](int first, int last) {
                return std::ranges::any_of(thing.segments, [&](const auto& segment) {
                    return crash.passes(segment.first, segment.second, first, last);
                });
            };
            const auto begins_near = [&](const auto& segment) {
                return crash.begins_near(segment.first, segment.second);
            };
            if (std::ranges::any_of(thing.segments, begins_near) || any(0, 0) || !any(1, 50)) continue;
            ++would;
            EXPECT_GT(crash.keep_out(motion), 0u);
            does += any(1, 50) ? 1 : 0;
        }
        EXPECT_GT(would, 5) << thing.name;
        EXPECT_EQ(does, 0) << thing.name << " of " << would;
    }
}

TEST(WholeTriangles, BytesDoNotDependOnThreads) {
    for (const Thing& thing : things())
        for (std::uint32_t seed = 1; seed <= 10; ++seed) {
            Crash one(seed), three(seed);
            const ColliderMotion motion{thing.at(one.start), thing.at(one.end)};
            EXPECT_EQ(one.keep_out(motion, 1), three.keep_out(motion, 3));
            EXPECT_EQ(std::memcmp(one.positions.data(), three.positions.data(),
                                  one.positions.size() * sizeof(Vec4)),
                      0);
            EXPECT_EQ(std::memcmp(one.velocities.data(), three.velocities.data(),
                                  one.positions.size() * sizeof(Vec4)),
                      0);
        }
}

// Beside cells of 3 cm a ball of 20 cm is thick.
TEST(WholeTriangles, WhatIsThickHasNoPart) {
    Crash crash(3);
    const ColliderMotion motion{{Sphere{{0, 0.1f, 0}, 0.1f}}, {Sphere{{0, -0.1f, 0}, 0.1f}}};
    Crash without(3);
    EXPECT_EQ(crash.keep_out(motion), without.keep_out(motion, 1, false));
    EXPECT_EQ(
        std::memcmp(without.positions.data(), crash.positions.data(), crash.positions.size() * sizeof(Vec4)),
        0);
}

// Where a limb is thicker than cells, an edge that begins within it is let out; one that begins outside is
// kept there.
TEST(WholeTriangles, AnEdgeThatBeganInALimbIsLetBe) {
    const auto limb = [](float y) { return Collider{Capsule{{-1, y, 0}, {1, y, 0}, 0.02f}}; };
    const Cores cores({limb(0), limb(0.08f)}, part, true);
    const auto is_kept = [&](float y, bool only_from_outside) {
        const std::array<Vector3, 3> ends{Vector3(0.2f, y, -0.1f), Vector3(0.2f, y, 0.1f),
                                          Vector3(0.2f, y, -0.1f)};
        CornerPaths paths{ends, ends};
        for (Vector3& from : paths.from) from = cores.seen_at_start(from);
        for (Vector3& to : paths.to) to = cores.seen(to);
        return std::ranges::any_of(cores.list(), [&](const Core& core) {
            return !core.is_point() &&
                   first_approach(cores, core, paths, {0.003f, only_from_outside}).has_value();
        });
    };
    EXPECT_TRUE(is_kept(0.015f, false));
    EXPECT_FALSE(is_kept(0.015f, true));
    EXPECT_TRUE(is_kept(0.021f, true));
    EXPECT_TRUE(is_kept(0.05f, true));
    EXPECT_FALSE(is_kept(0.15f, true)) << "it is not reached";
}

// What is struck goes as fast as what strikes it, and what comes slower than gravity brings does not bounce.
TEST(WholeTriangles, WhatIsStruckGoesAlong) {
    Crash crash(1);
    crash.positions = crash.starts;
    for (Vec4& v : crash.velocities) v = {};
    const ColliderMotion motion{{Capsule{{-1, 0.05f, 0}, {1, 0.05f, 0}, 0.005f}},
                                {Capsule{{-1, -0.03f, 0}, {1, -0.03f, 0}, 0.005f}}};
    EXPECT_GT(crash.keep_out(motion), 0u);
    const float speed = -0.08f / part;
    for (std::uint32_t i = 0; i < crash.positions.size(); ++i) {
        EXPECT_GT(crash.velocities[i].y, 2 * speed);
        EXPECT_LE(crash.velocities[i].y, crash.positions[i].y < crash.starts[i].y ? -1e-3f : 0.0f);
    }
}

// What slides over it takes it along, as far as it rubs.
TEST(WholeTriangles, FrictionTakesSidesAlong) {
    for (const float friction : {0.0f, 0.2f}) {
        Crash crash(1);
        for (Vec4& x : crash.starts) x.y = 0;
        crash.positions = crash.starts;
        for (Vec4& v : crash.velocities) v = {};
        const ColliderMotion motion{{Capsule{{-1, 0.02f, 0.015f}, {1, 0.02f, 0.015f}, 0.005f}, friction},
                                    {Capsule{{-0.96f, 0, 0.015f}, {1.04f, 0, 0.015f}, 0.005f}, friction}};
        EXPECT_GT(crash.keep_out(motion), 0u);
        float most = 0;
        for (const Vec4& v : crash.velocities) most = std::max(most, std::abs(v.x));
        if (friction == 0)
            EXPECT_LT(most, 1e-3f);
        else
            EXPECT_GT(most, 0.5f * friction * 0.02f / part);
    }
}

}  // namespace
}  // namespace weft::test
