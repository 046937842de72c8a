#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>

#include <Eigen/Geometry>

#include "cloth/mesh/obj/triangulate.h"
#include "engine/vector.h"

namespace weft {
namespace {

using Eigen::Vector2d, Eigen::Vector3d;
using Polygon = std::vector<Vector2d>;

double cross(const Vector2d& a, const Vector2d& b) {
    return a.x() * b.y() - a.y() * b.x();
}

double signed_area(const Polygon& polygon) {
    double sum = 0;
    for (std::size_t i = 0; i < polygon.size(); ++i)
        sum += cross(polygon[i], polygon[(i + 1) % polygon.size()]) / 2;
    return sum;
}

/// Sutherland and Hodgman 1974.
double common_area(const Polygon& a, const Polygon& b) {
    Polygon left = a;
    for (std::size_t i = 0; i < b.size() && !left.empty(); ++i) {
        const Vector2d from = b[i], along = b[(i + 1) % b.size()] - from;
        Polygon kept;
        for (std::size_t k = 0; k < left.size(); ++k) {
            const Vector2d &p = left[k], &q = left[(k + 1) % left.size()];
            const double of_p = cross(along, p - from), of_q = cross(along, q - from);
            if (of_p >= 0) kept.push_back(p);
            if ((of_p >= 0) != (of_q >= 0)) kept.push_back(p + (q - p) * (of_p / (of_p - of_q)));
        }
        left = kept;
    }
    return left.empty() ? 0 : signed_area(left);
}

/// Where a polygon lies in space: turned, moved away, seen from either side, and not quite flat.
struct Placing {
    Eigen::Quaterniond turn = Eigen::Quaterniond::Identity();
    Vector3d offset = Vector3d::Zero();
    double unevenness = 0;  ///< [m], across its plane
    bool reversed = false;

