#include "demo/study/stability/stability_verdict.h"

#include <gtest/gtest.h>

#include <limits>
#include <stdexcept>

namespace weft::study {
namespace {

/// Fell from 2 J to rest at -1 J, and hangs as it should.
RunMeasures sound_run() {
    return {.lasted = 2,
            .start_energy = 2,
            .peak_energy = 2,
            .end_energy = -0.9,
            .stretch = 0.002,
            .height = -0.52,
            .hang_energy = -1,
            .hang_stretch = 0.001,
            .hang_height = -0.5};
}

TEST(StabilityVerdict, WhatStaysWithinTheTolerancesIsStable) {
    const Judgement judgement = judge(sound_run(), {});
    EXPECT_EQ(judgement.verdict, Verdict::stable);
    EXPECT_EQ(judgement.broken(), "");
}

TEST(StabilityVerdict, EachToleranceBreaksByItself) {
    const Tolerance tolerance;
    RunMeasures run = sound_run();
    run.peak_energy = run.start_energy + 3 * tolerance.energy_rise * 1.01;
    EXPECT_EQ(judge(run, tolerance).broken(), "energy") << "3 J are what it had to lose";
    run = sound_run();
    run.stretch = run.hang_stretch + 1.01 * tolerance.stretch;
    EXPECT_EQ(judge(run, tolerance).broken(), "stretch");
    run = sound_run();
    run.height = run.hang_height + 1.01 * tolerance.height;
    EXPECT_EQ(judge(run, tolerance).broken(), "height");
    EXPECT_EQ(judge(run, tolerance).verdict, Verdict::wrong);
    run.stretch = 1;
    EXPECT_EQ(judge(run, tolerance).broken(), "stretch+height");
}

TEST(StabilityVerdict, WhatEndsTornWithMoreEnergyThanItEverHadDiverged) {
    RunMeasures run = sound_run();
    run.peak_energy = run.end_energy = 2 + 3.01;
    EXPECT_EQ(judge(run, {}).verdict, Verdict::wrong) << "stiff springs hold much energy in little stretch";
    run.stretch = run.hang_stretch + 1.01 * torn_stretch;
    EXPECT_EQ(judge(run, {}).verdict, Verdict::diverged);
    run.end_energy = 2 + 2.99;
    EXPECT_EQ(judge(run, {}).verdict, Verdict::wrong) << "long, but it has not gained";
}

TEST(StabilityVerdict, RunningAwayAndNoNumberComeFirst) {
    RunMeasures run = sound_run();
    run.ran_away = true;
    EXPECT_EQ(judge(run, {}).verdict, Verdict::diverged);
    run.not_a_number = true;
    EXPECT_EQ(judge(run, {}).verdict, Verdict::not_a_number);
}

TEST(StabilityVerdict, MeasuresThatAreNoNumberBreakEveryTolerance) {
    RunMeasures run = sound_run();
    run.stretch = run.height = run.peak_energy = std::numeric_limits<double>::quiet_NaN();
    EXPECT_EQ(judge(run, {}).broken(), "energy+stretch+height");
}

TEST(StabilityVerdict, WordsReadBack) {
    for (int i = 0; i < verdict_count; ++i) {
        const auto verdict = static_cast<Verdict>(i);
        EXPECT_EQ(verdict_of(word(verdict)), verdict);
    }
    EXPECT_THROW((void)verdict_of("fine"), std::runtime_error);
}

}  // namespace
}  // namespace weft::study
