// The check that builds with assertions make after every substep: nothing crosses that did not at the start.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <span>
#include <utility>
#include <vector>

#include "cloth/contact/feature_contact.h"
#include "crossing_count.h"

#include "tests/laid_out.h"

namespace weft::test {
namespace {

constexpr ImpactZones* no_zones = nullptr;

FeatureCounts settle(FeatureContact& space, Parallel& parallel) {
    space.project(parallel);
    return space.cut(parallel, false);
}

/// Two triangles of 1 m, one 0.1 m above the other, through the frame's part that features have.
struct TwoTriangles {
    static constexpr float apart = 0.1f;
    std::vector<Vec4> low = {{0, 0, 0, 1}, {1, 0, 0, 1}, {0, 0, 1, 1}};
    std::vector<Vec4> high = {{0.2f, apart, -0.5f, 1}, {0.2f, apart, 1.5f, 1}, {0.4f, apart, 0.2f, 1}};
    std::vector<Vec4> velocities = std::vector<Vec4>(3);
    std::vector<ContactMesh::Triangle> triangles = {{0, 1, 2}};
    ContactMesh low_mesh{low, triangles}, high_mesh{high, triangles};
    std::vector<ContactCloth> bodies{{.mesh = &low_mesh, .radius = 0.02f, .floor = 1e-4f},
                                     {.mesh = &high_mesh, .radius = 0.02f, .floor = 1e-4f}};
    LaidOut<FeatureContact> space{std::span<const ContactCloth>(bodies), no_zones};
    Parallel parallel{1};
    bool is_crowd = false;

