#include <gtest/gtest.h>

#include <random>

#include "collision/particles/self_contacts.h"
#include "engine/vector.h"
#include "tests/collision/contact/crumpled_sheet.h"

namespace weft::test::self_response {
namespace {

constexpr float h = 1.0f / 60;

struct Particles {
    std::vector<Vec4> positions, velocities;
};

SelfContactCounts avoid(Particles& particles, float distance, float friction, int threads = 1) {
    Parallel parallel(threads);
    SelfContacts contacts(particles.positions);
    contacts.find(parallel, particles.positions, {}, distance, SelfCollisionSearch::exact);
    return contacts.respond(parallel, distance, friction, h, particles.positions, particles.velocities);
}

float distance_between(const Particles& p, std::size_t i, std::size_t j) {
    return (xyz(p.positions[i]) - xyz(p.positions[j])).norm();
}

/// A crumpled sheet whose particles have random masses and velocities, and some more than 16 contacts.
Particles crowded_sheet() {
    Particles particles{crumpled_sheet(40).positions, {}};
    std::mt19937 random(3);
    std::uniform_real_distribution<float> uniform(-1, 1);
    for (Vec4& p : particles.positions) {
        p.w = 200 + 100 * uniform(random);
        particles.velocities.push_back({uniform(random), uniform(random), uniform(random), 0});
    }
    return particles;
}

/// Sum of squared overlaps over all pairs, in units of distance^2.
double overlap(const std::vector<Vec4>& positions, float distance) {
    double sum = 0;
    for (std::size_t i = 0; i < positions.size(); ++i) {
        for (std::size_t j = 0; j < i; ++j) {
            const auto apart = static_cast<double>((xyz(positions[i]) - xyz(positions[j])).norm() / distance);
            if (apart < 1) sum += (1 - apart) * (1 - apart);
        }
    }
    return sum;
}

TEST(SelfResponse, TwoParticlesEndAtTheDistanceAboutTheirCentreOfMass) {
    Particles pair{{{0.01f, 0.02f, 0.03f, 1}, {0.04f, 0.02f, -0.01f, 3}}, {{}, {}}};
    const Vector3 centre = 0.75f * xyz(pair.positions[0]) + 0.25f * xyz(pair.positions[1]);
    const SelfContactCounts counts = avoid(pair, 0.1f, 0.3f);
    EXPECT_NEAR(distance_between(pair, 0, 1), 0.1f, 1e-7f);
    EXPECT_LT((0.75f * xyz(pair.positions[0]) + 0.25f * xyz(pair.positions[1]) - centre).norm(), 1e-8f);
    EXPECT_EQ(counts.pairs, 1u);
    EXPECT_EQ(counts.peak, 1u);
    EXPECT_EQ(counts.dropped, 0u);
}

TEST(SelfResponse, APairsShareIsThatOfTheOneWithMoreContacts) {
    // The hub has three contacts, the others one each.
    const float apart = 0.05f, distance = 0.06f;
    Particles star{{{0, 0, 0, 1}, {apart, 0, 0, 1}, {0, apart, 0, 1}, {0, 0, apart, 1}},
                   {{}, {-3, 0, 0, 0}, {}, {}}};
    EXPECT_EQ(avoid(star, distance, 0).pairs, 3u);
    const float moved = 0.5f * (distance - apart) / 3;
    EXPECT_NEAR(star.positions[1].x, apart + moved, 1e-7f);
    EXPECT_NEAR(star.positions[2].y, apart + moved, 1e-7f);
    for (const float coordinate : {star.positions[0].x, star.positions[0].y, star.positions[0].z})
        EXPECT_NEAR(coordinate, -moved, 1e-7f);
    EXPECT_NEAR(star.velocities[1].x, -3 + 1.5f / 3, 1e-6f);
    EXPECT_NEAR(star.velocities[0].x, -1.5f / 3, 1e-6f);
}

TEST(SelfResponse, PinnedParticlesDoNotMove) {
    Particles particles{{{0, 0, 0, 0}, {0.05f, 0, 0, 1}, {5, 0, 0, 0}, {5, 0.01f, 0, 0}},
                        {{}, {-1, 0, 0, 0}, {}, {0, -1, 0, 0}}};
    const Particles before = particles;
    const SelfContactCounts counts = avoid(particles, 0.1f, 0.3f);
    for (const std::size_t pinned : {0u, 2u, 3u}) {
        EXPECT_EQ(xyz(particles.positions[pinned]), xyz(before.positions[pinned]));
        EXPECT_EQ(xyz(particles.velocities[pinned]), xyz(before.velocities[pinned]));
    }
    EXPECT_NEAR(particles.positions[1].x, 0.1f, 1e-7f);
    EXPECT_NEAR(particles.velocities[1].x, 0, 1e-7f);
    EXPECT_EQ(counts.pairs, 1u);
}

TEST(SelfResponse, ApproachEndsAtTheCommonVelocityAndSeparationIsUntouched) {
    Particles meeting{{{0, 0, 0, 1}, {0.05f, 0, 0, 3}}, {{2, 0, 0, 0}, {-1, 0, 0, 0}}};
    avoid(meeting, 0.1f, 0.3f);
    // Masses 1 and 1/3: the centre moves at (2 - 1/3) / (4/3).
    EXPECT_NEAR(meeting.velocities[0].x, 1.25f, 1e-6f);
    EXPECT_NEAR(meeting.velocities[1].x, 1.25f, 1e-6f);

    Particles parting{{{0, 0, 0, 1}, {0.05f, 0, 0, 3}}, {{-2, 1, 0, 0}, {1, 0, 0, 0}}};
    const Particles before = parting;
    avoid(parting, 0.1f, 0.3f);
    for (std::size_t i = 0; i < 2; ++i) EXPECT_EQ(xyz(parting.velocities[i]), xyz(before.velocities[i]));
}

TEST(SelfResponse, FrictionSticksBelowCoulombsLimitAndSlidesAbove) {
    const auto relative_sliding = [](float sliding) {
        Particles layers{{{0, 0.05f, 0, 1}, {0, 0, 0, 1}}, {{sliding, -1, 0, 0}, {}}};
        const float x = layers.positions[0].x - layers.positions[1].x;
        avoid(layers, 0.1f, 0.3f);
        const float change = layers.velocities[0].x - layers.velocities[1].x - sliding;
        // The step's motion loses what friction took from the velocity.
        EXPECT_NEAR(layers.positions[0].x - layers.positions[1].x - x, h * change, 1e-7f);
        return sliding + change;
    };
    EXPECT_NEAR(relative_sliding(0.29f), 0, 1e-6f);
    EXPECT_NEAR(relative_sliding(0.5f), 0.2f, 1e-6f);
    EXPECT_NEAR(relative_sliding(-0.5f), -0.2f, 1e-6f);
}

TEST(SelfResponse, LayersAtRestOnASlopeDoNotCreep) {
    // The lower particle is pinned; gravity pulls at an angle below the friction angle.
    Particles layers{{{0, 0.1f, 0, 1}, {0, 0, 0, 0}}, {{}, {}}};
    for (int step = 0; step < 600; ++step) {
        Vec4 &x = layers.positions[0], &v = layers.velocities[0];
        v.x += h * 2.0f;
        v.y -= h * 9.0f;
        x.x += h * v.x;
        x.y += h * v.y;
        avoid(layers, 0.1f, 0.3f);
    }
    EXPECT_NEAR(layers.positions[0].x, 0, 2e-4f);
    EXPECT_NEAR(layers.positions[0].y, 0.1f, 2e-4f);
}

/// Sums over all particles, in double precision: what the response changed, and how much it moved in all.
struct Balance {
    Eigen::Vector3d change = Eigen::Vector3d::Zero();
    double size = 0;

