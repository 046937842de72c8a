// When cloth is solved by one linearisation, since passes leave too much of its equation.

#include <gtest/gtest.h>

#include "tests/cloth/fixtures.h"

namespace weft::test {
namespace {

Parallel serial(1);

Cloth moving_cloth() {
    return crumpled(sheet(4, 4), 0.01f, 100);
}

/// For how long, until it is solved so or otherwise [s].
float time_until(bool one_pass, Cloth& cloth) {
    float time = 0;
    for (; Simulation::is_in_one_pass(cloth) != one_pass && time < 100; time += h)
        Simulation::count_unsolved(serial, cloth, h, true);
    return time;
}

TEST(OnePass, BeginsAfterItsPatienceAndEndsAfterFourSeconds) {
    Cloth cloth = moving_cloth();
    EXPECT_NEAR(time_until(true, cloth), 0.35f, 1.5f * h);
    EXPECT_NEAR(time_until(false, cloth), 4, 1.5f * h);
    EXPECT_NEAR(time_until(true, cloth), 0, 1.5f * h) << "passes still leave too much";
}

TEST(OnePass, IsPutOffByWhatIsSolvedAndByWhatDrives) {
    Cloth cloth = moving_cloth();
    const auto change = [&](bool unsolved) {
        cloth.state.unsolved = 0.2f;
        Simulation::count_unsolved(serial, cloth, h, unsolved);
        return cloth.state.unsolved - 0.2f;
    };
    EXPECT_FLOAT_EQ(change(true), h);
    EXPECT_FLOAT_EQ(change(false), -h);
    cloth.take_air(cloth.make_air(true, false));
    for (const float sign : {-1.0f, 1.0f}) {
        for (std::size_t i = 0; i < cloth.air.forces.size(); ++i) {
            const Vec4 v = cloth.state.velocities[i];
            cloth.air.forces[i] = {sign * v.x, sign * v.y, sign * v.z, 0};
        }
        EXPECT_FLOAT_EQ(change(true), sign < 0 ? h : -4 * h) << "drag takes power, wind gives it";
    }
    cloth.take_air(cloth.make_air(false, false));
    cloth.pin(3);
    EXPECT_FLOAT_EQ(change(true), h);
    cloth.state.pins.front().target.x() += 0.01f;
    EXPECT_FLOAT_EQ(change(true), -4 * h);
    cloth.state.unsolved = 0;
    Simulation::count_unsolved(serial, cloth, h, false);
    EXPECT_EQ(cloth.state.unsolved, 0);
}

TEST(OnePass, IsNotForWhatTouchesACollider) {
    Cloth cloth = moving_cloth();
    cloth.state.unsolved = 2;
    EXPECT_TRUE(Simulation::is_in_one_pass(cloth));
    cloth.state.held = HeldContacts(cloth.model.particle_count);
    EXPECT_TRUE(Simulation::is_in_one_pass(cloth));
    cloth.state.held.touching[0] = 1;
    EXPECT_FALSE(Simulation::is_in_one_pass(cloth));
}

}  // namespace
}  // namespace weft::test