    TwoTriangles() {
        const ExpectedMotion still{.velocities = velocities, .h = 0.01f};
        space.place(parallel, 0, low, still);
        space.place(parallel, 1, high, still);
    }
    /// One corner of the upper one goes down by so much [m].
    void arrive(float down) {
        std::vector<Vec4> moved = high;
        moved[2].y -= down;
        space.arrive(parallel, 0, low);
        space.arrive(parallel, 1, moved);
    }
};

TEST(NewCrossings, AreSeenWhereTheMotionIsNotCut) {
    TwoTriangles scene;
    scene.space.detect(scene.parallel, scene.is_crowd);
    scene.arrive(0.5f * TwoTriangles::apart);
    EXPECT_FALSE(scene.space.crosses_anew(scene.parallel));
    scene.arrive(1.5f * TwoTriangles::apart);
    EXPECT_TRUE(scene.space.crosses_anew(scene.parallel));
}

TEST(NewCrossings, AreNoneWhereItIsCut) {
    TwoTriangles scene;
    scene.space.detect(scene.parallel, scene.is_crowd);
    scene.arrive(1.5f * TwoTriangles::apart);
    EXPECT_GT(settle(scene.space, scene.parallel).truncated, 0u);
    EXPECT_FALSE(scene.space.crosses_anew(scene.parallel));
}

// Drawn out along one axis and in along the other the sheet would stay apart, if all of it went the same part
// of that way, and so the search before passes over its neighbours. Parts of 0 and 1 fold it over.
TEST(NewCrossings, AreNoneWhereASheetGoesPartsOfTheWayThatIsExpected) {
    constexpr std::uint32_t side = 13;
    constexpr float edge = 0.05f, h = 0.01f, strain = 0.25f;
    std::vector<Vec4> start, ways, moved;
    std::vector<ContactMesh::Triangle> triangles;
    for (std::uint32_t i = 0; i < side; ++i)
        for (std::uint32_t j = 0; j < side; ++j) {
            const float u = static_cast<float>(i) - 6, v = static_cast<float>(j) - 6;
            const float bump = std::sin(5 * u * u + 3 * v * v);
            start.push_back({edge * u, 0.1f * edge * bump, edge * v, 1});
            ways.push_back({strain * edge * u, 0, -strain * edge * v, 0});
            if (i == 0 || j == 0) continue;
            const std::uint32_t a = (i - 1) * side + j - 1, b = a + side;
            triangles.push_back({a, a + 1, b});
            triangles.push_back({b, a + 1, b + 1});
        }
    std::vector<Vec4> velocities, rest = start;
    for (Vec4& x : rest) x.y = 0;
    for (std::size_t i = 0; i < start.size(); ++i) {
        velocities.push_back({ways[i].x / h, 0, ways[i].z / h, 0});
        const float u = start[i].x / edge, v = start[i].z / edge;
        const bool goes = std::sin(7 * u * u + 11 * v * v) > 0;  // alike on all sides: so nothing turns
        moved.push_back(
            {start[i].x + (goes ? ways[i].x : 0), start[i].y, start[i].z + (goes ? ways[i].z : 0), 1});
    }
    const ContactMesh mesh(rest, triangles);
    const std::vector<ContactCloth> body{{.mesh = &mesh, .radius = 0.4f * edge, .floor = 0.01f * edge}};
    LaidOut<FeatureContact> space{std::span<const ContactCloth>(body), no_zones};
    Parallel parallel{1};
    bool is_crowd = false;
    space.place(parallel, 0, start, {.velocities = velocities, .h = h});
    space.detect(parallel, is_crowd);
    space.arrive(parallel, 0, moved);
    EXPECT_TRUE(space.crosses_anew(parallel));
    space.arrive(parallel, 0, moved);
    const FeatureCounts counts = settle(space, parallel);
    EXPECT_GT(counts.truncated, 0u);
    EXPECT_FALSE(counts.overflowed);
    EXPECT_FALSE(space.crosses_anew(parallel));
}

TEST(NewCrossings, AreNotWhatCrossedAtTheStart) {
    TwoTriangles scene;
    for (Vec4& x : scene.high) x.y -= TwoTriangles::apart;
    scene.high[2].y -= 0.05f;
    scene.high[0].y += 0.05f;
    scene.space.reserve(std::span<const ContactCloth>(scene.bodies), no_zones);
    const ExpectedMotion still{.velocities = scene.velocities, .h = 0.01f};
    scene.space.place(scene.parallel, 0, scene.low, still);
    scene.space.place(scene.parallel, 1, scene.high, still);
    const std::vector<TangleMemory> nothing(3);
    for (const std::size_t body : {0u, 1u}) scene.space.recall(body, nothing);
    scene.space.detect(scene.parallel, scene.is_crowd);
    scene.arrive(0);
    const FeatureCounts counts = settle(scene.space, scene.parallel);
    EXPECT_GT(counts.tangles.crossings, 0u);
    EXPECT_FALSE(scene.space.crosses_anew(scene.parallel));
}

// More pairs than there is room for, so that all go the way that they have in common; and they lie so near
// that rounding at the end of that way takes the gaps between them.
TEST(NewCrossings, AreNoneWhereRoundingWouldMakeThemInACrowd) {
    constexpr std::uint32_t triangles = 80;
    constexpr float apart = 2e-9f, h = 0.01f;
    std::vector<Vec4> start, end;
    std::vector<ContactMesh::Triangle> corners;
    for (std::uint32_t t = 0; t < triangles; ++t) {
        for (std::uint32_t k = 0; k < 3; ++k) {
            const float angle = 0.37f * static_cast<float>(t) + 2.1f * static_cast<float>(k);
            const Vec4 x{0.3f * std::cos(angle), apart * static_cast<float>(t), 0.3f * std::sin(angle), 1};
            start.push_back(x);
            end.push_back({x.x, x.y + 0.8f + 0.37f * x.x - 0.21f * x.z, x.z, 1});
        }
        corners.push_back({3 * t, 3 * t + 1, 3 * t + 2});
    }
    const ContactMesh mesh{start, corners};
    const ContactCloth body{.mesh = &mesh, .radius = 0.02f, .floor = 1e-4f};
    LaidOut<FeatureContact> space{std::span(&body, 1), no_zones};
    Parallel parallel{1};
    bool is_crowd = false;
    std::vector<Vec4> velocities(start.size());
    space.place(parallel, 0, start, {.velocities = velocities, .h = h});
    space.detect(parallel, is_crowd);
    space.arrive(parallel, 0, end);

    const FeatureCounts counts = settle(space, parallel);

    EXPECT_TRUE(counts.overflowed);
    EXPECT_EQ(counts.truncated, start.size());
    EXPECT_FALSE(space.crosses_anew(parallel));
    space.hand_back(parallel, 0, h, end, velocities);
    Soup soup;
    soup.add({.positions = end, .triangles = corners});
    EXPECT_EQ(soup.crossings(), 0);
    EXPECT_FLOAT_EQ(velocities[0].y, -(0.8f + 0.37f * start[0].x - 0.21f * start[0].z) / h);
}

// Groups are laid out in the same memory, one after another.
TEST(NewCrossings, OfOneGroupAreNothingToTheNext) {
    TwoTriangles scene;
    const std::vector<Vec4> above = scene.high;
    for (Vec4& x : scene.high) x.y -= TwoTriangles::apart;
    scene.high[2].y -= 0.05f;
    scene.high[0].y += 0.05f;
    const std::vector<Vec4> crossing = scene.high;
    const std::vector<TangleMemory> nothing(3);
    const ExpectedMotion still{.velocities = scene.velocities, .h = 0.01f};
    const auto place = [&](std::size_t recalled) {
        scene.space.reserve(std::span<const ContactCloth>(scene.bodies), no_zones);
        scene.space.place(scene.parallel, 0, scene.low, still);
        scene.space.place(scene.parallel, 1, scene.high, still);
        for (std::size_t body = 0; body < recalled; ++body) scene.space.recall(body, nothing);
        scene.space.detect(scene.parallel, scene.is_crowd);
    };
    const auto remembers = [&](std::size_t body) {
        return std::ranges::any_of(scene.space.memory(body),
                                   [](const TangleMemory& m) { return m.name != 0; });
    };
    place(2);
    ASSERT_TRUE(scene.space.may_cross());
    ASSERT_TRUE(remembers(1));
    scene.high = above;
    place(1);
    EXPECT_FALSE(remembers(1)) << "nobody has recalled anything of it";
    scene.high = crossing;
    place(2);
    ASSERT_TRUE(scene.space.may_cross());
    scene.high = above;
    place(0);
    EXPECT_FALSE(scene.space.may_cross());
    scene.arrive(1.5f * TwoTriangles::apart);
    const FeatureCounts counts = settle(scene.space, scene.parallel);
    EXPECT_GT(counts.truncated, 0u);
    EXPECT_EQ(counts.tangles.contours, 0u);
    EXPECT_FALSE(scene.space.crosses_anew(scene.parallel));
}

// At ten kilometres the gap between the two is less than a rounding.
TEST(NewCrossings, AreLookedForWhereRoundingMayHaveMadeThem) {
    for (const float way : {1.0f, 1e4f}) {
        TwoTriangles scene;
        for (Vec4& x : scene.high) x.y = 5e-5f;
        scene.space.reserve(std::span<const ContactCloth>(scene.bodies), no_zones);
        const ExpectedMotion still{.velocities = scene.velocities, .h = 0.01f};
        scene.space.place(scene.parallel, 0, scene.low, still);
        scene.space.place(scene.parallel, 1, scene.high, still);
        scene.space.detect(scene.parallel, scene.is_crowd);
        for (auto* rows : {&scene.low, &scene.high})
            for (Vec4& x : *rows) x.y += way;
        scene.arrive(0);
        scene.space.cut(scene.parallel, false);
        EXPECT_EQ(scene.space.may_cross(), way > 1) << way;
        scene.space.go_on(scene.parallel, false);
        EXPECT_EQ(scene.space.may_cross(), way > 1) << "what was uncertain stays so";
    }
}

// Two layers turn one way and, farther off, two more turn the other way, so that they have no motion in
// common.
TEST(Cut, GoesOnWithWhatTurns) {
    constexpr float apart = 0.01f, angle = 0.7f, h = 0.01f;
    std::vector<Vec4> start, end;
    std::vector<ContactMesh::Triangle> corners;
    for (const float side : {-1.0f, 1.0f})
        for (const float height : {0.0f, apart}) {
            const auto first = static_cast<std::uint32_t>(start.size());
            for (const auto& [x, z] :
                 {std::pair(0.0f, -0.1f), std::pair(-0.1f, 0.1f), std::pair(0.1f, 0.1f)}) {
                const float c = std::cos(side * angle), s = std::sin(side * angle);
                start.push_back({side + x, height, z, 1});
                end.push_back({side + x, c * height - s * z, s * height + c * z, 1});
            }
            corners.push_back({first, first + 1, first + 2});
        }
    const ContactMesh mesh{start, corners};
    const ContactCloth body{.mesh = &mesh, .radius = 0.02f, .floor = 1e-4f};
    LaidOut<FeatureContact> space{std::span(&body, 1), no_zones};
    Parallel parallel{1};
    bool is_crowd = false;
    const std::vector<Vec4> velocities(start.size());
    space.place(parallel, 0, start, {.velocities = velocities, .h = h});
    space.detect(parallel, is_crowd);
    space.arrive(parallel, 0, end);
    const auto missing = [&] {
        float most = 0;
        for (std::size_t i = 0; i < end.size(); ++i)
            most = std::max(most,
                            (xyz(space.starts(0)[i]) + xyz(space.displacements(0)[i]) - xyz(end[i])).norm());
        return most;
    };
    space.cut(parallel, false);
    const float after_cut = missing();
    ASSERT_GT(after_cut, 0.01f);
    space.go_on(parallel, false);
    EXPECT_LT(missing(), 0.5f * after_cut);
    EXPECT_FALSE(space.crosses_anew(parallel));

    std::vector<Vec4> places = end, speeds(start.size());
    space.hand_back(parallel, 0, h, places, speeds);
    for (std::size_t i = 0; i < end.size(); ++i) {
        EXPECT_LT((xyz(places[i]) - xyz(end[i])).norm(), 0.5f * after_cut);
        EXPECT_LT((xyz(speeds[i]) - (xyz(places[i]) - xyz(end[i])) / h).norm(), 1e-2f);
    }
}

// Every other one of a pile of triangles is to pass all above it: for a part of that way the list has room.
TEST(FullList, ShortensTheMotionUntilThereIsRoom) {
    constexpr std::uint32_t triangles = 80;
    constexpr float apart = 0.05f, way = 8;
    std::vector<Vec4> start, end;
    std::vector<ContactMesh::Triangle> corners;
    for (std::uint32_t t = 0; t < triangles; ++t) {
        for (std::uint32_t k = 0; k < 3; ++k) {
            const float angle = 0.37f * static_cast<float>(t) + 2.1f * static_cast<float>(k);
            start.push_back(
                {0.3f * std::cos(angle), apart * static_cast<float>(t), 0.3f * std::sin(angle), 1});
            end.push_back(start.back());
            end.back().y += t % 2 == 0 ? 0 : way;
        }
        corners.push_back({3 * t, 3 * t + 1, 3 * t + 2});
    }
    const ContactMesh mesh{start, corners};
    const ContactCloth body{.mesh = &mesh, .radius = 0.02f, .floor = 1e-4f};
    for (const bool is_pinned : {false, true}) {
        start[0].w = is_pinned ? 0.0f : 1.0f;
        LaidOut<FeatureContact> space{std::span(&body, 1), no_zones};
        Parallel parallel{1};
        bool is_crowd = false;
        const std::vector<Vec4> velocities(start.size());
        space.place(parallel, 0, start, {.velocities = velocities, .h = 0.01f});
        space.detect(parallel, is_crowd);
        space.arrive(parallel, 0, end);
        const FeatureCounts counts = settle(space, parallel);
        EXPECT_FALSE(counts.overflowed) << is_pinned;
        EXPECT_FALSE(space.crosses_anew(parallel)) << is_pinned;
        double farther = 0;
        for (std::uint32_t t = 0; t + 1 < triangles; t += 2)
            farther += double{space.displacements(0)[3 * t + 3].y - space.displacements(0)[3 * t].y};
        EXPECT_GT(farther / (triangles / 2), 0.3 * double{apart}) << is_pinned;
    }
}

}  // namespace
}  // namespace weft::test
