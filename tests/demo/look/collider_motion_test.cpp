// Colliders between two steps: drawn as late as the cloth that lies on them.

#include "demo/look/collider_motion.h"

#include <gtest/gtest.h>

namespace weft::demo {
namespace {

class MovedBall : public testing::Test {
  protected:
    static constexpr float dt = 1.0f / 60, metres_a_step = 0.02f;

    void SetUp() override { ball_ = world_.add_collider({.shape = Sphere{{}, 0.1f}}).value(); }
    void steps(int count) {
        for (int k = 0; k < count; ++k) {
            ++taken_;
            (void)world_.move_collider(
                ball_, {.shape = Sphere{{metres_a_step * static_cast<float>(taken_), 0, 0}, 0.1f}});
            world_.step(dt);
        }
    }
    /// The ball's place along X, as a picture at this share of the way shows it.
    float drawn_at(float share) {
        motion_.note(ball_, *world_.collider(ball_), world_.report().step);
        return std::get<Sphere>(motion_.at(ball_, share).shape).center.x;
    }

    World world_ = World::create({.threads = 1}).value();
    ColliderId ball_;
    ColliderMotion motion_;
    int taken_ = 0;
};

TEST_F(MovedBall, IsDrawnBetweenTheLastTwoSteps) {
    EXPECT_EQ(drawn_at(0.5f), 0) << "it has not moved yet";
    steps(1);
    EXPECT_NEAR(drawn_at(0), 0, 1e-6f);
    EXPECT_NEAR(drawn_at(0.25f), 0.25f * metres_a_step, 1e-6f);
    EXPECT_NEAR(drawn_at(1), metres_a_step, 1e-6f);
    steps(3);  // a slow picture
    EXPECT_NEAR(drawn_at(0), 3 * metres_a_step, 1e-6f);
    EXPECT_NEAR(drawn_at(0.5f), 3.5f * metres_a_step, 1e-6f);
}

TEST_F(MovedBall, IsWhereItHasJumped) {
    steps(1);
    (void)drawn_at(1);
    (void)world_.place_collider(ball_, {.shape = Sphere{{50, 0, 0}, 0.1f}});
    world_.step(dt);
    EXPECT_EQ(drawn_at(0.5f), 50);
}

}  // namespace
}  // namespace weft::demo
