// Many cloths: which run side by side, and that none of it shows in the results.

#include "cloth/simulation/schedule.h"

#include <gtest/gtest.h>

#include <array>
#include <atomic>
#include <cstring>
#include <thread>
#include <utility>

#include "engine/platform.h"
#include "tests/cloth/fixtures.h"

namespace weft::test {
namespace {

// A cloth is part of two kinds of World: large and small, with contacts, gusts and a moving collider.
struct Filled {
    std::vector<ClothId> cloths;
    ColliderId sphere;
};
Filled fill(World& world, std::span<const std::uint32_t> sides) {
    Filled filled;
    ClothSettings settings;
    settings.self_collision = {.method = SelfCollisionMethod::avoidance};
    for (const std::uint32_t side : sides) {
        settings.substeps = 1 + static_cast<int>(side % 3);
        const ClothId id = world.add_cloth(sheet(side, side), settings).value();
        for (const std::uint32_t corner : {0u, side - 1}) EXPECT_TRUE(world.pin(id, corner).ok());
        filled.cloths.push_back(id);
    }
    filled.sphere = world.add_collider({.shape = Sphere{{0.5f, -0.2f, 0.5f}, 0.2f}}).value();
    return filled;
}

void run(World& world, ColliderId sphere, std::vector<StepReport>& reports) {
    for (int k = 1; k <= 10; ++k) {
        const float z = 0.5f - 0.04f * static_cast<float>(k);
        ASSERT_TRUE(world.move_collider(sphere, {.shape = Sphere{{0.5f, -0.2f, z}, 0.2f}}).ok());
        reports.push_back(world.step(1.0f / 60));
    }
}

WorldSettings on_threads(int threads) {
    WorldSettings settings;
    settings.threads = threads;
    return settings;
}

// Hosts' executors.
#ifndef WEFT_WITHOUT_THREADS
void run_on_fresh_threads(void*, std::uint32_t count, Executor::Body body, void* context) {
    std::atomic<std::uint32_t> next = 0;
    const auto work = [&] {
        for (std::uint32_t block; (block = next++) < count;) body(context, block);
    };
    const std::jthread first(work), second(work);
}
#endif
void run_backwards(void* is_running, std::uint32_t count, Executor::Body body, void* context) {
    bool& running = *static_cast<bool*>(is_running);
    EXPECT_FALSE(std::exchange(running, true)) << "a loop within a loop";
    while (count > 0) body(context, --count);
    running = false;
}

struct Outcome {
    std::uint64_t hash;
    std::vector<StepReport> reports;
};

Outcome outcome(std::span<const std::uint32_t> sides, WorldSettings settings) {
    settings.wind.velocity = {3, 0, 1};
    settings.wind.gust = 0.5f;
    World world = World::create(settings).value();
    const Filled filled = fill(world, sides);
    Outcome outcome;
    run(world, filled.sphere, outcome.reports);
    outcome.hash = world.state_hash();
    return outcome;
}

TEST(ManyCloths, GiveTheSameBytesAndReportsOnAnyThreads) {
    const std::array sides{8u, 20u, 40u, 5u, 20u, 16u};
    const Outcome expected = outcome(sides, on_threads(1));
    std::vector<WorldSettings> others{on_threads(2)};
    bool is_running = false;
    others.emplace_back().executor = {.run = run_backwards, .user = &is_running, .width = 3};
#ifndef WEFT_WITHOUT_THREADS
    others.emplace_back().executor = {.run = run_on_fresh_threads, .width = 2};
#endif
    for (const WorldSettings& settings : others) {
        const Outcome other = outcome(sides, settings);
        EXPECT_EQ(other.hash, expected.hash);
        for (std::size_t k = 0; k < expected.reports.size(); ++k) {
            const StepReport &a = other.reports[k], &b = expected.reports[k];
            EXPECT_EQ(a.cloths, sides.size());
            EXPECT_EQ(a.flags, b.flags);
            EXPECT_EQ(a.particles, b.particles);
            EXPECT_EQ(a.collider_contacts, b.collider_contacts);
            EXPECT_EQ(a.self_contacts, b.self_contacts);
            EXPECT_EQ(a.peak_self_contacts, b.peak_self_contacts);
            EXPECT_EQ(a.peak_speed, b.peak_speed);
            EXPECT_EQ(a.residual, b.residual);
        }
    }
    EXPECT_GT(expected.reports.back().collider_contacts, 0u);
}

TEST(ManyCloths, MoveAsEachDoesAlone) {
    const std::array sides{8u, 33u, 12u};
    World together = World::create(on_threads(2)).value();
    const Filled all = fill(together, sides);
    std::vector<StepReport> reports;
    run(together, all.sphere, reports);
    for (std::uint32_t i = 0; i < sides.size(); ++i) {
        World alone = World::create(on_threads(1)).value();
        const Filled one = fill(alone, std::span(sides).subspan(i, 1));
        run(alone, one.sphere, reports);
        const auto expected = alone.cloth(one.cloths[0])->positions,
                   actual = together.cloth(all.cloths[i])->positions;
        ASSERT_EQ(actual.size(), expected.size());
        EXPECT_EQ(std::memcmp(actual.data(), expected.data(), actual.size_bytes()), 0) << sides[i];
    }
}

}  // namespace
}  // namespace weft::test
