// The count of triangles that cross, against integers and against shapes that are known.

#include "demo/study/crossings/crossings.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <random>
#include <string>
#include <vector>

#include "demo/study/crossings/orientation.h"

namespace weft::study {
namespace {

__extension__ using Wide = __int128;
using Whole = std::array<std::int64_t, 3>;
using WholeTriangle = std::array<Whole, 3>;

Whole less(const Whole& p, const Whole& q) {
    return {p[0] - q[0], p[1] - q[1], p[2] - q[2]};
}

Whole cross_product(const Whole& p, const Whole& q) {
    return {p[1] * q[2] - p[2] * q[1], p[2] * q[0] - p[0] * q[2], p[0] * q[1] - p[1] * q[0]};
}

std::int64_t dot(const Whole& p, const Whole& q) {
    return p[0] * q[0] + p[1] * q[1] + p[2] * q[2];
}

struct Fraction {
    Wide over, under;  // under > 0
    friend bool operator<(const Fraction& a, const Fraction& b) {
        return a.over * b.under < b.over * a.under;
    }
};

/// Where the inside of a triangle meets a plane, along one of the axes: the interval's two ends, none if it
/// does not.
std::vector<Fraction> stretch(const WholeTriangle& t, const std::array<std::int64_t, 3>& heights,
                              std::size_t axis) {
    std::vector<Fraction> ends;
    for (std::size_t k = 0; k < 3; ++k) {
        const std::size_t next = (k + 1) % 3;
        const std::int64_t here = heights[k], there = heights[next];
        if (here == 0) ends.push_back({t[k][axis], 1});
        if ((here > 0 && there < 0) || (here < 0 && there > 0)) {
            const std::int64_t sign = here > there ? 1 : -1;
            ends.push_back({Wide(sign) * (Wide(t[next][axis]) * here - Wide(t[k][axis]) * there),
                            Wide(sign) * (here - there)});
        }
    }
    std::ranges::sort(ends, [](const Fraction& a, const Fraction& b) { return a < b; });
    return ends;
}

/// By fractions of whole numbers up to 2^14: the rule as the header says it, computed as nowhere else.
bool known_to_cross(const WholeTriangle& a, const WholeTriangle& b) {
    const auto normal = [](const WholeTriangle& t) {
        return cross_product(less(t[1], t[0]), less(t[2], t[0]));
    };
    const auto heights = [&](const WholeTriangle& plane, const WholeTriangle& t) {
        const Whole n = normal(plane);
        return std::array{dot(n, less(t[0], plane[0])), dot(n, less(t[1], plane[0])),
                          dot(n, less(t[2], plane[0]))};
    };
    const auto of_a = heights(b, a), of_b = heights(a, b);
    for (const auto& h : {of_a, of_b})
        if (std::ranges::min(h) >= 0 || std::ranges::max(h) <= 0) return false;
    const Whole na = normal(a), nb = normal(b);
    // The line's direction overflows 64 bits: only which coordinate of it is greatest is needed.
    std::array<Wide, 3> line;
    for (std::size_t k = 0; k < 3; ++k) {
        const std::size_t l = (k + 1) % 3, m = (k + 2) % 3;
        line[k] = Wide(na[l]) * nb[m] - Wide(na[m]) * nb[l];
        if (line[k] < 0) line[k] = -line[k];
    }
    const auto axis = static_cast<std::size_t>(std::ranges::max_element(line) - line.begin());
    const auto in_a = stretch(a, of_a, axis), in_b = stretch(b, of_b, axis);
    return std::max(in_a.front(), in_b.front()) < std::min(in_a.back(), in_b.back());
}

/// Points of whole numbers in boxes of that size, all of them `from` the origin, and a factor that is a power
/// of two: floats hold them exactly.
struct Soup {
    std::vector<Whole> points;
    TriangleSoup soup;

