#include "collision/contact/response/settle.h"

#include <gtest/gtest.h>

#include <cstring>

#include "tests/collision/contact/settle_reference.h"
#include "tests/laid_out.h"

namespace weft::test {
namespace {

constexpr float not_a_number = std::numeric_limits<float>::quiet_NaN();
constexpr TruncationSettings settings{1e-4f, 30};

struct Settled {
    Rows displacements, relative;
    std::vector<float> fractions;
    SettleResult result;
};

Settled settle(const Triangles& mesh, const PairList& pairs, Rows displacements, int threads = 1,
               const TruncationSettings& how = settings, std::span<const std::uint8_t> exempt = {},
               bool is_pinned = false, CommonMotionKind most = CommonMotionKind::affine) {
    Parallel parallel(threads);
    LaidOut<Settler> settler;
    settler.reserve(mesh.positions.size(), 1, pairs.size);
    const ParticleRange all{0, mesh.size()};
    const BodyGroup group{.particles = {&all, 1}, .positions = mesh.positions, .is_pinned = is_pinned};
    settler.split(parallel, group, displacements, most);
    Settled settled;
    settled.relative.assign(settler.relative().begin(), settler.relative().end());
    settled.result = settler.settle(parallel, group, pairs, exempt, how, displacements);
    settled.fractions.assign(settler.fractions().begin(), settler.fractions().end());
    settled.displacements = std::move(displacements);
    return settled;
}

/// Crossings at 32 times of the motion in its frame, and at the end as rounded.
int crossings_on_the_way(const Triangles& mesh, const Settled& settled) {
    int count = crossings(mesh, points(ends_of(mesh.positions, settled.displacements)));
    for (int step = 1; step <= 32; ++step) {
        Points x = points(mesh.positions);
        for (std::size_t i = 0; i < x.size(); ++i) {
            x[i] += step / 32.0 * double{settled.fractions[i]} * point(settled.relative[i]);
        }
        count += crossings(mesh, x);
    }
    return count;
}

double gap_along_normal(const PairList& pairs, std::uint32_t k, const Points& x) {
    const Point normal = point(pairs.shapes[k].normal);
    double a = 1e30, b = -1e30;
    for (std::uint32_t i = 0; i < 4; ++i) {
        const double value = normal.dot(x[pairs.pairs[k].corners[i]] - x[pairs.pairs[k].corners[0]]);
        if (i < pairs.corners_of_a(k)) a = std::min(a, value);
        if (i >= pairs.corners_of_a(k)) b = std::max(b, value);
    }
    return a - b;
}

/// The least of gap at the end over the gap that must be kept, in the frame of the common motion.
double least_gap_kept(const Triangles& mesh, const PairList& pairs, const Settled& settled, double floor) {
    const Points start = points(mesh.positions);
    Points end = start;
    for (std::size_t i = 0; i < end.size(); ++i) {
        end[i] += double{settled.fractions[i]} * point(settled.relative[i]);
    }
    double least = 1e30;
    for (std::uint32_t k = 0; k < pairs.size; ++k) {
        const double kept = std::min(floor, gap_along_normal(pairs, k, start));
        if (kept > 1e-7) least = std::min(least, gap_along_normal(pairs, k, end) / kept);
    }
    return least;
}

/// A triangle in the plane y = 0, and a vertex `above` its middle that a far triangle belongs to.
Triangles vertex_above_triangle(float above) {
    return {{{-1, 0, -1, 1}, {1, 0, -1, 1}, {0, 0, 1, 1}, {0, above, 0, 1}, {-1, 5, 0, 1}, {1, 5, 0, 1}},
            {{0, 1, 2}, {3, 4, 5}}};
}

/// The fractions alone, without the common motion and without a look at what rounding does.
struct Cut {
    std::vector<float> fractions;
    std::uint32_t sweeps, standing;
};
Cut cut(const Triangles& mesh, const PairList& pairs, const Rows& motions,
        const TruncationSettings& how = settings) {
    Parallel parallel(1);
    LaidOut<Truncation> truncation;
    truncation.reserve(mesh.size(), pairs.size);
    truncation.cut(parallel, mesh.positions, motions, pairs, {}, how);
    const auto fractions = truncation.fractions();
    return {{fractions.begin(), fractions.end()},
            truncation.sweeps(),
            truncation.standing_planes(parallel, pairs)};
}

TEST(Settle, TheCertificateHoldsBeforeRoundingIsLookedAt) {
    for (unsigned seed = 0; seed < 4; ++seed) {
        const Triangles mesh = triangle_soup(60, 0.5f, seed);
        const LaidOut<PairList> pairs = all_pairs(mesh);
        Rows motions = random_vectors(mesh.size(), 0.02f, seed + 50);
        Settled settled{{}, motions, cut(mesh, pairs, motions).fractions, {}};
        EXPECT_GT(least_gap_kept(mesh, pairs, settled, 1e-4), 0.98) << seed;
        motions[5].z = not_a_number;
        EXPECT_EQ(cut(mesh, pairs, motions).fractions[5], 0.0f);
    }
}

TEST(Settle, RandomTrianglesCrossNothingOnTheirWay) {
    int wished = 0;
    for (unsigned seed = 0; seed < 8; ++seed) {
        Triangles mesh = triangle_soup(60, 0.5f, seed);
        const LaidOut<PairList> pairs = all_pairs(mesh);
        for (std::uint32_t i = 0; i < mesh.size(); i += 7) mesh.positions[i].w = 0;
        for (const float size : {0.02f, 0.3f, 3.0f}) {
            const Rows wanted = random_vectors(mesh.size(), size, seed + 100);
            wished += crossings(mesh, points(ends_of(mesh.positions, wanted))) > 0 ? 1 : 0;
            const Settled settled = settle(mesh, pairs, wanted);
            EXPECT_EQ(crossings_on_the_way(mesh, settled), 0) << seed << ' ' << size;
            EXPECT_GT(least_gap_kept(mesh, pairs, settled, 1e-4), 0.98) << seed << ' ' << size;
            EXPECT_EQ(settled.result.uncertain, 0u);
            EXPECT_GT(settled.result.truncated, 0u);
            EXPECT_GT(settled.result.motion_lost, 0);
            EXPECT_LT(settled.result.motion_lost, size < 0.1f ? 0.5f : 0.999f);
        }
    }
    EXPECT_GE(wished, 20) << "of 24: the motions that were wanted cross";
}

TEST(Settle, PlanesThatStandFromTheFirstCrossNothingAndLoseMore) {
    const Triangles mesh = triangle_soup(60, 0.5f, 3);
    const LaidOut<PairList> pairs = all_pairs(mesh);
    const Rows wanted = random_vectors(mesh.size(), 0.1f, 4);
    const Settled moving = settle(mesh, pairs, wanted), standing = settle(mesh, pairs, wanted, 1, {1e-4f, 0});
    EXPECT_EQ(crossings_on_the_way(mesh, standing), 0);
    EXPECT_GT(standing.result.standing_planes, 0u);
    EXPECT_GT(standing.result.motion_lost, moving.result.motion_lost);
    EXPECT_EQ(crossings_on_the_way(mesh, settle(mesh, pairs, wanted, 1, {1e-4f, 1})), 0);
}

TEST(Settle, StepsOneAfterAnotherCrossNothing) {
    Triangles mesh = folded_packet(4, 16, 5, 0.05f, 0.01f);
    for (unsigned step = 0; step < 12; ++step) {
        Rows wanted = random_vectors(mesh.size(), 0.02f, step);
        for (std::size_t i = 0; i < wanted.size(); ++i) wanted[i].y -= 0.3f * mesh.positions[i].y + 0.1f;
        const Settled settled = settle(mesh, all_pairs(mesh), wanted);
        mesh.positions = ends_of(mesh.positions, settled.displacements);
        ASSERT_EQ(crossings(mesh, points(mesh.positions)), 0) << step;
    }
}

TEST(Settle, WhatApproachesNothingKeepsAllItsMotion) {
    // Two soups: one is pressed flat, the other, far from it, shrinks a little.
    Triangles mesh = triangle_soup(30, 0.5f, 1);
    const std::uint32_t pressed = mesh.size();
    for (const Triangles free = triangle_soup(30, 0.2f, 2); const auto& t : free.triangles) {
        mesh.triangles.push_back({t[0] + pressed, t[1] + pressed, t[2] + pressed});
        for (const std::uint32_t i : t) {
            mesh.positions.push_back(to_vec4(xyz(free.positions[i]) + Vector3(20, 0, 0), 1));
        }
    }
    Rows motions(mesh.size());
    for (std::uint32_t i = 0; i < mesh.size(); ++i) {
        const Vec4& x = mesh.positions[i];
        motions[i] = i < pressed ? Vec4{0, -0.999f * x.y + 0.01f * std::sin(70 * x.x), 0, 0}
                                 : Vec4{-0.01f * (x.x - 20), -0.01f * x.y, -0.01f * x.z, 0};
    }
    const std::vector<float> fractions = cut(mesh, all_pairs(mesh), motions).fractions;
    const auto middle = fractions.begin() + pressed;
    EXPECT_LT(*std::min_element(fractions.begin(), middle), 0.5f);
    EXPECT_EQ(*std::min_element(middle, fractions.end()), 1.0f);
}

TEST(Settle, APacketLosesNothingOfAMotionThatItsLayersShare) {
    const Triangles mesh = folded_packet(6, 24, 8, 0.03f, 1e-3f);
    const LaidOut<PairList> pairs = all_pairs(mesh);
    Matrix3 turn = Eigen::AngleAxisf(1.0f, Vector3(1, 2, 3).normalized()).toRotationMatrix(), affine;
    affine << 1.2f, 0.1f, -0.1f, 0, 0.8f, 0.3f, 0.2f, 0, 0.9f;
    for (const Matrix3& map : {Matrix3(Matrix3::Identity()), turn, affine, Matrix3(turn * affine)}) {
        Rows wanted = mesh.positions;
        for (Vec4& d : wanted) set_xyz(d, map * xyz(d) - xyz(d) + Vector3(0.3f, -2, 0.1f));
        const Settled settled = settle(mesh, pairs, wanted);
        EXPECT_EQ(settled.result.truncated, 0u);
        EXPECT_EQ(settled.result.common, CommonMotionKind::affine);
        EXPECT_EQ(std::memcmp(settled.displacements.data(), wanted.data(), wanted.size() * sizeof(Vec4)), 0);
    }
    // The same turn, with no common motion taken out, is cut.
    Rows motions = mesh.positions;
    for (Vec4& d : motions) set_xyz(d, turn * xyz(d) - xyz(d));
    EXPECT_LT(std::ranges::min(cut(mesh, pairs, motions).fractions), 0.9f);
}

TEST(Settle, TheSameBytesWhateverTheThreads) {
    const Triangles mesh = triangle_soup(120, 0.4f, 5);
    const LaidOut<PairList> pairs = all_pairs(mesh);
    const Rows wanted = random_vectors(mesh.size(), 0.2f, 6);
    const Settled one = settle(mesh, pairs, wanted, 1);
    for (const int threads : {2, 4}) {
        const Settled other = settle(mesh, pairs, wanted, threads);
        EXPECT_EQ(
            std::memcmp(one.displacements.data(), other.displacements.data(), wanted.size() * sizeof(Vec4)),
            0);
        EXPECT_EQ(one.result.truncated, other.result.truncated);
        EXPECT_EQ(one.result.sweeps, other.result.sweeps);
        EXPECT_EQ(one.result.motion_lost, other.result.motion_lost);
    }
}

TEST(Settle, FarFromTheOriginRoundingCrossesNothing) {
    for (unsigned seed = 0; seed < 4; ++seed) {
        Triangles mesh = triangle_soup(60, 0.5f, seed);
        for (Vec4& x : mesh.positions) x = {x.x + 1000, x.y - 500, x.z + 800, 1};
        ASSERT_EQ(crossings(mesh, points(mesh.positions)), 0);
        const LaidOut<PairList> pairs = all_pairs(mesh);
        Rows wanted = random_vectors(mesh.size(), 0.3f, seed);
        const Matrix3 turn = Eigen::AngleAxisf(0.5f, Vector3(0, 1, 0)).toRotationMatrix();
        for (std::size_t i = 0; i < wanted.size(); ++i) {
            const Vector3 arm = xyz(mesh.positions[i]) - Vector3(1000, -500, 800);
            set_xyz(wanted[i], xyz(wanted[i]) + turn * arm - arm + Vector3(0.1f, -3, 0));
        }
        const Settled settled = settle(mesh, pairs, wanted, 1, {1e-6f, 30});
        EXPECT_EQ(crossings(mesh, points(ends_of(mesh.positions, settled.displacements))), 0) << seed;
        EXPECT_LT(settled.result.motion_lost, 0.5f);
        // Only those are uncertain whose gap was no wider than rounding at the start.
        const auto is_narrow = [](const PairShape& shape) { return shape.normal.w < 1e-4f; };
        EXPECT_LE(settled.result.uncertain, std::ranges::count_if(pairs.shapes.span(), is_narrow)) << seed;
    }
}

TEST(Settle, ASideThatFollowsAnotherIsNotCut) {
    const Triangles mesh = vertex_above_triangle(0.01f);
    const LaidOut<PairList> pairs = all_pairs(mesh);
    Rows motions(mesh.size(), Vec4{0, -0.5f, 0, 0});
    EXPECT_EQ(std::ranges::min(cut(mesh, pairs, motions).fractions), 1.0f);
    // Where the triangle goes less far, the vertex goes as far and the gap less the floor, at once.
    for (std::size_t i = 0; i < 3; ++i) motions[i].y = -0.3f;
    const Cut vertex = cut(mesh, pairs, motions, {5e-3f, 30});
    EXPECT_EQ(vertex.fractions[0], 1.0f);
    EXPECT_NEAR(vertex.fractions[3], (0.3f + 0.01f - 5e-3f) / 0.5f, 1e-3f);
    EXPECT_EQ(vertex.standing, 0u);
    EXPECT_LE(vertex.sweeps, 2u);
    // And the other way round: the triangle follows a vertex that goes up.
    for (Vec4& motion : motions) motion.y *= -1;
    for (std::size_t i = 0; i < 3; ++i) std::swap(motions[i].y, motions[i + 3].y);
    const Cut triangle = cut(mesh, pairs, motions, {5e-3f, 30});
    EXPECT_EQ(triangle.fractions[3], 1.0f);
    EXPECT_NEAR(triangle.fractions[0], (0.3f + 0.01f - 5e-3f) / 0.5f, 1e-3f);
    EXPECT_LE(triangle.sweeps, 2u);
}

TEST(Settle, SidesThatMeetShareTheGapAsTheyCloseIt) {
    const Triangles mesh = vertex_above_triangle(0.1f);
    const LaidOut<PairList> pairs = all_pairs(mesh);
    Rows motions(mesh.size());
    for (std::size_t i = 0; i < 3; ++i) motions[i].y = 0.1f;
    motions[3].y = -0.3f;
    const Cut moving = cut(mesh, pairs, motions, {0.02f, 30});
    EXPECT_NEAR(moving.fractions[3], 0.2f, 1e-3f);
    EXPECT_NEAR(moving.fractions[0], 0.2f, 1e-3f);
    EXPECT_LE(moving.sweeps, 2u);
    // A plane that stands is in the middle, with half of the floor on each side.
    const Cut standing = cut(mesh, pairs, motions, {0.02f, 0});
    EXPECT_NEAR(standing.fractions[3], 0.04f / 0.3f, 1e-3f);
    EXPECT_NEAR(standing.fractions[0], 0.4f, 1e-3f);
}

TEST(Settle, AGapBelowTheFloorDoesNotShrinkAndMayGrow) {
    const Triangles mesh = vertex_above_triangle(1e-6f);
    Rows motions(mesh.size());
    motions[3].y = -1;
    EXPECT_EQ(cut(mesh, all_pairs(mesh), motions).fractions[3], 0.0f);
    motions[3].y = 1;
    EXPECT_EQ(cut(mesh, all_pairs(mesh), motions).fractions[3], 1.0f);
    motions[3] = {0.1f, 0, 0, 0};
    EXPECT_EQ(cut(mesh, all_pairs(mesh), motions).fractions[3], 1.0f) << "it slides";
}

TEST(Settle, AMotionThatWouldEndWithinTheFloorEndsAtIt) {
    const Triangles mesh = vertex_above_triangle(0.01f);
    Rows motions(mesh.size());
    motions[3].y = -0.008f;
    EXPECT_NEAR(cut(mesh, all_pairs(mesh), motions, {5e-3f, 30}).fractions[3], 0.625f, 1e-2f);
    motions[3].y = -0.004f;
    EXPECT_EQ(cut(mesh, all_pairs(mesh), motions, {5e-3f, 30}).fractions[3], 1.0f);
}

// Momentum that cutting takes from some goes to all alike, where nothing holds any of them.
TEST(Settle, CuttingKeepsTheMomentumOfWhatIsFree) {
    for (std::uint32_t seed = 1; seed <= 5; ++seed) {
        Triangles mesh = triangle_soup(40, 0.5f, seed);
        for (std::uint32_t i = 0; i < mesh.size(); ++i)
            mesh.positions[i].w = 0.5f + 0.1f * static_cast<float>(i % 17);
        const LaidOut<PairList> pairs = all_pairs(mesh);
        const Rows wanted = random_vectors(mesh.size(), 0.3f, seed + 10);
        const auto momentum = [&](const Rows& displacements) {
            Point sum = Point::Zero();
            for (std::uint32_t i = 0; i < mesh.size(); ++i)
                sum += point(displacements[i]) / double{mesh.positions[i].w};
            return sum;
        };
        Parallel serial(1);
        LaidOut<Settler> settler;
        settler.reserve(mesh.positions.size(), 1, pairs.size);
        const ParticleRange all{0, mesh.size()};
        const BodyGroup group{.particles = {&all, 1}, .positions = mesh.positions, .is_free = true};
        Rows displacements = wanted;
        settler.split(serial, group, displacements, CommonMotionKind::affine);
        const SettleResult result = settler.settle(serial, group, pairs, {}, settings, displacements);
        EXPECT_GT(result.truncated, 20u);
        EXPECT_LT((momentum(displacements) - momentum(wanted)).norm(), 1e-4) << seed;
    }
}

TEST(Settle, TheFloorIsWiderThanTheRoundingOfCoordinates) {
    Triangles mesh = vertex_above_triangle(0.1f);
    for (Vec4& x : mesh.positions) x.x += 1000;
    Rows motions(mesh.size());
    motions[3].y = -1;
    EXPECT_LT(cut(mesh, all_pairs(mesh), motions, {1e-6f, 30}).fractions[3], 0.1f - 3e-4f);
}

TEST(Settle, APairThatOnlyRoundingBringsTogetherIsHeld) {
    // The triangle is in the plane x + y = 1500; coordinates of 1000 are rounded twice as much as those of
    // 500. The vertex, one rounding away from the triangle, slides along, and would end within it.
    const float fine = std::ldexp(1.0f, -15), coarse = 2 * fine;
    Triangles mesh;
    mesh.positions = {{499, 1001, -1, 1}, {501, 999, -1, 1}, {500, 1000, 2, 1}, {500, 1000, 0, 1}};
    mesh.positions[3].x += fine;
    for (const Vec4& far : {Vec4{510, 1010, 0, 1}, Vec4{520, 1010, 3, 1}}) mesh.positions.push_back(far);
    mesh.triangles = {{0, 1, 2}, {3, 4, 5}};
    const LaidOut<PairList> pairs = all_pairs(mesh);
    Rows wanted(mesh.size());
    wanted[3] = {0.55f * coarse, -0.55f * coarse, 0, 0};
    const auto plane = [](const Rows& rows) { return double{rows[3].x} + double{rows[3].y} - 1500; };
    EXPECT_GT(plane(mesh.positions), 0);
    EXPECT_EQ(plane(ends_of(mesh.positions, wanted)), 0);
    const Settled settled = settle(mesh, pairs, wanted);
    EXPECT_GT(plane(ends_of(mesh.positions, settled.displacements)), 0);
    EXPECT_EQ(settled.result.uncertain, 0u);
}

TEST(Settle, PinnedParticlesAreCut) {
    Triangles mesh = vertex_above_triangle(0.1f);
    mesh.positions[3].w = 0;
    Rows wanted(mesh.size());
    wanted[3].y = -1;
    const Settled settled = settle(mesh, all_pairs(mesh), wanted);
    EXPECT_EQ(crossings_on_the_way(mesh, settled), 0);
    EXPECT_GT(settled.displacements[3].y, -0.7f);
}

// What all have in common is not cut, and rounding at its end can take any gap.
TEST(Settle, APairWhoseGapIsLostOnTheCommonWayIsUncertain) {
    const Triangles mesh = vertex_above_triangle(1e-9f);
    const LaidOut<PairList> pairs = all_pairs(mesh);
    for (const float way : {0.0f, 1000.0f}) {
        const Settled settled = settle(mesh, pairs, Rows(mesh.size(), Vec4{0, way, 0, 0}));
        const Rows ends = ends_of(mesh.positions, settled.displacements);
        EXPECT_EQ(ends[3].y > ends[0].y, way == 0);
        EXPECT_EQ(settled.result.uncertain > 0, way > 0);
    }
}

// Whatever rounding brings through, even where holding one pair brings the next too near, is said.
TEST(Settle, NothingCrossesByRoundingThatIsNotUncertain) {
    int crossed = 0;
    for (unsigned seed = 0; seed < 60; ++seed) {
        Triangles mesh = triangle_soup(30, 0.5f, seed);
        for (Vec4& x : mesh.positions) x = {1 + 1e-5f * x.x, 1 + 1e-5f * x.y, 1 + 1e-5f * x.z, 1};
        if (crossings(mesh, points(mesh.positions)) > 0) continue;
        Rows wanted = random_vectors(mesh.size(), 3e-6f, seed);
        for (Vec4& d : wanted) d.y += 3;
        const Settled settled = settle(mesh, all_pairs(mesh), wanted);
        if (crossings(mesh, points(ends_of(mesh.positions, settled.displacements))) == 0) continue;
        ++crossed;
        EXPECT_GT(settled.result.uncertain, 0u) << seed;
    }
    EXPECT_GT(crossed, 3);
}

// A triangle comes up against a vertex that stays, which most of the common motion would take along.
TEST(Settle, NoPinIsDrawnOffByWhatOthersHaveInCommon) {
    Triangles mesh = vertex_above_triangle(0.1f);
    Rows wanted(mesh.size(), Vec4{0, 0.5f, 0, 0});
    const auto settle_pinned = [&](float way, CommonMotionKind most) {
        wanted[3].y = way;
        return settle(mesh, all_pairs(mesh), wanted, 1, settings, {}, true, most);
    };
    const Settled free = settle_pinned(0, CommonMotionKind::affine);
    EXPECT_FALSE(free.result.draws_pins);
    EXPECT_GT(free.displacements[3].y, 0.1f);
    mesh.positions[3].w = 0;
    for (const float way : {0.0f, -0.35f}) {
        const Settled drawn = settle_pinned(way, CommonMotionKind::affine);
        EXPECT_TRUE(drawn.result.draws_pins);
        EXPECT_EQ(std::memcmp(drawn.displacements.data(), wanted.data(), wanted.size() * sizeof(Vec4)), 0);
        const Settled held = settle_pinned(way, CommonMotionKind::none);
        EXPECT_FALSE(held.result.draws_pins);
        EXPECT_EQ(crossings_on_the_way(mesh, held), 0);
        EXPECT_LE(held.displacements[3].y, 0);
        EXPECT_GE(held.displacements[3].y, way);
        EXPECT_GT(held.displacements[0].y, 0.03f);
    }
}

TEST(Settle, ExemptPairsTakeNoPlaneAndOthersWithoutAGapDoNotMove) {
    Triangles mesh = vertex_above_triangle(-0.1f);  // through the triangle
    ASSERT_GT(crossings(mesh, points(mesh.positions)), 0);
    LaidOut<PairList> pairs = all_pairs(mesh);
    std::uint32_t crossed = 0;  // the edge from 3 to 4 and one of the triangle's, as if they touched
    while (pairs.pairs[pairs.vertex_triangle + crossed].corners[2] != 3) ++crossed;
    crossed += pairs.vertex_triangle;
    pairs.shapes[crossed].normal.w = 0;
    Rows wanted(mesh.size());
    wanted[3].y = 0.3f;
    std::vector<std::uint8_t> exempt(pairs.size, 0);
    const Settled frozen = settle(mesh, pairs, wanted, 1, settings, exempt);
    for (const std::uint32_t i : pairs.pairs[crossed].corners) EXPECT_EQ(frozen.fractions[i], 0.0f);
    EXPECT_EQ(frozen.fractions[5], 1.0f);
    std::ranges::fill(exempt, std::uint8_t{1});
    const Settled free = settle(mesh, pairs, wanted, 1, settings, exempt);
    EXPECT_EQ(free.result.truncated, 0u);
    EXPECT_EQ(free.displacements[3].y, 0.3f);
    EXPECT_EQ(crossings(mesh, points(ends_of(mesh.positions, free.displacements))), 0);
}

TEST(Settle, AnIncompleteListLeavesTheCommonMotionAlone) {
    const Triangles mesh = triangle_soup(40, 0.5f, 7);
    LaidOut<PairList> pairs = all_pairs(mesh);
    pairs.overflowed = true;
    pairs.size = 10;
    Rows wanted = random_vectors(mesh.size(), 0.3f, 8);
    for (Vec4& d : wanted) d.y -= 2;
    const Settled settled = settle(mesh, pairs, wanted);
    EXPECT_TRUE(settled.result.list_was_incomplete);
    EXPECT_EQ(settled.result.truncated, mesh.size());
    EXPECT_EQ(crossings_on_the_way(mesh, settled), 0);
    double fallen = 0;
    for (const Vec4& d : settled.displacements) fallen += double{d.y} / mesh.size();
    EXPECT_NEAR(fallen, -2, 0.1);

    // A pin that went along would leave its place by more than it was to.
    const Settled held = settle(mesh, pairs, wanted, 1, settings, {}, true);
    for (const Vec4& d : held.displacements) EXPECT_TRUE(xyz(d).isZero(0));
}

TEST(Settle, WhatIsNotANumberStopsThereAndCrossesNothingElse) {
    const Triangles mesh = triangle_soup(40, 0.5f, 11);
    const LaidOut<PairList> pairs = all_pairs(mesh);
    Rows wanted = random_vectors(mesh.size(), 0.1f, 12);
    wanted[4] = {not_a_number, 0, 0, 0};
    wanted[50] = {0, std::numeric_limits<float>::infinity(), 0, 0};
    wanted[70] = {0, 0, 3e38f, 0};
    const Settled settled = settle(mesh, pairs, wanted);
    for (const Vec4& d : settled.displacements) EXPECT_TRUE(xyz(d).allFinite());
    EXPECT_EQ(settled.fractions[4], 0.0f);
    EXPECT_EQ(crossings(mesh, points(ends_of(mesh.positions, settled.displacements))), 0);

    Triangles broken = mesh;
    broken.positions[7].x = not_a_number;
    settle(broken, all_pairs(broken), random_vectors(mesh.size(), 0.1f, 12));
}

}  // namespace
}  // namespace weft::test
