// Seams in a World: what they refuse, what happens to their cloths, and that they are saved and recorded.

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <numeric>
#include <string>
#include <vector>

#include "tests/cloth/fixtures.h"
#include "tests/cloth/material/sewn_strips.h"
#include "weft/weft.h"

namespace weft::test::sewn {
namespace {

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
        if (world == &sewn) {
            ASSERT_TRUE(world->unstitch(world->stitch(a, bottom, b, top).value()));
        }
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
        if (sink.write != nullptr) {
            EXPECT_TRUE(world.start_recording(sink));
        }
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
}  // namespace weft::test::sewn
