#include "collision/impact_zones/impact_zones.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <Eigen/Dense>
#include <functional>
#include <limits>
#include <numbers>
#include <numeric>
#include <random>

#include "engine/vector.h"

#include "tests/laid_out.h"

namespace weft::test {
namespace {

using Eigen::Vector3d;

/// Bodies that move for one step of 1 s: velocities are displacements.
class Meeting {
  public:
    /// A sheet of n x n particles; place(u, v) of 0 to 1.
    void add(std::uint32_t n, float mass, const Vec3& velocity,
             const std::function<Vec3(float, float)>& place) {
        const auto first = static_cast<std::uint32_t>(positions.size());
        std::vector<ContactMesh::Triangle> triangles;
        for (std::uint32_t i = 0; i < n * n; ++i) {
            const Vec3 p = place(static_cast<float>(i % n) / static_cast<float>(n - 1),
                                 static_cast<float>(i / n) / static_cast<float>(n - 1));
            positions.push_back({p.x, p.y, p.z, mass > 0 ? 1 / mass : 0});
            velocities.push_back({velocity.x, velocity.y, velocity.z, 0});
            if (i % n + 1 == n || i / n + 1 == n) continue;
            triangles.push_back({i, i + n, i + 1});
            triangles.push_back({i + 1, i + n, i + n + 1});
        }
        meshes_.push_back(std::make_unique<ContactMesh>(std::span(positions).subspan(first), triangles));
        bodies.push_back({.mesh = meshes_.back().get(), .first = first, .reach = 0.012f});
        while (positions.size() % 16 != 0) {
            positions.push_back({});
            velocities.push_back({});
        }
    }
    ZoneCounts resolve(double restitution = 0, bool as_bundles = true) {
        ImpactZones zones;
        zones.reserve(positions.size(), pairs.capacity());
        return resolve(zones, restitution, as_bundles);
    }
    ZoneCounts resolve(ImpactZones& zones, double restitution = 0, bool as_bundles = true) {
        const std::vector<float> of_bodies(bodies.size(), static_cast<float>(restitution));
        return zones.resolve({bodies, positions, pairs, find()}, {of_bodies, as_bundles}, velocities);
    }
    std::span<const std::uint32_t> find() {
        Parallel serial(1);
        LaidOut<PairFinder> finder;
        finder.reserve(bodies, pairs.capacity());
        finder.find(serial, bodies, positions, velocities, pairs);
        EXPECT_FALSE(pairs.overflowed);
        colliding.resize(pairs.size);
        colliding.resize(find_colliding(pairs, positions, velocities, 0.01f, 0, colliding));
        return colliding;
    }
    [[nodiscard]] Vector3d momentum() const {
        Vector3d sum = Vector3d::Zero();
        for (std::size_t i = 0; i < positions.size(); ++i)
            if (positions[i].w > 0)
                sum += xyz(velocities[i]).cast<double>() / static_cast<double>(positions[i].w);
        return sum;
    }
    [[nodiscard]] double size_of_momentum() const {
        double sum = 0;
        for (std::size_t i = 0; i < positions.size(); ++i)
            if (positions[i].w > 0) sum += static_cast<double>(xyz(velocities[i]).norm() / positions[i].w);
        return sum;
    }
    [[nodiscard]] Vector3d mean_velocity(std::size_t body) const {
        Vector3d sum = Vector3d::Zero();
        const std::uint32_t count = bodies[body].mesh->particles();
        for (std::uint32_t i = 0; i < count; ++i)
            sum += xyz(velocities[bodies[body].first + i]).cast<double>();
        return sum / count;
    }

    std::vector<Vec4> positions, velocities;
    std::vector<ContactBody> bodies;
    std::vector<std::uint32_t> colliding;
    LaidOut<PairList> pairs{100000};

