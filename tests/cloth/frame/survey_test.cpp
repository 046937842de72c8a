#include "cloth/motion/survey.h"

#include <gtest/gtest.h>

#include <limits>

#include "tests/cloth/fixtures.h"

namespace weft::test {
namespace {

ClothState random_state(std::uint32_t particles) {
    ClothState state(particles);
    state.positions = random_rows(particles, 3, 5);
    state.velocities = random_rows(particles, 2, 6);
    return state;
}

Survey surveyed(const ClothState& state) {
    Parallel serial(1);
    std::vector<Survey> partials(block_count(state.size()));
    return survey(serial, state, partials);
}

TEST(Survey, FindsTheExtentAndTheFastestWhereverTheyAre) {
    for (const std::uint32_t n : {1u, 2u, 7u, 8u, 9u, 15u, 16u, 17u, 31u, 255u, 256u, 257u, 600u}) {
        for (const std::uint32_t at : {0u, n / 2, n - 1}) {
            ClothState state = random_state(n);
            state.positions[at] = {-10, 11, 12, 1};
            EXPECT_EQ(surveyed(state).lower.x, -10) << at << " of " << n;
            EXPECT_EQ(surveyed(state).upper.y, 11) << at << " of " << n;
            EXPECT_EQ(surveyed(state).upper.z, 12) << at << " of " << n;
            state.positions[at] = {13, -14, -15, 1};
            EXPECT_EQ(surveyed(state).upper.x, 13) << at << " of " << n;
            EXPECT_EQ(surveyed(state).lower.y, -14) << at << " of " << n;
            EXPECT_EQ(surveyed(state).lower.z, -15) << at << " of " << n;
            state.velocities[at] = {0, -20, 0, 0};
            EXPECT_EQ(surveyed(state).peak_speed_squared, 400) << at << " of " << n;
            EXPECT_TRUE(surveyed(state).sound);
        }
    }
}

TEST(Survey, OneParticleThatIsNotSoundIsEnough) {
    constexpr float inf = std::numeric_limits<float>::infinity(),
                    nan = std::numeric_limits<float>::quiet_NaN();
    for (const std::uint32_t n : {1u, 9u, 16u, 257u, 300u}) {
        for (std::uint32_t at = 0; at < n; ++at) {
            for (const float bad : {nan, inf, -inf, 1.001f * runaway_distance, -1.001f * runaway_distance}) {
                for (float Vec4::*const coordinate : {&Vec4::x, &Vec4::y, &Vec4::z}) {
                    ClothState state = random_state(n);
                    state.positions[at].*coordinate = bad;
                    EXPECT_FALSE(surveyed(state).sound) << bad << " at " << at << " of " << n;
                }
            }
            for (const float bad : {nan, inf, -inf}) {
                ClothState state = random_state(n);
                state.velocities[at].z = bad;
                EXPECT_FALSE(surveyed(state).sound) << bad << " at " << at << " of " << n;
            }
        }
    }
}

}  // namespace
}  // namespace weft::test
