// Cloth where bodies leave it no place: it keeps to one of them, at rest, and comes out clean.

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <span>
#include <string>
#include <vector>

#include "collision/colliders/nearest_surface.h"
#include "engine/vector.h"
#include "tests/cloth/contact/crossing_count.h"
#include "tests/cloth/fixtures.h"
#include "weft/weft.h"

namespace weft::test {
namespace {

constexpr Vec3 gravity_of_earth{0, -9.81f, 0};

/// Two bodies, in the order in which they are added, that come together, stay so for two seconds, and part.
struct Bodies {
    std::vector<std::function<Collider(float)>> at;  ///< 0: apart; 1: together
    int closing = 40, together = 120, parting = 40, after = 60;
};

/// A particle is held while it is inside of one body and no farther out of the other than its thickness.
struct Held {
    std::size_t most = 0;      ///< particles
    double moved = 0;          ///< mean of those 3 mm deep over the last second of rest [m/s]
    float jerked = 0;          ///< the greatest of those [m/s]
    float off_later = 0;       ///< in that time, how far any is off the surface of the body added later [m]
    std::size_t came_out = 0;  ///< particles that in that time no longer were
    float released = 0;        ///< greatest speed of any in the three steps after it no longer was held [m/s]
    float afterwards = 0;      ///< greatest speed of all from when they part on [m/s]
    float greatest = 0;        ///< greatest speed ever within 1 cm of one [m/s]
    float deepest_after = 0;   ///< in any body, from a quarter of a second after they have parted on [m]
    float stretch = 0;         ///< of edges, in the end
    int crossings = 0;         ///< in the end
};

float blend_to(int k, int first, int count) {
    const float t = std::clamp(static_cast<float>(k - first + 1) / static_cast<float>(count), 0.0f, 1.0f);
    return t * t * (3 - 2 * t);
}

float longest_edge(std::span<const Vec4> positions, std::uint32_t side) {
    float longest = 0;
    for (std::uint32_t i = 0; i < side * side; ++i) {
        if (i % side != 0) longest = std::max(longest, (xyz(positions[i]) - xyz(positions[i - 1])).norm());
        if (i >= side) longest = std::max(longest, (xyz(positions[i]) - xyz(positions[i - side])).norm());
    }
    return longest;
}

constexpr std::uint32_t side = 41;
constexpr float width = 0.5f, cell = width / (side - 1);

Held squeeze(World& world, ClothId id, const Bodies& bodies) {
    std::vector<ColliderId> ids;
    for (const auto& at : bodies.at) ids.push_back(world.add_collider(at(0)).value());
    const int parts = bodies.closing + bodies.together, opened = parts + bodies.parting;
    Held held;
    std::vector<Vec4> before;
    std::vector<bool> was_in;
    std::vector<int> free_for;  // steps, of what was held
    double sum = 0;
    int summed = 0;
    for (int k = 0; k < opened + bodies.after; ++k) {
        const float t = k < parts ? blend_to(k, 0, bodies.closing) : 1 - blend_to(k, parts, bodies.parting);
        std::vector<Collider> now;
        for (std::size_t b = 0; b < ids.size(); ++b) {
            now.push_back(bodies.at[b](t));
            EXPECT_TRUE(world.move_collider(ids[b], now.back()));
        }
        world.step(h);
        const ClothView view = world.cloth(id).value();
        was_in.resize(view.positions.size());
        free_for.resize(view.positions.size(), 9);
        std::size_t count = 0;
        for (std::size_t i = 0; i < view.positions.size(); ++i) {
            const Vector3 p = xyz(view.positions[i]);
            const float a = nearest_surface(now[0], p).distance - 0.005f;
            const float b = nearest_surface(now[1], p).distance - 0.005f;
            const bool is_in = std::min(a, b) < -1e-3f && std::max(a, b) < 1e-3f;
            count += is_in ? 1 : 0;
            const float speed = xyz(view.velocities[i]).norm();
            EXPECT_TRUE(std::isfinite(speed));
            if (std::min(a, b) < 0.01f) held.greatest = std::max(held.greatest, speed);
            if (k >= bodies.closing + 60 && k < parts) {
                if (was_in[i] && !is_in) ++held.came_out;
                if (is_in) held.off_later = std::max(held.off_later, std::abs(b));
                if (std::min(a, b) < -3e-3f && was_in[i]) {
                    const float way = (p - xyz(before[i])).norm() / h;
                    held.jerked = std::max(held.jerked, way);
                    sum += static_cast<double>(way);
                    ++summed;
                }
            }
            if (k >= parts) {
                free_for[i] = is_in ? 0 : free_for[i] + 1;
                if (free_for[i] > 0 && free_for[i] <= 3) held.released = std::max(held.released, speed);
                held.afterwards = std::max(held.afterwards, speed);
            }
            was_in[i] = is_in;
            if (k >= opened + 15) held.deepest_after = std::max(held.deepest_after, -std::min(a, b));
        }
        held.most = std::max(held.most, count);
        before.assign(view.positions.begin(), view.positions.end());
    }
    held.moved = summed > 0 ? sum / summed : 1.0;
    held.stretch = longest_edge(before, side) / cell - 1;
    Soup soup;
    soup.add(world.cloth(id).value());
    held.crossings = soup.crossings();
    return held;
}

Mesh sheet_of(const Vec3& origin, const Vec3& v, std::uint32_t rows = side, float u = width) {
    return make_sheet({.rows = rows, .columns = rows, .origin = origin, .u = {u, 0, 0}, .v = v}).value();
}

/// A sheet that hangs between two limbs; these come together at up to .3 m/s, until they overlap.
Held between_limbs(const ClothSettings& settings, float overlap) {
    World world = World::create(vacuum(gravity_of_earth)).value();
    const ClothId id = world.add_cloth(sheet_of({-0.25f, 0.5f, 0}, {0, -width, 0}), settings).value();
    std::vector<std::uint32_t> top;
    for (std::uint32_t v = 0; v < side; ++v) top.push_back(v);
    EXPECT_TRUE(world.pin(id, top));
    constexpr float radius = 0.06f, way = 0.1f;
    const auto limb = [=](float sign) {
        return [=](float t) {
            const float z = sign * (radius + way - t * (way + 0.5f * overlap));
            return Collider{.shape = Capsule{{-0.2f, 0.25f, z}, {0.2f, 0.2f, z}, radius}};
        };
    };
    return squeeze(world, id, {.at = {limb(-1), limb(1)}});
}

TEST(SqueezedCloth, KeepsToTheLaterOfTwoLimbsAndComesOutClean) {
    for (const Method& method : {Method(Multilevel{}), Method(Multilevel{.passes = 3}), Method(Xpbd{})})
        for (const float overlap : {0.01f, 0.04f}) {
            const bool is_xpbd = std::holds_alternative<Xpbd>(method);
            ClothSettings settings;
            settings.method = method;
            if (is_xpbd) settings.substeps = 4;
            settings.air_damping = 5;
            const std::string of = std::to_string(method.index()) + ", " + std::to_string(overlap);
            const Held held = between_limbs(settings, overlap);
            EXPECT_GT(held.most, 50u) << of;
            EXPECT_LT(held.off_later, 1e-3f) << of;
            EXPECT_LT(held.deepest_after, 1e-3f) << of;
            if (is_xpbd) continue;
            EXPECT_LT(held.came_out, 9u) << of;
            EXPECT_LT(held.stretch, 0.02f) << of;
            EXPECT_LT(held.moved, overlap > 0.02f ? 6e-3 : 1.2e-4) << of;
            EXPECT_LT(held.jerked, 0.1f) << of;
            EXPECT_LT(held.released, 0.5f) << of;
            EXPECT_LT(held.greatest, 1.3f) << of;
        }
}

TEST(SqueezedCloth, WithContactNothingCrosses) {
    ClothSettings settings;
    settings.air_damping = 5;
    settings.self_collision = {.method = SelfCollisionMethod::contact};
    const Held held = between_limbs(settings, 0.03f);
    EXPECT_GT(held.most, 50u);
    EXPECT_EQ(held.crossings, 0);
    EXPECT_LT(held.deepest_after, 1e-3f);
    EXPECT_LT(held.greatest, 1.3f);
    EXPECT_LT(held.stretch, 0.02f);
}

/// A ball that goes down on a sheet which lies on the ground, deeper than the ground.
Held under_ball(const ClothSettings& settings, float overlap, float friction = 0.4f,
                bool ball_first = false) {
    World world = World::create(vacuum(gravity_of_earth)).value();
    const ClothId id = world.add_cloth(sheet_of({-0.25f, 0.0051f, -0.25f}, {0, 0, width}), settings).value();
    const auto ground = [=](float) { return Collider{.shape = Plane{}, .friction = friction}; };
    const auto ball = [=](float t) {
        return Collider{.shape = Sphere{{0, 0.2f - t * (0.1f + overlap), 0}, 0.1f}, .friction = friction};
    };
    if (ball_first) return squeeze(world, id, {.at = {ball, ground}});
    return squeeze(world, id, {.at = {ground, ball}});
}

/// Mean of Held::moved over five overlaps that differ by a tenth of a millimetre: each alone is .4 to 1.5
/// mm/s by rounding, without friction.
double mean_motion(const ClothSettings& settings, float overlap, float friction, bool ball_first) {
    double sum = 0;
    for (int k = -2; k <= 2; ++k)
        sum += under_ball(settings, overlap + 1e-4f * static_cast<float>(k), friction, ball_first).moved;
    return sum / 5;
}

TEST(SqueezedCloth, IsAtRestUnderABallThatPressesIntoTheGround) {
    for (const Method& method : {Method(Multilevel{}), Method(Xpbd{})})
        for (const float friction : {0.4f, 0.0f})
            for (const float overlap : {0.005f, 0.03f}) {
                const bool ball_first = (friction > 0) == (overlap > 0.02f);
                ClothSettings settings;
                settings.method = method;
                settings.air_damping = 20;  // so that what lies about the ball is at rest by then
                const std::string of = std::to_string(method.index()) + ", " + std::to_string(friction) +
                                       ", " + std::to_string(overlap) + (ball_first ? ", ball first" : "");
                const Held held = under_ball(settings, overlap, friction, ball_first);
                EXPECT_GT(held.most, 20u) << of;
                EXPECT_LT(held.off_later, 1e-3f) << of;
                EXPECT_LT(held.deepest_after, 1e-3f) << of;
                if (std::holds_alternative<Xpbd>(method)) continue;
                EXPECT_LT(held.came_out, 8u) << of;
                EXPECT_LT(mean_motion(settings, overlap, friction, ball_first),
                          overlap > 0.02f ? 1.1e-3 : 1e-4)
                    << of;
                EXPECT_LT(held.jerked, 0.1f) << of;
                EXPECT_LT(held.released, 0.39f) << "the ball goes up at 0.3 m/s: " << of;
                EXPECT_LT(held.greatest, 1.3f) << of;
                EXPECT_LT(held.stretch, 0.02f) << of;
            }
}

TEST(SqueezedCloth, WithContactABallDoesNotStretchIt) {
    for (const float overlap : {0.005f, 0.03f}) {
        ClothSettings settings;
        settings.air_damping = 20;
        settings.self_collision = {.method = SelfCollisionMethod::contact};
        const Held held = under_ball(settings, overlap);
        EXPECT_LT(held.greatest, 1.3f) << overlap;
        EXPECT_LT(held.moved, overlap > 0.02f ? 1e-3 : 1e-4) << overlap;
        EXPECT_LT(held.stretch, 0.02f) << overlap;
        EXPECT_LT(held.deepest_after, 1e-3f) << overlap;
    }
}

// Folds as narrow as a triangle had no force between their neighbouring features. They tried to pass through
// themselves in every step, stayed stretched by a third, and trembled at .1 m/s.
TEST(SqueezedCloth, CrumpledByACeilingItUnfolds) {
    constexpr std::uint32_t rows = 31;
    constexpr float length = 0.6f, high = 0.75f, low = 0.006f;
    World world = World::create({.threads = 1}).value();
    Mesh mesh = make_sheet({.rows = rows,
                            .columns = rows,
                            .origin = {-0.3f, 0.01f, 0},
                            .u = {length, 0, 0},
                            .v = {0, length, 0}})
                    .value();
    const std::vector<Vec3> flat = mesh.positions;
    for (const Vec3& p : flat) mesh.pattern.push_back({p.x, p.y});
    for (Vec3& p : mesh.positions) p.z = 0.03f * std::sin(12 * p.x) * std::sin(9 * p.y);
    ClothSettings settings;
    settings.self_collision = {.method = SelfCollisionMethod::contact};
    settings.sleep_speed = 0;
    const ClothId id = world.add_cloth(mesh, settings).value();
    ASSERT_TRUE(world.add_collider({.shape = Plane{}}));
    const auto ceiling = [](float y) {
        return Collider{.shape = Box{.center = {0, y + 0.1f, 0}, .half_extents = {0.6f, 0.1f, 0.6f}}};
    };
    const ColliderId box = world.add_collider(ceiling(high)).value();
    for (int k = 1; k <= 240; ++k) {
        const float t = static_cast<float>(k) * h;
        ASSERT_TRUE(world.move_collider(
            box, ceiling(t < 1.5f ? std::max(low, high - t) : std::min(high, low + 0.5f * (t - 1.5f)))));
        world.step(h);
    }
    const ClothView view = world.cloth(id).value();
    float longest = 0;
    for (const Triangle& t : mesh.triangles)
        for (int k = 0; k < 3; ++k) {
            const auto [a, b] = std::pair(t[k], t[(k + 1) % 3]);
            const auto at = [&](std::uint32_t v) { return xyz(view.positions[view.vertex_to_particle[v]]); };
            longest =
                std::max(longest, (at(a) - at(b)).norm() / (to_vector(flat[a]) - to_vector(flat[b])).norm());
        }
    EXPECT_LT(longest, 1.15f);
    EXPECT_LT(rms_speed(view), 0.05);
    EXPECT_EQ(crossings(world, std::array{id}), 0);
}

TEST(SqueezedCloth, IsSavedAndPutBack) {
    World world = World::create(vacuum(gravity_of_earth)).value();
    const Mesh mesh = sheet_of({-0.15f, 0.006f, -0.15f}, {0, 0, 0.3f}, 17, 0.3f);
    ASSERT_TRUE(world.add_cloth(mesh));
    ASSERT_TRUE(world.add_collider({.shape = Plane{}}));
    const ColliderId ball = world.add_collider({.shape = Sphere{{0, 0.2f, 0}, 0.1f}}).value();
    const auto press = [&](int from, int to) {
        for (int k = from; k < to; ++k) {
            const float y = 0.12f - 0.002f * static_cast<float>(std::min(k, 30));
            ASSERT_TRUE(world.move_collider(ball, {.shape = Sphere{{0, y, 0}, 0.1f}}));
            world.step(h);
        }
    };
    press(0, 35);
    std::vector<std::byte> saved(world.save_size());
    ASSERT_TRUE(world.save(saved));
    press(35, 60);
    const std::uint64_t hash = world.state_hash();
    ASSERT_TRUE(world.restore(saved));
    press(35, 60);
    EXPECT_EQ(world.state_hash(), hash);
}

// A corner has a free place within reach: there cloth lies as it would without any of this.
TEST(SqueezedCloth, AWideCornerSqueezesNothing) {
    World world = World::create(vacuum(gravity_of_earth)).value();
    const Mesh mesh = sheet_of({-0.15f, 0.25f, -0.15f}, {0, 0, 0.3f}, 21, 0.3f);
    const ClothId id = world.add_cloth(mesh).value();
    const float s = std::sqrt(0.5f);
    ASSERT_TRUE(world.add_collider({.shape = Plane{{s, s, 0}, 0}}));
    ASSERT_TRUE(world.add_collider({.shape = Plane{{-s, s, 0}, 0}}));
    for (int k = 0; k < 240; ++k) world.step(h);
    const ClothView view = world.cloth(id).value();
    for (const Vec4& p : view.positions) {
        EXPECT_GT(s * (p.y - std::abs(p.x)), 0.004f) << "outside of both";
    }
}

}  // namespace
}  // namespace weft::test
