// What fills closed cloth, by what it is for: balloons are tight by their pressure, gas and water keep what
// they are, balls that fall and are squeezed keep their volume, and cut ones burst.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <Eigen/Geometry>
#include <numbers>
#include <numeric>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "tests/cloth/fixtures.h"
#include "tests/cloth/material/sewn_strips.h"
#include "tests/cloth/meshes.h"
#include "weft/weft.h"

namespace weft::test::filled {
namespace {

constexpr float radius = 0.1f;

Mesh ball(Vec3 at = {}, float scale = radius) {
    Mesh mesh = sphere(3);
    for (Vec3& x : mesh.positions) x = {at.x + scale * x.x, at.y + scale * x.y, at.z + scale * x.z};
    return mesh;
}

/// Of the same stiffness in all directions, and without Poisson's effect.
ClothSettings filled(const Filling& filling, float stiffness = 4000) {
    ClothSettings settings;
    settings.fabric.warp = settings.fabric.weft = stiffness;
    settings.fabric.shear = 0.5f * stiffness;
    settings.air_damping = 0;
    settings.filling = filling;
    return settings;
}

constexpr Filling water{.kind = FillingKind::volume};

struct Filled {
    Filled(const Mesh& mesh, const ClothSettings& settings, const WorldSettings& of_world = vacuum())
        : world(World::create(of_world).value()), id(world.add_cloth(mesh, settings).value()) {}
    void run(int steps) {
        for (int k = 0; k < steps; ++k) EXPECT_FALSE(has(world.step(h).flags, StepFlags::state_restored));
    }
    [[nodiscard]] FillingInfo info() const { return world.filling_info(id).value(); }
    /// Part of the rest volume that is missing or too much.
    [[nodiscard]] double error() const {
        return static_cast<double>(info().volume) / static_cast<double>(info().rest_volume) - 1;
    }
    template <class Term>
    [[nodiscard]] Eigen::Vector3d sum(const Term& term) const {
        const ClothView view = *world.cloth(id);
        Eigen::Vector3d all = Eigen::Vector3d::Zero();
        for (std::size_t i = 0; i < view.positions.size(); ++i)
            all += term(1 / static_cast<double>(view.positions[i].w),
                        Eigen::Vector3d(xyz(view.positions[i]).cast<double>()),
                        Eigen::Vector3d(xyz(view.velocities[i]).cast<double>()));
        return all;
    }
    [[nodiscard]] Eigen::Vector3d momentum() const {
        return sum([](double m, const auto&, const auto& v) -> Eigen::Vector3d { return m * v; });
    }
    [[nodiscard]] Eigen::Vector3d angular_momentum() const {
        return sum([](double m, const auto& x, const auto& v) -> Eigen::Vector3d { return m * x.cross(v); });
    }
    [[nodiscard]] double kinetic_energy() const {
        return sum([](double m, const auto&, const auto& v) -> Eigen::Vector3d {
                   return Eigen::Vector3d::UnitX() * (0.5 * m * v.squaredNorm());
               })
            .x();
    }
    [[nodiscard]] double mean_radius() const {
        const ClothView view = *world.cloth(id);
        Eigen::Vector3d middle = Eigen::Vector3d::Zero();
        for (const Vec4& x : view.positions) middle += xyz(x).cast<double>();
        const auto count = static_cast<double>(view.positions.size());
        middle /= count;
        double all = 0;
        for (const Vec4& x : view.positions) all += (xyz(x).cast<double>() - middle).norm();
        return all / count;
    }

