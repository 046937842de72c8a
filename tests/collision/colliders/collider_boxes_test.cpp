// Boxes of colliders and planes beside cores pass over what is far off, and nothing else.

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <random>

#include "collision/colliders/collider_kernels.h"
#include "collision/shapes/moving_shapes.h"
#include "collision/thin/collide.h"
#include "collision/thin/first_approach.h"
#include "collision/thin/yielding.h"
#include "tests/collision/particle_cloud.h"

namespace weft::test {
namespace {

Vec3 operator+(const Vec3& a, const Vec3& b) {
    return {a.x + b.x, a.y + b.y, a.z + b.z};
}

class Random {
  public:
    explicit Random(std::uint32_t seed) : random_(seed) {}
    float uniform(float from, float to) { return std::uniform_real_distribution<float>(from, to)(random_); }
    Vec3 point(float size) { return {uniform(-size, size), uniform(-size, size), uniform(-size, size)}; }

    /// A shape, and where it is a substep later.
    ColliderMotion motion(int kind) {
        const Vec3 a = point(2), b = a + point(0.4f), way = point(0.3f);
        const float first = uniform(0.01f, 0.3f), last = uniform(0.01f, 0.3f);
        const Rotation turn{uniform(-1, 1), uniform(-1, 1), uniform(-1, 1), 1.5f};
        const auto both = [&](const auto& start, const auto& end) {
            ColliderMotion motion{{start, 0.3f}, {end, 0.3f}};
            motion.start.thickness = motion.end.thickness = uniform(0, 0.05f);
            return motion;
        };
        if (kind == 0) return both(Sphere{a, first}, Sphere{a + way, last});
        if (kind == 1) return both(Capsule{a, b, first}, Capsule{a + way, b + point(0.2f), last});
        if (kind == 2)
            return both(TaperedCapsule{a, b, first, last}, TaperedCapsule{a + way, b + way, last, first});
        if (kind == 3)
            return both(Box{.center = a, .half_extents = {first, last, 0.1f}},
                        Box{.center = a + way, .rotation = turn, .half_extents = {first, last, 0.2f}});
        return both(Plane{{0, 1, 0}, -1.9f}, Plane{{0, 1, 0}, -1.9f});
    }

  private:
    std::mt19937 random_;
};

template <class T>
bool have_same_bytes(const std::vector<T>& a, const std::vector<T>& b) {
    return a.size() == b.size() && std::memcmp(a.data(), b.data(), a.size() * sizeof(T)) == 0;
}

/// Blocks of particles, each somewhere.
struct Blocks {
    Particles particles;
    std::vector<Vec4> starts;

