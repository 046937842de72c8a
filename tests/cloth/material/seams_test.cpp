// Seams, by what they are for: they carry loads, hold what is sewn together, break at their force, and take
// neither momentum nor energy from nothing.

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <numeric>
#include <string>
#include <vector>

#include <Eigen/Geometry>

#include "tests/cloth/fixtures.h"
#include "weft/weft.h"

namespace weft::test {
namespace {

using Vertices = std::vector<std::uint32_t>;
constexpr std::uint32_t columns = 6, rows = 9;
constexpr float length = 0.4f, width = 0.25f;

Vertices row(std::uint32_t number) {
    Vertices vertices(columns);
    std::iota(vertices.begin(), vertices.end(), number * columns);
    return vertices;
}
const Vertices top = row(0), bottom = row(rows - 1);

Mesh strip(float y, float x = 0) {
    return make_sheet({.rows = rows,
                       .columns = columns,
                       .origin = {x, y, 0},
                       .u = {width, 0, 0},
                       .v = {0, -length, 0}})
        .value();
}

ClothSettings of_density(float density) {
    ClothSettings settings;
    settings.fabric.areal_density = density;
    return settings;
}

/// Two strips, the lower one sewn to the upper one's end; the upper one is pinned at its top.
struct Hanging {
    explicit Hanging(const SeamSettings& settings = {}, const ClothSettings& of_a = {},
                     const ClothSettings& of_b = {}, WorldSettings of_world = vacuum(downwards),
                     float gap = 0)
        : world(World::create(of_world).value()),
          a(world.add_cloth(strip(0), of_a).value()),
          b(world.add_cloth(strip(-length - gap), of_b).value()),
          seam(world.stitch(a, bottom, b, top, settings).value()) {
        EXPECT_TRUE(world.pin(a, top));
    }
    void run(int steps) {
        for (int k = 0; k < steps; ++k) world.step(h);
    }
    [[nodiscard]] Vector3 place(ClothId id, std::uint32_t vertex) const {
        const ClothView view = *world.cloth(id);
        return xyz(view.positions[view.vertex_to_particle[vertex]]);
    }
    [[nodiscard]] float gap(std::uint32_t k) const { return (place(a, bottom[k]) - place(b, top[k])).norm(); }
    [[nodiscard]] float widest_gap() const {
        float widest = 0;
        for (std::uint32_t k = 0; k < columns; ++k) widest = std::max(widest, gap(k));
        return widest;
    }
    [[nodiscard]] float weight(ClothId id) const { return 9.81f * world.cloth_info(id)->mass; }

