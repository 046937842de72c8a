#include "collision/contact/response/common_motion.h"

#include <gtest/gtest.h>

#include <cstring>
#include <Eigen/LU>

#include "tests/collision/contact/settle_reference.h"
#include "tests/laid_out.h"

namespace weft::test::common_motion {
namespace {

constexpr float nan = std::numeric_limits<float>::quiet_NaN();

CommonMotion fit(const Rows& positions, const Rows& displacements, std::vector<ParticleRange> group = {},
                 int threads = 1) {
    if (group.empty()) group = {{0, static_cast<std::uint32_t>(positions.size())}};
    Parallel parallel(threads);
    LaidOut<CommonMotionFit> fitting;
    fitting.reserve(positions.size(), group.size());
    return fitting.fit(parallel, group, positions, displacements);
}

Rows moved_by(const Matrix3& map, const Rows& positions, const Vector3& translation = Vector3::Zero()) {
    Rows displacements = positions;
    for (Vec4& d : displacements) set_xyz(d, map * xyz(d) - xyz(d) + translation);
    return displacements;
}

float largest_rest(const CommonMotion& motion, const Rows& positions, const Rows& displacements) {
    float largest = 0;
    for (std::size_t i = 0; i < positions.size(); ++i) {
        largest = std::max(largest, (xyz(displacements[i]) - motion.of(xyz(positions[i]))).norm());
    }
    return largest;
}

Matrix3 turn(float angle) {
    return Eigen::AngleAxisf(angle, Vector3(1, -2, 2) / 3).toRotationMatrix();
}

TEST(CommonMotion, IsFoundWhereItIsAffine) {
    const Rows positions = random_vectors(1000, 1, 1);
    Matrix3 map;
    map << 1.3f, 0.2f, 0, -0.1f, 0.7f, 0.3f, 0.4f, 0, 1.1f;
    for (const Matrix3& m : {map, turn(1.5f), Matrix3(turn(1.2f) * map)}) {
        const Rows wanted = moved_by(m, positions, {3, 4, -5});
        const CommonMotion motion = fit(positions, wanted);
        EXPECT_EQ(motion.kind, CommonMotionKind::affine);
        EXPECT_LT(largest_rest(motion, positions, wanted), 3e-6f);
        EXPECT_LT((motion.inverse * (motion.linear + Matrix3::Identity()) - Matrix3::Identity()).norm(),
                  1e-5f);
    }
}

TEST(CommonMotion, IsTheBestOfAllAffineOnes) {
    const Rows positions = random_vectors(300, 1, 2);
    Rows wanted = moved_by(turn(0.4f), positions, {0, 1, 0});
    const Rows noise = random_vectors(300, 0.3f, 3);
    for (std::size_t i = 0; i < wanted.size(); ++i) set_xyz(wanted[i], xyz(wanted[i]) + xyz(noise[i]));
    const auto squares = [&](const CommonMotion& motion) {
        double sum = 0;
        for (std::size_t i = 0; i < wanted.size(); ++i) {
            sum += (point(wanted[i]) - motion.of(xyz(positions[i])).cast<double>()).squaredNorm();
        }
        return sum;
    };
    const CommonMotion best = fit(positions, wanted);
    for (int entry = 0; entry < 12; ++entry) {
        for (const float change : {-0.01f, 0.01f}) {
            CommonMotion other = best;
            (entry < 9 ? other.linear(entry % 3, entry / 3) : other.translation[entry - 9]) += change;
            EXPECT_LT(squares(best), squares(other));
        }
    }
}

TEST(CommonMotion, OfAFlatSheetGoesAlongWithItsNormal) {
    Rows positions = random_vectors(400, 1, 4);
    for (Vec4& x : positions) x.z = 0;
    const Matrix3 quarter = Eigen::AngleAxisf(1.5707963f, Vector3(1, 0, 0)).toRotationMatrix();
    const Rows wanted = moved_by(quarter, positions);
    const CommonMotion motion = fit(positions, wanted);
    EXPECT_EQ(motion.kind, CommonMotionKind::affine);
    EXPECT_LT((motion.linear + Matrix3::Identity() - quarter).norm(), 1e-5f);
}

TEST(CommonMotion, DoesNotTurnInsideOutAndDoesNotFlatten) {
    const Rows positions = random_vectors(500, 1, 5);
    for (const float scale : {-1.0f, 0.0f, 0.2f, 4.0f}) {
        Matrix3 map = turn(0.5f);
        map.col(1) *= scale;
        const CommonMotion motion = fit(positions, moved_by(map, positions, {1, 2, 3}));
        // A mirror's nearest turn is a half-turn.
        EXPECT_EQ(motion.kind, scale < 0 ? CommonMotionKind::translation : CommonMotionKind::rigid) << scale;
        const Matrix3 rotation = motion.linear + Matrix3::Identity();
        EXPECT_LT((rotation * rotation.transpose() - Matrix3::Identity()).norm(), 1e-5f);
        EXPECT_GT(rotation.determinant(), 0);
    }
}

// Sheets that have passed through one another look as if they had turned so.
TEST(CommonMotion, HasNoTurnOfMoreThanAQuarter) {
    const Rows positions = random_vectors(500, 1, 9);
    for (const float angle : {1.7f, 2.5f, 3.14f}) {
        const CommonMotion motion = fit(positions, moved_by(turn(angle), positions, {1, 2, 3}));
        EXPECT_EQ(motion.kind, CommonMotionKind::translation) << angle;
    }
}

TEST(CommonMotion, OfFewParticlesOrALineIsTheirMean) {
    for (const std::size_t n : {1u, 2u, 5u}) {
        Rows positions(n), wanted(n);
        for (std::size_t i = 0; i < n; ++i) {
            positions[i] = {0.5f * static_cast<float>(i), 1, 2, 1};
            wanted[i] = {0, static_cast<float>(i), 1, 0};
        }
        const CommonMotion motion = fit(positions, wanted);
        EXPECT_EQ(motion.kind, CommonMotionKind::translation);
        EXPECT_EQ(motion.linear, Matrix3::Zero());
        EXPECT_NEAR(motion.translation.y(), 0.5f * static_cast<float>(n - 1), 1e-6f);
    }
    EXPECT_EQ(fit({}, {}).kind, CommonMotionKind::none);
}

TEST(CommonMotion, LeavesOutWhatIsNotFinite) {
    Rows positions = random_vectors(100, 1, 6), wanted = moved_by(turn(0.3f), positions);
    positions[0].y = nan;
    wanted[50].x = std::numeric_limits<float>::infinity();
    const CommonMotion motion = fit(positions, wanted);
    EXPECT_EQ(motion.kind, CommonMotionKind::affine);
    EXPECT_LT((motion.linear + Matrix3::Identity() - turn(0.3f)).norm(), 1e-5f);
    for (Vec4& d : wanted) d.x = nan;
    EXPECT_EQ(fit(positions, wanted).kind, CommonMotionKind::none);
}

TEST(CommonMotion, IsThatOfItsRangesWhateverTheThreads) {
    const Rows positions = random_vectors(3000, 1, 7);
    Rows wanted = random_vectors(3000, 5, 8);
    const std::vector<ParticleRange> group{{100, 700}, {1000, 0}, {1500, 900}};
    const Rows shared = moved_by(turn(1), positions, {1, 1, 1});
    for (const ParticleRange& range : group) {
        std::copy_n(shared.begin() + range.first, range.count, wanted.begin() + range.first);
    }
    const CommonMotion one = fit(positions, wanted, group), four = fit(positions, wanted, group, 4);
    EXPECT_LT((one.linear + Matrix3::Identity() - turn(1)).norm(), 1e-5f);
    EXPECT_EQ(one.linear, four.linear);
    EXPECT_EQ(one.translation, four.translation);

    Parallel parallel(2);
    Rows relative(3000, Vec4{9, 9, 9, 9});
    take_out(parallel, one, group, positions, wanted, relative);
    EXPECT_EQ(relative[99].x, 9);
    EXPECT_EQ(relative[800].x, 9);
    for (const std::uint32_t i : {100u, 799u, 1500u, 2399u}) {
        EXPECT_LT(xyz(relative[i]).norm(), 1e-5f);
        EXPECT_EQ(relative[i].w, 9);
    }
    EXPECT_EQ(relative[2400].x, 9);
}

TEST(CommonMotion, GivenBackMakesTheImageOfWhereTheParticleWent) {
    const Rows positions = random_vectors(50, 1, 9), wanted = random_vectors(50, 0.5f, 10);
    const CommonMotion motion = fit(positions, wanted);
    Rows relative(50);
    Parallel parallel(1);
    const ParticleRange all{0, 50};
    take_out(parallel, motion, {&all, 1}, positions, wanted, relative);
    for (const float tau : {0.0f, 0.3f, 0.9f}) {
        for (std::size_t i = 0; i < 50; ++i) {
            const Vector3 x = xyz(positions[i]), y = x + tau * xyz(relative[i]);
            const Vector3 image = y + motion.of(y);
            EXPECT_LT((x + give_back(motion, x, xyz(wanted[i]), tau) - image).norm(), 2e-6f);
        }
    }
    EXPECT_EQ(give_back(motion, xyz(positions[0]), xyz(wanted[0]), 1), xyz(wanted[0]));
    EXPECT_TRUE(give_back(motion, xyz(positions[0]), Vector3::Constant(nan), 0).allFinite());
}

}  // namespace
}  // namespace weft::test::common_motion
