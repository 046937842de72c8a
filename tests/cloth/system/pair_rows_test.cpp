// Pairs as rows of the implicit equation, against a dense matrix in double precision.

#include "cloth/equation/pairs/pair_rows.h"
#include "collision/contact/response/leverage.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <vector>

#include "tests/cloth/as_for_threads.h"
#include "tests/cloth/fixtures.h"
#include "tests/cloth/system/dense_algebra.h"
#include "tests/cloth/system/pair_scene.h"

namespace weft::test::pair_rows {
namespace {

using Vector3d = Eigen::Vector3d;
using Matrix3d = Eigen::Matrix3d;

constexpr double spring_per_mass = 50, onset_per_radius = 0.1, stick_per_spring = 10, hard_from = 0.5,
                 hard_per_spring = 30;

Vector3d exact(const Vec4& v) {
    return xyz(v).cast<double>();
}

double weight(const PairShape& shape, std::size_t corner) {
    return static_cast<double>((&shape.weights.x)[corner]);
}

/// What PairRows says that it computes.
struct Reference {
    Eigen::MatrixXd matrix;  // rows of pinned particles are 0; their columns are not
    Eigen::VectorXd impulses;
    std::uint32_t pushing = 0;

    explicit Reference(const PairScene& scene)
        : matrix(Eigen::MatrixXd::Zero(size(scene), size(scene))),
          impulses(Eigen::VectorXd::Zero(size(scene))) {
        for (std::uint32_t k = 0; k < scene.pairs.size; ++k) add(scene, k);
    }

  private:
    static Eigen::Index size(const PairScene& scene) {
        return 3 * static_cast<Eigen::Index>(scene.positions.size());
    }