    World world;
    ClothId id;
};

// Laplace's law: the tension per width is p r / 2, and the fabric strains by that over its stiffness.
TEST(Filling, BalloonsAreAsTightAsTheirPressure) {
    for (const float pressure : {500.0f, 3000.0f}) {
        ClothSettings settings = filled({.kind = FillingKind::pressure, .pressure = pressure});
        settings.air_damping = 5;
        Filled balloon(ball(), settings);
        balloon.run(240);
        const double r = balloon.mean_radius(), at_rest = Filled(ball(), filled({})).mean_radius();
        const double tension = static_cast<double>(pressure) * r / 2;
        EXPECT_NEAR(r / at_rest - 1, tension / 4000, 0.05 * tension / 4000) << pressure;
        EXPECT_EQ(balloon.info().pressure, pressure);
    }
}

TEST(Filling, GasHasOnePressureTimesVolume) {
    const Filling gas{.kind = FillingKind::gas, .pressure = 4000};
    ClothSettings settings = filled(gas);
    settings.air_damping = 5;
    Filled balloon(ball(), settings);
    balloon.run(240);
    const FillingInfo info = balloon.info();
    EXPECT_GT(info.volume, 1.005f * info.rest_volume);
    EXPECT_NEAR((info.pressure + gas.outside) * info.volume, (gas.pressure + gas.outside) * info.rest_volume,
                1e-4f * (gas.pressure + gas.outside) * info.rest_volume);
    const double tension = static_cast<double>(info.pressure) * balloon.mean_radius() / 2;
    const double strain = balloon.mean_radius() / Filled(ball(), filled({})).mean_radius() - 1;
    EXPECT_NEAR(strain, tension / 4000, 0.05 * tension / 4000);
}

class KeptVolume : public testing::TestWithParam<float> {};
INSTANTIATE_TEST_SUITE_P(Stiffnesses, KeptVolume, testing::Values(400.0f, 4000.0f, 1e5f));

TEST_P(KeptVolume, WhileItFallsToTheGround) {
    Filled fallen(ball({0, 0.5f, 0}), filled(water, GetParam()), vacuum(downwards));
    ASSERT_TRUE(fallen.world.add_collider({.shape = Plane{}}));
    for (int k = 0; k < 240; ++k) {
        fallen.run(1);
        EXPECT_NEAR(fallen.error(), 0, 1e-3) << k;
    }
    EXPECT_GT(fallen.world.cloth(fallen.id)->bounds.lower.y, -0.001f);
}

TEST_P(KeptVolume, WhileABoxSqueezesIt) {
    Filled squeezed(ball({0, radius + 0.005f, 0}), filled(water, GetParam()), vacuum(downwards));
    ASSERT_TRUE(squeezed.world.add_collider({.shape = Plane{}}));
    const auto lid = [](float y) {
        return Collider{.shape = Box{.center = {0, y + 0.1f, 0}, .half_extents = {0.5f, 0.1f, 0.5f}}};
    };
    const ColliderId box = squeezed.world.add_collider(lid(0.22f)).value();
    for (int k = 0; k < 120; ++k) {
        ASSERT_TRUE(squeezed.world.move_collider(box, lid(0.22f - 0.0004f * static_cast<float>(k))));
        squeezed.run(1);
        EXPECT_NEAR(squeezed.error(), 0, 1e-3) << k;
    }
}

// A ball that begins as an egg rings, turns and drifts.
TEST(Filling, FreeFlightKeepsMomentumAndGainsNoEnergy) {
    for (const FillingKind kind : {FillingKind::pressure, FillingKind::gas, FillingKind::volume}) {
        Filled flying(ball(), filled({.kind = kind, .pressure = 2000}), vacuum({1, 0, 0.5f}));
        flying.run(60);
        ASSERT_TRUE(flying.world.set_settings(vacuum()));
        flying.run(20);  // the time scheme extrapolates the last acceleration for some steps
        const Eigen::Vector3d p = flying.momentum();
        const double before = flying.kinetic_energy(), scale = p.norm();
        double most = before;
        for (int k = 0; k < 600; ++k) {
            flying.run(1);
            most = std::max(most, flying.kinetic_energy());
        }
        EXPECT_LT((flying.momentum() - p).norm(), 1e-4 * scale) << static_cast<int>(kind);
        EXPECT_LT(most, 1.01 * before) << static_cast<int>(kind);
        if (kind == FillingKind::volume) {
            EXPECT_NEAR(flying.error(), 0, 1e-3);
        }
    }
}

// The volume is given in cubic metres and may change from step to step, as in a cushion that is blown up.
TEST(Filling, FollowsAVolumeThatGrows) {
    Filled cushion(ball(), filled(water, 400));
    const float rest = cushion.info().rest_volume;
    for (int k = 1; k <= 60; ++k) {
        const float wanted = rest * (1 + 0.002f * static_cast<float>(k));
        ASSERT_TRUE(cushion.world.set_cloth_settings(
            cushion.id, filled({.kind = FillingKind::volume, .volume = wanted}, 400)));
        cushion.run(1);
        EXPECT_NEAR(cushion.info().volume, wanted, 1e-3f * rest);
    }
    EXPECT_GT(cushion.info().pressure, 0);
}

TEST(Filling, ActsInEveryMethod) {
    const Method methods[] = {Jacobi{}, Chebyshev{},      ConjugateGradient{}, Xpbd{.iterations = 10},
                              Fibres{}, SymplecticEuler{}};
    for (const Method& method : methods) {
        ClothSettings settings = filled({.kind = FillingKind::pressure, .pressure = 20}, 40);
        settings.method = method;
        settings.substeps = std::holds_alternative<SymplecticEuler>(method) ? 64 : 8;
        settings.air_damping = 5;
        Filled balloon(ball(), settings);
        balloon.run(120);
        const double strain = balloon.mean_radius() / Filled(ball(), filled({})).mean_radius() - 1;
        EXPECT_GT(strain, 0.013) << method.index();  // Xpbd's springs are stiffer on general meshes
        EXPECT_LT(strain, 0.03) << method.index();
    }
}

std::string refusal(const Mesh& mesh, const ClothSettings& settings) {
    World world = World::create(vacuum()).value();
    const auto added = world.add_cloth(mesh, settings);
    const auto cooked = CookedCloth::create(mesh, settings);
    EXPECT_EQ(added.ok(), cooked.ok());
    return added ? "" : added.error().message;
}

TEST(Filling, IsRefusedByNameWhereNothingCanBeFilled) {
    Mesh holed = ball();
    holed.triangles.pop_back();
    EXPECT_NE(refusal(holed, filled(water)).find("3 open edges"), std::string::npos);
    EXPECT_NE(refusal(sheet(5, 5), filled(water)).find("16 open edges"), std::string::npos);
    Mesh inside_out = ball();
    for (Triangle& triangle : inside_out.triangles) std::swap(triangle[1], triangle[2]);
    EXPECT_NE(refusal(inside_out, filled(water)).find("wound inwards"), std::string::npos);
    Mesh flat = ball();
    for (Vec3& x : flat.positions) x.y *= 1e-5f;
    EXPECT_NE(refusal(flat, filled(water)).find("flat"), std::string::npos);
    EXPECT_EQ(refusal(flat, filled({.kind = FillingKind::volume, .volume = 1e-3f})), "");
    EXPECT_EQ(refusal(ball(), filled({})), "");
    EXPECT_EQ(refusal(holed, filled({})), "");

    ClothSettings by_xpbd = filled({.kind = FillingKind::gas});
    by_xpbd.method = Xpbd{};
    EXPECT_NE(refusal(ball(), by_xpbd).find("Multilevel"), std::string::npos);
    const Filling vacuum_within{.kind = FillingKind::gas, .pressure = -5000, .outside = 5000};
    EXPECT_NE(refusal(ball(), filled(vacuum_within)).find("leaves no gas"), std::string::npos);
}

TEST(Filling, ARefusalChangesNothing) {
    Filled open(sheet(5, 5), ClothSettings{});
    EXPECT_FALSE(open.world.set_cloth_settings(open.id, filled(water)));
    EXPECT_EQ(open.world.cloth_settings(open.id)->filling, Filling{});
    EXPECT_EQ(open.info().open_edges, 16u);
    EXPECT_EQ(open.info().volume, 0);
}

TEST(Filling, BurstsWhereItIsCut) {
    const Mesh whole = ball();
    const Filling air{.kind = FillingKind::gas, .pressure = 3000};
    Filled balloon(whole, filled(air));
    balloon.run(30);
    const float tight = balloon.info().volume;
    const Triangle& first = whole.triangles[0];
    const Triangle* next = nullptr;  // beyond the edge from its corner 1 to its corner 2
    for (const Triangle& other : whole.triangles)
        for (std::size_t k = 0; k < 3; ++k)
            if (other[k] == first[2] && other[(k + 1) % 3] == first[1]) next = &other;
    ASSERT_NE(next, nullptr);
    const std::vector<MeshEdge> slit{{first[0], first[1]}, {first[1], first[2]}};
    const MeshCut cut = cut_mesh(whole, slit).value();
    ASSERT_TRUE(balloon.world.recut_cloth(balloon.id, cut.mesh, cut.from));
    EXPECT_EQ(balloon.world.cloth_settings(balloon.id)->filling.kind, FillingKind::none);
    EXPECT_EQ(balloon.info().open_edges, 4u);
    EXPECT_EQ(balloon.info().volume, 0);
    balloon.run(60);
    EXPECT_LT(balloon.mean_radius(), 1.001 * Filled(whole, filled({})).mean_radius());
    EXPECT_GT(tight, 0);
    const auto again = balloon.world.set_cloth_settings(balloon.id, filled(air));
    ASSERT_FALSE(again);
    EXPECT_NE(again.error().message.find("4 open edges"), std::string::npos);
}

TEST(Filling, ACutThatStaysClosedDoesNotBurst) {
    Filled balloon(ball(), filled(water));
    balloon.run(5);
    std::vector<std::uint32_t> same(ball().positions.size());
    for (std::uint32_t v = 0; v < same.size(); ++v) same[v] = v;
    ASSERT_TRUE(balloon.world.recut_cloth(balloon.id, ball(), same));
    balloon.run(5);
    EXPECT_NEAR(balloon.error(), 0, 1e-3);
}

// Settings that come later leave no trace, saves continue by the byte, and threads change nothing.
TEST(Filling, HasNoHistory) {
    const auto hash_of = [](int threads, bool is_late, bool is_restored) {
        WorldSettings of_world = vacuum(downwards);
        of_world.threads = threads;
        const ClothSettings settings = filled({.kind = FillingKind::gas, .pressure = 1000});
        Filled one(ball({0, 0.3f, 0}), is_late ? filled(water, 900) : settings, of_world);
        EXPECT_TRUE(one.world.add_collider({.shape = Plane{}}));
        if (is_late) {
            EXPECT_TRUE(one.world.set_cloth_settings(one.id, settings));
        }
        one.run(20);
        if (is_restored) {
            std::vector<std::byte> saved(one.world.save_size());
            EXPECT_TRUE(one.world.save(saved));
            one.run(7);
            EXPECT_TRUE(one.world.restore(saved));
        }
        one.run(30);
        return one.world.state_hash();
    };
    const std::uint64_t plain = hash_of(1, false, false);
    EXPECT_EQ(hash_of(4, false, false), plain);
    EXPECT_EQ(hash_of(1, true, false), plain);
    EXPECT_EQ(hash_of(1, false, true), plain);
}

TEST(Filling, BallsThatTouchKeepTheirVolumes) {
    World world = World::create(vacuum(downwards)).value();
    ASSERT_TRUE(world.add_collider({.shape = Plane{}}));
    ClothSettings settings = filled(water);
    settings.self_collision.method = SelfCollisionMethod::contact;
    std::vector<ClothId> balls;
    for (const float x : {0.0f, 0.23f, 0.115f})
        balls.push_back(world.add_cloth(ball({x, x == 0.115f ? 0.4f : 0.11f, 0}), settings).value());
    for (int k = 0; k < 120; ++k) {
        world.step(h);
        for (const ClothId id : balls) {
            const FillingInfo info = world.filling_info(id).value();
            EXPECT_NEAR(info.volume, info.rest_volume, 1e-3f * info.rest_volume) << k;
        }
    }
}

// Two balls of water hang from a strip, one below the other, each by four stitches at its top.
TEST(Filling, KeepsItsVolumeWhereItIsSewnToOtherCloth) {
    World world = World::create(vacuum(downwards)).value();
    const ClothId strip = world.add_cloth(sewn::strip(0.2f, -0.5f * sewn::width), sewn::damped()).value();
    EXPECT_TRUE(world.pin(strip, sewn::top));
    ClothSettings settings = filled(water);
    settings.air_damping = 3;
    constexpr float length = 0.02f;
    const Mesh first = ball({0, -0.2f - radius - length, 0}),
               second = ball({0, -0.2f - 3 * radius - 2 * length, 0});
    const ClothId upper = world.add_cloth(first, settings).value(),
                  lower = world.add_cloth(second, settings).value();
    const auto four = [&](bool highest) {
        std::vector<std::uint32_t> vertices(first.positions.size());
        std::iota(vertices.begin(), vertices.end(), 0u);
        std::ranges::stable_sort(vertices, {}, [&](std::uint32_t i) {
            return highest ? -first.positions[i].y : first.positions[i].y;
        });
        vertices.resize(4);
        return vertices;
    };
    const SeamId above =
        world.stitch(strip, std::span(sewn::bottom).subspan(1, 4), upper, four(true), {.rest_length = length})
            .value();
    ASSERT_TRUE(world.stitch(upper, four(false), lower, four(true), {.rest_length = length}));
    for (int k = 0; k < 300; ++k) {
        ASSERT_FALSE(has(world.step(h).flags, StepFlags::state_restored));
        for (const ClothId id : {upper, lower}) {
            const FillingInfo info = world.filling_info(id).value();
            ASSERT_NEAR(info.volume / info.rest_volume, 1, 1e-3f) << k;
        }
    }
    const float weight = 9.81f * (world.cloth_info(upper)->mass + world.cloth_info(lower)->mass);
    EXPECT_NEAR(world.seam_info(above)->force.y, -weight, 0.03f * weight);
}

}  // namespace
}  // namespace weft::test::filled