    World world;
    ClothId a, b;
    SeamId seam;
};

/// Strips that are damped enough to hang still after some seconds.
ClothSettings damped(float density = 0.2f) {
    ClothSettings settings = of_density(density);
    settings.air_damping = 3;
    return settings;
}

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

ClothSettings in_contact() {
    ClothSettings settings = damped();
    settings.self_collision.enabled = true;
    return settings;
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

TEST(Seams, RefuseWhatTheyCannotJoin) {
    World world = World::create(vacuum()).value();
    const ClothId a = world.add_cloth(strip(0)).value(), b = world.add_cloth(strip(-length)).value();
    ClothSettings other;
    other.method = Jacobi{};
    const ClothId jacobi = world.add_cloth(strip(-2), other).value();
    other = in_contact();
    other.self_collision.method = SelfCollisionMethod::impact_zones;
    const ClothId zones = world.add_cloth(strip(-4), other).value();
    const std::uint64_t before = world.state_hash();
    const auto refused = [&](ClothId p, Vertices of_p, ClothId q, Vertices of_q, const SeamSettings& settings,
                             const std::string& why) {
        const auto made = world.stitch(p, of_p, q, of_q, settings);
        ASSERT_FALSE(made);
        EXPECT_NE(made.error().message.find(why), std::string::npos) << made.error().message;
    };
    refused(a, {0}, ClothId{}, {0}, {}, "ClothId is null");
    refused(a, {0, 1}, b, {0}, {}, "2 vertices of the first cloth and 1 of the second");
    refused(a, {}, b, {}, {}, "at least one");
    refused(a, {0, 1}, b, {0, rows * columns}, {}, "stitch 1: vertex 54 does not exist");
    refused(a, {0, 7}, a, {1, 7}, {}, "stitch 1: vertices 7 and 7 are the same particle");
    refused(a, {0}, jacobi, {0}, {}, "Jacobi");
    refused(a, {0}, zones, {0}, {}, "impact_zones");
    refused(a, {0}, b, {0}, {.rest_length = -1}, "SeamSettings::rest_length");
    refused(a, {0}, b, {0}, {.break_force = 0}, "SeamSettings::break_force");
    refused(a, {0}, b, {0}, {.break_force = std::nanf("")}, "SeamSettings::break_force");
    refused(a, {0}, b, {0}, {.stiffness = 1e8f}, "SeamSettings::stiffness");
    EXPECT_EQ(world.state_hash(), before);
    EXPECT_FALSE(world.unstitch(SeamId{}));
    EXPECT_FALSE(world.seam_info(SeamId{7, 7}));

    const SeamId seam = world.stitch(a, bottom, b, top).value();
    other = {};
    other.method = ConjugateGradient{};
    const auto changed = world.set_cloth_settings(b, other);
    ASSERT_FALSE(changed);
    EXPECT_NE(changed.error().message.find("ConjugateGradient"), std::string::npos);
    ASSERT_TRUE(world.unstitch(seam));
    EXPECT_FALSE(world.unstitch(seam));
    EXPECT_EQ(world.state_hash(), before);
    EXPECT_TRUE(world.set_cloth_settings(b, other));
}

TEST(Seams, GoWithTheirCloth) {
    Hanging hanging;
    hanging.run(5);
    ASSERT_TRUE(hanging.world.remove_cloth(hanging.a));
    EXPECT_FALSE(hanging.world.seam_info(hanging.seam));
    const float before = hanging.place(hanging.b, 0).y();
    hanging.run(30);
    EXPECT_LT(hanging.place(hanging.b, 0).y(), before - 0.5f);
}

TEST(Seams, LeaveNoTraceOnceTheyAreUnstitched) {
    World sewn = World::create(vacuum(downwards)).value(), plain = World::create(vacuum(downwards)).value();
    for (World* world : {&sewn, &plain}) {
        const ClothId a = world->add_cloth(strip(0)).value();
        const ClothId b = world->add_cloth(strip(-length)).value();
        if (world == &sewn) ASSERT_TRUE(world->unstitch(world->stitch(a, bottom, b, top).value()));
        ASSERT_TRUE(world->pin(a, top));
        for (int k = 0; k < 20; ++k) world->step(h);
    }
    EXPECT_EQ(sewn.state_hash(), plain.state_hash());
}

TEST(Seams, OutlastACut) {
    Hanging hanging({}, damped(), damped());
    hanging.run(60);
    Vertices same(rows * columns);
    std::iota(same.begin(), same.end(), 0u);
    ASSERT_TRUE(hanging.world.recut_cloth(hanging.b, strip(-length), same));
    EXPECT_EQ(hanging.world.seam_info(hanging.seam)->holding, columns);
    // Without its last column: the vertices get other numbers, and a stitch goes.
    Vertices from;
    for (std::uint32_t v = 0; v < rows * columns; ++v)
        if (v % columns + 1 < columns) from.push_back(v);
    const Mesh narrow = make_sheet({.rows = rows,
                                    .columns = columns - 1,
                                    .origin = {0, -length, 0},
                                    .u = {width * (columns - 2) / (columns - 1), 0, 0},
                                    .v = {0, -length, 0}})
                            .value();
    ASSERT_TRUE(hanging.world.recut_cloth(hanging.b, narrow, from));
    EXPECT_EQ(hanging.world.seam_info(hanging.seam)->stitches, columns - 1);
    hanging.run(240);
    for (std::uint32_t k = 0; k + 1 < columns; ++k) EXPECT_LT(hanging.gap(k), 1e-3f);
    const float weight = hanging.weight(hanging.b);
    EXPECT_NEAR(hanging.world.seam_info(hanging.seam)->force.y, -weight, 0.02f * weight);
}

TEST(Seams, MoveWithTheirCloths) {
    Hanging here, there;
    for (Hanging* one : {&here, &there}) one->run(30);
    const Transform by{{3, 1, -2}, {}};
    ASSERT_TRUE(there.world.move_cloth(there.a, by));
    ASSERT_TRUE(there.world.move_cloth(there.b, by));
    ASSERT_TRUE(there.world.shift_origin({3, 1, -2}));
    for (Hanging* one : {&here, &there}) one->run(30);
    EXPECT_LT((here.place(here.b, 53) - there.place(there.b, 53)).norm(), 1e-3f);
}

TEST(Seams, OfClothThatIsSwitchedOffHoldAsPins) {
    Hanging hanging({}, damped(), damped());
    hanging.run(240);
    const Vector3 before = hanging.place(hanging.b, 53);
    ASSERT_TRUE(hanging.world.set_enabled(hanging.a, false));
    hanging.run(120);
    EXPECT_LT((hanging.place(hanging.b, 53) - before).norm(), 1e-3f);
    ASSERT_TRUE(hanging.world.set_enabled(hanging.a, true));
    hanging.run(120);
    EXPECT_LT((hanging.place(hanging.b, 53) - before).norm(), 5e-3f);
}

TEST(Seams, LetJoinedClothsSleepAndWakeTogether) {
    ClothSettings settings = damped();
    settings.sleep_speed = 0.01f;
    Hanging hanging({}, settings, settings);
    const auto sleep = [&] {
        return std::array{hanging.world.is_asleep(hanging.a).value(),
                          hanging.world.is_asleep(hanging.b).value()};
    };
    int steps = 0;
    for (; steps < 1200 && !sleep()[0]; ++steps) {
        hanging.run(1);
        ASSERT_EQ(sleep()[0], sleep()[1]);
    }
    ASSERT_LT(steps, 1200);
    ASSERT_TRUE(hanging.world.move_pin(hanging.a, 0, {0, 0.1f, 0}));
    hanging.run(1);
    EXPECT_EQ(sleep(), (std::array{false, false}));
    while (!sleep()[0]) hanging.run(1);
    ASSERT_TRUE(hanging.world.unstitch(hanging.seam));
    EXPECT_EQ(sleep(), (std::array{false, false}));
}

/// A patchwork of four sheets in gusts, two of them in contact, whose seams tear one after the other.
struct Patchwork {
    explicit Patchwork(int threads = 1, const RecordingSink& sink = {}, int substeps = 1)
        : world(make_world(threads, substeps)) {
        if (sink.write != nullptr) EXPECT_TRUE(world.start_recording(sink));
        for (int k = 0; k < 4; ++k) {
            ClothSettings settings = k < 2 ? in_contact() : ClothSettings{};
            const float x = k % 2 == 0 ? 0.0f : width + apart, y = k < 2 ? 0.0f : -length - apart;
            cloths.push_back(world.add_cloth(strip(y, x), settings).value());
        }
        Vertices left, right;
        for (std::uint32_t r = 0; r < rows; ++r) {
            left.push_back(r * columns);
            right.push_back(r * columns + columns - 1);
        }
        const SeamSettings weak{.rest_length = apart, .break_force = 0.2f};
        EXPECT_TRUE(world.stitch(cloths[0], right, cloths[1], left, weak));
        EXPECT_TRUE(world.stitch(cloths[2], right, cloths[3], left, weak));
        EXPECT_TRUE(
            world.stitch(cloths[0], bottom, cloths[2], top, {.rest_length = apart, .break_force = 0.4f}));
        seam = world.stitch(cloths[3], top, cloths[1], bottom, {.rest_length = apart}).value();
        EXPECT_TRUE(world.pin(cloths[0], top));
        EXPECT_TRUE(world.pin(cloths[1], Vertices{columns - 1}));
    }
    static World make_world(int threads, int substeps) {
        WorldSettings settings;
        settings.wind.velocity = {1, 0, 4};
        settings.wind.gust = 0.5f;
        settings.threads = threads;
        settings.substeps = substeps;
        return World::create(settings).value();
    }
    std::uint32_t run(int steps) {
        std::uint32_t broken = 0;
        for (int k = 0; k < steps; ++k) broken += world.step(h).broken_stitches;
        return broken;
    }
    [[nodiscard]] std::vector<std::byte> saved() const {
        std::vector<std::byte> bytes(world.save_size());
        EXPECT_TRUE(world.save(bytes));
        return bytes;
    }

    static constexpr float apart = 0.015f;  // the distance of contact
    World world;
    std::vector<ClothId> cloths;
    SeamId seam;
};

TEST(Seams, GiveTheSameBytesByAnyNumberOfThreads) {
    for (const int substeps : {1, 3}) {
        Patchwork one(1, {}, substeps);
        EXPECT_GT(one.run(60), 0u);
        for (const int threads : {2, 4}) {
            Patchwork several(threads, {}, substeps);
            several.run(60);
            EXPECT_EQ(several.world.state_hash(), one.world.state_hash()) << threads;
        }
    }
}

TEST(Seams, AreSavedAsTheyAreTorn) {
    Patchwork game;
    game.run(10);
    const std::vector<std::byte> then = game.saved();
    EXPECT_GT(game.run(50), 0u);
    const std::vector<std::byte> expected = game.saved();
    ASSERT_TRUE(game.world.restore(then));
    game.run(50);
    EXPECT_EQ(game.saved(), expected);

    Patchwork later;
    ASSERT_TRUE(later.world.restore(then));
    later.run(50);
    EXPECT_EQ(later.saved(), expected);
    ASSERT_TRUE(later.world.unstitch(later.seam));
    const auto refused = later.world.restore(then);
    ASSERT_FALSE(refused);
    EXPECT_NE(refused.error().message.find("4 seams, this one has 3"), std::string::npos)
        << refused.error().message;
    ASSERT_TRUE(later.world.stitch(later.cloths[3], bottom, later.cloths[1], bottom));
    EXPECT_FALSE(later.world.restore(then));
}

TEST(Seams, AreRecorded) {
    std::vector<std::byte> bytes;
    const RecordingSink sink{[](void* to, std::span<const std::byte> more) {
                                 auto& all = *static_cast<std::vector<std::byte>*>(to);
                                 all.insert(all.end(), more.begin(), more.end());
                                 return true;
                             },
                             &bytes};
    Patchwork game(1, sink);
    game.run(30);
    ASSERT_TRUE(game.world.unstitch(game.seam));
    game.run(10);
    ASSERT_TRUE(game.world.stop_recording());
    const auto replayed = replay(bytes, {.threads = 2});
    ASSERT_TRUE(replayed) << replayed.error().message;
    EXPECT_TRUE(replayed->is_whole);
    EXPECT_EQ(replayed->steps, 40u);
}

TEST(Seams, AreDescribed) {
    const Hanging hanging({.break_force = 12});
    const std::string text = hanging.world.describe().value();
    EXPECT_NE(text.find("seams"), std::string::npos);
    EXPECT_NE(text.find("break_force: 12"), std::string::npos) << text;
}

}  // namespace
}  // namespace weft::test
