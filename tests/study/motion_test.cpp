// What weft_study motion measures, on motion that is known.

#include "demo/study/accuracy/motion_measures.h"

#include <gtest/gtest.h>

#include <limits>
#include <vector>

namespace weft::study {
namespace {

MethodPoint implicit(TimeScheme scheme) {
    MethodPoint point;
    point.configure = [=](ClothSettings& settings) {
        settings.method = Multilevel{.passes = 20};
        settings.time_scheme = scheme;
        settings.substeps = 1;
    };
    return point;
}

TEST(SwingMeasures, TheTruthWithoutDampingKeepsItsEnergy) {
    StudyScene scene = swinging_sheet(9);
    scene.cloth.fabric.damping = 0;
    const double kept = energy_lost(scene, true_swing(scene, 60, 1, 1));
    EXPECT_NEAR(kept, 0, 5e-3);
    scene.cloth.fabric.damping = 5e-3f;
    EXPECT_GT(energy_lost(scene, true_swing(scene, 60, 1, 1)), 0.015) << "damping takes its part";
}

TEST(SwingMeasures, ASchemeOfSecondOrderLosesLessAndIsFasterThanOneOfFirst) {
    const StudyScene scene = swinging_sheet(9);
    const Swing truth = true_swing(scene, 60, 1, 1);
    const Swing second = swing(scene, implicit(TimeScheme::bdf2), 60, 1, 1);
    const Swing first = swing(scene, implicit(TimeScheme::backward_euler), 60, 1, 1);
    EXPECT_LT(energy_lost(scene, truth), energy_lost(scene, second));
    EXPECT_LT(energy_lost(scene, second), energy_lost(scene, first));
    EXPECT_GT(second.speed, first.speed);
}

TEST(TimeToRest, IsWhenSpeedsStayBelowTheLimit) {
    EXPECT_DOUBLE_EQ(time_to_rest(std::vector{3.0, 0.5, 2.0, 0.5, 0.4}, 0.1, 1), 0.4);
    EXPECT_DOUBLE_EQ(time_to_rest(std::vector{0.5, 0.5}, 0.1, 1), 0.1);
    EXPECT_EQ(time_to_rest(std::vector{0.5, 1.0}, 0.1, 1), std::numeric_limits<double>::infinity());
    EXPECT_EQ(time_to_rest(std::vector{0.5, std::nan("")}, 0.1, 1), std::numeric_limits<double>::infinity());
}

}  // namespace
}  // namespace weft::study
