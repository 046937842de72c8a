// Every method from the worst start: all free particles at one point, or all but.

#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <vector>

#include "tests/cloth/fixtures.h"

namespace weft::test::collapsed_start {
namespace {

struct Case {
    std::string name;
    Method method;
    TimeScheme scheme = TimeScheme::backward_euler;
    int substeps = 1;
};

std::vector<Case> cases() {
    using enum TimeScheme;
    return {{"JacobiFirstGuess", Jacobi{.iterations = 0, .exact_mean_motion = false}},
            {"Jacobi", Jacobi{}},
            {"JacobiEven", Jacobi{16}},
            {"Chebyshev", Chebyshev{}},
            {"ConjugateGradient", ConjugateGradient{}},
            {"ConjugateGradientBdf2", ConjugateGradient{}, bdf2},
            {"Multilevel", Multilevel{}},
            {"MultilevelBdf2", Multilevel{}, bdf2},
            {"MultilevelPasses", Multilevel{.passes = 2}},
            {"Xpbd", Xpbd{}},
            {"XpbdSubsteps", Xpbd{}, backward_euler, 8},
            {"Fibres", Fibres{}},
            {"SymplecticEuler", SymplecticEuler{}, backward_euler, 64}};
}

class CollapsedStart : public testing::TestWithParam<Case> {
  protected:
    /// Steps a sheet hung by two corners whose free particles begin within `radius` of one point.
    static void run(float stiffer, float radius) {
        ClothSettings settings;
        settings.method = GetParam().method;
        settings.time_scheme = GetParam().scheme;
        settings.substeps = GetParam().substeps;
        for (float* k :
             {&settings.fabric.warp, &settings.fabric.weft, &settings.fabric.shear, &settings.fabric.bending})
            *k *= stiffer;
        auto made = std::make_unique<Cloth>(cook(sheet(9, 9)).value(), settings);
        Cloth& cloth = *made;
        cloth.pin(0);
        cloth.pin(8);
        std::mt19937 random(3);
        std::uniform_real_distribution<float> offset(-radius, radius);
        for (Vec4& x : cloth.state.positions.span()) {
            if (x.w > 0) set_xyz(x, {offset(random), offset(random), offset(random)});
        }
        WorldSettings world;
        world.wind.air_density = 0;
        world.threads = 1;
        Simulation simulation(world);
        simulation.prepare(cloth);
        simulation.add(std::move(made));
        // No step is short enough for the explicit method and fabric that is ten thousand times as stiff.
        const bool can = stiffer == 1 || !std::holds_alternative<SymplecticEuler>(settings.method);
        bool says_so = false;
        for (int frame = 0; frame < 30; ++frame) {
            simulation.step(1.0f / 60);
            says_so |= has(simulation.report.flags, StepFlags::state_restored) ||
                       has(simulation.report.flags, StepFlags::speed_limited);
            if (can) {
                ASSERT_EQ(simulation.report.restored_cloths, 0u) << "frame " << frame;
            }
            for (std::uint32_t i = 0; i < cloth.state.size(); ++i) {
                ASSERT_TRUE(xyz(cloth.state.positions[i]).allFinite()) << "frame " << frame;
                ASSERT_TRUE(xyz(cloth.state.velocities[i]).allFinite()) << "frame " << frame;
            }
        }
        if (!can) {
            EXPECT_TRUE(says_so);
        } else if (radius > 0) {
            EXPECT_GT(width_of_the_free(cloth), 0.4f) << "it opens";
        }
    }

    static float width_of_the_free(const Cloth& cloth) {
        float width = 0;
        for (const Vec4& a : cloth.state.positions.span())
            for (const Vec4& b : cloth.state.positions.span())
                if (a.w > 0 && b.w > 0) width = std::max(width, (xyz(a) - xyz(b)).norm());
        return width;
    }
};

INSTANTIATE_TEST_SUITE_P(, CollapsedStart, testing::ValuesIn(cases()),
                         [](const auto& info) { return info.param.name; });

TEST_P(CollapsedStart, OpensFromNearOnePoint) {
    run(1, 1e-4f);
    run(1e4f, 1e-4f);
}

TEST_P(CollapsedStart, GoesOnFromExactlyOnePoint) {
    run(1, 0);
    run(1e4f, 0);
}

}  // namespace
}  // namespace weft::test::collapsed_start