  private:
    std::vector<std::unique_ptr<ContactMesh>> meshes_;
};

std::function<Vec3(float, float)> flat_at(float y, float x = 0) {
    return [=](float u, float v) { return Vec3{x + 0.1f * u, y, 0.1f * v}; };
}

TEST(ImpactZones, TwoSheetsTakeRestitutionAndKeepMomentum) {
    for (const double restitution : {0.0, 0.4, 1.0}) {
        for (const bool as_bundles : {false, true}) {
            Meeting meeting;
            meeting.add(6, 0.002f, {0.01f, -0.03f, 0}, flat_at(0.02f));
            meeting.add(6, 0.001f, {0, 0.02f, 0.005f}, flat_at(0, 0.004f));
            const Vector3d before = meeting.momentum(), tangential = meeting.mean_velocity(0);
            const double size = meeting.size_of_momentum();
            const ZoneCounts counts = meeting.resolve(restitution, as_bundles);
            EXPECT_EQ(counts.zones, 1u);
            EXPECT_EQ(counts.clusters, 2u);
            EXPECT_EQ(counts.unresolved + counts.programs + counts.merged, 0u);
            EXPECT_LT((meeting.momentum() - before).norm(), 1e-6 * size);
            const double after = meeting.mean_velocity(0).y() - meeting.mean_velocity(1).y();
            // Nearly all particles are in collision: those beyond the other's border go on.
            EXPECT_NEAR(after, 0.05 * restitution, 0.02);
            EXPECT_NEAR(meeting.velocities[14].y - meeting.velocities[meeting.bodies[1].first + 14].y,
                        0.05 * restitution, 1e-7);
            EXPECT_NEAR(meeting.mean_velocity(0).x(), tangential.x(), 1e-7) << "no friction";
            EXPECT_NEAR(meeting.velocities[14].y, (-0.03 * 2 + 0.02) / 3 + restitution * 0.05 / 3, 1e-3)
                << "closed form, if all collide";
        }
    }
}

TEST(ImpactZones, WhatSeparatesOrMissesIsLeftAlone) {
    Meeting apart;
    apart.add(5, 1, {0, 0.02f, 0}, flat_at(0.012f));
    apart.add(5, 1, {0, -0.02f, 0}, flat_at(0));
    apart.add(5, 1, {0, -0.02f, 0}, flat_at(0.5f));
    const std::vector<Vec4> before = apart.velocities;
    EXPECT_EQ(apart.resolve().zones, 0u);
    for (std::size_t i = 0; i < before.size(); ++i) EXPECT_EQ(apart.velocities[i].y, before[i].y);
}

TEST(ImpactZones, ThreeSheetsInARowSolveAllEquationsTogether) {
    // One falls on two that lie close: one zone, two equations and momentum.
    for (const double restitution : {0.0, 0.5}) {
        Meeting meeting;
        meeting.add(5, 3, {0, -0.05f, 0}, flat_at(0.03f));
        meeting.add(5, 1, {0, -0.001f, 0}, flat_at(0.015f));
        meeting.add(5, 2, {0, 0.001f, 0}, flat_at(0.004f));
        meeting.bodies[0].mask = 2;  // the first and the third do not meet
        meeting.bodies[0].layer = 1;
        meeting.bodies[1].layer = 3;
        meeting.bodies[1].mask = 7;
        meeting.bodies[2].layer = 4;
        meeting.bodies[2].mask = 2;
        const Vector3d before = meeting.momentum();
        const double size = meeting.size_of_momentum();
        const ZoneCounts counts = meeting.resolve(restitution, true);
        EXPECT_EQ(counts.zones, 1u);
        EXPECT_EQ(counts.collisions, 2u);
        EXPECT_EQ(counts.programs, 0u);
        EXPECT_LT((meeting.momentum() - before).norm(), 1e-6 * size);
        // v0 - v1 = C .049, v1 - v2 = C .002, 3 v0 + v1 + 2 v2 = 3 (-.05) - .001 + .002.
        Eigen::Matrix3d equations;
        equations << 1, -1, 0, 0, 1, -1, 3, 1, 2;
        const Vector3d known =
            equations.fullPivLu().solve(Vector3d(restitution * 0.049, restitution * 0.002, -0.149));
        for (std::size_t body = 0; body < 3; ++body)
            EXPECT_NEAR(meeting.mean_velocity(body).y(), known[static_cast<Eigen::Index>(body)], 1e-6)
                << body;
    }
}

TEST(ImpactZones, ACycleIsSolvedByLinearProgramming) {
    // All three collide with one another: the uppermost is fast enough to reach the lowest as well.
    Meeting meeting;
    meeting.add(5, 1, {0, -0.06f, 0}, flat_at(0.03f));
    meeting.add(5, 2, {0, -0.01f, 0}, flat_at(0.015f));
    meeting.add(5, 1, {0, 0.02f, 0}, flat_at(0));
    const Vector3d before = meeting.momentum();
    const double size = meeting.size_of_momentum(), restitution = 0.5;
    const ZoneCounts counts = meeting.resolve(restitution, true);
    EXPECT_EQ(counts.collisions, 3u);
    EXPECT_EQ(counts.programs, 1u);
    EXPECT_EQ(counts.relaxed, 0u);
    EXPECT_LT((meeting.momentum() - before).norm(), 1e-6 * size);
    const double v0 = meeting.mean_velocity(0).y(), v1 = meeting.mean_velocity(1).y(),
                 v2 = meeting.mean_velocity(2).y();
    EXPECT_GE(v0 - v1, restitution * 0.05 - 1e-7);
    EXPECT_GE(v1 - v2, restitution * 0.03 - 1e-7);
    EXPECT_GE(v0 - v2, restitution * 0.08 - 1e-7);
    // Least is where all three hold with equality, which parallel directions allow.
    EXPECT_NEAR(v0 - v2, restitution * 0.08, 1e-6);
}

TEST(ImpactZones, OfManyCyclesAsManyAsAreAllowedHaveAProgrammeAndTheRestAreRelaxed) {
    Meeting meeting;
    constexpr int count = ImpactZones::most_programs + 4;
    for (int k = 0; k < count; ++k) {
        const float aside = 0.3f * static_cast<float>(k);
        meeting.add(3, 1, {0, -0.06f, 0}, flat_at(0.03f, aside));
        meeting.add(3, 2, {0, -0.01f, 0}, flat_at(0.015f, aside));
        meeting.add(3, 1, {0, 0.02f, 0}, flat_at(0, aside));
    }
    const Vector3d before = meeting.momentum();
    const ZoneCounts counts = meeting.resolve(0.5);
    EXPECT_EQ(counts.zones, static_cast<std::uint32_t>(count));
    EXPECT_EQ(counts.programs, ImpactZones::most_programs);
    EXPECT_EQ(counts.relaxed, 4u);
    EXPECT_LT((meeting.momentum() - before).norm(), 1e-6 * meeting.size_of_momentum());
    for (std::size_t body = 0; body < meeting.bodies.size(); body += 3)
        EXPECT_GE(meeting.mean_velocity(body).y() - meeting.mean_velocity(body + 2).y(), 0.5 * 0.08 - 1e-6);
}

TEST(ImpactZones, OfTwoBodiesTheGreaterRestitutionHolds) {
    for (const bool turned : {false, true}) {
        Meeting meeting;
        meeting.add(5, 1, {0, -0.04f, 0}, flat_at(0.02f));
        meeting.add(5, 1, {0, 0.01f, 0}, flat_at(0));
        ImpactZones zones;
        zones.reserve(meeting.positions.size(), meeting.pairs.capacity());
        const std::vector<float> restitutions{turned ? 0.2f : 0.9f, turned ? 0.9f : 0.2f};
        zones.resolve({meeting.bodies, meeting.positions, meeting.pairs, meeting.find()}, {restitutions},
                      meeting.velocities);
        EXPECT_NEAR(meeting.mean_velocity(0).y() - meeting.mean_velocity(1).y(), 0.9 * 0.05, 1e-6);
    }
}

TEST(ImpactZones, WhatARoundHasStoppedBecomesABundle) {
    // Their means do not approach, to rounding either way; their ends do.
    for (const float rounding : {-1e-9f, 1e-9f}) {
        Meeting meeting;
        meeting.add(5, 1, {0, rounding, 0}, flat_at(0.012f));
        meeting.add(5, 1, {}, flat_at(0));
        for (std::size_t i = 0; i < 25; ++i)
            meeting.velocities[i].y += i % 5 == 0 ? -0.006f : i % 5 == 4 ? 0.006f : 0.0f;
        ImpactZones zones;
        zones.reserve(meeting.positions.size(), meeting.pairs.capacity());
        ASSERT_FALSE(meeting.find().empty());
        std::vector<std::uint32_t> colliding(meeting.pairs.size);  // so that all of both are in the clusters
        std::iota(colliding.begin(), colliding.end(), 0u);
        zones.resolve({meeting.bodies, meeting.positions, meeting.pairs, colliding},
                      {.as_bundles = true, .still = 1e-3}, meeting.velocities);
        EXPECT_NEAR(meeting.velocities[0].y, meeting.velocities[1].y, 1e-6) << rounding;
    }
}

/// A strip folded in two along a crease, or around a bend; the upper half comes down.
Meeting folded_strip(bool creased) {
    Meeting meeting;
    constexpr float gap = 0.02f;
    meeting.add(21, 1, {}, [=](float u, float v) {
        const float along = 0.4f * u;
        if (creased)
            return along <= 0.2f ? Vec3{along, 0, 0.1f * v}
                                 : Vec3{0.4f - along, gap * (along - 0.2f) / 0.2f, 0.1f * v};
        const float bend = 0.5f * gap * std::numbers::pi_v<float>, start = 0.2f - 0.5f * bend;
        if (along <= start) return Vec3{along, 0, 0.1f * v};
        if (along >= start + bend) return Vec3{start - (along - start - bend), gap, 0.1f * v};
        const float angle = (along - start) / bend * std::numbers::pi_v<float>;
        return Vec3{start + 0.5f * gap * std::sin(angle), 0.5f * gap * (1 - std::cos(angle)), 0.1f * v};
    });
    for (std::size_t i = 0; i < 441; ++i)
        meeting.velocities[i].y =
            meeting.positions[i].y > 0.5f * gap && meeting.positions[i].x < 0.17f ? -0.015f : 0.005f;
    return meeting;
}

TEST(ImpactZones, AFoldThatCollidesWithItselfIsSplit) {
    for (const bool creased : {false, true}) {
        Meeting meeting = folded_strip(creased);
        const Vector3d before = meeting.momentum();
        const double size = meeting.size_of_momentum();
        const ZoneCounts counts = meeting.resolve();
        const std::size_t colliding = meeting.colliding.size();
        EXPECT_GT(colliding, 100u);
        EXPECT_EQ(counts.zones, 1u) << creased;
        EXPECT_GE(counts.clusters, 2u);
        EXPECT_LT(counts.unresolved, colliding / 10) << creased;
        EXPECT_LT((meeting.momentum() - before).norm(), 1e-6 * size);
        // A crease's own particles are in no cluster, and go on as they did.
        EXPECT_LT(meeting.find().size(), colliding / (creased ? 2 : 20));
    }
}

TEST(ImpactZones, ClustersOfOneSurfaceThatAreCloseAreMerged) {
    // Two bumps of the upper sheet touch the lower one, two edges from each other: three clusters or more.
    Meeting meeting;
    const auto bumps = [](float u, float v) {
        const bool near =
            std::abs(v - 0.5f) < 0.26f && (std::abs(u - 0.2f) < 0.06f || std::abs(u - 0.6f) < 0.06f);
        return Vec3{0.1f * u, near ? 0.012f : 0.05f, 0.1f * v};
    };
    meeting.add(11, 1, {0, -0.02f, 0}, bumps);
    meeting.add(11, 1, {}, flat_at(0));
    const ZoneCounts counts = meeting.resolve();
    EXPECT_GE(counts.clusters, 3u);
    EXPECT_GE(counts.merged, 1u);
    EXPECT_EQ(counts.collisions, 1u) << "of the merged one and the lower sheet";
}

TEST(ImpactZones, WhatIsHeldGivesNothingWay) {
    Meeting meeting;
    meeting.add(5, 1, {0, -0.04f, 0}, flat_at(0.02f));
    meeting.add(5, 0, {0, 0.01f, 0}, flat_at(0));
    EXPECT_EQ(meeting.resolve(0.5, true).zones, 1u);
    EXPECT_NEAR(meeting.mean_velocity(1).y(), 0.01, 1e-9);
    EXPECT_NEAR(meeting.mean_velocity(0).y(), 0.01 + 0.5 * 0.05, 1e-6);
    Meeting held;
    held.add(5, 0, {0, -0.04f, 0}, flat_at(0.02f));
    held.add(5, 0, {0, 0.01f, 0}, flat_at(0));
    EXPECT_EQ(held.resolve(0.5, true).zones, 0u);
}

TEST(ImpactZones, ManySheetsAtOnceAreRelaxedAndKeepMomentum) {
    Meeting meeting;
    std::mt19937 random(3);
    std::uniform_real_distribution<float> uniform(-0.05f, 0.05f);
    for (int k = 0; k < 12; ++k)
        meeting.add(5, 1 + static_cast<float>(k % 3), {0.1f * uniform(random), uniform(random), 0},
                    flat_at(0.012f * static_cast<float>(k)));
    const Vector3d before = meeting.momentum();
    const double size = meeting.size_of_momentum();
    ImpactZones zones;
    zones.reserve(meeting.positions.size(), meeting.pairs.capacity());
    const ZoneCounts counts = meeting.resolve(zones);
    EXPECT_GE(counts.collisions, 12u);
    EXPECT_LT((meeting.momentum() - before).norm(), 1e-6 * size);
    const std::size_t first = meeting.colliding.size();
    std::size_t left = first;
    for (int round = 0; round < 6 && left > 0; ++round) {
        meeting.resolve(zones);
        left = meeting.find().size();
    }
    EXPECT_EQ(left, 0u) << "of " << first << ": rounds find what the first ones newly brought together";
    EXPECT_LT((meeting.momentum() - before).norm(), 1e-6 * size);
}

/// The least cost over all vertices of the feasible region; infinite if there is none.
double by_enumeration(const Eigen::VectorXd& cost, const Eigen::MatrixXd& a, const Eigen::VectorXd& b) {
    const Eigen::Index n = cost.size(), m = b.size();
    double least = std::numeric_limits<double>::infinity();
    for (std::uint32_t set = 0; set < 1u << (n + m); ++set) {
        if (std::popcount(set) != n) continue;
        Eigen::MatrixXd tight(n, n);
        Eigen::VectorXd right(n);
        for (Eigen::Index row = 0, k = 0; k < n + m; ++k) {
            if ((set >> k & 1) == 0) continue;
            tight.row(row) = k < m ? a.row(k) : Eigen::RowVectorXd(Eigen::RowVectorXd::Unit(n, k - m));
            right[row++] = k < m ? b[k] : 0;
        }
        const Eigen::FullPivLU<Eigen::MatrixXd> factors(tight);
        if (!factors.isInvertible()) continue;
        const Eigen::VectorXd x = factors.solve(right);
        if (x.minCoeff() >= -1e-9 && (a * x - b).minCoeff() >= -1e-9) least = std::min(least, cost.dot(x));
    }
    return least;
}

TEST(LinearProgramTest, FindsTheVertexThatEnumerationFinds) {
    std::mt19937 random(11);
    std::uniform_real_distribution<double> uniform(-1, 1);
    LinearProgram program(5);
    int solved = 0, refused = 0;
    for (int trial = 0; trial < 400; ++trial) {
        const Eigen::Index n = 1 + trial % 5, m = 1 + trial / 5 % 5;
        Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor> a(m, n);
        Eigen::VectorXd b(m), cost(n);
        for (double& value : a.reshaped()) value = uniform(random);
        for (double& value : b) value = trial % 7 == 0 ? 0 : 1e-3 * uniform(random);
        for (double& value : cost) value = 0.3 + uniform(random);
        if (trial % 3 == 0 && m > 1) {  // vertices that coincide
            a.row(m - 1) = a.row(0);
            b[m - 1] = b[0];
        }
        std::vector<double> x(static_cast<std::size_t>(n), -1);
        const double least = by_enumeration(cost, a, b);
        const bool found = program.minimise({cost.data(), static_cast<std::size_t>(n)},
                                            {a.data(), static_cast<std::size_t>(n * m)},
                                            {b.data(), static_cast<std::size_t>(m)}, x);
        if (!found) {
            ++refused;
            EXPECT_EQ(x[0], -1) << "unchanged";
            // No point, or no end: then some direction of no inequality's loss lowers the cost.
            if (std::isfinite(least)) {
                EXPECT_LT(cost.minCoeff(), 0) << "a cost that is nowhere negative has a least";
            }
            continue;
        }
        ++solved;
        const Eigen::VectorXd at = Eigen::Map<const Eigen::VectorXd>(x.data(), n);
        EXPECT_GE(at.minCoeff(), -1e-12);
        EXPECT_GE((a * at - b).minCoeff(), -1e-9);
        EXPECT_NEAR(cost.dot(at), least, 1e-9) << trial;
    }
    EXPECT_GT(solved, 150);
    EXPECT_GT(refused, 30);
}

}  // namespace
}  // namespace weft::test
