#include "weft/fixed_step.h"

#include <gtest/gtest.h>

#include <limits>
#include <random>
#include <vector>

namespace weft {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr double nan = std::numeric_limits<double>::quiet_NaN();

struct Expected {
    double frame_seconds;
    int steps;
    float alpha;
};

void expect_frames(FixedStep clock, const std::vector<Expected>& frames) {
    for (std::size_t i = 0; i < frames.size(); ++i) {
        const FixedStepFrame frame = clock.advance(frames[i].frame_seconds);
        EXPECT_EQ(frame.steps, frames[i].steps) << "frame " << i;
        EXPECT_EQ(frame.alpha, frames[i].alpha) << "frame " << i;
        EXPECT_EQ(frame.dropped_seconds, 0) << "frame " << i;
    }
}

TEST(FixedStep, PaysOutWholeStepsAndKeepsTheRest) {
    const FixedStepSettings quarter_second{.step = 0.25, .max_steps_per_frame = 4};
    expect_frames(*FixedStep::create(quarter_second), {{0.25, 1, 0.0f},
                                                       {0.125, 0, 0.5f},
                                                       {0.125, 1, 0.0f},
                                                       {0.0625, 0, 0.25f},
                                                       {0.625, 2, 0.75f},
                                                       {0.0, 0, 0.75f},
                                                       {1.0, 4, 0.75f}});
}

// Frames of p/q of a step: rounding must not hold a due step back until the next frame.
TEST(FixedStep, TakesEveryStepInTheFrameInWhichItFallsDue) {
    for (const int hertz : {24, 25, 30, 50, 72, 75, 90, 100, 120, 144, 165, 180, 240, 1000}) {
        FixedStep clock;
        int steps = 0;
        for (int frame = 1; frame <= 20 * hertz; ++frame) {
            steps += clock.advance(1.0 / hertz).steps;
            ASSERT_EQ(steps, frame * 60 / hertz) << "frame " << frame << " at " << hertz << " Hz";
        }
    }
}

TEST(FixedStep, DropsTheTimeBeyondTheCapAndSaysHowMuch) {
    FixedStep clock = *FixedStep::create({.step = 0.25, .max_steps_per_frame = 4});
    const FixedStepFrame slow = clock.advance(3.125);
    EXPECT_EQ(slow.steps, 4);
    EXPECT_EQ(slow.alpha, 0);
    EXPECT_EQ(slow.dropped_seconds, 2.125);

    const FixedStepFrame next = clock.advance(0.375);  // nothing of the slow frame is left over
    EXPECT_EQ(next.steps, 1);
    EXPECT_EQ(next.alpha, 0.5f);
    EXPECT_EQ(next.dropped_seconds, 0);
}

TEST(FixedStep, SurvivesAnyFrameTime) {
    FixedStep clock = *FixedStep::create({.step = 0.25, .max_steps_per_frame = 4});
    for (const double time : {1e9, 1e300, std::numeric_limits<double>::max()}) {
        const FixedStepFrame frame = clock.advance(time);
        EXPECT_EQ(frame.steps, 4);
        EXPECT_EQ(frame.alpha, 0);
        EXPECT_GT(frame.dropped_seconds, 0.99 * time - 4);
    }
}

TEST(FixedStep, CountsNegativeAndNonFiniteTimesAsZero) {
    FixedStep clock = *FixedStep::create({.step = 0.25, .max_steps_per_frame = 4});
    EXPECT_EQ(clock.advance(0.125).alpha, 0.5f);
    for (const double time : {-1.0, -0.0, nan, infinity, -infinity}) {
        const FixedStepFrame frame = clock.advance(time);
        EXPECT_EQ(frame.steps, 0) << time;
        EXPECT_EQ(frame.alpha, 0.5f) << time;
        EXPECT_EQ(frame.dropped_seconds, 0) << time;
    }
}

TEST(FixedStep, KeepsAlphaBelowOneAndLosesNoTime) {
    std::mt19937 random(1);
    std::uniform_real_distribution<double> frame_time(0, 0.09);
    FixedStep clock;
    double given = 0, simulated = 0, dropped = 0;
    float alpha = 0;
    for (int i = 0; i < 100000; ++i) {
        const double time = frame_time(random);
        const FixedStepFrame frame = clock.advance(time);
        given += time;
        simulated += frame.steps / 60.0;
        dropped += frame.dropped_seconds;
        alpha = frame.alpha;
        ASSERT_GE(alpha, 0.0f);
        ASSERT_LT(alpha, 1.0f);
        ASSERT_LE(frame.steps, 4);
    }
    EXPECT_GT(dropped, 0);
    EXPECT_NEAR(simulated + dropped + static_cast<double>(alpha) / 60.0, given, 1e-6);
}

TEST(FixedStep, ForgetsTheRestWhenReset) {
    FixedStep clock = *FixedStep::create({.step = 0.25, .max_steps_per_frame = 4});
    EXPECT_EQ(clock.advance(0.125).alpha, 0.5f);
    clock.reset();
    EXPECT_EQ(clock.advance(0).alpha, 0);
}

TEST(FixedStep, RefusesSettingsThatAreOutOfRange) {
    for (const double step : {0.0, -1.0, nan, infinity}) {
        const auto clock = FixedStep::create({.step = step, .max_steps_per_frame = 4});
        ASSERT_FALSE(clock.ok()) << step;
        EXPECT_NE(clock.error().message.find("FixedStepSettings::step"), std::string::npos);
    }
    const auto clock = FixedStep::create({.step = 1, .max_steps_per_frame = 0});
    ASSERT_FALSE(clock.ok());
    EXPECT_EQ(clock.error().message, "FixedStepSettings::max_steps_per_frame is 0; it must be >= 1");
}

}  // namespace
}  // namespace weft
