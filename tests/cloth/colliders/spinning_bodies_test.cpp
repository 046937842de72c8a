// Bodies that spin freely.

#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

#include "tests/cloth/colliders/bodies_scene.h"

namespace weft::test {
namespace {

/// A body of uneven inertia in a World without gravity.
struct SpinningBody {
    SpinningBody(const Vec3& its_inertia, const Vec3& spin)
        : inertia(to_vector(its_inertia)),
          world(World::create({.gravity = {}, .threads = 1}).value()),
          id(world.add_body({.inertia = its_inertia}, {.velocity = {1, 0, 0}, .angular_velocity = spin})
                 .value()) {}

    [[nodiscard]] Eigen::Quaternionf rotation() const {
        const Rotation r = world.body_state(id)->rotation;
        return {r.w, r.x, r.y, r.z};
    }
    /// Angular velocity in the body's own frame [rad/s].
    [[nodiscard]] Vector3 own_spin() const {
        return rotation().conjugate() * to_vector(world.body_state(id)->angular_velocity);
    }
    [[nodiscard]] Vector3 momentum() const { return rotation() * inertia.cwiseProduct(own_spin()); }
    [[nodiscard]] float energy() const { return 0.5f * own_spin().dot(inertia.cwiseProduct(own_spin())); }

    Vector3 inertia;
    World world;
    BodyId id;
};

TEST(SpinningBodies, TurnOverAboutTheMiddleAxis) {
    SpinningBody body({0.01f, 0.02f, 0.03f}, {0.1f, 5, 0.1f});
    float least = 5;
    for (int k = 0; k < 600; ++k) {
        body.world.step(body_step);
        least = std::min(least, body.own_spin().y());
    }
    EXPECT_LT(least, 0);
    EXPECT_NEAR(body.world.body_state(body.id)->position.x, 10, 1e-3f);
}

TEST(SpinningBodies, KeepAngularMomentumAndEnergyAtAnySpeed) {
    const std::vector<Vec3> inertias{
        {0.01f, 0.02f, 0.03f}, {0.1f, 0.003f, 0.12f}, {1, 1, 0.001f}, {0.2f, 0.19f, 0.001f}};
    const std::vector<Vec3> spins{{30, 1, 1}, {1, 30, 1}, {0.1f, 5, 0.1f}, {10, 100, 10}};
    for (const Vec3& inertia : inertias)
        for (const Vec3& spin : spins) {
            SpinningBody body(inertia, spin);
            const Vector3 momentum = body.momentum();
            const float energy = body.energy();
            for (int k = 0; k < 600; ++k) {
                body.world.step(body_step);
                ASSERT_LT((body.momentum() - momentum).norm(), 3e-4f * momentum.norm())
                    << "inertia " << inertia.x << ' ' << inertia.y << ' ' << inertia.z << ", spin " << spin.x
                    << ' ' << spin.y << ' ' << spin.z << ", step " << k;
                ASSERT_NEAR(body.energy(), energy, 0.02f * energy);
            }
        }
}

}  // namespace
}  // namespace weft::test
