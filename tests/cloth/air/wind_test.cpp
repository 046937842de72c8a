// Air forces against flat-plate formulas, and the gusts' statistics.

#include "cloth/air/wind.h"

#include <gtest/gtest.h>

#include <random>

#include "cloth/air/gusts.h"
#include "tests/cloth/fixtures.h"
#include "tests/cloth/material/plate_force.h"

namespace weft::test {
namespace {

constexpr Wind plain{.velocity = {}, .air_density = 1.2f, .drag = 1.1f, .lift = 0.7f};

Vector3 random_vector(std::mt19937& random) {
    std::normal_distribution<float> component;
    return {component(random), component(random), component(random)};
}

TEST(PlateForce, HeadOnIsDynamicPressureTimesAreaAndDrag) {
    const PlateForce plate = plate_force({0, 0, 5}, {0, 0, 0.2f}, plain);
    EXPECT_NEAR(plate.force.z(), 0.5f * 1.2f * 5 * 5 * 0.2f * 1.1f, 1e-5f);
    EXPECT_LT(plate.force.head<2>().norm(), 1e-6f);
}

TEST(PlateForce, At45DegreesSplitsIntoDragAlongAndLiftAcrossTheStream) {
    const Vector3 stream = Vector3(1, 0, 1).normalized();
    const PlateForce plate = plate_force(4 * stream, {0, 0, 0.5f}, plain);
    const float half_pressure_area = 0.5f * 1.2f * 16 * 0.5f * std::sqrt(0.5f);
    EXPECT_NEAR(plate.force.dot(stream), half_pressure_area * 1.1f, 1e-5f);
    EXPECT_NEAR(plate.force.dot(Vector3(-1, 0, 1).normalized()), half_pressure_area * 0.7f * std::sqrt(0.5f),
                1e-5f);
}

TEST(PlateForce, VanishesEdgeOnAndDoesNotJumpThere) {
    EXPECT_LT(plate_force({3, 0, 0}, {0, 1, 0}, plain).force.norm(), 1e-6f);
    const Vector3 above = plate_force({3, 1e-3f, 0}, {0, 1, 0}, plain).force;
    const Vector3 below = plate_force({3, -1e-3f, 0}, {0, 1, 0}, plain).force;
    EXPECT_LT((above - below).norm(), 0.02f);
}

TEST(PlateForce, SlopeBoundsTheRateOfChange) {
    std::mt19937 random(4);
    for (int k = 0; k < 500; ++k) {
        const Vector3 u = 5 * random_vector(random), n = random_vector(random);
        const PlateForce plate = plate_force(u, n, plain);
        const float step = 1e-3f * u.norm();
        const Vector3 e = step * random_vector(random).normalized();
        const float rate =
            (plate_force(u + e, n, plain).force - plate_force(u - e, n, plain).force).norm() / (2 * step);
        EXPECT_LE(rate, 1.01f * plate.slope) << u.transpose() << " on " << n.transpose();
    }
}

TEST(AirForces, AddUpAndScaleWithRelativeVelocity) {
    Cloth cloth = crumpled(sheet(6, 6), 0.02f, 10);
    for (Vec4& v : cloth.state.velocities.span()) v = {0, -2, 0, 0};
    Parallel serial(1);
    AlignedBuffer<Vec4> forces(cloth.model.particle_count);
    const auto blow = [&](const Wind& wind) {
        cloth.surface.compute_air_forces(serial,
                                         {.wind = &wind,
                                          .air_velocities = {},
                                          .positions = cloth.state.positions.span(),
                                          .velocities = cloth.state.velocities.span(),
                                          .from_velocities = cloth.state.velocities.span()},
                                         false, forces.span());
    };
    blow(plain);
    Vector3 total = Vector3::Zero();
    for (const Vec4& force : forces.span()) total += xyz(force);
    // A sheet of 1 m^2 that falls flat at 2 m/s: drag upward, close to 1/2 rho v^2 A Cd.
    EXPECT_NEAR(total.y(), 0.5f * 1.2f * 4 * 1.1f, 0.15f);

    Wind carried = plain;
    carried.velocity = {0, -2, 0};
    blow(carried);
    for (const Vec4& force : forces.span()) EXPECT_EQ(xyz(force), Vector3(0, 0, 0));
}

Vector3 velocity_at(const WindField& field, const Vector3& point) {
    Parallel serial(1);
    AlignedBuffer<Vec4> points(1), velocities(1);
    points[0] = to_vec4(point, 0);
    field.sample(serial, points.span(), velocities.span());
    return xyz(velocities[0]);
}

class Gusts : public testing::Test {
  protected:
    static constexpr Wind gusty{.velocity = {6, 0, 0}, .gust = 0.4f, .gust_length = 0.8f};
};

TEST_F(Gusts, HaveTheStatedStrengthAndNoMean) {
    Eigen::Vector3d sum = Eigen::Vector3d::Zero(), squares = Eigen::Vector3d::Zero();
    int samples = 0;
    std::mt19937 random(5);
    std::uniform_real_distribution<float> place(-40, 40);
    const WindField field(gusty, {12.5, 0, 3}, 2.0);
    for (; samples < 40000; ++samples) {
        const Eigen::Vector3d gust =
            (velocity_at(field, Vector3{place(random), place(random), place(random)}) - Vector3(6, 0, 0))
                .cast<double>();
        sum += gust;
        squares += gust.cwiseAbs2();
    }
    const double stated = 0.4 * 6;
    for (int axis = 0; axis < 3; ++axis) {
        EXPECT_NEAR(sum[axis] / samples, 0, 0.03 * stated);
        EXPECT_NEAR(std::sqrt(squares[axis] / samples), stated, 0.05 * stated);
    }
}

TEST_F(Gusts, AreCarriedByTheMeanWind) {
    // Taylor's hypothesis, up to the slow drift of the octaves across it.
    const WindField now(gusty, {}, 0), soon(gusty, {6 * 0.1, 0, 0}, 0.1);
    float carried = 0, standing = 0;
    for (int k = 0; k < 200; ++k) {
        const Vector3 here{0.37f * static_cast<float>(k), 1, 0.1f * static_cast<float>(k)};
        carried += (velocity_at(now, here) - velocity_at(soon, here + Vector3(0.6f, 0, 0))).norm();
        standing += (velocity_at(now, here) - velocity_at(soon, here)).norm();
    }
    EXPECT_LT(carried, 0.3f * standing);
}

TEST_F(Gusts, AreContinuousAcrossLatticeCellsAndOverDays) {
    for (const double day : {0.0, 1e5, 1e7}) {
        const WindField field(gusty, {6 * day, 0, 0}, day), next(gusty, {6 * (day + 1e-3), 0, 0}, day + 1e-3);
        for (int k = 0; k < 400; ++k) {
            const Vector3 here{0.02f * static_cast<float>(k), 0.4f, 0.8f};
            EXPECT_LT((velocity_at(field, here) - velocity_at(field, here + Vector3(1e-4f, 0, 0))).norm(),
                      0.01f);
            EXPECT_LT((velocity_at(field, here) - velocity_at(next, here)).norm(), 0.2f)
                << "after " << day << " s";
        }
    }
}

TEST_F(Gusts, OtherSeedsOtherGusts) {
    Wind other = gusty;
    other.seed = 2;
    EXPECT_NE(velocity_at(WindField(gusty, {}, 0), {0.3f, 1, 0.2f}),
              velocity_at(WindField(other, {}, 0), {0.3f, 1, 0.2f}));
    EXPECT_EQ(velocity_at(WindField(gusty, {}, 0), {0.3f, 1, 0.2f}),
              velocity_at(WindField(gusty, {}, 0), {0.3f, 1, 0.2f}));
}

}  // namespace
}  // namespace weft::test