    template <class Random>
    static Placing any(Random& random) {
        std::uniform_real_distribution<double> unit(-1, 1);
        Placing placing;
        placing.turn =
            Eigen::Quaterniond(unit(random), unit(random), unit(random), unit(random)).normalized();
        const double far = std::pow(10, 3 * std::abs(unit(random)) - 1);
        placing.offset = far * Vector3d(unit(random), unit(random), unit(random));
        placing.unevenness = random() % 2 == 0 ? 0 : 0.02;
        placing.reversed = random() % 2 == 0;
        return placing;
    }
};

/// `same[i]`: an earlier corner at the same position, or i.
std::vector<Vec3> place(const Polygon& polygon, const Placing& placing, std::mt19937& random) {
    std::uniform_real_distribution<double> uneven(-placing.unevenness, placing.unevenness);
    std::vector<Vec3> outline;
    for (const Vector2d& p : polygon) {
        const auto same = std::ranges::find(polygon, p) - polygon.begin();
        if (static_cast<std::size_t>(same) < outline.size()) {
            outline.push_back(outline[static_cast<std::size_t>(same)]);
            continue;
        }
        const Vector3d q = placing.offset + placing.turn * Vector3d(p.x(), p.y(), uneven(random));
        outline.push_back({static_cast<float>(q.x()), static_cast<float>(q.y()), static_cast<float>(q.z())});
    }
    return outline;
}

/// Triangles keep the outline's direction and area and do not overlap, and every corner has one.
void expect_right(const Polygon& polygon, const std::vector<Triangle>& triangles, const std::string& what) {
    ASSERT_EQ(triangles.size(), polygon.size() - 2) << what;
    const double area = signed_area(polygon), rounding = 1e-3 * std::abs(area);
    std::vector<Polygon> cut;
    std::vector<bool> used(polygon.size());
    double sum = 0;
    for (const Triangle& t : triangles) {
        for (const std::uint32_t corner : t) used.at(corner) = true;
        cut.push_back({polygon[t[0]], polygon[t[1]], polygon[t[2]]});
        if (area < 0) std::swap(cut.back()[1], cut.back()[2]);
        ASSERT_GE(signed_area(cut.back()), -rounding) << what;
        sum += std::abs(signed_area(cut.back()));
    }
    EXPECT_NEAR(sum, std::abs(area), rounding) << what;
    EXPECT_EQ(std::ranges::count(used, false), 0) << what;
    for (std::size_t i = 0; i < cut.size() && cut.size() < 200; ++i)
        for (std::size_t k = 0; k < i; ++k) ASSERT_LE(common_area(cut[i], cut[k]), rounding) << what;
}

Polygon star(int spikes, std::mt19937& random) {
    std::uniform_real_distribution<double> radius(0.2, 2);
    Polygon polygon;
    for (int i = 0; i < spikes; ++i) {
        const double angle = 2 * std::numbers::pi * i / spikes;
        polygon.push_back(radius(random) * Vector2d(std::cos(angle), std::sin(angle)));
    }
    return polygon;
}

/// Teeth of width 1 and gaps of width 1; `tooth` corners along each long side.
Polygon comb(int teeth, int along = 1, double height = 5) {
    Polygon polygon{{0, -1}, {2.0 * teeth - 1, -1}};
    for (int i = teeth - 1; i >= 0; --i) {
        const double right = 2 * i + 1, left = 2 * i;
        for (int k = 0; k <= along; ++k) polygon.emplace_back(right, height * k / along);
        for (int k = along; k >= 0; --k) polygon.emplace_back(left, height * k / along);
    }
    return polygon;
}

Polygon spiral(double turns, int corners) {
    Polygon polygon;
    for (const double inner : {0.0, 1.0}) {
        for (int i = 0; i < corners; ++i) {
            const double part = static_cast<double>(inner > 0 ? corners - 1 - i : i) / (corners - 1);
            const double angle = 2 * std::numbers::pi * turns * part;
            const double radius = 1 + turns * part - 0.5 * inner;
            polygon.push_back(radius * Vector2d(std::cos(angle), std::sin(angle)));
        }
    }
    return polygon;
}

bool cross_each_other(const Vector2d& a, const Vector2d& b, const Vector2d& c, const Vector2d& d) {
    const double clear = 1e-3;
    const auto side = [&](const Vector2d& p, const Vector2d& q, const Vector2d& r) {
        return cross(q - p, r - p) / (q - p).norm();
    };
    const auto apart = [&](double s, double t) {
        return (s > clear && t > clear) || (s < -clear && t < -clear);
    };
    return !apart(side(a, b, c), side(a, b, d)) && !apart(side(c, d, a), side(c, d, b));
}

/// Corners are put in at random places between two others, where the outline then does not cross itself.
Polygon grown(std::size_t corners, std::mt19937& random) {
    std::uniform_real_distribution<double> unit(-1, 1);
    Polygon polygon{{0, 0}, {0.2, 0}, {0, 0.2}};
    while (polygon.size() < corners) {
        const std::size_t n = polygon.size(), k = random() % n, next = (k + 1) % n;
        const Vector2d p(unit(random), unit(random));
        bool is_clear = std::abs(cross(polygon[k] - p, polygon[next] - p)) > 1e-3;
        for (std::size_t i = 0; i < n && is_clear; ++i) {
            const std::size_t j = (i + 1) % n;
            if (i != k && j != k) is_clear = !cross_each_other(p, polygon[k], polygon[i], polygon[j]);
            if (is_clear && i != next && j != next)
                is_clear = !cross_each_other(p, polygon[next], polygon[i], polygon[j]);
            if (is_clear && i != k) is_clear = std::abs(cross(polygon[j] - p, polygon[i] - p)) > 1e-3;
        }
        if (is_clear) polygon.insert(polygon.begin() + static_cast<std::ptrdiff_t>(next), p);
        if (next == 0 && is_clear) std::ranges::rotate(polygon, polygon.begin() + 1);
    }
    return polygon;
}

/// Corners on its edges, which go straight on.
Polygon with_straight_corners(const Polygon& polygon, std::mt19937& random) {
    Polygon result;
    for (std::size_t i = 0; i < polygon.size(); ++i) {
        const Vector2d &p = polygon[i], &q = polygon[(i + 1) % polygon.size()];
        const int parts = 1 + static_cast<int>(random() % 4);
        for (int k = 0; k < parts; ++k) result.push_back(p + (q - p) * k / parts);
    }
    return result;
}

/// Square holes in a row, each joined to the one before by an edge there and back, the first to the outline.
Polygon with_holes_in_a_row(int holes) {
    Polygon there, back;
    for (int i = 0; i < holes; ++i) {
        const double x = 3.0 * i;
        there.insert(there.end(), {{x, 0}, {x, 1}, {x + 1, 1}});
        back.insert(back.begin(), {{x + 1, 1}, {x + 1, 0}, {x, 0}});
    }
    back.erase(back.begin());
    Polygon polygon{{-1, -3}, {3.0 * holes, -3}, {3.0 * holes, 3}, {-1, 3}};
    polygon.insert(polygon.end(), there.begin(), there.end());
    polygon.insert(polygon.end(), back.begin(), back.end());
    polygon.emplace_back(-1, 3);
    return polygon;
}

/// Square holes that are all joined to one corner of the outline.
Polygon with_holes_about_a_corner(int holes) {
    Polygon polygon{{0, -9}, {9, -9}, {9, 0}, {0, 0}};
    for (int i = 0; i < holes; ++i) {
        const double angle = -(i + 0.5) / holes * std::numbers::pi / 2;
        const Vector2d ahead(std::cos(angle), std::sin(angle)), aside(-ahead.y(), ahead.x());
        for (const Vector2d& p : {Vector2d(-ahead), aside, ahead, Vector2d(-aside), Vector2d(-ahead)})
            polygon.push_back(6 * ahead + 0.4 * p);
        polygon.emplace_back(0, 0);
    }
    return polygon;
}

class Triangulation : public testing::Test {
  protected:
    /// Wherever it lies, and from whichever corner it begins.
    void expect_right_anywhere(const Polygon& polygon, const std::string& what, int placings = 20) {
        for (int k = 0; k < placings; ++k) {
            Placing placing = Placing::any(random_);
            if (k == 0) placing = {};
            Polygon turned = polygon;
            std::ranges::rotate(turned,
                                turned.begin() + static_cast<std::ptrdiff_t>(random_() % turned.size()));
            if (placing.reversed) std::ranges::reverse(turned);
            std::vector<Triangle> triangles;
            const bool is_cut = triangulate(place(turned, placing, random_), triangles);
            const std::string where = what + ", placed " + std::to_string(k);
            EXPECT_TRUE(is_cut) << where;
            expect_right(turned, triangles, where);
            if (HasFailure()) return;
        }
    }
    void expect_crossing(const Polygon& polygon, const std::string& what) {
        for (int k = 0; k < 20; ++k) {
            Placing placing = Placing::any(random_);
            placing.unevenness /= 10;
            if (k == 0) placing = {};
            std::vector<Triangle> triangles;
            EXPECT_FALSE(triangulate(place(polygon, placing, random_), triangles)) << what << " " << k;
            EXPECT_EQ(triangles.size(), polygon.size() - 2);
        }
    }

