// Seams, by what they are for: they carry loads, hold what is sewn together, break at their force, and take
// neither momentum nor energy from nothing.

#include <gtest/gtest.h>

#include <cmath>
#include <Eigen/Geometry>
#include <utility>
#include <vector>

#include "tests/cloth/fixtures.h"
#include "tests/cloth/material/sewn_strips.h"
#include "weft/weft.h"

namespace weft::test::sewn {
namespace {

TEST(Seams, CarryTheWeightThatHangsOnThem) {
    for (const float stiffness : {0.0f, 20.0f, 2000.0f}) {
        Hanging hanging({.stiffness = stiffness}, damped(), damped());
        hanging.run(360);
        const SeamInfo info = hanging.world.seam_info(hanging.seam).value();
        const float weight = hanging.weight(hanging.b);
        EXPECT_NEAR(info.force.y, -weight, 0.01f * weight) << stiffness;
        EXPECT_NEAR(info.force.x, 0, 0.01f * weight);
        EXPECT_EQ(info.holding, columns);
        float gaps = 0;
        for (std::uint32_t k = 0; k < columns; ++k) gaps += hanging.gap(k);
        const float resolved = stiffness > 0 ? stiffness : Fabric{}.warp;
        EXPECT_NEAR(gaps * resolved, weight, 0.02f * weight) << stiffness;
    }
}

TEST(Seams, KeepTheirRestLength) {
    Hanging hanging({.rest_length = 0.03f}, damped(), damped(), vacuum(downwards), 0.03f);
    hanging.run(300);
    for (std::uint32_t k = 0; k < columns; ++k) EXPECT_NEAR(hanging.gap(k), 0.03f, 0.001f);
}

// A seam that gives next to nothing hangs and swings as cloth that was never cut.
TEST(Seams, SwingAsOnePiece) {
    const auto end_of = [](bool is_sewn) {
        World world = World::create(vacuum(downwards)).value();
        std::vector<ClothId> ids;
        const auto add = [&](std::uint32_t of_rows, float from, float to) {
            const Mesh mesh = make_sheet({.rows = of_rows,
                                          .columns = columns,
                                          .origin = {0, 0, from},
                                          .u = {width, 0, 0},
                                          .v = {0, 0, to - from}})
                                  .value();
            ids.push_back(world.add_cloth(mesh).value());
        };
        if (is_sewn) {
            add(rows, 0, length);
            add(rows, length, 2 * length);
            EXPECT_TRUE(world.stitch(ids[0], bottom, ids[1], top));
        } else {
            add(2 * rows - 1, 0, 2 * length);
        }
        EXPECT_TRUE(world.pin(ids[0], top));
        for (int k = 0; k < 30; ++k) world.step(h);
        return xyz(world.cloth(ids.back())->positions.back());
    };
    EXPECT_LT((end_of(true) - end_of(false)).norm(), 0.03f);
}

// Gravity grows until the seam tears: `stitches` between two vertices, of which each bears the same.
TEST(Seams, BreakAtTheirForceAndNotBelow) {
    for (const std::uint32_t stitches : {1u, 3u}) {
        constexpr float most = 0.02f;  // N
        WorldSettings settings = vacuum({0, 0, 0});
        World world = World::create(settings).value();
        const ClothId a = world.add_cloth(strip(0), damped()).value(),
                      b = world.add_cloth(strip(-length), damped()).value();
        ASSERT_TRUE(world.pin(a, top));
        ASSERT_TRUE(world.pin(a, bottom));
        const SeamId seam = world
                                .stitch(a, Vertices(stitches, bottom[2]), b, Vertices(stitches, top[2]),
                                        {.break_force = most})
                                .value();
        const float mass = world.cloth_info(b)->mass;
        float load = 0;
        std::uint32_t broken = 0;
        for (int k = 0; k < 3000 && broken == 0; ++k) {
            settings.gravity.y = -4e-3f * static_cast<float>(k);
            ASSERT_TRUE(world.set_settings(settings));
            broken = world.step(h).broken_stitches;
            load = -settings.gravity.y * mass;
        }
        EXPECT_EQ(broken, stitches);
        EXPECT_NEAR(load, static_cast<float>(stitches) * most, 0.03f * static_cast<float>(stitches) * most);
        EXPECT_EQ(world.seam_info(seam)->holding, 0u);
        EXPECT_EQ(world.step(h).broken_stitches, 0u);
        for (int k = 0; k < 90; ++k) world.step(h);
        EXPECT_LT(world.cloth(b)->positions[0].y, -1.5f * length);  // it falls
    }
}

/// Kinetic energy and that in gravity, of particles that are not pinned [J].
double energy_of(const World& world, std::initializer_list<ClothId> ids) {
    double sum = 0;
    for (const ClothId id : ids) {
        const ClothView view = *world.cloth(id);
        for (std::size_t i = 0; i < view.positions.size(); ++i) {
            if (!(view.positions[i].w > 0)) continue;
            const double m = 1 / static_cast<double>(view.positions[i].w);
            sum += 0.5 * m * xyz(view.velocities[i]).cast<double>().squaredNorm() +
                   9.81 * m * static_cast<double>(view.positions[i].y);
        }
    }
    return sum;
}

TEST(Seams, GainNoEnergy) {
    for (const SeamSettings& settings :
         {SeamSettings{}, SeamSettings{.rest_length = 0.05f, .stiffness = 1e5f}}) {
        ClothSettings undamped;
        undamped.air_damping = undamped.fabric.damping = 0;
        World world = World::create(vacuum(downwards)).value();
        const auto lying = [](float z) {
            return make_sheet({.rows = rows,
                               .columns = columns,
                               .origin = {0, 0, z},
                               .u = {width, 0, 0},
                               .v = {0, 0, length}})
                .value();
        };
        const ClothId a = world.add_cloth(lying(0), undamped).value(),
                      b = world.add_cloth(lying(length + settings.rest_length), undamped).value();
        ASSERT_TRUE(world.stitch(a, bottom, b, top, settings));
        ASSERT_TRUE(world.pin(a, 0));
        const double start = energy_of(world, {a, b});
        for (int k = 0; k < 300; ++k) {
            ASSERT_FALSE(has(world.step(h).flags, StepFlags::state_restored));
            ASSERT_LT(energy_of(world, {a, b}), start + 1e-4) << k;
        }
    }
}

struct Momenta {
    Eigen::Vector3d linear = Eigen::Vector3d::Zero(), angular = Eigen::Vector3d::Zero();
};
Momenta momenta_of(const World& world, std::initializer_list<ClothId> ids) {
    Momenta sum;
    for (const ClothId id : ids) {
        const ClothView view = *world.cloth(id);
        for (std::size_t i = 0; i < view.positions.size(); ++i) {
            const Eigen::Vector3d x = xyz(view.positions[i]).cast<double>(),
                                  v = xyz(view.velocities[i]).cast<double>() /
                                      static_cast<double>(view.positions[i].w);
            sum.linear += v;
            sum.angular += x.cross(v);
        }
    }
    return sum;
}

// Two strips of unlike mass, drawn apart, swung round by one end and let go.
TEST(Seams, KeepMomentum) {
    World world = World::create(vacuum({0, 0, 0})).value();
    ClothSettings light, heavy = of_density(0.6f);
    light.air_damping = heavy.air_damping = 0;
    const ClothId a = world.add_cloth(strip(0), light).value(),
                  b = world.add_cloth(strip(-length - 0.02f, 0.03f), heavy).value();
    ASSERT_TRUE(world.stitch(a, bottom, b, top));
    ASSERT_TRUE(world.pin(a, top));
    const Mesh mesh = strip(0);
    for (int k = 1; k <= 20; ++k) {
        const Eigen::AngleAxisf turn(0.004f * static_cast<float>(k * k), Vector3::UnitZ());
        for (const std::uint32_t v : top)
            ASSERT_TRUE(world.move_pin(a, v, to_vec3(turn * to_vector(mesh.positions[v]))));
        world.step(h);
    }
    ASSERT_TRUE(world.unpin(a, top));
    for (int k = 0; k < 10; ++k) world.step(h);
    const Momenta before = momenta_of(world, {a, b});
    ASSERT_GT(before.linear.norm(), 0.01);
    ASSERT_GT(before.angular.norm(), 0.001);
    for (int k = 0; k < 60; ++k) world.step(h);
    const Momenta after = momenta_of(world, {a, b});
    EXPECT_LT((after.linear - before.linear).norm(), 1e-5 * before.linear.norm());
    EXPECT_LT((after.angular - before.angular).norm(), 1e-4 * before.angular.norm());
}

TEST(Seams, HoldHeavyOnLightAndLightOnHeavy) {
    for (const auto& [above, below] : {std::pair(0.02f, 2.0f), std::pair(2.0f, 0.02f)}) {
        Hanging hanging({}, damped(above), damped(below));
        for (int k = 0; k < 480; ++k) {
            const StepReport& report = hanging.world.step(h);
            ASSERT_FALSE(has(report.flags, StepFlags::state_restored));
            ASSERT_LT(report.peak_speed, 10);
        }
        const float weight = hanging.weight(hanging.b);
        EXPECT_NEAR(hanging.world.seam_info(hanging.seam)->force.y, -weight, 0.02f * weight);
        EXPECT_LT(hanging.world.report().peak_speed, 0.05f);
    }
}

// Contact keeps cloth a thickness apart, so that a seam in contact is as long as that at least.
TEST(Seams, DoNotFightContact) {
    const ClothSettings settings = in_contact();
    Hanging hanging({}, settings, settings, vacuum(downwards), 0.005f);
    const float thickness = 0.3f * hanging.world.cloth_info(hanging.a)->mean_edge;
    for (int k = 0; k < 240; ++k) {
        const StepReport& report = hanging.world.step(h);
        ASSERT_EQ(report.crossings, 0u) << k;
    }
    EXPECT_LT(hanging.world.report().peak_speed, 0.02f);
    EXPECT_EQ(hanging.world.report().truncated_particles, 0u);
    for (std::uint32_t k = 0; k < columns; ++k) EXPECT_NEAR(hanging.gap(k), thickness, 0.05f * thickness);
}

// A bag of two sheets, sewn at three sides, falls onto the ground and folds.
TEST(Seams, FoldWithoutCrossing) {
    WorldSettings of_world = vacuum(downwards);
    World world = World::create(of_world).value();
    const ClothSettings settings = in_contact();
    const auto sheet_at = [](float z) {
        return make_sheet({.rows = rows,
                           .columns = columns,
                           .origin = {0, 0.5f, z},
                           .u = {width, 0, 0},
                           .v = {0, -length, 0}})
            .value();
    };
    const ClothId a = world.add_cloth(sheet_at(0), settings).value(),
                  b = world.add_cloth(sheet_at(0.02f), settings).value();
    Vertices rim = bottom;
    for (std::uint32_t r = 0; r + 1 < rows; ++r)
        rim.insert(rim.end(), {r * columns, r * columns + columns - 1});
    ASSERT_TRUE(world.stitch(a, rim, b, rim));
    ASSERT_TRUE(world.add_collider({.shape = Plane{}, .friction = 0.5f}));
    for (int k = 0; k < 300; ++k) {
        const StepReport& report = world.step(h);
        ASSERT_EQ(report.crossings, 0u) << k;
        ASSERT_LT(report.peak_speed, 6) << k;
    }
    EXPECT_LT(world.report().peak_speed, 0.3f);
}

TEST(Seams, JoinVerticesOfOneCloth) {
    WorldSettings of_world = vacuum(downwards);
    World world = World::create(of_world).value();
    const ClothId id = world.add_cloth(strip(0), damped()).value();
    ASSERT_TRUE(world.stitch(id, top, id, bottom));
    ASSERT_TRUE(world.pin(id, row(rows / 2)));
    for (int k = 0; k < 300; ++k) world.step(h);
    const ClothView view = *world.cloth(id);
    for (std::uint32_t k = 0; k < columns; ++k)
        EXPECT_LT((xyz(view.positions[top[k]]) - xyz(view.positions[bottom[k]])).norm(), 0.002f);
}

}  // namespace
}  // namespace weft::test::sewn
