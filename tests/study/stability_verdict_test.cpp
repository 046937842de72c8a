#include "demo/study/stability/stability_verdict.h"

#include <gtest/gtest.h>

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

}  // namespace
}  // namespace weft::study
