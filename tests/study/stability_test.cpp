// Stability maps: verdicts, and the bounds that theory gives.

#include <gtest/gtest.h>

#include <string>

#include "demo/study/accuracy/motion_measures.h"
#include "demo/study/stability/stability_cell.h"
#include "demo/study/stability/study_solvers.h"

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

// Predictions of theory for cells of the stability maps, on sheets small enough for a test.

constexpr StabilitySheet small{.per_side = 6, .seconds = 0.5};

MethodPoint with_method(const Method& method) {
    MethodPoint point;
    point.configure = [=](ClothSettings& settings) { settings.method = method; };
    return point;
}

MethodPoint exact_steps() {
    MethodPoint point = with_method(Jacobi{});
    point.make_solver = [](const ClothModel& model, const ClothSettings& settings) {
        return std::make_unique<CholeskySolver>(model, settings);
    };
    return point;
}

TEST(StabilityBounds, ExactLinearlyImplicitStepsStayBoundedFromEveryStart) {
    // W is positive definite whatever stiffness and step, so an exact step is a contraction of what moves.
    // The one linearisation may stretch springs for a while; the energy of motion never exceeds the start's.
    for (const Start start : starts) {
        for (const double stiffness : {1.0, 100.0, 10000.0}) {
            for (const float step : {1.0f / 240, 1.0f / 60, 1.0f / 15}) {
                StudyScene scene = stability_scene(small, start, stiffness);
                scene.frame = step;
                study::Run run(scene, exact_steps(), 1);
                const double begin = energy_of(run.cloth(), scene.world.gravity).total();
                Energy energy;
                for (float time = 0; time < 0.5f; time += step) {
                    run.step();
                    energy = energy_of(run.cloth(), scene.world.gravity);
                    ASSERT_LE(energy.kinetic + energy.gravity, begin + 1e-3 * std::abs(begin))
                        << name_of(start) << " x" << stiffness << " at " << step;
                }
                EXPECT_EQ(run.restored_frames(), 0);
            }
        }
    }
}

/// Energy left of a little noise in a free, stiff sheet after 30 frames, over that of its start.
double noise_left(int iterations) {
    StudyScene scene = stability_scene(small, Start::crumpled, 1000);
    scene.world.gravity = {0, 0, 0};
    scene.cloth.air_damping = 0;
    scene.cloth.fabric.damping = 0;
    scene.pins.clear();
    for (std::size_t i = 0; i < scene.mesh.positions.size(); ++i) {
        const Vector3 rest = to_vector(scene.mesh.positions[i]);
        set_xyz(scene.start_positions[i], rest + 0.02f * (xyz(scene.start_positions[i]) - rest));
    }
    study::Run run(scene, with_method(Jacobi{iterations}), 1);
    const double begin = energy_of(run.cloth(), scene.world.gravity).total();
    for (int frame = 0; frame < 30; ++frame) run.step();
    return energy_of(run.cloth(), scene.world.gravity).total() / begin;
}

TEST(StabilityBounds, EvenJacobiCountsFeedNoiseAndOddOnesDampIt) {
    // k iterations leave the part p = g^(k+1) of an error in a mode of G = I - D^-1 W with eigenvalue g. In a
    // stiff mode backward Euler then has amplification p +- sqrt(p (p - 1)): within the unit circle for -1/3
    // < p < 1, and g is close to -1 in the shortest waves.
    for (const int even : {0, 2, 4, 8}) EXPECT_GT(noise_left(even), 10) << even << " iterations";
    for (const int odd : {1, 3, 5, 9, 15}) EXPECT_LT(noise_left(odd), 1) << odd << " iterations";
}

}  // namespace

}  // namespace weft::study
