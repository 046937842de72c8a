// Chebyshev's iteration: its error against theory, its interval, and where it fails.

#include "cloth/methods/linear/chebyshev.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <utility>

#include "tests/cloth/fixtures.h"
#include "tests/cloth/meshes.h"
#include "tests/cloth/system/dense_algebra.h"

namespace weft::test {
namespace {

/// Chebyshev's polynomial of degree n, anywhere on the real line.
double chebyshev_polynomial(int n, double x) {
    if (std::abs(x) <= 1) return std::cos(n * std::acos(x));
    const double magnitude = std::cosh(n * std::acosh(std::abs(x)));
    return x < 0 && n % 2 == 1 ? -magnitude : magnitude;
}

struct ChebyshevProblem {
    explicit ChebyshevProblem(Cloth of, float h = 1.0f / 60)
        : cloth(std::move(of)),
          system(assembled(cloth, h)),
          reference(dense(*system)),
          diagonal(inverse(dense_preconditioner(*system))),
          modes(test::modes(reference.matrix, diagonal)),
          exact(solution(reference.matrix, reference.right_side)),
          dv(cloth.model.particle_count),
          scratch(cloth.model.particle_count) {}

    void solve(int iterations, Spectrum interval) {
        Parallel serial(1);
        solve_chebyshev(serial, *system, iterations, interval, scratch.span(), dv.span());
    }
    [[nodiscard]] Eigen::VectorXd error() const { return flat(dv.span()) - exact; }
    [[nodiscard]] double energy(const Eigen::VectorXd& e) const {
        return std::sqrt(e.dot(reference.matrix * e));
    }
    [[nodiscard]] Spectrum spectrum() const {
        return {modes.eigenvalues.minCoeff(), modes.eigenvalues.maxCoeff()};
    }