    void add(const Eigen::Vector3d& term) {
        change += term;
        size += term.norm();
    }
    void expect_kept(double tolerance) const {
        EXPECT_GT(size, 0);
        EXPECT_LT(change.norm(), tolerance * size);
    }
};

TEST(SelfResponse, MomentumIsKeptWithManyContactsAndFullLists) {
    for (const float friction : {0.0f, 0.5f}) {
        for (const float edges : {1.5f, 4.0f}) {
            const Particles before = crowded_sheet();
            Particles after = before;
            const SelfContactCounts counts = avoid(after, edges / 40, friction);
            EXPECT_GT(counts.pairs, 1000u);
            EXPECT_EQ(counts.dropped > 0, edges == 4.0f);

            Balance linear, centre, angular, moment;
            for (std::size_t i = 0; i < before.positions.size(); ++i) {
                const double mass = 1 / static_cast<double>(before.positions[i].w);
                const Eigen::Vector3d x = xyz(before.positions[i]).cast<double>();
                const Eigen::Vector3d dx = mass * (xyz(after.positions[i]).cast<double>() - x);
                const Eigen::Vector3d dv =
                    mass * (xyz(after.velocities[i]) - xyz(before.velocities[i])).cast<double>();
                linear.add(dv);
                centre.add(dx);
                angular.add(x.cross(dv));
                moment.add(x.cross(dx));
            }
            linear.expect_kept(1e-7);
            centre.expect_kept(1e-5);  // positions are rounded at their distance from the origin
            if (friction == 0) {
                angular.expect_kept(1e-7);
                moment.expect_kept(1e-5);
            }
        }
    }
}

TEST(SelfResponse, OverlapShrinksInEveryRound) {
    Particles particles = crowded_sheet();
    for (Vec4& v : particles.velocities) v = {};
    const float distance = 1.5f / 40;
    double before = overlap(particles.positions, distance);
    EXPECT_GT(before, 10);
    for (int round = 0; round < 10; ++round) {
        avoid(particles, distance, 0.3f);
        const double after = overlap(particles.positions, distance);
        EXPECT_LT(after, before) << "round " << round;
        before = after;
    }
}

TEST(SelfResponse, KineticEnergyDoesNotGrow) {
    const auto energy = [](const Particles& particles) {
        double sum = 0;
        for (std::size_t i = 0; i < particles.positions.size(); ++i) {
            sum += static_cast<double>(xyz(particles.velocities[i]).squaredNorm() / particles.positions[i].w);
        }
        return sum;
    };
    for (const float edges : {0.75f, 1.5f, 4.0f}) {
        Particles particles = crowded_sheet();
        const double before = energy(particles);
        avoid(particles, edges / 40, 0.5f);
        EXPECT_LT(energy(particles), before);
    }
}

TEST(SelfResponse, ParticlesAtOnePointOpenUpAndStayFinite) {
    Particles heap{std::vector<Vec4>(500, Vec4{1, 2, 3, 1}), std::vector<Vec4>(500)};
    const float distance = 0.1f;
    const SelfContactCounts first = avoid(heap, distance, 0.3f);
    EXPECT_GT(first.pairs, 500u);
    EXPECT_GT(first.dropped, 400u);
    EXPECT_EQ(first.peak, SelfContacts::capacity);
    for (int round = 0; round < 200; ++round) avoid(heap, distance, 0.3f);
    for (const Vec4& p : heap.positions) EXPECT_TRUE(xyz(p).allFinite());
    EXPECT_LT(overlap(heap.positions, distance) / 500, 0.1);
    const Bounds bounds = bounds_of(heap.positions);
    for (const float side : {bounds.upper.x - bounds.lower.x, bounds.upper.y - bounds.lower.y,
                             bounds.upper.z - bounds.lower.z}) {
        EXPECT_GT(side, 4 * distance);   // a heap of 500, not a line or a sheet
        EXPECT_LT(side, 40 * distance);  // and not an explosion
    }
}

}  // namespace
}  // namespace weft::test::self_response