    std::mt19937 random_{7};
};

TEST_F(Triangulation, CoversTheFaceOnceWhateverItsShape) {
    expect_right_anywhere({{0, 0}, {1, 0}, {1, 1}, {0, 1}}, "square");
    expect_right_anywhere({{0, 0}, {2, 1}, {0, 2}, {0.5, 1}}, "arrowhead");
    expect_right_anywhere({{3, 0}, {3, 1}, {1, 1}, {1, 2}, {3, 2}, {3, 3}, {0, 3}, {0, 0}}, "C");
    expect_right_anywhere({{0, 0}, {1, 0}, {2, 0}, {3, 0}, {3, 1}, {1, 1}, {1, 2}, {1, 3}, {0, 3}, {0, 1}},
                          "L");
    for (const int corners : {3, 4, 5, 7, 64, 65, 150}) {
        expect_right_anywhere(star(corners, random_), "star of " + std::to_string(corners));
        expect_right_anywhere(comb(corners), "comb of " + std::to_string(corners), 3);
    }
    expect_right_anywhere(comb(4, 3), "comb with straight corners");
    for (const double turns : {0.7, 1.5, 3.2}) expect_right_anywhere(spiral(turns, 40), "spiral");
}

TEST_F(Triangulation, CoversRandomFacesOnce) {
    for (int k = 0; k < 60; ++k) {
        const Polygon polygon = grown(4 + random_() % 40, random_);
        expect_right_anywhere(polygon, "grown " + std::to_string(k), 4);
        expect_right_anywhere(with_straight_corners(polygon, random_),
                              "with straight corners " + std::to_string(k), 4);
        if (HasFailure()) return;
    }
}

TEST_F(Triangulation, CutsFacesWithHoles) {
    for (const int holes : {1, 2, 5}) {
        expect_right_anywhere(with_holes_in_a_row(holes), "holes in a row " + std::to_string(holes));
        expect_right_anywhere(with_holes_about_a_corner(holes),
                              "holes from one corner " + std::to_string(holes));
    }
}

TEST_F(Triangulation, CutsFacesThatMeetThemselvesAtACorner) {
    expect_right_anywhere({{0, 0}, {2, -1}, {2, 1}, {0, 0}, {-2, 1}, {-2, -1}}, "two leaves");
    Polygon leaves;
    for (int i = 0; i < 7; ++i) {
        for (const double ahead : {0.0, 0.4, 0.7}) {
            const double angle = 2 * std::numbers::pi * (i + ahead) / 7;
            leaves.emplace_back(Vector2d(std::cos(angle), std::sin(angle)));
        }
        leaves.emplace_back(0, 0);
    }
    expect_right_anywhere(leaves, "seven leaves");
    expect_right_anywhere({{0, 0}, {3, 0}, {3, 3}, {1, 1}, {2, 1}, {1, 1}, {0, 3}}, "slit");
    expect_right_anywhere({{0, 0}, {2, 0}, {2, 2}, {2, 2}, {0, 2}}, "corner twice");
}

TEST_F(Triangulation, OutlinesThatCrossThemselvesAreTold) {
    expect_crossing({{0, 0}, {1, 1}, {1, 0}, {0, 1}}, "bow tie");
    expect_crossing({{0, 0}, {2, 1}, {2, 0}, {0, 1.1}}, "uneven bow tie");
    Polygon pentagram, twice;
    for (int i = 0; i < 5; ++i) {
        const double angle = 2 * std::numbers::pi * 2 * i / 5;
        pentagram.emplace_back(std::cos(angle), std::sin(angle));
    }
    for (int i = 0; i < 60; ++i) {
        const double angle = 2 * std::numbers::pi * 2 * i / 60, radius = 1 + 0.3 * std::sin(angle / 2);
        twice.push_back(radius * Vector2d(std::cos(angle), std::sin(angle)));
    }
    expect_crossing(pentagram, "pentagram");
    expect_crossing(twice, "twice around");
    expect_crossing({{0, 0}, {4, 0}, {4, 4}, {3, -1}, {0, 4}}, "a spike through the other side");
    int crossing = 0;
    for (int k = 0; k < 200; ++k) {
        Polygon polygon;
        std::uniform_real_distribution<double> unit(-1, 1);
        for (int i = 0; i < 12; ++i) polygon.emplace_back(unit(random_), unit(random_));
        std::vector<Triangle> triangles;
        if (triangulate(place(polygon, {}, random_), triangles))
            expect_right(polygon, triangles, "random corners " + std::to_string(k));
        else
            ++crossing;
    }
    EXPECT_GT(crossing, 190);
}

TEST_F(Triangulation, FacesWithoutAreaAreCutAsTheyAre) {
    std::vector<Triangle> triangles;
    const std::vector<Vec3> line{{0, 0, 0}, {1, 1, 1}, {2, 2, 2}, {3, 3, 3}, {4, 4, 4}};
    EXPECT_TRUE(triangulate(line, triangles));
    EXPECT_EQ(triangles.size(), 3u);
    EXPECT_TRUE(triangulate(std::vector<Vec3>(9), triangles));
    EXPECT_EQ(triangles.size(), 7u);
}

TEST_F(Triangulation, AConcaveFaceOfManyCornersCrowdsNone) {
    Polygon polygon;
    for (int i = 0; i < 10'000; ++i) {
        const double angle = 2 * std::numbers::pi * i / 10'000, radius = i == 0 ? 0.5 : 1;
        polygon.push_back(radius * Vector2d(std::cos(angle), std::sin(angle)));
    }
    std::vector<Triangle> triangles;
    EXPECT_TRUE(triangulate(place(polygon, {}, random_), triangles));
    expect_right(polygon, triangles, "notched circle");
    std::vector<int> at(polygon.size());
    for (const Triangle& t : triangles)
        for (const std::uint32_t corner : t) ++at[corner];
    EXPECT_LE(std::ranges::max(at), 2 * 14);
}

}  // namespace
}  // namespace weft
