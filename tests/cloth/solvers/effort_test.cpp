// Effort where it is needed: the line search, the passes that are added, their bound, and what is reported.

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <optional>
#include <string>

#include "cloth/solvers/multigrid/effort.h"
#include "tests/cloth/fixtures.h"
#include "tests/cloth/meshes.h"

namespace weft::test {
namespace {

/// Threads that hardly stretch in a cloth that shears easily: the ends of the demo's sliders.
ClothSettings stiff_threads(const Multilevel& method) {
    ClothSettings settings;
    settings.fabric.warp = settings.fabric.weft = 1e5f;
    settings.fabric.shear = 100;
    settings.method = method;
    return settings;
}

/// A square sheet hung by two corners.
struct Hung {
    Hung(std::uint32_t side, const ClothSettings& settings, int threads = 1) : side(side) {
        WorldSettings world_settings = vacuum(downwards);
        world_settings.threads = threads;
        world = World::create(world_settings).value();
        id = world->add_cloth(sheet(side, side), settings).value();
        EXPECT_TRUE(world->pin(id, 0).ok() && world->pin(id, side - 1).ok());
    }
    /// Of the threads: worst length over rest length.
    [[nodiscard]] float stretch() const {
        const ClothView cloth = world->cloth(id).value();
        const float length = 1 / static_cast<float>(side - 1);
        float worst = 0;
        for (std::uint32_t i = 0; i < side * side; ++i) {
            const auto to = [&](std::uint32_t j) {
                worst = std::max(worst, (xyz(cloth.positions[j]) - xyz(cloth.positions[i])).norm() / length);
            };
            if (i % side + 1 < side) to(i + 1);
            if (i / side + 1 < side) to(i + side);
        }
        return worst;
    }

