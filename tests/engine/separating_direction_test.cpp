#include "engine/separating_direction.h"

#include <gtest/gtest.h>

namespace weft {
namespace {

TEST(SeparatingDirection, IsAUnitVectorThatFlipsWithThePair) {
    for (std::uint32_t i = 0; i < 200; ++i)
        for (std::uint32_t j = i + 1; j < 200; ++j) {
            const Vector3 d = separating_direction(i, j);
            EXPECT_NEAR(d.norm(), 1.0f, 1e-6f);
            EXPECT_EQ(separating_direction(j, i), Vector3(-d));
        }
}

// A mean of zero and a covariance of I / 3 are what the uniform distribution on the sphere has. With n
// samples the deviations are of the order 1 / sqrt(n) = 0.007; five times that would hardly ever be seen by
// chance.
void expect_spread_over_the_sphere(const auto& directions) {
    const auto n = static_cast<float>(directions.size());
    Vector3 mean = Vector3::Zero();
    Matrix3 covariance = Matrix3::Zero();
    for (const Vector3& d : directions) {
        mean += d / n;
        covariance += d * d.transpose() / n;
    }
    EXPECT_LT(mean.norm(), 0.035f);
    EXPECT_LT((covariance - Matrix3::Identity() / 3).norm(), 0.035f);
}

TEST(SeparatingDirection, SpreadsTheNeighboursOfOneParticle) {
    std::vector<Vector3> directions;
    for (std::uint32_t j = 1; j <= 20000; ++j) directions.push_back(separating_direction(0, j));
    expect_spread_over_the_sphere(directions);
}

TEST(SeparatingDirection, SpreadsPairsOfConsecutiveParticles) {
    std::vector<Vector3> directions;
    for (std::uint32_t i = 0; i < 20000; ++i) directions.push_back(separating_direction(i, i + 1));
    expect_spread_over_the_sphere(directions);
}

}  // namespace
}  // namespace weft