    void add_triangle(const WholeTriangle& triangle, std::int64_t from, float factor) {
        const auto first = static_cast<std::uint32_t>(points.size());
        for (const Whole& p : triangle) {
            points.push_back(p);
            const auto at = [&](std::size_t k) { return factor * static_cast<float>(p[k] + from); };
            soup.points.push_back({at(0), at(1), at(2)});
        }
        soup.triangles.push_back({first, first + 1, first + 2});
        soup.bodies.push_back(first % 2);
    }
    [[nodiscard]] WholeTriangle whole(std::size_t t) const {
        return {points[3 * t], points[3 * t + 1], points[3 * t + 2]};
    }
};

std::vector<std::pair<std::uint32_t, std::uint32_t>> brute_force(const Soup& soup) {
    std::vector<std::pair<std::uint32_t, std::uint32_t>> pairs;
    const auto count = static_cast<std::uint32_t>(soup.soup.triangles.size());
    for (std::uint32_t i = 0; i < count; ++i)
        for (std::uint32_t j = i + 1; j < count; ++j)
            if (known_to_cross(soup.whole(i), soup.whole(j))) pairs.emplace_back(i, j);
    return pairs;
}

struct SoupKind {
    std::string name;
    std::int64_t size;  // of a triangle's box
    std::int64_t room;  // of the box in which these are
    std::int64_t from;  // the origin
    float factor;
    std::array<std::int64_t, 3> flattened;  // each coordinate is a multiple of these
};

class RandomSoups : public testing::TestWithParam<SoupKind> {};

TEST_P(RandomSoups, AreCountedAsWholeNumbersSay) {
    const SoupKind& kind = GetParam();
    std::mt19937 random(7);
    const auto up_to = [&](std::int64_t most) {
        return static_cast<std::int64_t>(random() % static_cast<std::uint64_t>(most + 1));
    };
    std::size_t crossings = 0;
    for (int round = 0; round < 40; ++round) {
        Soup soup;
        for (int t = 0; t < 60; ++t) {
            WholeTriangle triangle;
            const Whole corner{up_to(kind.room), up_to(kind.room), up_to(kind.room)};
            for (Whole& p : triangle) {
                for (std::size_t k = 0; k < 3; ++k) {
                    p[k] = corner[k] + up_to(kind.size);
                    p[k] -= p[k] % kind.flattened[k];
                }
            }
            soup.add_triangle(triangle, kind.from, kind.factor);
        }
        const auto known = brute_force(soup);
        EXPECT_EQ(crossing_pairs(soup.soup), known) << "round " << round;
        EXPECT_EQ(count_crossings(soup.soup).all, known.size());
        crossings += known.size();
    }
    if (kind.flattened[1] <= kind.room) {
        EXPECT_GT(crossings, 100u) << "too few to tell";
    } else {
        EXPECT_EQ(crossings, 0u) << "all lie in one plane";
    }
}

INSTANTIATE_TEST_SUITE_P(Crossings, RandomSoups,
                         testing::Values(SoupKind{"random", 8000, 8000, 0, 1, {1, 1, 1}},
                                         SoupKind{"scattered", 3000, 12000, 0, 1.0f / 1024, {1, 1, 1}},
                                         SoupKind{"clustered", 6, 3, 0, 1, {1, 1, 1}},
                                         SoupKind{"degenerate", 2, 1, 0, 0.25f, {1, 1, 1}},
                                         SoupKind{"layered", 4000, 4000, 0, 1, {1, 2000, 1}},
                                         SoupKind{"planar", 4000, 4000, 0, 1, {1, 16000, 1}},
                                         SoupKind{"far", 40, 40, (1 << 24) - 100, 0x1p-10f, {1, 1, 1}},
                                         SoupKind{"tiny", 900, 900, 0, 0x1p-120f, {1, 1, 1}},
                                         SoupKind{"huge", 900, 900, 1000, 0x1p100f, {1, 1, 1}}),
                         [](const auto& info) { return info.param.name; });

TriangleSoup two_triangles(const std::array<Vec3, 6>& points) {
    TriangleSoup soup;
    soup.points = {points.begin(), points.end()};
    soup.triangles = {{0, 1, 2}, {3, 4, 5}};
    soup.bodies = {0, 1};
    return soup;
}

constexpr Vec3 p{0, 0, 0}, q{4, 0, 0}, r{0, 0, 4};  // a face on the ground

TEST(LeastGap, IsThatOfTheClosestTwo) {
    EXPECT_NEAR(least_gap(two_triangles({p, q, r, {1, 0.25f, 1}, {1, 1, 1}, {2, 1, 1}}), 9), 0.25, 1e-12);
    EXPECT_NEAR(least_gap(two_triangles({p, q, r, {-1, 0.5f, 1}, {1, 0.5f, -1}, {-1, 5, -1}}), 9), 0.5,
                1e-12);
    EXPECT_EQ(least_gap(two_triangles({p, q, r, {1, -1, 1}, {1, 1, 1}, {9, 1, 1}}), 9), 0);
    EXPECT_EQ(least_gap(two_triangles({p, q, r, {1, 8, 1}, {1, 9, 1}, {9, 9, 1}}), 2), 2) << "the bound";
    TriangleSoup many;
    for (int k = 0; k < 50; ++k) {
        const float h = static_cast<float>(k) + (k == 30 ? 0.125f : 0.0f);
        many.add_body({{0, h, 0}, {1, h, 0}, {0, h, 1}}, {{0, 1, 2}});
    }
    EXPECT_NEAR(least_gap(many, 9), 0.875, 1e-6);
}

}  // namespace
}  // namespace weft::study
