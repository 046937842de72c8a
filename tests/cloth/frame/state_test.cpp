// Normals against analytic surfaces, and the survey against a plain loop and against what must not pass it.

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "cloth/motion/survey.h"
#include "tests/cloth/fixtures.h"
#include "tests/cloth/meshes.h"

namespace weft::test {
namespace {

void update_normals(Cloth& cloth) {
    Parallel serial(1);
    cloth.surface.compute_normals(serial, cloth.state.positions.span(), cloth.state.normals.span());
}

TEST(Normals, OfASphereAreRadial) {
    Cloth cloth(cook(sphere(3)).value(), {});
    update_normals(cloth);
    for (std::uint32_t i = 0; i < cloth.state.size(); ++i) {
        const Vector3 radial = xyz(cloth.state.positions[i]).normalized();
        EXPECT_GT(xyz(cloth.state.normals[i]).dot(radial), 0.999f) << "particle " << i;
        EXPECT_NEAR(xyz(cloth.state.normals[i]).norm(), 1, 1e-6f);
    }
}

TEST(Normals, OfACollapsedClothAreStillUnitVectors) {
    Cloth cloth(cook(sheet(4, 4)).value(), {});
    for (Vec4& x : cloth.state.positions.span()) x = {1, 2, 3, x.w};
    update_normals(cloth);
    for (const Vec4& n : cloth.state.normals.span()) EXPECT_EQ(xyz(n), Vector3(0, 1, 0));
}

class SurveyTest : public testing::Test {
  protected:
    SurveyTest() : cloth(crumpled(sheet(40, 40), 0.1f, 10)) {}
    Survey look() {
        Parallel serial(1);
        return survey(serial, cloth.state, cloth.partial_surveys.span());
    }
    Cloth cloth;
};

TEST_F(SurveyTest, FindsExtentAndPeakSpeed) {
    expect_like(look(), plain_survey(cloth.state));
}

TEST_F(SurveyTest, OneBadNumberAnywhereIsSeen) {
    constexpr float bad[] = {std::numeric_limits<float>::quiet_NaN(), std::numeric_limits<float>::infinity(),
                             -2e5f};
    for (const float value : bad) {
        for (const std::uint32_t i : {0u, 255u, 256u, 1599u}) {
            for (float Vec4::*component : {&Vec4::x, &Vec4::y, &Vec4::z}) {
                float& coordinate = cloth.state.positions[i].*component;
                const float good = std::exchange(coordinate, value);
                EXPECT_FALSE(look().sound) << value << " at " << i;
                coordinate = good;
            }
        }
    }
    cloth.state.velocities[700].z = std::numeric_limits<float>::quiet_NaN();
    EXPECT_FALSE(look().sound);
}

}  // namespace
}  // namespace weft::test
