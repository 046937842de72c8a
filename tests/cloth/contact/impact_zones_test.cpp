// Impact zones through the interface that a host has.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>
#include <optional>
#include <string>
#include <vector>

#include "crossing_count.h"
#include "engine/vector.h"
#include "tests/cloth/fixtures.h"

namespace weft::test::impact_zones {
namespace {

using Eigen::Vector3d;

ClothSettings by_zones(float restitution = 0) {
    ClothSettings settings;
    settings.self_collision = {.method = SelfCollisionMethod::impact_zones, .restitution = restitution};
    settings.air_damping = 0;
    return settings;
}

/// By XPBD, which keeps momentum itself.
ClothSettings with_xpbd(ClothSettings settings) {
    settings.method = Xpbd{.iterations = 10};
    settings.substeps = 2;
    return settings;
}

ClothSettings without(ClothSettings settings) {
    settings.self_collision = {};
    return settings;
}

/// Vertices of a cloth, the first so many, or all, that fly at this velocity when the clash begins.
struct Flying {
    Mesh mesh;
    Vec3 velocity{};  // [m/s]
    std::uint32_t count = ~0u;
};

/// Cloths that fly at one another in the void. They are held until they go as fast as they are to.
class Clash {
  public:
    static constexpr int held_frames = 3;

    explicit Clash(const std::vector<Flying>& cloths, const std::vector<ClothSettings>& settings,
                   int threads = 1) {
        WorldSettings of_world = vacuum();
        of_world.threads = threads;
        world = World::create(of_world).value();
        for (std::size_t k = 0; k < cloths.size(); ++k)
            ids.push_back(world->add_cloth(cloths[k].mesh, settings[k % settings.size()]).value());
        for (const ClothId id : ids) EXPECT_TRUE(world->pin(id, vertices_of(id)));
        for (int frame = 1; frame <= held_frames; ++frame) {
            const float time = h * static_cast<float>(frame);
            for (std::size_t k = 0; k < ids.size(); ++k)
                for (const std::uint32_t i : vertices_of(ids[k])) {
                    if (i >= cloths[k].count) break;
                    const Vec3 &start = cloths[k].mesh.positions[i], &v = cloths[k].velocity;
                    EXPECT_TRUE(world->move_pin(
                        ids[k], i, {start.x + time * v.x, start.y + time * v.y, start.z + time * v.z}));
                }
            world->step(h);
        }
        for (const ClothId id : ids) EXPECT_TRUE(world->unpin(id, vertices_of(id)));
    }

    [[nodiscard]] std::vector<std::uint32_t> vertices_of(ClothId id) const {
        std::vector<std::uint32_t> all(world->cloth_info(id).value().vertices);
        std::iota(all.begin(), all.end(), 0u);
        return all;
    }
    [[nodiscard]] Vector3d momentum() const {
        Vector3d sum = Vector3d::Zero();
        for_each_particle([&](double mass, const Vector3d& velocity) { sum += mass * velocity; });
        return sum;
    }
    /// Of what particles have each, whatever way they go.
    [[nodiscard]] double all_momenta() const {
        double sum = 0;
        for_each_particle([&](double mass, const Vector3d& velocity) { sum += mass * velocity.norm(); });
        return sum;
    }
    /// Mean upward velocity.
    [[nodiscard]] double rise(std::size_t cloth) const {
        double sum = 0;
        const ClothView view = world->cloth(ids[cloth]).value();
        for (const Vec4& v : view.velocities) sum += static_cast<double>(v.y);
        return sum / static_cast<double>(view.velocities.size());
    }
    [[nodiscard]] int crossings() const {
        Soup soup;
        for (const ClothId id : ids) soup.add(world->cloth(id).value());
        return soup.crossings();
    }
    [[nodiscard]] int crossings_between() const {
        int count = crossings();
        for (const ClothId id : ids) {
            Soup soup;
            soup.add(world->cloth(id).value());
            count -= soup.crossings();
        }
        return count;
    }
    [[nodiscard]] std::vector<Vec4> positions() const {
        std::vector<Vec4> all;
        for (const ClothId id : ids) {
            const ClothView view = world->cloth(id).value();
            all.insert(all.end(), view.positions.begin(), view.positions.end());
        }
        return all;
    }

