// A host with the library alone: its own threads, several Worlds, settings by name.

#include <gtest/gtest.h>
#include <weft/weft.h>

#include <limits>
#include <string>

#ifndef __wasi__
#include "naive_pool.h"
#endif

namespace weft::test {
namespace {

Mesh sheet(std::uint32_t side) {
    return make_sheet({.rows = side, .columns = side, .origin = {0, 1, 0}}).value();
}

// A large cloth, for all threads at once, and small ones, for one thread each; a sphere below, and gusts.
World busy_world(const WorldSettings& settings) {
    World world = World::create(settings).value();
    for (const std::uint32_t side : {48u, 12u, 10u, 8u}) {
        const ClothId id = world.add_cloth(sheet(side)).value();
        EXPECT_TRUE(world.pin(id, 0).ok());
    }
    EXPECT_TRUE(world.add_collider({.shape = Sphere{.center = {0, 0.8f, 0}, .radius = 0.15f}}).ok());
    return world;
}

std::uint64_t hash_after(World world, int steps) {
    for (int step = 0; step < steps; ++step) {
        const StepReport& report = world.step(1.0f / 60);
        EXPECT_EQ(report.cloths, 4u);
    }
    return world.state_hash();
}

constexpr Wind gusty{.velocity = {2, 0, 3}, .gust = 0.4f};

TEST(HostThreads, TakenOneAfterTheOtherGiveTheSameBytes) {
    constexpr int steps = 5;
    const std::uint64_t expected = hash_after(busy_world({.wind = gusty, .threads = 1}), steps);
    const Executor forwards{.run =
                                [](void*, std::uint32_t count, Executor::Body body, void* context) {
                                    for (std::uint32_t i = 0; i < count; ++i) body(context, i);
                                },
                            .width = 4};
    const Executor backwards{.run =
                                 [](void*, std::uint32_t count, Executor::Body body, void* context) {
                                     for (std::uint32_t i = count; i-- > 0;) body(context, i);
                                 },
                             .width = 4};
    EXPECT_EQ(hash_after(busy_world({.wind = gusty, .executor = forwards}), steps), expected);
    EXPECT_EQ(hash_after(busy_world({.wind = gusty, .executor = backwards}), steps), expected);
}

#ifndef __wasi__  // which has one thread
TEST(HostThreads, OfANaivePoolGiveTheBytesOfOneThread) {
    constexpr int steps = 20;
    const std::uint64_t expected = hash_after(busy_world({.wind = gusty, .threads = 1}), steps);
    for (const int threads : {1, 2, 3, 8}) {
        NaivePool pool(threads);
        World world = busy_world({.wind = gusty, .executor = pool.executor(threads < 2 ? 2 : threads)});
        EXPECT_EQ(pool.calls(), 0) << "outside of steps";
        EXPECT_EQ(hash_after(std::move(world), steps), expected) << threads;
        EXPECT_EQ(pool.calls(), steps) << "once a step";
    }
}

TEST(HostThreads, MayBeChangedBetweenSteps) {
    constexpr int rounds = 3;
    NaivePool pool(2), other(3);
    const WorldSettings own{.wind = gusty, .threads = 1};
    World expected = busy_world(own), world = busy_world(own);
    for (int round = 0; round < rounds; ++round) {
        for (const WorldSettings& settings :
             {WorldSettings{.wind = gusty, .executor = pool.executor(2)},
              WorldSettings{.wind = gusty, .threads = 2},
              WorldSettings{.wind = gusty, .executor = other.executor(3)}, own}) {
            ASSERT_TRUE(world.set_settings(settings).ok());
            world.step(1.0f / 60);
            expected.step(1.0f / 60);
            ASSERT_EQ(world.state_hash(), expected.state_hash());
        }
    }
    EXPECT_EQ(pool.calls(), rounds);
    EXPECT_EQ(other.calls(), rounds);
}

TEST(Threads, OfAnyNumberAreStartedAndEndedInSilence) {
    testing::internal::CaptureStderr();
    World world = busy_world({.threads = 1});
    for (int repeat = 0; repeat < 5; ++repeat) {
        for (const int threads : {2, 3, 8, 256, 1}) {
            ASSERT_TRUE(world.set_settings({.threads = threads}).ok());
            world.step(1.0f / 60);
        }
    }
    EXPECT_EQ(testing::internal::GetCapturedStderr(), "");
}
#endif

template <class Value>
void expect_stale(const Result<Value>& result, const std::string& type) {
    ASSERT_FALSE(result.ok());
    EXPECT_EQ(result.error().code, ErrorCode::stale_id);
    EXPECT_EQ(result.error().message.find(type), 0u) << result.error().message;
    EXPECT_NE(result.error().message.find("another World"), std::string::npos) << result.error().message;
}

TEST(Ids, OfAnotherWorldAreRefusedByEveryCall) {
    World first = World::create().value(), second = World::create().value();
    const Collider ball{.shape = Sphere{.center = {0, 0, 0}}};
    for (int repeat = 0; repeat < 4; ++repeat) {
        const ClothId own = first.add_cloth(sheet(4)).value(), other = second.add_cloth(sheet(4)).value();
        const ColliderId own_ball = first.add_collider(ball).value(),
                         other_ball = second.add_collider(ball).value();
        ASSERT_TRUE(first.pin(own, 0).ok());
        const std::uint64_t before = first.state_hash();
        expect_stale(first.remove_cloth(other), "ClothId");
        expect_stale(first.cloth_settings(other), "ClothId");
        expect_stale(first.set_cloth_settings(other, {}), "ClothId");
        expect_stale(first.cloth_info(other), "ClothId");
        expect_stale(first.cloth(other), "ClothId");
        expect_stale(first.pin(other, 1), "ClothId");
        expect_stale(first.move_pin(other, 0, {1, 1, 1}), "ClothId");
        expect_stale(first.unpin(other, 0), "ClothId");
        expect_stale(first.move_collider(other_ball, ball), "ColliderId");
        expect_stale(first.remove_collider(other_ball), "ColliderId");
        expect_stale(first.collider(other_ball), "ColliderId");
        EXPECT_EQ(first.state_hash(), before);
        EXPECT_TRUE(first.cloth(own).ok());
        EXPECT_TRUE(first.collider(own_ball).ok());
        if (repeat % 2 == 0) {  // the next ones take the same slot
            EXPECT_TRUE(first.remove_cloth(own).ok() && second.remove_cloth(other).ok());
            EXPECT_TRUE(first.remove_collider(own_ball).ok());
        }
    }
}

TEST(Ids, StayTheWorldsOwnWhenItIsMoved) {
    World first = World::create().value();
    const ClothId id = first.add_cloth(sheet(4)).value();
    World second = std::move(first);
    EXPECT_TRUE(second.cloth(id).ok());
    first = World::create().value();
    expect_stale(first.cloth(id), "ClothId");
}

TEST(Trace, OfMoreEventsThanItsLimitIsRefused) {
    World world = World::create().value();
    constexpr std::size_t most = std::numeric_limits<std::size_t>::max();
    for (const std::size_t max_events : {std::size_t{0}, most / 2 + 1, most}) {
        const Result<void> started = world.start_trace(max_events);
        ASSERT_FALSE(started.ok()) << max_events;
        EXPECT_EQ(started.error().code, ErrorCode::invalid_argument);
        EXPECT_NE(started.error().message.find(std::to_string(max_events)), std::string::npos);
    }
    EXPECT_TRUE(world.start_trace(10).ok());
}

// g++ -Wextra warns of fields that are left out, unless they have an initialiser: this file is compiled with
// warnings as errors.
TEST(Settings, MayBeNamedOneByOne) {
    EXPECT_EQ((WorldSettings{.threads = 2}).threads, 2);
    EXPECT_EQ((WorldSettings{.substeps = 2}).wind.gust_length, Wind{}.gust_length);
    EXPECT_EQ((Wind{.gust = 0.3f}).velocity.x, 0.0f);
    EXPECT_EQ((ClothSettings{.thickness = 0.01f}).substeps, 1);
    EXPECT_EQ((Executor{.width = 2}).run, nullptr);
    EXPECT_EQ((Sphere{.radius = 2}).center.x, 0.0f);
    EXPECT_EQ((Capsule{.radius = 2}).a.x, 0.0f);
    EXPECT_EQ((Collider{.friction = 0.1f}).shape.index(), 0u);
    EXPECT_EQ((Mesh{.rows = 2, .columns = 2}).positions.size(), 0u);
    EXPECT_EQ((SheetSettings{.rows = 2}).columns, 64u);
    EXPECT_TRUE((FiniteElements{.enabled = true}).enabled);
    EXPECT_EQ((FixedStepSettings{.max_steps_per_frame = 2}).step, 1.0 / 60.0);
}

}  // namespace
}  // namespace weft::test
