#include "demo/window/grab.h"

#include <gtest/gtest.h>

#include "engine/vector.h"
#include "tests/demo/small_world.h"

namespace weft::demo {
namespace {

constexpr float dt = 1.0f / 60.0f;
constexpr Vec3 forward{0, 0, -1};

TEST(Grab, HoldsTheParticleUnderTheRay) {
    SmallWorld small;
    Grab grab;
    ASSERT_TRUE(grab.begin(small.world, SmallWorld::straight_at(0.31f, 0.58f), forward));
    EXPECT_EQ(grab.vertex(), SmallWorld::vertex(4, 3));
    EXPECT_EQ(small.position(grab.vertex()).w, 0);

    const Vec4 before = small.position(grab.vertex());
    for (int i = 0; i < 10; ++i) {
        grab.before_step(small.world, dt);
        small.world.step(dt);
    }
    const Vec4 after = small.position(grab.vertex());
    EXPECT_EQ(xyz(after), xyz(before)) << "a still hand holds still";
}

TEST(Grab, FollowsThePointerAtItsDepthAndNoFasterThanAHand) {
    SmallWorld small;
    Grab grab;
    ASSERT_TRUE(grab.begin(small.world, SmallWorld::straight_at(0.5f, 0.5f), forward));
    grab.aim(SmallWorld::straight_at(0.9f, 0.8f));
    Vec4 last = small.position(grab.vertex());
    for (int i = 0; i < 30; ++i) {
        grab.before_step(small.world, dt);
        small.world.step(dt);
        const Vec4 now = small.position(grab.vertex());
        EXPECT_LE((xyz(now) - xyz(last)).norm(), 1.001f * Grab::max_speed * dt);
        last = now;
    }
    EXPECT_NEAR(last.x, 0.9f, 1e-5);
    EXPECT_NEAR(last.y, 0.8f, 1e-5);
    EXPECT_NEAR(last.z, 0, 1e-5);
}

TEST(Grab, LeavesPinnedWhatTheScenePinned) {
    SmallWorld small;
    const std::uint32_t corner = SmallWorld::vertex(0, 0);
    ASSERT_TRUE(small.world.pin(small.cloths.front().id, corner).ok());
    Grab grab;
    ASSERT_TRUE(grab.begin(small.world, SmallWorld::straight_at(0.01f, 0.99f), forward));
    ASSERT_EQ(grab.vertex(), corner);
    grab.end(small.world);
    small.world.step(dt);
    EXPECT_EQ(small.position(corner).w, 0);
}

}  // namespace
}  // namespace weft::demo
