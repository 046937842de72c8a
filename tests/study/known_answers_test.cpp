// The known answers against tables and closed forms.

#include "demo/study/physics/known_answers.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace weft::study {
namespace {

TEST(HeavyElastica, AgreesWithItsTable) {
    struct Line {
        double gamma, drop, reach, chord;
    };
    for (const Line& line : {Line{0.1, 0.01250, 0.99991, 0.716}, Line{1, 0.12347, 0.99125, 7.100},
                             Line{5, 0.49591, 0.84666, 30.358}, Line{8, 0.64063, 0.72442, 41.487},
                             Line{10, 0.70020, 0.65635, 46.851}, Line{50, 0.90792, 0.24501, 74.898}}) {
        const HangingStrip strip = heavy_elastica(line.gamma);
        EXPECT_NEAR(strip.drop, line.drop, 2e-5) << line.gamma;
        EXPECT_NEAR(strip.reach, line.reach, 2e-5) << line.gamma;
        EXPECT_NEAR(strip.chord_degrees(), line.chord, 2e-3) << line.gamma;
    }
}

TEST(HeavyElastica, IsABeamUnderSmallLoads) {
    EXPECT_NEAR(heavy_elastica(1e-3).drop, 1e-3 / 8, 1e-9);
}

TEST(HeavyElastica, HangsByFortyOneAndAHalfDegreesAtTwiceTheBendingLength) {
    EXPECT_NEAR(heavy_elastica(8.0042).chord_degrees(), 41.5, 1e-3);
}

TEST(LateralBuckling, ComesAtTheTextbooksLoad) {
    EXPECT_NEAR(lateral_buckling_gamma(), 12.8538 * std::numbers::sqrt2, 1e-3);
}

TEST(Catenary, HasItsLength) {
    for (const auto& [span, length] : {std::pair(0.6, 1.0), {0.95, 1.0}, {0.1, 1.0}, {2.0, 3.0}}) {
        const double sag = catenary_sag(span, length);
        // length^2 = (2 sag)^2 + 8 a sag, of any catenary.
        const double a = (length * length - 4 * sag * sag) / (8 * sag);
        EXPECT_NEAR(2 * a * std::sinh(span / (2 * a)), length, 1e-9);
    }
    EXPECT_NEAR(catenary_sag(1, 1 + 1e-4), std::sqrt(3 * 1e-4 / 8), 1e-4) << "shallow: a parabola";
}

TEST(Pendulums, HaveTheirPeriods) {
    EXPECT_NEAR(plate_pendulum_period(1.5, 1e-3, 9.81), 2 * std::numbers::pi / std::sqrt(9.81), 1e-6);
    // The complete elliptic integral at 60 degrees: 1.0732 of the small swing's period.
    const double small = plate_pendulum_period(1, 0, 9.81);
    EXPECT_NEAR(plate_pendulum_period(1, std::numbers::pi / 3, 9.81) / small, 1.0732, 1e-3);
    EXPECT_NEAR(chain_pendulum_period(1, 9.81), 5.2255 / std::sqrt(9.81), 1e-4);
}

TEST(TerminalSpeed, BalancesWeightAndDrag) {
    const double speed = terminal_speed(0.2, 9.81, 1.2, 1.1);
    EXPECT_NEAR(0.5 * 1.2 * 1.1 * speed * speed, 0.2 * 9.81, 1e-12);
}

TEST(Capstan, IsEytelweinsOnAThinRod) {
    EXPECT_NEAR(capstan_friction(0.1, 0.2, 1e-7), std::log(2.0) / std::numbers::pi, 1e-5);
    EXPECT_NEAR(capstan_friction(0.3, 0.3, 0.05), 0, 1e-6) << "balanced without friction";
    // The part on the cylinder presses, too, so that less friction holds the same lengths.
    EXPECT_LT(capstan_friction(0.1, 0.2, 0.05), capstan_friction(0.1, 0.2, 1e-7));
}

TEST(Slope, HoldsBelowTheAngleOfFriction) {
    EXPECT_EQ(slope_acceleration(std::atan(0.39), 0.4, 9.81), 0);
    EXPECT_NEAR(slope_acceleration(std::numbers::pi / 2, 0.4, 9.81), 9.81, 1e-12);
}

}  // namespace
}  // namespace weft::study
