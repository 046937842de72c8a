// The truth by fine steps: its order, and the motion of one particle that is known.

#include "demo/study/reference/fine_time.h"

#include <gtest/gtest.h>
#include <cmath>

#include "demo/study/reference/states.h"
#include "demo/study/study_scenes.h"

namespace weft::study {
namespace {

Positions after(const StudyScene& scene, int frames, int substeps) {
    FineTime fine(scene, 1);
    for (int frame = 0; frame < frames; ++frame) fine.step(substeps);
    return fine.positions();
}

// Without pins a flat sheet falls as one particle against air damping: v' = g - c v.
TEST(FineTime, FallsAsTheClosedFormSays) {
    StudyScene scene = hung_sheet(5, false);
    scene.pins.clear();
    scene.start_positions.clear();
    const double c = static_cast<double>(scene.cloth.air_damping), t = 0.5, g = -9.81;
    const double expected = g / c * (t - (1 - std::exp(-c * t)) / c);
    for (const Eigen::Vector3d& x : after(scene, 30, 64)) EXPECT_NEAR(x.y(), expected, 1e-6);
}

}  // namespace
}  // namespace weft::study
