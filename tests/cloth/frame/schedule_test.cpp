// Many cloths: which run side by side, and that none of it shows in the results.

#include "cloth/simulation/schedule.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <cstring>
#include <limits>
#include <map>
#include <thread>
#include <utility>

#include "engine/platform.h"
#include "tests/cloth/fixtures.h"

namespace weft::test {
namespace {

class Planned {
  public:
    explicit Planned(std::span<const std::uint32_t> sides) {
        for (const std::uint32_t side : sides) {
            cloths_.push_back(std::make_unique<Cloth>(cook(sheet(side, side)).value(), ClothSettings{}));
            present_.push_back(cloths_.back().get());
        }
    }
    const Schedule& on(int threads) {
        schedule_.plan(present_, threads);
        return schedule_;
    }
    const Schedule& on(int threads, std::span<const std::uint32_t> first_of) {
        schedule_.plan(present_, first_of, threads);
        return schedule_;
    }
    [[nodiscard]] const Cloth* cloth(std::size_t i) const { return present_[i]; }

  private:
    std::vector<std::unique_ptr<Cloth>> cloths_;
    std::vector<Cloth*> present_;
    Schedule schedule_;
};

std::vector<std::uint32_t> many_small_and(std::initializer_list<std::uint32_t> others) {
    std::vector<std::uint32_t> sides(100, 20);
    sides.insert(sides.begin() + 50, others);
    return sides;
}

TEST(Schedule, PlansEachClothOnceAndTheLargestFirst) {
    const std::vector<std::uint32_t> sides = many_small_and({128, 40, 30, 3});
    Planned cloths(sides);
    for (const int threads : {1, 2, 16, 64}) {
        const Schedule& schedule = cloths.on(threads);
        std::map<const Cloth*, int> planned;
        for (const auto entries : {schedule.side_by_side(), schedule.in_turn()}) {
            EXPECT_TRUE(std::ranges::is_sorted(entries, std::ranges::greater(), &Schedule::Group::work));
            for (const Schedule::Group& entry : entries) {
                ASSERT_EQ(entry.cloths.size(), 1u);
                ++planned[entry.cloths[0]];
            }
        }
        EXPECT_EQ(planned.size(), sides.size());
        EXPECT_EQ(schedule.side_by_side().size() + schedule.in_turn().size(), sides.size());
    }
}

TEST(Schedule, KeepsALargeClothForAllThreads) {
    Planned mix(many_small_and({128})), alone(std::array{128u});
    for (const int threads : {2, 4, 16}) {
        ASSERT_EQ(mix.on(threads).in_turn().size(), 1u) << threads;
        EXPECT_EQ(mix.on(threads).in_turn()[0].cloths[0]->model.particle_count, 128u * 128u);
        EXPECT_EQ(alone.on(threads).in_turn().size(), 1u);
    }
}

TEST(Schedule, GivesClothsOfFewBlocksToOneThreadEach) {
    Planned few_blocks(std::array{40u, 40u, 40u, 40u, 40u, 40u, 40u, 40u});  // 7 blocks each
    EXPECT_EQ(few_blocks.on(8).side_by_side().size(), 8u) << "no thread waits, and none does two";
    EXPECT_EQ(few_blocks.on(16).in_turn().size(), 8u) << "eight threads would wait";
}

TEST(Schedule, TakesTheClothsOfAGroupTogetherInTheirOrder) {
    Planned cloths(std::array{8u, 8u, 8u, 8u, 64u, 8u, 8u});
    const std::array first_of{0u, 1u, 0u, 3u, 1u, 0u, 6u};
    const Schedule& schedule = cloths.on(4, first_of);
    std::map<std::vector<const Cloth*>, int> groups;
    for (const auto part : {schedule.side_by_side(), schedule.in_turn()})
        for (const Schedule::Group& group : part) ++groups[{group.cloths.begin(), group.cloths.end()}];
    const std::map<std::vector<const Cloth*>, int> expected{
        {{cloths.cloth(0), cloths.cloth(2), cloths.cloth(5)}, 1},
        {{cloths.cloth(1), cloths.cloth(4)}, 1},
        {{cloths.cloth(3)}, 1},
        {{cloths.cloth(6)}, 1}};
    EXPECT_EQ(groups, expected);
    ASSERT_EQ(schedule.in_turn().size(), 1u) << "the large one";
    EXPECT_EQ(schedule.in_turn()[0].work, 64u * 64 + 64) << "a group is as large as its cloths in sum";
}

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

// So what a thread takes lies in the memory of the group that it began with.
TEST(Schedule, GroupsOfOneThreadComeInTheOrderOfTheirScratch) {
    const std::vector<std::uint32_t> sides = many_small_and({128, 40, 30, 3});
    Planned cloths(sides);
    for (const int threads : {1, 2, 16, 64}) {
        std::size_t end = 0, before = std::numeric_limits<std::size_t>::max();
        for (const Schedule::Group& group : cloths.on(threads).side_by_side()) {
            EXPECT_EQ(group.scratch, end);
            EXPECT_LE(group.scratch_bytes, before);
            EXPECT_GT(group.scratch_bytes, 0u);
            before = group.scratch_bytes;
            end += before;
        }
    }
}

}  // namespace
}  // namespace weft::test
