// Boxes and tapered capsules that move and turn, and particles that fly: nothing passes.

#include <gtest/gtest.h>

#include <algorithm>
#include <random>

#include <Eigen/Geometry>

#include "tests/collision/colliders/collider_reference.h"
#include "tests/collision/colliders/swept_way.h"
#include "tests/collision/particle_cloud.h"

namespace weft::test {
namespace {

struct Slab {
    Vector3 half;
    [[nodiscard]] Collider at(const Placed& place) const {
        const Eigen::Quaternionf& q = place.turn;
        return {Box{to_vec3(place.origin), {q.x(), q.y(), q.z(), q.w()}, to_vec3(half)}, 0.3f};
    }
    [[nodiscard]] float thin() const { return 0.5f * (half.minCoeff() + thickness); }
    static constexpr bool knows_spin = true;
};

struct Limb {
    float half_length, radius_a, radius_b;
    [[nodiscard]] Collider at(const Placed& place) const {
        return {TaperedCapsule{to_vec3(place({-half_length, 0, 0})), to_vec3(place({half_length, 0, 0})),
                               radius_a, radius_b},
                0.3f};
    }
    [[nodiscard]] float thin() const { return 0.5f * (std::min(radius_a, radius_b) + thickness); }
    static constexpr bool knows_spin = false;  // about its own axis, from its ends
};

/// Of a point in its own space from the surface.
template <class Body>
float distance(const Body& body, const Vector3& p) {
    const Collider still = body.at({});
    return std::visit(
        [&]<class Shape>(const Shape& shape) { return reference_surface(shape, shape, h, p).distance; },
        still.shape);
}

template <class Body>
float nearest_to_body(const Body& body, const Vector3& from, const Vector3& to) {
    float least = inf;
    for (int k = 0; k <= 40; ++k)
        least = std::min(least, distance(body, from + static_cast<float>(k) / 40.0f * (to - from)));
    return least;
}

/// Particles that start outside of a body that moves by up to 0.4 m and turns by up to a radian.
template <class Body>
void expect_nothing_passes(const Body& body, std::uint32_t seed, std::size_t& passed, std::size_t& missed) {
    std::mt19937 random(seed);
    std::uniform_real_distribution<float> uniform(-1, 1);
    const auto vector = [&](float size) -> Vector3 {
        return size * Vector3(uniform(random), uniform(random), uniform(random));
    };
    Placed start{Eigen::Quaternionf(Eigen::AngleAxisf(3 * uniform(random), vector(1).normalized())),
                 vector(0.2f)};
    const Vector3 axis =
        Body::knows_spin ? Vector3(vector(1).normalized())
                         : Vector3(start.turn * Vector3(0, uniform(random), uniform(random)).normalized());
    const Placed end{Eigen::Quaternionf(Eigen::AngleAxisf(uniform(random), axis)) * start.turn,
                     start.origin + vector(0.4f)};
    std::vector<Vec4> starts;
    Particles particles;
    while (starts.size() < 100) {
        const Vector3 from = vector(0.6f), to = from + vector(0.3f);
        if (distance(body, start.back(from)) <= thickness) continue;
        starts.push_back(to_vec4(from, 1));
        particles.positions.push_back(to_vec4(to, 1));
        particles.velocities.push_back(to_vec4(Vector3((to - from) / h), 0));
    }
    const Particles before = particles;
    meet_on_the_way(particles, starts, {body.at(start), body.at(end)});
    for (std::size_t i = 0; i < starts.size(); ++i) {
        const Vector3 from = start.back(xyz(starts[i])), to = end.back(xyz(before.positions[i]));
        if ((to - from).norm() < 1.01f * body.thin()) continue;
        const float would = nearest_to_body(body, from, to);
        const float is = nearest_to_body(body, from, end.back(xyz(particles.positions[i])));
        EXPECT_GT(is, thickness - 0.06f * body.thin()) << seed << ' ' << i;
        if (would > thickness + 0.06f * body.thin()) {
            EXPECT_EQ(xyz(before.positions[i]), xyz(particles.positions[i])) << seed << ' ' << i;
            ++missed;
        } else if (would < 0 && distance(body, to) > thickness) {
            ++passed;
        }
    }
}

TEST(SweptShapes, NothingPassesABoxThatMovesAndTurns) {
    std::size_t passed = 0, missed = 0;
    for (std::uint32_t seed = 0; seed < 12; ++seed) {
        const float size = 0.1f + 0.02f * static_cast<float>(seed);
        expect_nothing_passes(Slab{{0.02f, size, 0.3f}}, seed, passed, missed);
    }
    EXPECT_GT(passed, 30u);
    EXPECT_GT(missed, 400u);
}

TEST(SweptShapes, NothingPassesATaperedCapsuleThatMovesAndTurns) {
    std::size_t passed = 0, missed = 0;
    for (std::uint32_t seed = 0; seed < 9; ++seed)
        expect_nothing_passes(Limb{0.3f, 0.02f, 0.02f + 0.01f * static_cast<float>(seed)}, seed, passed,
                              missed);
    EXPECT_GT(passed, 5u);  // the standard library draws, and each its own numbers
    EXPECT_GT(missed, 300u);
}

// A door of 2 cm that is swung by half a turn a step's hundredth: at its tip 0.5 m in a substep.
TEST(SweptShapes, ATurningBoxCarriesWhatItPassedAtTheSpeedOfThatPoint) {
    const Slab door{{0.5f, 0.4f, 0.01f}};
    const float angle = 0.5f;
    const Placed end{Eigen::Quaternionf(Eigen::AngleAxisf(-angle, Vector3::UnitY())), Vector3::Zero()};
    Particles particles{{{0.4f, 0, 0.1f, 1}, {0.4f, 0, 0.1f, 0}, {0.4f, 0.5f, 0.1f, 1}},
                        std::vector<Vec4>(3)};
    const std::vector<Vec4> starts = particles.positions;
    EXPECT_EQ(meet_on_the_way(particles, starts, {door.at({}), door.at(end)}), 1u);
    const Vector3 seen = end.back(xyz(particles.positions[0]));
    EXPECT_NEAR(seen.z(), 0.01f + thickness, 1e-4f);
    const Vector3 way = end(seen) - seen;
    EXPECT_NEAR(xyz(particles.velocities[0]).norm(), way.dot(end.turn * Vector3::UnitZ()) / h,
                0.02f * way.norm() / h);
    EXPECT_EQ(xyz(particles.positions[1]), xyz(starts[1]));  // pinned
    EXPECT_EQ(xyz(particles.positions[2]), xyz(starts[2]));  // above it
}

TEST(SweptShapes, ABoxThatGrowsMeetsWhatItPasses) {
    Particles particles{{{0.05f, 0.3f, 0, 1}}, {{}}};
    const std::vector<Vec4> starts = particles.positions;
    meet_on_the_way(particles, starts, {Slab{{0.1f, 0.1f, 0.1f}}.at({}), Slab{{0.1f, 0.5f, 0.1f}}.at({})});
    EXPECT_NEAR(particles.positions[0].y, 0.5f + thickness, 1e-5f);
    EXPECT_NEAR(particles.velocities[0].y, 0.4f / h, 1e-2f);
}

TEST(SweptShapes, OneThatJumpsSweepsNothing) {
    const Slab slab{{0.1f, 0.1f, 0.005f}};
    expect_jumps_sweep_nothing({slab.at({}), slab.at({Eigen::Quaternionf::Identity(), {0, 0, 0.5f}})});
}

}  // namespace
}  // namespace weft::test