    Cloth cloth;
    std::unique_ptr<ImplicitSystem> system;
    DenseSystem reference;
    Eigen::MatrixXd diagonal;
    Modes modes;
    Eigen::VectorXd exact;
    AlignedBuffer<Vec4> dv;
    AlignedBuffer<Vec4> scratch;
};

/// Springs along threads alone, which make a bipartite graph: the spectrum reaches from nearly 0 to nearly 2.
Cloth bipartite(float stiffness) {
    Cloth cloth = crumpled(sheet(6, 6), 0.01f, stiffness);
    cloth.settings.fabric.shear = cloth.settings.fabric.bending = 0;
    return cloth;
}

TEST(Chebyshev, ErrorIsItsPolynomialOfTheEigenvalues) {
    Cloth cloth = crumpled(sheet(5, 5), 0.03f, 200.0f);
    cloth.pin(0);
    ChebyshevProblem problem(std::move(cloth));
    const Modes& modes = problem.modes;
    for (const Spectrum interval : {Spectrum{0.05, 2}, Spectrum{0.3, 1.7}}) {
        const double centre = (interval.largest + interval.least) / 2;
        const double half_width = (interval.largest - interval.least) / 2;
        for (const int iterations : {1, 2, 3, 8, 20}) {
            problem.solve(iterations, interval);
            const int n = iterations + 1;
            Eigen::VectorXd factors = modes.eigenvalues;
            for (double& lambda : factors) {
                lambda = chebyshev_polynomial(n, (centre - lambda) / half_width) /
                         chebyshev_polynomial(n, centre / half_width);
            }
            const Eigen::VectorXd coefficients =
                modes.vectors.transpose() * (problem.diagonal * -problem.exact);
            const Eigen::VectorXd expected = modes.vectors * factors.cwiseProduct(coefficients);
            EXPECT_LT((problem.error() - expected).norm(), 1e-4 * problem.exact.norm()) << iterations;
        }
    }
}

TEST(Chebyshev, ErrorKeepsItsBoundOnTheInterval) {
    ChebyshevProblem problem(crumpled(sheet(6, 6), 0.02f, 1000.0f));
    const Spectrum interval{problem.spectrum().least, 2};
    const double ratio = (interval.largest + interval.least) / (interval.largest - interval.least);
    for (int iterations = 1; iterations <= 60; ++iterations) {
        problem.solve(iterations, interval);
        const double bound = problem.energy(problem.exact) / chebyshev_polynomial(iterations + 1, ratio);
        EXPECT_LE(problem.energy(problem.error()), bound * 1.001 + 1e-5 * problem.energy(problem.exact))
            << iterations;
    }
}

TEST(Chebyshev, DivergesWhereTheIntervalEndsBelowTheLargestEigenvalue) {
    ChebyshevProblem problem(bipartite(1e4f));
    const Spectrum spectrum = problem.spectrum();
    ASSERT_GT(spectrum.largest, 1.98);
    ASSERT_LT(spectrum.largest, 2);
    problem.solve(300, {0.005, 2});
    EXPECT_LT(problem.energy(problem.error()), 0.02 * problem.energy(problem.exact));
    problem.solve(60, {0.005, 0.95 * spectrum.largest});
    EXPECT_GT(problem.energy(problem.error()), 100 * problem.energy(problem.exact));
}

TEST(ChebyshevInterval, EndsAtTwoAndReducesFourfold) {
    for (const int iterations : {1, 2, 5, 16, 64, 1000}) {
        const Spectrum interval = chebyshev_interval(iterations, 1e-9);
        EXPECT_EQ(interval.largest, 2);
        const double ratio = (interval.largest + interval.least) / (interval.largest - interval.least);
        EXPECT_NEAR(chebyshev_polynomial(iterations + 1, ratio), 4, 1e-6) << iterations;
        EXPECT_EQ(chebyshev_interval(iterations, 0.9).least, 0.9) << "what the cloth says, if it is higher";
    }
}

TEST(ChebyshevInterval, LeastEigenvalueIsEstimatedFromAbove) {
    // As a Rayleigh quotient is an upper bound.
    for (const float stiffness : {10.0f, 1e3f, 1e5f}) {
        for (const Mesh& mesh : {sheet(8, 8), loose_sheet(8, 8)}) {
            const ChebyshevProblem problem(crumpled(mesh, 0.0f, stiffness));
            double area = 0;
            for (const float a : problem.cloth.model.rest_area.span()) area += static_cast<double>(a);
            const double estimate =
                least_eigenvalue(problem.cloth.model.info, problem.cloth.settings, area, 1.0f / 60);
            const double least = problem.spectrum().least;
            EXPECT_GT(estimate, 0.999 * least) << stiffness;
            EXPECT_LT(estimate, 3 * least) << stiffness;
        }
    }
}

/// The highest speed that is left after a second of a stiff, flat sheet whose particles start with noise,
/// relative to that after the first step.
double noise_left(const Method& method) {
    WorldSettings world_settings;
    world_settings.gravity = {0, 0, 0};
    world_settings.threads = 1;
    world_settings.wind.air_density = 0;
    World world = World::create(world_settings).value();
    Mesh mesh = sheet(12, 12);
    mesh.pattern = mesh.texcoords;
    std::mt19937 random(5);
    std::uniform_real_distribution<float> offset(-1e-4f, 1e-4f);
    for (Vec3& x : mesh.positions) x = {x.x + offset(random), 0, x.z + offset(random)};
    ClothSettings settings;
    settings.fabric = {.warp = 4e4f, .weft = 4e4f, .shear = 0, .bending = 0, .damping = 0};
    settings.air_damping = 0;
    settings.method = method;
    (void)world.add_cloth(mesh, settings).value();
    world.step(1.0f / 60);
    const float first = world.report().peak_speed;
    for (int k = 0; k < 60; ++k) world.step(1.0f / 60);
    return static_cast<double>(world.report().peak_speed / first);
}

TEST(Chebyshev, NeverSetsStiffClothBuzzing) {
    // What the fourfold reduction is for: every count of iterations damps noise.
    for (const int iterations : {1, 2, 3, 4, 7, 8, 16, 31}) {
        EXPECT_LT(noise_left(Chebyshev{.iterations = iterations}), 0.5) << iterations;
    }
}

}  // namespace
}  // namespace weft::test
