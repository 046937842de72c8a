// BDF2 in steps of changing length: its coefficients, and that motion knows nothing of where steps change.

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <random>

#include "cloth/motion/history.h"
#include "weft/weft.h"

namespace weft::test::step_lengths {
namespace {

constexpr float h = 1.0f / 60;

/// A sheet of cotton that swings by two corners, without air.
struct Swing {
    explicit Swing(TimeScheme scheme = TimeScheme::bdf2) : world(World::create(still_air()).value()) {
        ClothSettings settings;
        settings.air_damping = 0;
        settings.time_scheme = scheme;
        id = world.add_cloth(make_sheet({.rows = 17, .columns = 17}).value(), settings).value();
        (void)world.pin(id, std::vector<std::uint32_t>{0, 16});
    }
    static WorldSettings still_air() {
        WorldSettings settings;
        settings.threads = 1;
        settings.wind.air_density = 0;
        return settings;
    }
    [[nodiscard]] double energy() const {
        double sum = 0;
        const auto view = world.cloth(id);
        for (std::size_t i = 0; i < view->positions.size(); ++i) {
            const Vec4 &x = view->positions[i], &v = view->velocities[i];
            if (x.w > 0)
                sum += (9.81 * static_cast<double>(x.y) +
                        0.5 * static_cast<double>(v.x * v.x + v.y * v.y + v.z * v.z)) /
                       static_cast<double>(x.w);
        }
        return sum;
    }
    /// What it loses in 2 s.
    double lost(const std::function<float(int)>& step_of) {
        const double before = energy();
        double time = 0;
        for (int k = 0; time < 2; ++k) {
            const float dt = step_of(k);
            world.step(dt);
            time += static_cast<double>(dt);
        }
        return before - energy();
    }
    World world;
    ClothId id;
};

TEST(StepLengths, ASwingLosesWhatItDoesInEqualSteps) {
    const double equal = Swing().lost([](int) { return h; });
    const double euler = Swing(TimeScheme::backward_euler).lost([](int) { return h; });
    ASSERT_GT(euler, 1.5 * equal);
    const auto is_near = [&](double lost) { return std::abs(lost - equal) < 0.2 * (euler - equal); };
    std::mt19937 random(3);
    std::uniform_real_distribution<float> jitter(0.9f, 1.1f);
    const double hardly = Swing().lost([](int k) { return h * (k % 2 == 0 ? 1.0001f : 0.9999f); });
    const double somewhat = Swing().lost([&](int) { return h * jitter(random); });
    const double hitches = Swing().lost([](int k) { return k % 7 == 6 ? 2 * h : h * 5 / 6; });
    EXPECT_TRUE(is_near(hardly)) << hardly << " of " << equal << ", " << euler;
    EXPECT_TRUE(is_near(somewhat)) << somewhat << " of " << equal << ", " << euler;
    EXPECT_LT(hitches, equal + 0.5 * (euler - equal)) << equal << ", " << euler;
}

// Substeps of another number than the last step had are steps of another length.
TEST(StepLengths, SubstepsThatChangeKeepTheOrder) {
    const double equal = Swing().lost([](int) { return h; });
    const double euler = Swing(TimeScheme::backward_euler).lost([](int) { return h; });
    Swing swing;
    const double lost = swing.lost([&](int k) {
        WorldSettings settings = swing.world.settings();
        settings.substeps = 1 + k % 2;
        EXPECT_TRUE(swing.world.set_settings(settings));
        return h;
    });
    EXPECT_LT(lost, equal + 0.2 * (euler - equal));
}

// Falling free, each step adds g h to the velocity, whatever steps came before.
TEST(StepLengths, FreeFallIsExactInAnySteps) {
    Swing falling;
    ClothSettings settings = falling.world.cloth_settings(falling.id).value();
    settings.method = ConjugateGradient{.iterations = 100};
    ASSERT_TRUE(falling.world.set_cloth_settings(falling.id, settings));
    (void)falling.world.unpin(falling.id, std::vector<std::uint32_t>{0, 16});
    std::mt19937 random(11);
    std::uniform_real_distribution<float> exponent(-4, -1);
    double time = 0;
    for (int k = 0; k < 200 && time < 2; ++k) {
        const float dt = std::pow(10.0f, exponent(random));
        falling.world.step(dt);
        time += static_cast<double>(dt);
        EXPECT_NEAR(static_cast<double>(falling.world.cloth(falling.id)->velocities[7].y), -9.81 * time,
                    1e-3 * (1 + 9.81 * time))
            << k;
    }
}

TEST(StepLengths, NoSequenceOfStepsGainsEnergy) {
    std::mt19937 random(17);
    for (int run = 0; run < 6; ++run) {
        std::uniform_real_distribution<float> exponent(-2.4f, -1.4f);  // 4 to 40 ms
        EXPECT_GT(Swing().lost([&](int) { return std::pow(10.0f, exponent(random)); }), 0);
    }
}

// A cloth that joins others in contact takes its first step by backward Euler, and once.
TEST(StepLengths, ClothThatIsAddedBesideAnotherFallsByOneStep) {
    World world = World::create(Swing::still_air()).value();
    ClothSettings meets;
    meets.air_damping = 0;
    meets.self_collision = {.method = SelfCollisionMethod::contact};
    const auto add = [&](float height) {
        return world
            .add_cloth(
                make_sheet(
                    {.rows = 9, .columns = 9, .origin = {0, height, 0}, .u = {0.4f, 0, 0}, .v = {0, 0, 0.4f}})
                    .value(),
                meets)
            .value();
    };
    const ClothId old = add(0);
    for (int k = 0; k < 3; ++k) world.step(h);
    const ClothId next = add(0.01f);
    const float before = world.cloth(next)->positions[40].y;
    world.step(h);
    EXPECT_NEAR(world.cloth(next)->velocities[40].y, -9.81f * h, 1e-3f);
    EXPECT_NEAR(world.cloth(next)->positions[40].y - before, -9.81f * h * h, 1e-4f);
    EXPECT_EQ(world.cloth(next)->previous_positions[40].y, before);
    EXPECT_NEAR(world.cloth(old)->velocities[40].y, -9.81f * 4 * h, 1e-3f);
}

}  // namespace
}  // namespace weft::test::step_lengths