    void add(const PairScene& scene, std::uint32_t k) {
        const auto& corners = scene.pairs.pairs[k].corners;
        const PairShape& shape = scene.pairs.shapes[k];
        const Vector3d n = exact(shape.normal);
        Vector3d gap = Vector3d::Zero(), u = Vector3d::Zero();
        std::array<float, 4> inverse_masses{}, weights{};
        for (std::size_t c = 0; c < 4; ++c) {
            const double b = weight(shape, c);
            gap += b * exact(scene.positions[corners[c]]);
            u += b * exact(scene.velocities[corners[c]]);
            weights[c] = (&shape.weights.x)[c];
            inverse_masses[c] = scene.positions[corners[c]].w;
        }
        const double mobility = static_cast<double>(mobility_of_gap(inverse_masses, weights));
        const double radius = static_cast<double>(scene.laws[k].radius), h = static_cast<double>(pair_gamma);
        const double friction = static_cast<double>(scene.laws[k].friction);
        const double depth = radius - n.dot(gap) - h * n.dot(u);
        if (radius == 0 || mobility == 0 || !(depth > 0)) return;
        ++pushing;
        const double full = spring_per_mass / mobility, onset = onset_per_radius * radius;
        const double deep = std::max(0.0, depth - hard_from * radius);
        const double soft = full * std::min(depth / onset, 1.0),
                     hard = hard_per_spring * full * std::min(deep / onset, 1.0), spring = soft + hard;
        const double pressed =
            (soft * (depth - std::min(depth, onset) / 2) + hard * (deep - std::min(deep, onset) / 2)) / h;
        const Vector3d sliding = u - n.dot(u) * n;
        const double damper =
            friction == 0 ? 0 : std::min(stick_per_spring * full, friction * pressed / sliding.norm());
        const Matrix3d along = n * n.transpose();
        const Matrix3d stiffness = spring * along + damper * (Matrix3d::Identity() - along);
        for (std::size_t c = 0; c < 4; ++c) {
            if (scene.positions[corners[c]].w == 0) continue;
            const auto i = 3 * static_cast<Eigen::Index>(corners[c]);
            impulses.segment<3>(i) += weight(shape, c) * (pressed * n - damper * sliding);
            for (std::size_t other = 0; other < 4; ++other)
                matrix.block<3, 3>(i, 3 * static_cast<Eigen::Index>(corners[other])) +=
                    weight(shape, c) * weight(shape, other) * stiffness;
        }
    }
};

TEST(PairRows, AreThoseOfADenseMatrix) {
    const PairScene scene(61, 333);
    const Reference reference(scene);
    ASSERT_GT(reference.pushing, 50u);
    ASSERT_LT(reference.pushing, 250u);
    Linearised linearised(scene);
    const Eigen::VectorXd impulses = flat(linearised.impulses(scene.positions.size()));
    EXPECT_LT((impulses - reference.impulses).norm(), 1e-4 * reference.impulses.norm());

    std::uint32_t pushing = 0;
    linearised.rows.for_each_active([&](const PairRows::ActivePair& active) {
        EXPECT_GT(active.spring, 0);
        ++pushing;
    });
    EXPECT_EQ(pushing, reference.pushing);

    std::vector<Vec4> product(scene.positions.size(), Vec4{1, 2, 3, 0});
    const Eigen::VectorXd before = flat(product), x = flat(scene.velocities);
    const double sum = linearised.multiply(scene.velocities, product);
    const Eigen::VectorXd expected = reference.matrix * x;
    EXPECT_LT((flat(product) - before - expected).norm(), 1e-4 * expected.norm());
    const PairScene free(61, 333, 1000);  // where no rows are left out, x . C x is that of the matrix
    const Reference of_free(free);
    Linearised of_free_rows(free);
    // Its first particle is pinned: still, it has no part in the product of rows.
    std::vector<Vec4> still = free.velocities;
    still[0] = {};
    const Eigen::VectorXd y = flat(still);
    const double exact_sum = y.dot(of_free.matrix * y);
    EXPECT_NEAR(of_free_rows.multiply(still, product), exact_sum, 1e-4 * exact_sum);
    EXPECT_GT(sum, 0);
}

TEST(PairRows, OfOneClothAreThoseThatPushItsFreeParticles) {
    const PairScene scene(61, 333);
    Linearised linearised(scene);
    std::vector<const FeaturePair*> seen;
    const auto see = [&](std::uint32_t row) { seen.push_back(&linearised.rows.active_pair(row).pair); };
    for (const auto& [first, count] : {std::pair(0u, 61u), {0, 17}, {17, 30}, {47, 14}, {7, 1}, {20, 0}}) {
        std::vector<const FeaturePair*> expected;
        linearised.rows.for_each_active([&](const PairRows::ActivePair& active) {
            if (std::ranges::any_of(active.pair.corners, [&](std::uint32_t i) {
                    return i >= first && i < first + count && scene.positions[i].w > 0;
                }))
                expected.push_back(&active.pair);
        });
        seen.clear();
        linearised.rows.for_each_active_row_of(first, count, see);
        EXPECT_EQ(seen, expected) << first << " " << count;
        EXPECT_EQ(seen.empty(), count < 2) << "each cloth but the last two has some";
    }
}

TEST(PairRows, AreOfTheFirstPairsThatThereIsRoomFor) {
    constexpr std::uint32_t particles = 61, count = 5000;  // in several blocks
    const PairScene scene(particles, count);
    const auto active_of = [](const Linearised& linearised) {
        std::vector<const FeaturePair*> active;
        linearised.rows.for_each_active([&](const PairRows::ActivePair& of) { active.push_back(&of.pair); });
        return active;
    };
    const std::vector<const FeaturePair*> all = active_of(Linearised(scene));
    for (const std::size_t room : {std::size_t{1}, std::size_t{16}, std::size_t{1001}, std::size_t{count}}) {
        const std::vector<const FeaturePair*> some = active_of(Linearised(scene, 2, room));
        ASSERT_LE(some.size(), std::min(room, all.size()));
        EXPECT_TRUE(std::ranges::equal(some, std::span(all).first(some.size()))) << room;
        EXPECT_FALSE(some.empty()) << room;
    }
}

TEST(PairRows, AreSymmetricAndKeepMomentum) {
    PairScene scene(24, 120, 1000);
    scene.positions[0].w = 200;  // none is pinned
    Linearised linearised(scene);
    const std::size_t count = scene.positions.size();
    Eigen::MatrixXd matrix(3 * count, 3 * count);
    for (std::size_t i = 0; i < 3 * count; ++i) {
        std::vector<Vec4> unit(count), product(count);
        (&unit[i / 3].x)[i % 3] = 1;
        linearised.multiply(unit, product);
        matrix.col(static_cast<Eigen::Index>(i)) = flat(product);
    }
    EXPECT_LT((matrix - matrix.transpose()).norm(), 1e-6 * matrix.norm());
    EXPECT_LT((matrix - Reference(scene).matrix).norm(), 1e-4 * matrix.norm());

    // A block of the diagonal stands for the row where a relaxation knows no other particle.
    linearised.rows.for_each_particle(0, 24, [&](const PairRows::AtParticle& at) {
        const Eigen::Index i = 3 * static_cast<Eigen::Index>(at.particle);
        const Matrix3d more = at.diagonal.full() - Matrix3d(matrix.block<3, 3>(i, i));
        EXPECT_GT(eigenvalues(more)[0], -1e-5 * matrix.norm());
    });
    Vector3d sum = Vector3d::Zero();
    double size = 0;
    for (const Vec4& impulse : linearised.impulses(count)) {
        sum += exact(impulse);
        size += exact(impulse).norm();
    }
    EXPECT_LT(sum.norm(), 1e-6 * size);
}

TEST(PairRows, LeavePinnedParticlesAlone) {
    const PairScene scene(61, 333);
    Linearised linearised(scene);
    std::vector<Vec4> product(scene.positions.size());
    linearised.multiply(scene.velocities, product);
    for (std::size_t i = 0; i < product.size(); ++i)
        EXPECT_TRUE(scene.positions[i].w > 0 || xyz(product[i]).isZero(0));
    linearised.rows.for_each_particle(
        0, 61, [&](const PairRows::AtParticle& at) { EXPECT_GT(scene.positions[at.particle].w, 0); });
}

TEST(PairRows, AreEmptyWithoutPairsThatHaveARadius) {
    PairScene scene(20, 50);
    std::ranges::fill(scene.laws, PairLaw{.radius = 0, .friction = 1});
    Linearised linearised(scene);
    EXPECT_TRUE(linearised.rows.empty());
    std::vector<Vec4> product(scene.positions.size());
    EXPECT_EQ(linearised.multiply(scene.velocities, product), 0);
}

}  // namespace
}  // namespace weft::test::pair_rows