    std::uint32_t side;
    std::optional<World> world;
    ClothId id;
};

TEST(Effort, HoldsThreadsThatAreAThousandTimesStifferThanShear) {
    for (const std::uint32_t side : {17u, 33u}) {
        Hung hung(side, stiff_threads({}));
        float worst = 0;
        for (int k = 0; k < 150; ++k) {
            hung.world->step(h);
            worst = std::max(worst, hung.stretch());
        }
        EXPECT_LT(worst, 1.12f) << side;  // 1.001 where each step is solved to the end
    }
}

TEST(Effort, ManyPassesDoNotTearIt) {
    for (const int passes : {6, 12}) {
        Hung hung(17, stiff_threads({.passes = passes, .iterations = 2}));
        float worst = 0;
        for (int k = 0; k < 90; ++k) {
            hung.world->step(h);
            worst = std::max(worst, hung.stretch());
        }
        EXPECT_LT(worst, 1.25f) << passes;
    }
}

TEST(Effort, ChangesNothingWhereTheEquationIsEasy) {
    const auto settings = [](float effort) {
        return ClothSettings{.method = Multilevel{.passes = 3, .effort = effort},
                             .time_scheme = TimeScheme::backward_euler};
    };
    Hung usual(24, settings(1.5f)), none(24, settings(1));
    for (int k = 0; k < 120; ++k) {
        usual.world->step(h);
        none.world->step(h);
        ASSERT_EQ(usual.world->report().flags, StepFlags::none) << k;
    }
    EXPECT_EQ(usual.world->state_hash(), none.world->state_hash());
}

TEST(Effort, GivesTheSameBytesForAnyNumberOfThreads) {
    const auto hash = [](int threads) {
        Hung hung(48, stiff_threads({}), threads);
        for (int k = 0; k < 20; ++k) hung.world->step(h);
        return hung.world->state_hash();
    };
    const std::uint64_t serial = hash(1);
    for (const int threads : {2, 3, 8}) EXPECT_EQ(hash(threads), serial) << threads;
    Hung without(48, stiff_threads({.effort = 1}));
    for (int k = 0; k < 20; ++k) without.world->step(h);
    EXPECT_NE(without.world->state_hash(), serial) << "the scene is hard enough to be a test";
}

TEST(Effort, SaysWhatIsLeftUnsolved) {
    const auto flags = [](const Multilevel& method) {
        Hung hung(17, stiff_threads(method));
        StepFlags all = StepFlags::none;
        for (int k = 0; k < 40; ++k) all = all | hung.world->step(h).flags;
        return all;
    };
    EXPECT_TRUE(has(flags({.effort = 1, .tolerance = 1e-3f}), StepFlags::unsolved));
    EXPECT_FALSE(has(flags({.effort = 1, .tolerance = 1e6f}), StepFlags::unsolved));
    EXPECT_FALSE(has(flags({.passes = 8, .effort = 100, .tolerance = 10}), StepFlags::unsolved));
}

TEST(Effort, NeverDoesMoreThanItMay) {
    for (const auto& [passes, iterations] : {std::pair(1, 1), {2, 1}, {3, 2}, {1, 12}}) {
        for (const float bound : {1.0f, 1.5f, 2.0f, 5.0f}) {
            const Multilevel method{.passes = passes, .iterations = iterations, .effort = bound};
            Effort effort(method, 1, 1.0 / 60);
            double work = 2.7;  // of coarse operators, in linearisations
            do {
                const int taken = effort.iterations_for(1e6);
                ASSERT_GE(taken, 1);
                ASSERT_LE(taken, iterations);
                work += 1 + 2 * taken;
                effort.add({.decrement = 1e6, .slope = 1e5, .length = 1, .iterations = taken});
            } while (effort.wants_another_pass());
            const double usual = 2.7 + 3 * (passes - 1) + 1 + 2 * iterations;
            EXPECT_LE(work, static_cast<double>(bound) * usual + 1e-9) << passes << " " << bound;
            EXPECT_GT(work, static_cast<double>(bound) * usual - 3) << "what it may do, it does";
            EXPECT_TRUE(effort.is_unsolved());
        }
    }
}

TEST(Effort, StepsBackToWhereASecantHasTheEnergyLeast) {
    const Multilevel method;
    const auto back = [&](double slope, bool a_pass_follows = true) {
        Effort effort(method, 1, 1.0 / 60);
        effort.add({.decrement = 4, .slope = 2, .length = 0.5f, .iterations = 1});
        return effort.step_back(slope, a_pass_follows);
    };
    EXPECT_EQ(back(1), 0) << "still downhill";
    EXPECT_EQ(back(-1.9), 0) << "uphill, but lower than it began";
    EXPECT_EQ(back(1, false), 0);
    EXPECT_FLOAT_EQ(back(-2, false), 0.25f) << "no pass will see to it";
    EXPECT_FLOAT_EQ(back(-2.5), 0.5f * (1 - 2 / 4.5f));
    EXPECT_FLOAT_EQ(back(-6), 0.5f * 0.75f);
    EXPECT_FLOAT_EQ(back(-1e9), 0.5f * 0.9f) << "a tenth is always kept";
}

TEST(Effort, SettingsOutOfRangeAreRefusedByName) {
    World world = World::create(vacuum(downwards)).value();
    const auto message = [&](const Multilevel& method) {
        const auto made = world.add_cloth(sheet(3, 3), {.method = method});
        return made ? std::string() : made.error().message;
    };
    for (const float bad : {0.99f, 1001.0f, -1.0f, std::numeric_limits<float>::quiet_NaN()})
        EXPECT_NE(message({.effort = bad}).find("Multilevel::effort is"), std::string::npos) << bad;
    EXPECT_NE(message({.effort = 0.5f}).find("it must be from 1 to 1000"), std::string::npos);
    for (const float bad : {-1.0f, 2e9f, std::numeric_limits<float>::infinity()})
        EXPECT_NE(message({.tolerance = bad}).find("Multilevel::tolerance is"), std::string::npos) << bad;
    EXPECT_EQ(message({.effort = 1, .tolerance = 0}), "");
    EXPECT_EQ(message({.effort = 1000, .tolerance = 1e9f}), "");
}

}  // namespace
}  // namespace weft::test
