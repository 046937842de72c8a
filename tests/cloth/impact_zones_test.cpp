// Impact zones through the interface that a host has.

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>
#include <optional>
#include <vector>

#include "crossing_count.h"
#include "engine/vector.h"
#include "fixtures.h"

namespace weft::test {
namespace {

ClothSettings by_zones(float restitution = 0) {
    ClothSettings settings;
    settings.self_collision = {
        .enabled = true, .method = SelfCollisionMethod::impact_zones, .restitution = restitution};
    settings.air_damping = 0;
    return settings;
}

/// Two sheets that meet in the air at 1 m/s, one of them tilted. The upper one is held until it goes so fast.
class Clash {
  public:
    explicit Clash(const ClothSettings& upper, const ClothSettings& lower, int threads = 1) {
        WorldSettings settings = vacuum();
        settings.threads = threads;
        world = World::create(settings).value();
        const auto add = [&](float y, float tilt, const ClothSettings& of) {
            const Mesh mesh = make_sheet({.rows = side,
                                          .columns = side,
                                          .origin = {-0.15f, y, -0.15f},
                                          .u = {0.3f, tilt, 0},
                                          .v = {0, 0, 0.3f}})
                                  .value();
            return world->add_cloth(mesh, of).value();
        };
        ids = {add(0.09f, 0.02f, upper), add(0, 0, lower)};
        std::vector<std::uint32_t> all(side * side);
        std::iota(all.begin(), all.end(), 0u);
        EXPECT_TRUE(world->pin(ids[0], all));
        std::vector<Vec3> starts;
        for (const Vec4& p : world->cloth(ids[0]).value().positions) starts.push_back({p.x, p.y, p.z});
        for (int frame = 1; frame <= 3; ++frame) {
            for (std::uint32_t i = 0; i < starts.size(); ++i)
                EXPECT_TRUE(world->move_pin(
                    ids[0], i, {starts[i].x, starts[i].y - h * static_cast<float>(frame), starts[i].z}));
            world->step(h);
        }
        EXPECT_TRUE(world->unpin(ids[0], all));
    }
    [[nodiscard]] Eigen::Vector3d momentum() const {
        Eigen::Vector3d sum = Eigen::Vector3d::Zero();
        for (const ClothId id : ids) {
            const ClothView view = world->cloth(id).value();
            for (std::size_t i = 0; i < view.positions.size(); ++i)
                sum += xyz(view.velocities[i]).cast<double>() / static_cast<double>(view.positions[i].w);
        }
        return sum;
    }
    [[nodiscard]] double rise(std::size_t cloth) const {
        double sum = 0;
        const ClothView view = world->cloth(ids[cloth]).value();
        for (const Vec4& v : view.velocities)
            sum += static_cast<double>(v.y) / static_cast<double>(side * side);
        return sum;
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

    static constexpr std::uint32_t side = 13;
    std::optional<World> world;
    std::array<ClothId, 2> ids;
};

TEST(ImpactZonesInWorld, ClothsThatClashKeepMomentumAndDoNotCross) {
    for (const float restitution : {0.0f, 0.8f}) {
        ClothSettings settings = by_zones(restitution);
        settings.method = Xpbd{.iterations = 10};  // which keeps momentum itself
        settings.substeps = 2;
        Clash clash(settings, settings);
        const Eigen::Vector3d before = clash.momentum();
        const double size = before.norm();
        std::uint32_t met = 0;
        for (int frame = 0; frame < 60; ++frame) {
            clash.world->step(h);
            met = std::max(met, clash.world->report().self_contacts);
            EXPECT_LT((clash.momentum() - before).norm(), 1e-5 * size) << frame;
        }
        EXPECT_GT(met, 50u);
        EXPECT_EQ(clash.crossings(), 0);
        EXPECT_GT(clash.rise(0), clash.rise(1) - 0.02) << "they have not passed through each other";
        if (restitution > 0) {
            EXPECT_GT(clash.rise(0) - clash.rise(1), 0.3) << "they bounce";
        }
    }
}

TEST(ImpactZonesInWorld, TheDefaultMethodAndAnyNumberOfThreads) {
    const auto positions = [](int threads) {
        Clash clash(by_zones(), by_zones(), threads);
        for (int frame = 0; frame < 40; ++frame) clash.world->step(h);
        EXPECT_GT(clash.rise(0), clash.rise(1) - 0.1) << "they have not passed through each other";
        std::vector<Vec4> all;
        for (const ClothId id : clash.ids) {
            const ClothView view = clash.world->cloth(id).value();
            all.insert(all.end(), view.positions.begin(), view.positions.end());
        }
        return all;
    };
    const std::vector<Vec4> one = positions(1);
    for (const int threads : {2, 4}) EXPECT_TRUE(same_bytes(positions(threads), one)) << threads;
}

TEST(ImpactZonesInWorld, WithClothByContactNothingPasses) {
    ClothSettings contact = by_zones();
    contact.self_collision.method = SelfCollisionMethod::contact;
    Clash clash(by_zones(), contact);
    for (int frame = 0; frame < 40; ++frame) {
        clash.world->step(h);
        ASSERT_EQ(clash.crossings_between(), 0) << frame;
    }
}

TEST(ImpactZonesInWorld, CanBeSwitchedToAndFrom) {
    Clash clash(by_zones(), by_zones());
    using enum SelfCollisionMethod;
    for (const SelfCollisionMethod method :
         {contact, impact_zones, avoidance, impact_zones, contact, avoidance}) {
        for (const ClothId id : clash.ids) {
            ClothSettings settings = by_zones();
            settings.self_collision.method = method;
            ASSERT_TRUE(clash.world->set_cloth_settings(id, settings));
            for (int frame = 0; frame < 3; ++frame) clash.world->step(h);
        }
        for (const ClothId id : clash.ids) {
            const ClothView view = clash.world->cloth(id).value();
            for (const Vec4& p : view.positions) ASSERT_TRUE(std::isfinite(p.x + p.y + p.z));
        }
    }
}

}  // namespace
}  // namespace weft::test
