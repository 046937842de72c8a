// Along which normal a pair is kept apart that moves: of its closest points, or one that serves it longer.

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstring>
#include <random>
#include <vector>

#include "collision/contact/pairs/pair_kernels.h"
#include "tests/collision/contact/contact_reference.h"

namespace weft::test::pair_shapes {
namespace {

using Points = std::array<Vector3d, 4>;

/// Corners 0 to 3, and where they go.
struct Case {
    std::vector<Vec4> positions, motions;

    Case(const Points& from, const Points& to) {
        for (std::size_t k = 0; k < 4; ++k) {
            positions.push_back(to_vec4(from[k].cast<float>(), 0));
            motions.push_back(to_vec4((to[k] - from[k]).cast<float>(), 0));
        }
    }
    [[nodiscard]] PairShape shape(bool vertex_triangle, bool moves = true) const {
        const FeaturePair pair{{0, 1, 2, 3}};
        PairShape shape;
        shape_pairs(positions.data(), vertex_triangle, {&pair, 1}, &shape);
        if (moves) shape_moving_pairs(positions.data(), motions.data(), vertex_triangle, {&pair, 1}, &shape);
        return shape;
    }
    [[nodiscard]] EndGaps gaps(const PairShape& shape, bool vertex_triangle) const {
        return {in_double(shape.normal), {0, 1, 2, 3}, vertex_triangle ? 1u : 2u, positions, motions};
    }
};

/// A triangle in the plane y = 0 whose side x = 0 a vertex comes from, `height` above the plane.
Case sliding(double from, double to, double height, double end_height) {
    const Vector3d a(0, 0, 0), b(0, 0, 1), c(1, 0, 0.5);
    return {{Vector3d(from, height, 0.5), a, b, c}, {Vector3d(to, end_height, 0.5), a, b, c}};
}

TEST(PairShapes, AVertexThatSlidesOverATriangleIsKeptAboveIt) {
    const PairShape shape = sliding(-1, 0.5, 0.1, 0.1).shape(true);
    EXPECT_NEAR(std::abs(shape.normal.y), 1, 1e-6);
    EXPECT_NEAR(shape.normal.w, 0.1f, 1e-6f);
    EXPECT_FALSE(shape.is_at_border());
    EXPECT_GT(sliding(-1, 0.5, 0.1, 0.1).shape(true, false).normal.w, 0.9f);
}

// The vertex is above the triangle on its way, and at neither end.
TEST(PairShapes, WhatPassesOverABorderIsKeptAboveIt) {
    const Case over = sliding(-0.4, 1.3, 0.2, 0.2);
    EXPECT_LT(over.gaps(over.shape(true, false), true).end, 0);
    EXPECT_GT(over.gaps(over.shape(true), true).least(), 0.1);

    const Vector3d p(0, 0.2, 0), q(0, 0.2, 1);  // beside an edge that is parallel to it
    const Case rolling({p, q, {0.5, 0, 0.2}, {0.5, 0, 0.8}}, {p, q, {-0.4, 0, 0.2}, {-0.4, 0, 0.8}});
    EXPECT_LT(rolling.gaps(rolling.shape(false, false), false).end, 0);
    EXPECT_GT(rolling.gaps(rolling.shape(false), false).least(), 0.1);
}

TEST(PairShapes, WhatGoesThroughATriangleKeepsItsNormal) {
    const Case through = sliding(-0.1, 0.5, 0.2, -0.2);
    const PairShape shape = through.shape(true), still = through.shape(true, false);
    EXPECT_EQ(std::memcmp(&shape, &still, sizeof shape), 0);
}

TEST(PairShapes, AreOfTheStartUnlessAnotherNormalServesLonger) {
    std::mt19937 random(5);
    std::uniform_real_distribution<double> uniform(-1, 1);
    const auto points = [&] {
        Points all;
        for (Vector3d& x : all) x = {uniform(random), uniform(random), uniform(random)};
        return all;
    };
    int changed[2] = {}, inner = 0;
    for (int k = 0; k < 20000; ++k) {
        const bool vertex_triangle = k % 2 == 0;
        const Case moving(points(), points());
        const PairShape still = moving.shape(vertex_triangle, false), shape = moving.shape(vertex_triangle);
        if (std::memcmp(&shape, &still, sizeof shape) == 0) continue;
        ++changed[vertex_triangle];
        inner += still.is_at_border() ? 0 : 1;
        const EndGaps gaps = moving.gaps(shape, vertex_triangle);
        EXPECT_GT(gaps.least(), std::max(moving.gaps(still, vertex_triangle).least(), 0.0) - 1e-6);
        EXPECT_NEAR(double{shape.normal.w}, gaps.start, 1e-5);
    }
    EXPECT_EQ(inner, 0);
    EXPECT_GT(changed[0], 1000);
    EXPECT_GT(changed[1], 1000);
}

}  // namespace
}  // namespace weft::test::pair_shapes