    explicit Blocks(Random& random) {
        for (int block = 0; block < 12; ++block) {
            const Vec3 middle = random.point(2);
            for (std::uint32_t k = 0; k < block_size; ++k) {
                const Vec3 from = middle + random.point(0.2f), way = random.point(0.05f);
                starts.push_back({from.x, from.y, from.z, 1});
                particles.positions.push_back({from.x + way.x, from.y + way.y, from.z + way.z, 1});
                particles.velocities.push_back({way.x / h, way.y / h, way.z / h, 0});
            }
        }
    }
};

TEST(ColliderBoxes, WhatIsPassedOverWouldMeetNothing) {
    Random random(3);
    std::size_t passed_over = 0, met = 0;
    std::vector<ColliderMotion> plain;
    for (int k = 0; k < 60; ++k) plain.push_back(random.motion(k % 5));
    std::vector<ColliderMotion> boxed = plain;
    for (ColliderMotion& motion : boxed) motion.filled = filled_by(motion);
    const Blocks blocks(random);
    const std::size_t n = blocks.starts.size();
    const EvenSide even(n, 0.02f, 1);
    const ClothSide side = even;
    Parallel parallel(1);
    std::vector<std::uint32_t> partials(block_count(static_cast<std::uint32_t>(n)));

    const auto collided = [&](const std::vector<ColliderMotion>& colliders, std::uint32_t& count) {
        Particles moved = blocks.particles;
        count =
            collide(parallel, colliders, side, h,
                    {.positions = moved.positions, .velocities = moved.velocities, .starts = blocks.starts},
                    partials);
        return moved;
    };
    std::uint32_t without = 0, with = 0;
    const Particles a = collided(plain, without), b = collided(boxed, with);
    EXPECT_EQ(without, with);
    EXPECT_GT(with, 500u);
    EXPECT_TRUE(have_same_bytes(a.positions, b.positions) && have_same_bytes(a.velocities, b.velocities));

    for (std::size_t begin = 0; begin < n; begin += block_size) {
        const auto of_block = [&](const std::vector<Vec4>& all) {
            return std::span(all).subspan(begin, block_size);
        };
        const ClothSide own = side.part(static_cast<std::uint32_t>(begin), block_size);
        const std::span<const Vec4> starts = of_block(blocks.starts);
        const std::span<const Vec4> velocities = of_block(blocks.particles.velocities);
        NearSurfaces by_all, by_near;
        const auto find = [&](const std::vector<ColliderMotion>& colliders, NearSurfaces& near) {
            return find_near_surfaces(colliders, own, h, 4e-3f, starts, starts, h, velocities, near);
        };
        ASSERT_EQ(find(plain, by_all), find(boxed, by_near));
        if (find(plain, by_all)) {
            EXPECT_EQ(0, std::memcmp(&by_all.surfaces, &by_near.surfaces, sizeof by_all.surfaces));
            ++met;
        }
        const BlockPaths paths = paths_of(starts, of_block(blocks.particles.positions));
        for (const ColliderMotion& motion : boxed) {
            if (may_be_near(motion, 0.02f, paths)) continue;
            ++passed_over;
            EXPECT_FALSE(with_shapes(motion, [&](const auto& start, const auto& end) {
                return may_meet(start, end, {h, motion.fastest}, {0.02f + motion.end.thickness, 0}, paths)
                    .has_value();
            }));
        }
    }
    EXPECT_GT(met, 4u);
    EXPECT_GT(passed_over, 6u * boxed.size());
    for (const float length : {h, 8 * h}) {
        const auto parts = [&](std::span<const ColliderMotion> colliders) {
            return parts_to_meet(parallel, colliders, side, length, 8, blocks.starts,
                                 blocks.particles.velocities, partials);
        };
        std::uint32_t most = 1;
        for (const ColliderMotion& motion : plain) most = std::max(most, parts({&motion, 1}));
        EXPECT_GT(most, 1u);
        EXPECT_EQ(parts(plain), most);
        EXPECT_EQ(parts(boxed), most);
    }
}

/// Least distance of an edge's way from a core's balls, as far as samples tell.
float least_clear(const Core& core, const CornerPaths& paths) {
    float least = inf;
    for (int step = 0; step <= 200; ++step) {
        const float t = static_cast<float>(step) / 200;
        const Vector3 a = (1 - t) * paths.from[0] + t * paths.to[0],
                      b = (1 - t) * paths.from[1] + t * paths.to[1];
        for (int k = 0; k <= 40; ++k)
            for (int m = 0; m <= 40; ++m) {
                const float s = static_cast<float>(k) / 40, w = static_cast<float>(m) / 40;
                least = std::min(least, ((1 - w) * a + w * b - core.at(s)).norm() - core.radius_at(s));
            }
    }
    return least;
}

TEST(FirstApproach, MissesNoEdgeThatComesIntoTheGap) {
    constexpr float gap = 0.01f;
    Random random(8);
    int near = 0, far = 0;
    for (int trial = 0; trial < 400; ++trial) {
        const Vec3 b = random.point(0.2f);
        const ColliderMotion motion = at_rest(
            {TaperedCapsule{{}, b, random.uniform(0.02f, 0.06f), random.uniform(0.02f, 0.06f)}, 0.3f});
        const Cores cores(motion, h, true);
        const Core& core = cores.list().front();
        CornerPaths paths;
        for (std::size_t k = 0; k < 2; ++k) {
            paths.from[k] = to_vector(random.point(0.15f));
            paths.to[k] = paths.from[k] + to_vector(random.point(0.1f));
        }
        paths.from[2] = paths.from[0];
        paths.to[2] = paths.to[0];
        CornerPaths still = paths;
        still.to = still.from;
        if (least_clear(core, still) < 2 * gap) continue;
        const float clear = least_clear(core, paths);
        const auto approach = first_approach(cores, core, paths, {gap, true});
        if (clear < 0.5f * gap) {
            EXPECT_TRUE(approach.has_value()) << trial << ": " << clear;
            ++near;
        }
        if (clear > 1.1f * gap) {
            EXPECT_FALSE(approach.has_value()) << trial << ": " << clear;
            ++far;
        }
    }
    EXPECT_GT(near, 20);
    EXPECT_GT(far, 40);
}

TEST(FirstApproach, NoCornerGoesMuchFartherThanWhatIsPushed) {
    Random random(4);
    for (int trial = 0; trial < 1000; ++trial) {
        std::array<float, 3> weights{random.uniform(0, 1), random.uniform(0, 1), random.uniform(0, 1)};
        if (trial % 2 == 0) weights[2] = 0;
        const float sum = weights[0] + weights[1] + weights[2];
        std::array<float, 3> masses{};
        for (std::size_t k = 0; k < 3; ++k) {
            weights[k] /= sum;
            masses[k] = trial % 3 == 0 ? 1.0f : std::exp(random.uniform(-9, 9));
        }
        if (trial % 5 == 0) masses[static_cast<std::size_t>(trial) % 2] = 0;  // it is pinned
        const float yields = yielding(weights, [&](std::size_t k) { return masses[k]; });
        float point = 0;
        for (std::size_t k = 0; k < 3; ++k) {
            const float share = weights[k] * masses[k] / yields;
            EXPECT_LT(share, 2.1f);
            point += weights[k] * share;
        }
        EXPECT_LT(point, 1 + 1e-5f);
        if (trial % 3 == 0 && trial % 5 != 0) {
            EXPECT_NEAR(point, 1, 1e-5f);
        }
    }
}

}  // namespace
}  // namespace weft::test