    std::optional<World> world;
    std::vector<ClothId> ids;

  private:
    template <class Visit>
    void for_each_particle(const Visit& visit) const {
        for (const ClothId id : ids) {
            const ClothView view = world->cloth(id).value();
            for (std::size_t i = 0; i < view.positions.size(); ++i)
                visit(1 / static_cast<double>(view.positions[i].w), xyz(view.velocities[i]).cast<double>());
        }
    }
};

Mesh level_sheet(float y, float tilt = 0, std::uint32_t side = 13) {
    return make_sheet({.rows = side,
                       .columns = side,
                       .origin = {-0.15f, y, -0.15f},
                       .u = {0.3f, tilt, 0},
                       .v = {0, 0, 0.3f}})
        .value();
}

/// One is tilted, so that they touch along an edge first.
std::vector<Flying> two_sheets() {
    return {{level_sheet(0.09f, 0.02f), {0, -1, 0}}, {level_sheet(0)}};
}
std::vector<Flying> three_sheets() {
    return {{level_sheet(0.12f, 0.02f), {0, -1, 0}}, {level_sheet(0.02f, 0.005f)}, {level_sheet(0)}};
}
/// Three upright ones along the sides of a triangle, each with its end before the face of the next: so few
/// columns wide that each is one cluster, and the clusters collide in a ring.
std::vector<Flying> cycle() {
    constexpr float side = 0.1f, gap = 0.07f;
    std::vector<Flying> cloths;
    Vector3 corner(-0.5f * side, 0, -side / (2 * std::numbers::sqrt3_v<float>));
    for (int k = 0; k < 3; ++k) {
        const float angle = 2 * std::numbers::pi_v<float> * static_cast<float>(k) / 3;
        const Vector3 along(std::cos(angle), 0, std::sin(angle)), inward(-along.z(), 0, along.x());
        const Vector3 outside = 0.1f * (side * along - gap * inward);
        cloths.push_back({make_sheet({.rows = 5,
                                      .columns = 3,
                                      .origin = to_vec3(corner + outside - gap * inward),
                                      .u = to_vec3(side * along),
                                      .v = {0, 0.1f, 0}})
                              .value(),
                          to_vec3(0.8f * inward)});
        corner += side * along;
    }
    return cloths;
}
/// A strip bent round by half a turn, whose upper half comes down on the lower one.
std::vector<Flying> self_fold() {
    constexpr std::uint32_t columns = 7, rows = 31, bent = 7, leaf = (rows - bent) / 2;
    constexpr float edge = 0.0125f, pi = std::numbers::pi_v<float>;
    constexpr float radius = edge * static_cast<float>(bent + 1) / pi;
    Mesh mesh = make_sheet({.rows = rows, .columns = columns}).value();
    mesh.rows = mesh.columns = 0;
    for (std::uint32_t i = 0; i < rows * columns; ++i) {
        const float z = edge * static_cast<float>(i % columns);
        const std::uint32_t row = i / columns;
        const float turn = std::clamp(
            (static_cast<float>(row) - static_cast<float>(leaf) + 1) / static_cast<float>(bent + 1), 0.0f,
            1.0f);
        const float out = row < leaf          ? static_cast<float>(leaf - 1 - row)
                          : row < leaf + bent ? 0.0f
                                              : static_cast<float>(row - leaf - bent);
        mesh.positions[i] = {edge * out - radius * std::sin(pi * turn), radius * std::cos(pi * turn), z};
    }
    return {{mesh, {0, -1, 0}, leaf * columns}};
}

struct Case {
    std::string name;
    std::vector<Flying> cloths;
    bool stays_clean;  ///< others are pressed, and zones promise nothing
};
std::vector<Case> cases() {
    return {{"TwoSheets", two_sheets(), true},
            {"ThreeSheets", three_sheets(), false},
            {"Cycle", cycle(), true},
            {"SelfFold", self_fold(), false}};
}

class ImpactZonesInWorld : public testing::TestWithParam<Case> {};

// Two Worlds go the same way, bit by bit, until in one of them a zone is resolved.
TEST_P(ImpactZonesInWorld, TakeNoMomentum) {
    // Few passes would draw the lower half of the strip along before the upper one has come down.
    const auto solved = [](ClothSettings settings) {
        settings.method = Multilevel{.passes = 12};
        return settings;
    };
    for (const ClothSettings& settings :
         {with_xpbd(by_zones()), with_xpbd(by_zones(0.8f)), solved(by_zones()), solved(by_zones(0.8f))}) {
        Clash zones(GetParam().cloths, {settings}), off(GetParam().cloths, {without(settings)});
        bool met = false;
        for (int frame = 0; frame < 30 && !met; ++frame) {
            zones.world->step(h);
            off.world->step(h);
            met = zones.world->report().self_contacts > 0;
            if (!met) {
                ASSERT_TRUE(same_bytes(zones.positions(), off.positions())) << frame;
            }
        }
        ASSERT_TRUE(met);
        EXPECT_FALSE(same_bytes(zones.positions(), off.positions()));
        EXPECT_LT((zones.momentum() - off.momentum()).norm(), 1e-6 * off.all_momenta());
    }
}

TEST_P(ImpactZonesInWorld, ClothsThatClashKeepMomentum) {
    for (const float restitution : {0.0f, 0.8f}) {
        Clash clash(GetParam().cloths, {with_xpbd(by_zones(restitution))});
        const Vector3d before = clash.momentum();
        const double size = clash.all_momenta();
        std::uint32_t met = 0;
        for (int frame = 0; frame < 40; ++frame) {
            clash.world->step(h);
            met = std::max(met, clash.world->report().self_contacts);
            ASSERT_LT((clash.momentum() - before).norm(), 1e-5 * size) << frame;
            if (GetParam().stays_clean) {
                ASSERT_EQ(clash.crossings(), 0) << frame;
            }
        }
        EXPECT_GT(met, 3u);
    }
}

INSTANTIATE_TEST_SUITE_P(Scenes, ImpactZonesInWorld, testing::ValuesIn(cases()),
                         [](const auto& info) { return info.param.name; });

TEST(ImpactZonesInWorld, RestitutionDecidesHowClothsPart) {
    const auto parting = [](float restitution) {
        Clash clash(two_sheets(), {with_xpbd(by_zones(restitution))});
        for (int frame = 0; frame < 20; ++frame) clash.world->step(h);
        return clash.rise(0) - clash.rise(1);
    };
    const double none = parting(0), some = parting(0.4f), much = parting(0.8f);
    EXPECT_GT(none, -0.02) << "they have not passed through each other";
    EXPECT_GT(some, none + 0.15);
    EXPECT_GT(much, some + 0.15);
    EXPECT_LT(much, 1) << "of the 1 m/s that they came with";
}

TEST(ImpactZonesInWorld, TwoClothsHaveTheGreaterRestitution) {
    const auto end = [](float upper, float lower) {
        Clash clash(two_sheets(), {with_xpbd(by_zones(upper)), with_xpbd(by_zones(lower))});
        for (int frame = 0; frame < 12; ++frame) clash.world->step(h);
        return clash.positions();
    };
    const std::vector<Vec4> both = end(0.9f, 0.9f);
    EXPECT_TRUE(same_bytes(end(0.3f, 0.9f), both));
    EXPECT_TRUE(same_bytes(end(0.9f, 0.3f), both));
    EXPECT_FALSE(same_bytes(end(0.3f, 0.3f), both));
}

TEST(ImpactZonesInWorld, TheDefaultMethodAndAnyNumberOfThreads) {
    const auto positions = [](int threads) {
        Clash clash(two_sheets(), {by_zones()}, threads);
        for (int frame = 0; frame < 40; ++frame) clash.world->step(h);
        EXPECT_GT(clash.rise(0), clash.rise(1) - 0.1) << "they have not passed through each other";
        return clash.positions();
    };
    const std::vector<Vec4> one = positions(1);
    for (const int threads : {2, 4}) EXPECT_TRUE(same_bytes(positions(threads), one)) << threads;
}

TEST(ImpactZonesInWorld, WithClothByContactNothingPasses) {
    ClothSettings contact = by_zones();
    contact.self_collision.method = SelfCollisionMethod::contact;
    Clash clash(two_sheets(), {by_zones(), contact});
    for (int frame = 0; frame < 40; ++frame) {
        clash.world->step(h);
        ASSERT_EQ(clash.crossings_between(), 0) << frame;
    }
}

TEST(ImpactZonesInWorld, WhatIsHitIsNotPushedIntoTheGround) {
    Clash clash(two_sheets(), {by_zones()});
    const float thickness = by_zones().thickness;
    ASSERT_TRUE(
        clash.world->add_collider({.shape = Plane{{0, 1, 0}, -thickness}}));  // the lower one lies on it
    std::uint32_t met = 0, on_ground = 0;
    for (int frame = 0; frame < 30; ++frame) {
        clash.world->step(h);
        met = std::max(met, clash.world->report().self_contacts);
        on_ground = std::max(on_ground, clash.world->report().collider_contacts);
        for (const Vec4& p : clash.positions()) ASSERT_GT(p.y, -1e-5f) << frame;
    }
    EXPECT_GT(met, 50u);
    EXPECT_GT(on_ground, 50u);
}

TEST(ImpactZonesInWorld, CanBeSwitchedToAndFrom) {
    Clash clash(two_sheets(), {by_zones()});
    using enum SelfCollisionMethod;
    for (const SelfCollisionMethod method :
         {contact, impact_zones, avoidance, impact_zones, contact, avoidance}) {
        for (const ClothId id : clash.ids) {
            ClothSettings settings = by_zones();
            settings.self_collision.method = method;
            ASSERT_TRUE(clash.world->set_cloth_settings(id, settings));
            for (int frame = 0; frame < 3; ++frame) clash.world->step(h);
        }
        for (const Vec4& p : clash.positions()) ASSERT_TRUE(std::isfinite(p.x + p.y + p.z));
    }
}

// All particles in one place: more pairs than a list has room for, over and over.
TEST(ImpactZonesInWorld, OfACrowdWhatHasNoRoomIsCountedAndNoStepIsLong) {
    const auto time_of_step = [](bool with_zones) {
        Mesh mesh = level_sheet(0, 0, 25);
        mesh.rows = mesh.columns = 0;
        ClothSettings settings = with_xpbd(by_zones());
        if (!with_zones) settings.self_collision.method = SelfCollisionMethod::contact;
        settings.self_collision.distance = 0.02f;
        World world = World::create(vacuum()).value();
        const ClothId id = world.add_cloth(mesh, settings).value();
        std::vector<std::uint32_t> all(mesh.positions.size());
        std::iota(all.begin(), all.end(), 0u);
        EXPECT_TRUE(world.pin(id, all));
        for (const std::uint32_t i : all) {
            const auto way = [&](std::uint32_t k) { return 1e-4f * static_cast<float>(i * k % 97); };
            EXPECT_TRUE(world.move_pin(id, i, {way(5), way(7), way(11)}));
        }
        world.step(h);
        EXPECT_TRUE(world.unpin(id, all));
        float least = 1e9f;
        std::uint32_t unresolved = 0;
        for (int frame = 0; frame < 4; ++frame) {
            world.step(h);
            least = std::min(least, world.report().milliseconds);
            unresolved = std::max(unresolved, world.report().unresolved_pairs);
        }
        EXPECT_EQ(unresolved > 0, with_zones);
        return least;
    };
    const float zones = time_of_step(true), contact = time_of_step(false);
    EXPECT_LT(zones, 4 * contact) << "ms, and contact searches three times";
}

}  // namespace
}  // namespace weft::test::impact_zones
