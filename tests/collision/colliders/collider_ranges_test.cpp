// What a collider may be, and what comes of the ends of its ranges.

#include <gtest/gtest.h>

#include <cmath>
#include <string>

#include "engine/error_text.h"
#include "tests/collision/particle_cloud.h"

namespace weft::test {
namespace {

TEST(Colliders, ValidateNamesTheBadValue) {
    const auto expect_names = [](const Collider& collider, const std::string& name,
                                 const std::string& value) {
        const Result<void> result = validate(collider);
        ASSERT_FALSE(result.ok()) << name;
        EXPECT_EQ(result.error().code, ErrorCode::invalid_argument);
        EXPECT_NE(result.error().message.find(name), std::string::npos) << result.error().message;
        EXPECT_NE(result.error().message.find(value), std::string::npos) << result.error().message;
    };
    expect_names({Sphere{{0, nan, 0}, 1}, 0.4f}, "Sphere::center", "nan");
    expect_names({Sphere{{0, 0, 0}, 0}, 0.4f}, "Sphere::radius", "0");
    expect_names({Sphere{{0, 0, 0}, inf}, 0.4f}, "Sphere::radius", "inf");
    expect_names({Capsule{{0, inf, 0}, {0, 0, 0}, 1}, 0.4f}, "Capsule::a", "inf");
    expect_names({Capsule{{0, 0, 0}, {0, 0, nan}, 1}, 0.4f}, "Capsule::b", "nan");
    expect_names({Capsule{{0, 0, 0}, {0, 0, 0}, -2}, 0.4f}, "Capsule::radius", "-2");
    expect_names({TaperedCapsule{{0, inf, 0}, {}, 1, 1}, 0.4f}, "TaperedCapsule::a", "inf");
    expect_names({TaperedCapsule{{}, {nan, 0, 0}, 1, 1}, 0.4f}, "TaperedCapsule::b", "nan");
    expect_names({TaperedCapsule{{}, {}, -1, 1}, 0.4f}, "TaperedCapsule::radius_a", "-1");
    expect_names({TaperedCapsule{{}, {}, 1, 2e5f}, 0.4f}, "TaperedCapsule::radius_b", "200000");
    expect_names({Box{{0, nan, 0}}, 0.4f}, "Box::center", "nan");
    expect_names({Box{{}, {0, 0, 0, 0}}, 0.4f}, "Box::rotation", "0");
    expect_names({Box{{}, {nan, 0, 0, 1}}, 0.4f}, "Box::rotation", "nan");
    expect_names({Box{{}, {}, {1, -1, 1}}, 0.4f}, "Box::half_extents", "-1");
    expect_names({Box{{}, {}, {1, 1, nan}}, 0.4f}, "Box::half_extents", "nan");
    EXPECT_TRUE(validate({Box{{1e5f, 0, 0}, {0.5f, -0.5f, 0.5f, 0.5f}, {1e-6f, 1, 1e5f}}, 0.4f}).ok());
    EXPECT_TRUE(validate({TaperedCapsule{{}, {}, 1e-6f, 1e5f}, 0.4f}).ok());
    expect_names({Plane{{0, 0, 0}, 1}, 0.4f}, "Plane::normal", "0");
    expect_names({Plane{{0, nan, 0}, 1}, 0.4f}, "Plane::normal", "nan");
    expect_names({Plane{{0, 1, 0}, -inf}, 0.4f}, "Plane::offset", "-inf");
    expect_names({Sphere{}, -0.5f}, "Collider::friction", "-0.5");

    EXPECT_TRUE(validate({Sphere{}, 0}).ok());
    EXPECT_TRUE(validate({Capsule{}, 0.4f}).ok());  // a == b is a sphere
    EXPECT_TRUE(validate({Plane{{0, 20, 0}, -3}, 2}).ok());
}

TEST(Colliders, ValidateKnowsBothEndsOfEachRange) {
    const auto rejects = [](const Collider& collider, const std::string& value) {
        const Result<void> result = validate(collider);
        return !result.ok() && result.error().message.find(value) != std::string::npos;
    };
    for (const float radius : {1e-39f, 1e-7f, 1.1e5f, 1e30f}) {
        const std::string value = number_text(static_cast<double>(radius));
        EXPECT_TRUE(rejects({Sphere{{}, radius}, 0}, value)) << radius;
        EXPECT_TRUE(rejects({Capsule{{}, {1, 0, 0}, radius}, 0}, value)) << radius;
    }
    for (const float far : {1.1e5f, -1.1e5f, 1e30f}) {
        const std::string value = number_text(static_cast<double>(far));
        EXPECT_TRUE(rejects({Sphere{{0, far, 0}, 1}, 0}, value)) << far;
        EXPECT_TRUE(rejects({Capsule{{far, 0, 0}, {}, 1}, 0}, value)) << far;
        EXPECT_TRUE(rejects({Capsule{{}, {0, 0, far}, 1}, 0}, value)) << far;
        EXPECT_TRUE(rejects({Plane{{0, 1, 0}, far}, 0}, value)) << far;
    }
    for (const float length : {1e-39f, 1e-30f, 1e13f, 3e38f})
        EXPECT_TRUE(rejects({Plane{{0, length, 0}, 0}, 0}, number_text(static_cast<double>(length))));
    EXPECT_TRUE(rejects({Sphere{}, inf}, "inf"));
    EXPECT_TRUE(rejects({Sphere{}, nan}, "nan"));
    EXPECT_TRUE(rejects({Sphere{}, 1.1e6f}, "1100000"));
}

/// Every collider that validate() takes at the ends of its ranges.
std::vector<Collider> extreme_colliders() {
    std::vector<Collider> all;
    for (const float friction : {0.0f, 1e-40f, 1e6f}) {
        for (const float radius : {1e-6f, 0.3f, 1e5f}) {
            for (const Vec3 center : {Vec3{0, 0, 0}, Vec3{1e-40f, 0.1f, 0}, Vec3{1e5f, -1e5f, 1e5f}}) {
                all.push_back({Sphere{center, radius}, friction});
                all.push_back({Capsule{center, center, radius}, friction});
                for (const float axis : {1e-40f, 1e-20f, 1e-7f, 1.0f, 1e5f})
                    all.push_back({Capsule{center, {axis, 0, axis}, radius}, friction});
                for (const float axis : {1e-20f, 0.3f, 1e5f})
                    for (const float other : {1e-6f, 0.31f, 1e5f})
                        all.push_back({TaperedCapsule{center, {axis, 0, axis}, radius, other}, friction});
                for (const Rotation turn : {Rotation{}, Rotation{0.6f, 0, -0.8f, 0}})
                    for (const float other : {1e-6f, 0.3f, 1e5f})
                        all.push_back({Box{center, turn, {radius, other, 0.2f}}, friction});
            }
        }
        for (const float length : {2e-12f, 1.0f, 9e11f})
            for (const float offset : {-1e5f, 1e-40f, 0.1f, 1e5f})
                for (const Vec3 normal : {Vec3{0, length, 0}, Vec3{0, -0.5f * length, 0.5f * length}})
                    all.push_back({Plane{normal, offset}, friction});
    }
    return all;
}

TEST(Colliders, NothingThatIsTakenMakesWhatIsNotFinite) {
    constexpr float fastest = 100;
    const std::vector<Collider> all = extreme_colliders();
    Particles start = cloud(48);
    for (std::size_t i = 0; i < 16; ++i)  // on axes, and all but on them
        start.positions[i] = {i % 4 == 0 ? 0 : 1e-22f * static_cast<float>(i), i % 3 == 0 ? 0.1f : 0, 0, 1};
    std::size_t met = 0;
    for (const Collider& from : all) {
        ASSERT_TRUE(validate(from).ok()) << validate(from).error().message;
        for (const Collider& to : all) {
            if (from.shape.index() != to.shape.index()) continue;
            Particles particles = start;
            const std::vector<ColliderMotion> motions{{from, to, fastest}};
            met += meet(particles, motions, 0.005f);
            for (std::size_t i = 0; i < particles.positions.size(); ++i) {
                ASSERT_TRUE(xyz(particles.positions[i]).allFinite() &&
                            xyz(particles.velocities[i]).allFinite());
                ASSERT_LT(xyz(particles.velocities[i]).norm(), 4 * fastest);
            }
            NearSurfaces near;
            if (!find_near_surfaces(motions, EvenSide(start.positions.size(), 0.005f, 1), h, 0.004f, {},
                                    start.positions, h, start.velocities, near))
                continue;
            for (std::size_t i = 0; i < start.positions.size(); ++i) {
                const Vector3 normal(near.surfaces.x[i], near.surfaces.y[i], near.surfaces.z[i]),
                    motion(near.motions.x[i], near.motions.y[i], near.motions.z[i]);
                ASSERT_TRUE(near.surfaces.w[i] >= 0.004f || std::abs(normal.norm() - 1) < 1e-4f);
                ASSERT_TRUE(std::isfinite(near.surfaces.w[i]) && motion.norm() < 3 * fastest);
            }
        }
    }
    EXPECT_GT(met, 10000u);
}

TEST(Colliders, OneThatJumpsMovesWhatItMeetsNoFasterThanItsFastest) {
    for (const float way : {10.0f, 100.0f, 1000.0f, 1e5f}) {
        for (const ColliderMotion& motion :
             {ColliderMotion{{Sphere{{way, 0, 0}, 1.5f}, 0.4f}, {Sphere{{0, 0, 0}, 1.5f}, 0.4f}, 100},
              ColliderMotion{{Capsule{{way, 0, 0}, {0, 0, way}, 1.5f}, 0.4f},
                             {Capsule{{-1, 0, 0}, {1, 0, 0}, 1.5f}, 0.4f},
                             100},
              ColliderMotion{{Plane{{0, 1, 0}, -way}, 0.4f}, {Plane{{0, 1, 0}, 1}, 0.4f}, 100},
              ColliderMotion{{Plane{{0, -1, 0}, way}, 0.4f}, {Plane{{0, 1, 0}, 1}, 0.4f}, 100}}) {
            const Particles before = cloud(500);
            Particles after = before;
            EXPECT_GT(meet(after, {motion}, 0.005f), 100u);
            for (std::size_t i = 0; i < before.positions.size(); ++i) {
                EXPECT_LE(xyz(after.velocities[i]).norm(), 103) << way;
                // Out of it, and rubbed along by a speed that is no greater.
                EXPECT_LT((xyz(after.positions[i]) - xyz(before.positions[i])).norm(), 3.5f + 103 * h) << way;
            }
        }
    }
}

TEST(Colliders, BlendGoesFromOneToTheOther) {
    const Collider sphere = blend({Sphere{{0, 0, 0}, 1}, 0.2f}, {Sphere{{4, 8, 0}, 3}, 0.6f}, 0.25f);
    EXPECT_FLOAT_EQ(std::get<Sphere>(sphere.shape).center.y, 2);
    EXPECT_FLOAT_EQ(std::get<Sphere>(sphere.shape).radius, 1.5f);
    EXPECT_FLOAT_EQ(sphere.friction, 0.3f);

    const Collider capsule =
        blend({Capsule{{0, 0, 0}, {1, 0, 0}, 1}, 0}, {Capsule{{0, 2, 0}, {3, 0, 0}, 2}, 0}, 0.5f);
    EXPECT_FLOAT_EQ(std::get<Capsule>(capsule.shape).a.y, 1);
    EXPECT_FLOAT_EQ(std::get<Capsule>(capsule.shape).b.x, 2);
    EXPECT_FLOAT_EQ(std::get<Capsule>(capsule.shape).radius, 1.5f);

    const Collider plane = blend({Plane{{0, 5, 0}, 1}, 0}, {Plane{{0.5f, 0, 0}, 3}, 0}, 0.5f);
    EXPECT_NEAR(std::get<Plane>(plane.shape).normal.x, std::sqrt(0.5f), 1e-6f);
    EXPECT_NEAR(std::get<Plane>(plane.shape).normal.y, std::sqrt(0.5f), 1e-6f);
    EXPECT_FLOAT_EQ(std::get<Plane>(plane.shape).offset, 2);

    const Collider tapered = blend({TaperedCapsule{{0, 0, 0}, {1, 0, 0}, 1, 2}, 0},
                                   {TaperedCapsule{{0, 2, 0}, {3, 0, 0}, 3, 6}, 0}, 0.5f);
    EXPECT_FLOAT_EQ(std::get<TaperedCapsule>(tapered.shape).a.y, 1);
    EXPECT_FLOAT_EQ(std::get<TaperedCapsule>(tapered.shape).b.x, 2);
    EXPECT_FLOAT_EQ(std::get<TaperedCapsule>(tapered.shape).radius_a, 2);
    EXPECT_FLOAT_EQ(std::get<TaperedCapsule>(tapered.shape).radius_b, 4);

    // A third of a right angle about y, whichever of its two signs the second quaternion has.
    const float half = std::sqrt(0.5f), sixth = std::sin(0.25f * std::acos(0.0f) / 1.5f);
    for (const float sign : {1.0f, -1.0f}) {
        const Collider box =
            blend({Box{{0, 0, 0}, {}, {1, 1, 1}}, 0},
                  {Box{{3, 0, 0}, {0, sign * half, 0, sign * half}, {1, 4, 1}}, 0}, 1.0f / 3);
        EXPECT_FLOAT_EQ(std::get<Box>(box.shape).center.x, 1);
        EXPECT_NEAR(std::get<Box>(box.shape).rotation.y, sixth, 1e-6f);
        EXPECT_FLOAT_EQ(std::get<Box>(box.shape).half_extents.y, 2);
    }
    const Rotation odd{0.1f, 0.2f, 0.3f, 0.9274f};
    const Collider still = blend({Box{{}, odd}, 0}, {Box{{}, odd}, 0}, 0.37f);
    EXPECT_EQ(std::get<Box>(still.shape).rotation.w, odd.w);  // every byte

    const Collider turned = blend({Plane{{0, 1, 0}, 0}, 0}, {Plane{{0, -1, 0}, 0}, 0}, 0.5f);
    EXPECT_TRUE(validate(turned).ok());
}

}  // namespace
}  // namespace weft::test
