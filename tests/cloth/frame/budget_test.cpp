// A World that may take only so long, by costs that are known: no time is measured.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>
#include <utility>
#include <vector>

#include "cloth/settings/validate.h"
#include "cloth/simulation/simulation.h"
#include "tests/cloth/fixtures.h"
#include "weft/weft.h"

namespace weft::test::budgets {
namespace {

constexpr std::uint32_t side = 9;

Mesh sheet(float x) {
    return make_sheet(
               {.rows = side, .columns = side, .origin = {x, 1, 0}, .u = {0.5f, 0, 0}, .v = {0, 0.01f, 0.5f}})
        .value();
}

/// What each cloth is taken to cost as it is set: 100 us.
std::int64_t known_cost(const Cloth& cloth) {
    if (cloth.state.detail->left + 1 < cloth.state.detail->rate) return 5'000;  // it glides
    constexpr std::int64_t costs[] = {100'000, 60'000, 33'000};
    return costs[cloth.state.detail->rung];
}
/// And by how much that is off, by turns.
std::int64_t noisy_cost(const Cloth& cloth) {
    static std::int64_t turn = 0;
    return known_cost(cloth) * (90 + turn++ * 7 % 21) / 100;
}

struct Hall {
    explicit Hall(float budget, int count = 20, ClothSettings of_cloth = {})
        : simulation({.wind = {.velocity = {0, 0, 2}}, .threads = 1, .budget = budget}) {
        simulation.cost_of = known_cost;
        of_cloth.sleep_speed = 0;
        for (int i = 0; i < count; ++i) {
            auto cloth = std::make_unique<Cloth>(cook(sheet(static_cast<float>(i))).value(), of_cloth);
            cloth->pin(std::vector<std::uint32_t>{0, side - 1});
            simulation.prepare(*cloth);
            cloths.push_back(cloth.get());
            simulation.add(std::move(cloth));
        }
    }
    float step() {
        simulation.step(h);
        float milliseconds = 0;
        for (const Cloth* cloth : cloths)
            milliseconds += 1e-6f * static_cast<float>(simulation.cost_of(*cloth));
        changes += simulation.choices.size();
        return milliseconds;
    }
    void run(int steps) {
        for (int i = 0; i < steps; ++i) {
            simulation.step(h);
            changes += simulation.choices.size();
        }
    }
    [[nodiscard]] std::uint32_t rung(std::size_t i) const { return cloths[i]->state.detail->rung; }

    Simulation simulation;
    std::vector<Cloth*> cloths;
    std::size_t changes = 0;
};

TEST(Budget, IsHeldAndUsed) {
    for (const float budget : {0.4f, 0.8f, 1.2f, 1.8f}) {
        Hall hall(budget);
        hall.run(200);
        std::vector<float> times;
        for (int i = 0; i < 200; ++i) times.push_back(hall.step());
        std::ranges::sort(times);
        EXPECT_LT(times[197], 1.1f * budget + 0.04f) << budget << ", and one cloth";
        EXPECT_GT(times[100], 0.7f * budget) << budget;
    }
}

/// All of a step of 20 cloths off by a fifth to a third, step by step; and what the step took [ms].
float unsteady_step = 0;
std::int64_t unsteady_cost(const Cloth& cloth) {
    static int turn = 0;
    if (turn % 20 == 0) unsteady_step = 0;
    const std::int64_t cost = known_cost(cloth) * (80 + turn++ / 20 * 37 % 53) / 100;
    unsteady_step += 1e-6f * static_cast<float>(cost);
    return cost;
}

TEST(Budget, LeavesRoomForStepsThatTakeLonger) {
    Hall hall(1.2f);
    hall.simulation.cost_of = unsteady_cost;
    hall.run(300);
    std::vector<float> times;
    for (int i = 0; i < 300; ++i) {
        hall.run(1);
        times.push_back(unsteady_step);
    }
    std::ranges::sort(times);
    EXPECT_LT(times[284], 1.03f * 1.2f) << "of twenty steps nineteen";
    EXPECT_GT(times[150], 0.7f * 1.2f);
}

TEST(Budget, WithRoomForAllNothingIsReduced) {
    Hall hall(3), free(0);
    for (int i = 0; i < 60; ++i) {
        hall.run(1);
        free.simulation.step(h);
        EXPECT_EQ(hall.simulation.report.reduced_cloths, 0u);
    }
    for (std::size_t i = 0; i < hall.cloths.size(); ++i) {
        const auto a = hall.cloths[i]->state.positions.span(), b = free.cloths[i]->state.positions.span();
        EXPECT_TRUE(std::ranges::equal(
            a, b, [](const Vec4& p, const Vec4& q) { return p.x == q.x && p.y == q.y && p.z == q.z; }));
    }
    EXPECT_FALSE(free.cloths[0]->budgeted);
    EXPECT_EQ(free.cloths[0]->state.ahead.size(), 0u);
}

TEST(Budget, GoesToWhatCounts) {
    Hall hall(0.8f);
    for (std::size_t i = 0; i < 20; ++i)
        hall.cloths[i]->settings.importance = 1 / (1 + 5 * static_cast<float>(i));
    hall.cloths[3]->settings.importance = 0;
    hall.run(200);
    EXPECT_EQ(hall.rung(0), 0u);
    EXPECT_EQ(hall.rung(3), rung_count - 1);
    for (std::size_t i = 1; i < 20; ++i)
        if (i != 3 && i != 4) {
            EXPECT_GE(hall.rung(i), hall.rung(i - 1)) << i;
        }
    std::swap(hall.cloths[0]->settings.importance, hall.cloths[19]->settings.importance);
    hall.run(120);
    for (std::size_t i = 0; i < 19; ++i) EXPECT_LE(hall.rung(19), hall.rung(i)) << i;
    EXPECT_LE(hall.rung(19), 1u);
    EXPECT_GE(hall.rung(0), 1u) << "it keeps what nobody else needs";
}

// What is learnt of a rung when it is new says nothing of the others.
TEST(Budget, KnowsWhatEachRungCostsHoweverRungsChange) {
    Hall hall(3, 2);
    for (int s = 0; s < 600; ++s) {
        hall.simulation.settings.budget = s / 60 % 2 == 0 ? 3 : 0.15f;
        hall.run(1);
        if (s < 60) continue;
        for (const Cloth* cloth : hall.cloths)
            ASSERT_NEAR(cloth->budgeted->costs.all()[0], 100'000, 1000) << "step " << s;
    }
    EXPECT_GT(hall.changes, 10u);
}

/// The strain that 19 of 20 steps of a flag in gusts of 8 m/s stay below, stepped as a rung does.
float strain_of_flag(const char* fabric, const Method& method, std::uint32_t rate, int substeps = 1) {
    WorldSettings gusty;
    gusty.threads = 1;
    gusty.wind = {.velocity = {8, 0, 0.8f}, .gust = 0.3f};
    World world = World::create(gusty).value();
    constexpr std::uint32_t rows = 13, columns = 19;
    ClothSettings settings{.fabric = Fabric::named(fabric).value(), .method = method, .substeps = substeps};
    const Mesh mesh =
        make_sheet({.rows = rows, .columns = columns, .u = {1.5f, 0, 0}, .v = {0, -1, 0}}).value();
    const ClothId id = world.add_cloth(mesh, settings).value();
    for (std::uint32_t r = 0; r < rows; ++r) EXPECT_TRUE(world.pin(id, r * columns).ok());
    std::vector<float> strains;
    std::vector<StrainedEdge> worst(1);
    for (std::uint32_t step = 0; step < 600; step += rate) {
        world.step(static_cast<float>(rate) * h);
        if (step < 60) continue;
        EXPECT_TRUE(world.strained_edges(id, -1, worst).ok());
        strains.push_back(worst.front().strain);
    }
    const auto place = strains.begin() + static_cast<std::ptrdiff_t>(strains.size() * 19 / 20);
    std::ranges::nth_element(strains, place);
    return *place;
}

TEST(Budget, NoRungStrainsAFlagByHalfMoreThanItsTruth) {
    for (const char* fabric : {"cotton", "tablecloth"}) {
        const float truth = strain_of_flag(fabric, Multilevel{.passes = 6}, 1, 8);
        for (std::uint32_t r = 0; r < rung_count; ++r)
            EXPECT_LT(strain_of_flag(fabric, reduced(Method(), r, rate_of(r)), rate_of(r)), 1.5f * truth)
                << fabric << ", rung " << r;
    }
}

TEST(Budget, ALongStepThatIsPutBackIsReportedAndNotGoneThrough) {
    Hall hall(0.001f, 3);
    hall.run(30);
    Cloth& cloth = *hall.cloths[1];
    while (cloth.state.detail->left > 0) hall.run(1);
    const auto positions = std::as_const(cloth.state.positions).span();
    const std::vector<Vec4> before(positions.begin(), positions.end());
    cloth.solver_failed = true;
    hall.run(1);
    EXPECT_EQ(hall.simulation.report.restored_cloths, 1u);
    EXPECT_TRUE(has(hall.simulation.report_of(cloth).flags, StepFlags::state_restored));
    EXPECT_EQ(hall.simulation.report_of(cloth).rate, 1u);
    EXPECT_EQ(cloth.state.detail->left, 0u);
    EXPECT_TRUE(std::ranges::equal(before, cloth.state.positions.span(),
                                   [](const Vec4& a, const Vec4& b) { return xyz(a) == xyz(b); }));
    hall.run(1);
    EXPECT_EQ(hall.simulation.report.restored_cloths, 0u);
}

TEST(Budget, ChangesNothingWhereNothingChanges) {
    for (const float budget : {0.5f, 0.77f, 1.0f, 1.43f}) {
        Hall hall(budget);
        hall.simulation.cost_of = noisy_cost;
        hall.run(200);
        hall.changes = 0;
        hall.run(600);
        EXPECT_LE(hall.changes, 4u) << budget;
    }
}

/// How fast particles are seen to go, step by step: the farthest from the step before [m/s].
float most_jump(Hall& hall, int steps) {
    float most = 0;
    std::vector<Vector3> ways(std::size_t{side} * side * hall.cloths.size());
    bool known = false;
    for (int s = 0; s < steps; ++s) {
        hall.step();
        std::size_t k = 0;
        for (const Cloth* cloth : hall.cloths)
            for (std::uint32_t i = 0; i < cloth->state.size(); ++i, ++k) {
                const Vector3 way =
                    (xyz(cloth->state.positions[i]) - xyz(cloth->state.previous_positions[i])) / h;
                if (known) most = std::max(most, (way - ways[k]).norm());
                ways[k] = way;
            }
        known = true;
    }
    return most;
}

// On the last rung each second step begins another straight way.
TEST(Budget, ChangesOfRungsAreNotSeen) {
    Hall full(3, 6), last(0.001f, 6), changing(0.001f, 6);
    for (Hall* hall : {&full, &last, &changing}) hall->run(20);
    const float usual = std::max(most_jump(full, 240), most_jump(last, 240));
    float most = 0;
    for (int i = 0; i < 12; ++i) {
        changing.simulation.settings.budget = i % 2 == 0 ? 3 : 0.001f;
        most = std::max(most, most_jump(changing, 20));
    }
    EXPECT_GT(changing.changes, 20u);
    EXPECT_LT(most, 2.5f * usual);  // from the last rung to the first at once: six times
}

// Positions follow from the last ones without a gap, whatever happens.
TEST(Budget, EachStepBeginsWhereTheLastOneEnded) {
    Hall hall(0.4f, 8);
    hall.run(30);
    const auto positions = [&](std::size_t c) {
        const auto span = hall.cloths[c]->state.positions.span();
        return std::vector<Vec4>(span.begin(), span.end());
    };
    for (int s = 0; s < 60; ++s) {
        hall.simulation.settings.budget = s % 9 < 4 ? 0.4f : 0.05f;
        if (s == 33) hall.cloths[2]->pin(40);
        if (s == 34) hall.cloths[2]->find_pin(40)->target.y() += 0.01f;
        if (s == 41) hall.cloths[2]->unpin(40);
        std::vector<std::vector<Vec4>> before;
        for (std::size_t c = 0; c < 8; ++c) before.push_back(positions(c));
        hall.step();
        for (std::size_t c = 0; c < 8; ++c) {
            const auto& previous = hall.cloths[c]->state.previous_positions;
            for (std::size_t i = 0; i < before[c].size(); ++i) ASSERT_EQ(previous[i].y, before[c][i].y) << s;
        }
    }
}

TEST(Budget, LongStepsAreEvenAndSpread) {
    Hall hall(0.001f, 16);
    hall.run(40);
    for (int s = 0; s < 12; ++s) {
        hall.step();
        const auto long_steps = std::ranges::count_if(
            hall.cloths, [](const Cloth* cloth) { return cloth->state.detail->left == 1; });
        EXPECT_EQ(long_steps, 8);
        for (const Cloth* cloth : hall.cloths) {
            EXPECT_EQ(cloth->state.detail->rate, 2u);
            EXPECT_EQ(hall.simulation.report_of(*cloth).rate, 2u);
            EXPECT_EQ(hall.simulation.report_of(*cloth).rung, 2u);
        }
    }
    EXPECT_EQ(hall.simulation.report.reduced_cloths, 16u);
}

TEST(Budget, WhatMovesOrHasContactTakesNoLongSteps) {
    ClothSettings meets;
    meets.self_collision = {.method = SelfCollisionMethod::contact};
    Hall contact(0.001f, 3, meets);
    contact.run(30);
    for (const Cloth* cloth : contact.cloths) {
        EXPECT_EQ(cloth->state.detail->rung, last_of_rate_1);
        EXPECT_EQ(cloth->state.detail->rate, 1u);
    }
    Hall moved(0.001f, 3);
    moved.run(30);
    for (int s = 0; s < 8; ++s) {
        const Vector3 target = moved.cloths[1]->find_pin(0)->target + Vector3(0, 0.01f, 0);
        moved.cloths[1]->find_pin(0)->target = target;
        moved.step();
        EXPECT_EQ(moved.cloths[1]->state.detail->rate, 1u);
        EXPECT_EQ(moved.cloths[1]->state.positions[0].y, target.y()) << "a pin waits for nothing";
        EXPECT_EQ(moved.cloths[0]->state.detail->rate, 2u);
    }
}

// Cloth that moves in every step once fell to the rung of long steps, which it cannot take, and nothing told
// what it cost there.
TEST(Budget, IsUsedByWhatMovesInEveryStep) {
    constexpr float tight = 0.001f, budget = 1.6f;
    Hall hall(tight);
    for (int step = 0; step < 300; ++step) {
        if (step == 60) hall.simulation.settings.budget = budget;
        for (Cloth* cloth : hall.cloths)
            cloth->find_pin(0)->target = Vector3(xyz(cloth->model.positions[0])) +
                                         Vector3(0, 0.1f * std::sin(0.1f * static_cast<float>(step + 1)), 0);
        const float took = hall.step();
        for (const Cloth* cloth : hall.cloths) EXPECT_LE(cloth->state.detail->rung, last_of_rate_1) << step;
        if (step < 260) continue;
        EXPECT_LT(took, budget);
        EXPECT_GT(took, 0.75f * budget);
    }
}

// A step of its own would come too late where the cloth is to follow at once.
TEST(Budget, WhatIsWornTakesNoLongSteps) {
    Hall hall(0.001f, 3);
    hall.run(30);
    AlignedBuffer<float> leash(side * side);
    std::ranges::fill(leash.span(), 0.1f);
    hall.cloths[0]->set_map(Map::leash, std::move(leash));
    hall.cloths[1]->state.frame.emplace();
    hall.run(30);
    EXPECT_EQ(hall.cloths[0]->state.detail->rate, 1u);
    EXPECT_EQ(hall.cloths[1]->state.detail->rate, 1u);
    EXPECT_EQ(hall.cloths[2]->state.detail->rate, 2u);
}

// A budget changes one rung at a time, since others see what it leaves unsolved, and not to and fro.
TEST(Budget, RungsAreKeptForAWhile) {
    Hall hall(0.4f, 8);
    std::vector<std::uint32_t> rungs(8, 0);
    std::vector<int> since(8, -100);
    int falls = 0, rises = 0;
    for (int s = 0; s < 300; ++s) {
        hall.simulation.settings.budget = s % 60 < 30 ? 0.05f : 1.8f;
        hall.step();
        for (std::size_t c = 0; c < 8; ++c) {
            const std::uint32_t rung = hall.rung(c);
            if (rung == rungs[c]) continue;
            const bool falls_now = rung > rungs[c];
            (falls_now ? falls : rises) += 1;
            EXPECT_EQ(std::max(rung, rungs[c]) - std::min(rung, rungs[c]), 1u);
            EXPECT_GE(s - since[c], falls_now ? 4 : 10) << "step " << s;
            rungs[c] = rung;
            since[c] = s;
        }
    }
    EXPECT_GT(falls, 30);
    EXPECT_GT(rises, 15);
}

TEST(Budget, RefusesWhatIsNoTimeAndNoPriority) {
    const auto refuses = [](const auto& answer, const std::string& name) {
        ASSERT_FALSE(answer);
        EXPECT_NE(answer.error().message.find(name), std::string::npos) << answer.error().message;
    };
    const float nan = std::numeric_limits<float>::quiet_NaN();
    for (const float budget : {-1.0f, nan, 1e4f})
        refuses(World::create({.budget = budget}), "WorldSettings::budget");
    World world = World::create({.threads = 1, .budget = 1}).value();
    const ClothId cloth = world.add_cloth(sheet(0)).value();
    ASSERT_TRUE(world.set_importance(cloth, 2));
    for (const float bad : {-1.0f, nan, 1e7f}) {
        refuses(world.set_importance(cloth, bad), "ClothSettings::importance");
        refuses(world.set_cloth_settings(cloth, {.importance = bad}), "ClothSettings::importance");
    }
    EXPECT_EQ(world.cloth_settings(cloth)->importance, 2);
    refuses(world.set_importance({}, 1), "ClothId");
}

/// A World of its own whose budget is tight: rungs change with what time it is.
struct Game {
    explicit Game(float budget) : world(World::create({.threads = 1, .budget = budget}).value()) {}
    void add() {
        for (int i = 0; i < 6; ++i) {
            cloths.push_back(world.add_cloth(sheet(static_cast<float>(i))).value());
            EXPECT_TRUE(world.pin(cloths.back(), 0));
        }
    }
    void run(int steps) {
        for (int s = 0; s < steps; ++s) {
            for (std::size_t i = 0; i < cloths.size(); ++i)
                EXPECT_TRUE(world.set_importance(
                    cloths[i], 1 / (1 + static_cast<float>((i + static_cast<std::size_t>(s) / 10) % 6))));
            if (s % 40 == 20) budget(1e-4f);
            if (s % 40 == 39) budget(100);
            if (s % 16 == 9) {
                const float up = 1 + 0.01f * static_cast<float>(s % 3);
                EXPECT_TRUE(world.move_pin(cloths[3], 0, {3, up, 0}));
            }
            world.step(h);
        }
    }
    void budget(float milliseconds) {
        WorldSettings settings = world.settings();
        settings.budget = milliseconds;
        EXPECT_TRUE(world.set_settings(settings));
    }
    World world;
    std::vector<ClothId> cloths;
};

TEST(Budget, AReplayMakesTheSameChoices) {
    std::vector<std::byte> recorded;
    Game game(0.3f);
    ASSERT_TRUE(game.world.start_recording({[](void* to, std::span<const std::byte> more) {
                                                auto& all = *static_cast<std::vector<std::byte>*>(to);
                                                all.insert(all.end(), more.begin(), more.end());
                                                return true;
                                            },
                                            &recorded}));
    game.add();
    game.run(130);
    ASSERT_TRUE(game.world.stop_recording());
    for (const int threads : {1, 3}) {
        const auto replayed = replay(recorded, {.threads = threads});
        ASSERT_TRUE(replayed) << replayed.error().message;
        EXPECT_FALSE(replayed->difference) << "step " << replayed->difference->step;
        EXPECT_EQ(replayed->steps, 130u);
    }
}

TEST(Budget, ALongStepThatASaveGoesOnWithWasNotPutBack) {
    const WorldSettings usual{.wind = {.air_density = 0}, .threads = 1, .budget = 1e-4f};
    WorldSettings wild = usual;
    wild.gravity = {0, -1e4f, 0};
    wild.max_speed = 1e4f;
    for (int steps = 30; steps < 34; ++steps) {
        World world = World::create(usual).value();
        const ClothId cloth = world.add_cloth(sheet(0)).value();
        for (int i = 0; i < steps; ++i) world.step(h);
        ASSERT_EQ(world.cloth_report(cloth)->rung, 2u);
        std::vector<std::byte> saved(world.save_size());
        ASSERT_TRUE(world.save(saved));
        ASSERT_TRUE(world.set_settings(wild));
        for (int i = 0; i < 60 && world.report().restored_cloths == 0; ++i) world.step(1);
        ASSERT_EQ(world.report().restored_cloths, 1u);
        ASSERT_TRUE(world.set_settings(usual));
        ASSERT_TRUE(world.restore(saved));
        world.step(h);
        EXPECT_EQ(world.report().restored_cloths, 0u) << steps;
    }
}

// With a budget that nothing fits and none rises from, no choice depends on time.
TEST(Budget, GoesOnFromASaveAmidALongStep) {
    for (const int steps : {14, 30, 31, 32}) {
        Game game(1e-4f), other(1e-4f);
        game.add();
        other.add();
        const auto run = [](Game& g, int n) {
            for (int i = 0; i < n; ++i) g.world.step(h);
        };
        run(game, steps);
        std::vector<std::byte> saved(game.world.save_size());
        ASSERT_TRUE(game.world.save(saved));
        run(game, 7);
        ASSERT_TRUE(other.world.restore(saved));
        run(other, 7);
        EXPECT_EQ(game.world.state_hash(), other.world.state_hash()) << steps;
        EXPECT_EQ(game.world.cloth_report(game.cloths[0])->rate, 2u);
        ASSERT_TRUE(game.world.restore(saved));
        run(game, 7);
        EXPECT_EQ(game.world.state_hash(), other.world.state_hash()) << steps;
    }
    Game without(0), with(1);
    without.add();
    with.add();
    std::vector<std::byte> saved(without.world.save_size());
    ASSERT_TRUE(without.world.save(saved));
    const auto answer = with.world.restore(saved);
    ASSERT_FALSE(answer);
    EXPECT_NE(answer.error().message.find("WorldSettings::budget"), std::string::npos);
}

TEST(Budget, SwitchedOffLeavesNoTrace) {
    Game game(1e-4f), free(0);
    game.add();
    free.add();
    for (int i = 0; i < 13; ++i) game.world.step(h);
    game.budget(0);
    std::vector<std::byte> saved(game.world.save_size());
    ASSERT_TRUE(game.world.save(saved));
    ASSERT_TRUE(free.world.restore(saved));
    for (int i = 0; i < 5; ++i) {
        game.world.step(h);
        free.world.step(h);
    }
    EXPECT_EQ(game.world.state_hash(), free.world.state_hash());
    EXPECT_EQ(game.world.cloth_report(game.cloths[0])->rung, 0u);
    EXPECT_EQ(game.world.cloth_info(game.cloths[0])->bytes, free.world.cloth_info(free.cloths[0])->bytes);
}

}  // namespace
}  // namespace weft::test::budgets
