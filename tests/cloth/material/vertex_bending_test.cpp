// Bending of general meshes by vertices: the plate's energy and equilibrium, whatever the triangles, and
// whatever cloth's rigidity along the weft, here z, is over that along the warp, x.

#include "cloth/mesh/rest/vertex_bending.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <numbers>
#include <random>

#include <Eigen/Dense>

#include "cloth/mesh/rest/linear_bending.h"
#include "cloth/mesh/rest/rigidity.h"
#include "tests/cloth/fixtures.h"
#include "tests/cloth/meshes.h"

namespace weft::test {
namespace {

enum class Diagonals { same, chessboard, shorter };

struct Sample {
    std::string name;
    Diagonals diagonals;
    float jitter;      ///< of a cell
    float aspect = 1;  ///< of cells
};
const Sample samples[] = {{"one diagonal", Diagonals::same, 0},
                          {"chessboard", Diagonals::chessboard, 0},
                          {"jittered", Diagonals::same, 0.15f},
                          {"shorter diagonals", Diagonals::shorter, 0.3f},
                          {"three to one", Diagonals::same, 0, 3}};

/// In the plane y = 0, `side` cells of size 1 / side along x; inner vertices are moved.
Mesh mesh_of(const Sample& sample, std::uint32_t side) {
    std::mt19937 random(7);
    const float cell = 1.0f / static_cast<float>(side), height = cell * sample.aspect;
    std::uniform_real_distribution<float> offset(-sample.jitter, sample.jitter);
    const auto rows = static_cast<std::uint32_t>(static_cast<float>(side) / sample.aspect);
    Mesh mesh;
    for (std::uint32_t r = 0; r <= rows; ++r)
        for (std::uint32_t c = 0; c <= side; ++c) {
            const bool is_inner = r > 0 && c > 0 && r < rows && c < side;
            const float x = offset(random), z = offset(random);
            mesh.positions.push_back({cell * (static_cast<float>(c) + (is_inner ? x : 0)), 0,
                                      height * (static_cast<float>(r) + (is_inner ? z : 0))});
        }
    const auto apart = [&](std::uint32_t a, std::uint32_t b) {
        return (to_vector(mesh.positions[a]) - to_vector(mesh.positions[b])).norm();
    };
    for (std::uint32_t r = 0; r < rows; ++r)
        for (std::uint32_t c = 0; c < side; ++c) {
            const std::uint32_t a = r * (side + 1) + c, b = a + side + 1;
            const bool is_main =
                sample.diagonals == Diagonals::same ||
                (sample.diagonals == Diagonals::chessboard ? (r + c) % 2 == 0
                                                           : apart(a, b + 1) < apart(b, a + 1));
            if (is_main) {
                mesh.triangles.push_back({a, b, b + 1});
                mesh.triangles.push_back({a, b + 1, a + 1});
            } else {
                mesh.triangles.push_back({a, b, a + 1});
                mesh.triangles.push_back({a + 1, b, b + 1});
            }
        }
    return mesh;
}

using Height = std::function<double(double x, double z)>;

/// The force of bending of rigidity 1 at each particle, by heights over the plane [N].
std::vector<double> forces(const ClothModel& model, const Height& height) {
    std::vector<double> of(model.particle_count), result(model.particle_count);
    for (std::uint32_t i = 0; i < model.particle_count; ++i)
        of[i] = height(static_cast<double>(model.positions[i].x), static_cast<double>(model.positions[i].z));
    for (std::uint32_t i = 0; i < model.particle_count; ++i)
        for (std::uint32_t e = model.spring_offsets[i]; e < model.spring_offsets[i + 1]; ++e)
            result[i] += static_cast<double>(model.bending[e]) * (of[model.neighbours[e]] - of[i]);
    return result;
}

/// The energy of bending of rigidity 1 at such heights [N m].
double energy_of(const ClothModel& model, const Height& height) {
    const std::vector<double> force = forces(model, height);
    double energy = 0;
    for (std::uint32_t i = 0; i < model.particle_count; ++i)
        energy -=
            0.5 * force[i] *
            height(static_cast<double>(model.positions[i].x), static_cast<double>(model.positions[i].z));
    return energy;
}

constexpr float ratios[] = {1, 0.25f, 6};  // of rigidities along weft and warp

/// How far a particle is from the border, in cells.
double cells_inside(const ClothModel& model, std::uint32_t i, double cell) {
    const auto x = static_cast<double>(model.positions[i].x), z = static_cast<double>(model.positions[i].z);
    return std::min({x, z, 1 - x, 1 - z}) / cell;
}

TEST(VertexBending, LeavesASheetOfConstantCurvatureInEquilibriumInside) {
    constexpr std::uint32_t side = 24;
    const Height curvatures[] = {[](double x, double) { return x * x / 2; },
                                 [](double, double z) { return z * z / 2; },
                                 [](double x, double z) { return x * z; }};
    for (const Sample& sample : samples)
        for (const float ratio : ratios) {
            SCOPED_TRACE(sample.name + " " + std::to_string(ratio));
            const ClothModel model = must(cook(mesh_of(sample, side), ratio));
            const double cell = static_cast<double>(sample.aspect) / side;
            const double stiffest = std::max(static_cast<double>(ratio), 1.0);
            for (const Height& height : curvatures) {
                const std::vector<double> force = forces(model, height);
                for (std::uint32_t i = 0; i < model.particle_count; ++i)
                    if (cells_inside(model, i, cell) > 3.5) {  // at a border moments of 1 N would have to act
                        EXPECT_LE(std::abs(force[i]), 0.06 * stiffest) << i;  // hinges by themselves: up to 9
                    }
            }
        }
}

// A sheet that is bent along x alone would need moments at its borders of constant x: nothing gives these, so
// the half cells beside them are not bent.
TEST(VertexBending, BearsNoMomentAboutABorder) {
    constexpr std::uint32_t side = 24;
    const Height along_warp = [](double x, double) { return x * x / 2; };
    const Height along_weft = [](double, double z) { return z * z / 2; };
    for (const Sample& sample : samples)
        for (const float ratio : ratios) {
            SCOPED_TRACE(sample.name + " " + std::to_string(ratio));
            const ClothModel model = must(cook(mesh_of(sample, side), ratio));
            const double cell = 1.0 / side;
            EXPECT_NEAR(2 * energy_of(model, along_warp), 1 - cell, 0.3 * cell);
            EXPECT_NEAR(2 * energy_of(model, along_weft) / static_cast<double>(ratio),
                        1 - static_cast<double>(sample.aspect) * cell,
                        0.3 * static_cast<double>(sample.aspect) * cell);
        }
}

// Half the integral of the curvature's square: of a bump sin^4 sin^4, whose border bears nothing.
TEST(VertexBending, HasThePlatesEnergyOnAnyMesh) {
    constexpr std::uint32_t side = 60;
    constexpr double pi = std::numbers::pi;
    const auto bump = [](double s) { return s < 0 || s > 1 ? 0 : std::pow(std::sin(pi * s), 4); };
    const Height height = [&](double x, double z) { return bump(x) * bump(z); };
    // Means over (0, 1): of sin^8 35 / 128; of the slope's square pi^2 5 / 8; of the curvature's 4 pi^4.
    const double flat = 35.0 / 128, slope = 5 * pi * pi / 8, curved = 4 * std::pow(pi, 4);
    for (const float ratio : ratios) {
        SCOPED_TRACE(ratio);
        const auto r = static_cast<double>(ratio);
        const double of_plate = 0.5 * ((1 + r) * curved * flat + 2 * std::sqrt(r) * slope * slope);
        for (const Sample& sample : samples)
            EXPECT_NEAR(energy_of(must(cook(mesh_of(sample, side), ratio)), height) / of_plate, 1,
                        sample.aspect > 1 ? 0.06 : 0.02)
                << sample.name;
        const Mesh sheet = must(make_sheet({side + 1, side + 1, {0, 0, 0}, {1, 0, 0}, {0, 0, 1}}));
        EXPECT_NEAR(energy_of(must(cook(sheet, ratio)), height) / of_plate, 1, 0.02);
    }
}

// Which directions are stiff goes with the pattern, which lies askew on the mesh, and mirrored.
TEST(VertexBending, FollowsThePattern) {
    constexpr std::uint32_t side = 40;
    constexpr float ratio = 6, turn = 0.6f;
    const double r = static_cast<double>(ratio), cu = std::cos(static_cast<double>(turn)),
                 su = std::sin(static_cast<double>(turn));
    const auto bump = [](double s) {
        return s < 0 || s > 1 ? 0 : std::pow(std::sin(std::numbers::pi * s), 4);
    };
    for (const float handed : {1.0f, -1.0f}) {
        Mesh mesh = mesh_of(samples[3], side);
        for (const Vec3& x : mesh.positions)
            mesh.pattern.push_back({std::cos(turn) * x.x + std::sin(turn) * x.z,
                                    handed * (std::cos(turn) * x.z - std::sin(turn) * x.x)});
        const ClothModel model = must(cook(mesh, ratio));
        // A roll across the middle, at several angles to the warp: it bends along one direction most.
        for (const double angle : {0.0, 0.4, 0.785, 1.3, 2.0, 2.8}) {
            const double c = std::cos(angle), s = std::sin(angle);
            const Height roll = [&](double x, double z) {
                return bump(0.5 + (x - 0.5) * c + (z - 0.5) * s) * bump(x) * bump(z);
            };
            // The plate's, of curvatures along warp u and weft v, by differences.
            double expected = 0;
            constexpr int cells = 200;
            constexpr double h = 1e-4;
            for (int i = 0; i < cells; ++i)
                for (int k = 0; k < cells; ++k) {
                    const double x = (i + 0.5) / cells, z = (k + 0.5) / cells;
                    const auto second = [&](double ax, double az, double bx, double bz) {
                        return (roll(x + h * (ax + bx), z + h * (az + bz)) -
                                roll(x + h * (ax - bx), z + h * (az - bz)) -
                                roll(x - h * (ax - bx), z - h * (az - bz)) +
                                roll(x - h * (ax + bx), z - h * (az + bz))) /
                               (4 * h * h);
                    };
                    const double uu = second(cu, su, cu, su), vv = second(-su, cu, -su, cu),
                                 uv = second(cu, su, -su, cu);
                    expected += 0.5 * (uu * uu + r * vv * vv + 2 * std::sqrt(r) * uv * uv) / (cells * cells);
                }
            EXPECT_NEAR(energy_of(model, roll) / expected, 1, 0.03) << angle;
        }
    }
}

// The moment is along x alone, so that borders along x bear none, though they run askew to the warp.
TEST(VertexBending, BordersAskewToTheWarpAreFree) {
    constexpr std::uint32_t side = 24;
    constexpr double turn = 0.6;
    for (const Sample& sample : samples)
        for (const float ratio : ratios) {
            SCOPED_TRACE(sample.name + " " + std::to_string(ratio));
            Mesh mesh = mesh_of(sample, side);
            for (const Vec3& x : mesh.positions)
                mesh.pattern.push_back(
                    {static_cast<float>(std::cos(turn)) * x.x + static_cast<float>(std::sin(turn)) * x.z,
                     static_cast<float>(std::cos(turn)) * x.z - static_cast<float>(std::sin(turn)) * x.x});
            const ClothModel model = must(cook(mesh, ratio));
            const Tensor k =
                rigidity_about({std::cos(turn), std::sin(turn)}, static_cast<double>(ratio)).inverse().col(0);
            const std::vector<double> force = forces(model, [&](double x, double z) {
                return (k[0] * x * x + k[1] * z * z) / 2 + k[2] / std::numbers::sqrt2 * x * z;
            });
            const double cell = static_cast<double>(sample.aspect) / side;
            for (std::uint32_t i = 0; i < model.particle_count; ++i) {
                const auto x = static_cast<double>(model.positions[i].x);
                if (std::min(x, 1 - x) / cell > 3.5) {
                    EXPECT_LE(std::abs(force[i]), 0.06 * std::max(static_cast<double>(ratio), 1.0)) << i;
                }
            }
        }
}

// XPBD and fibres have hinges: each bends by B (cos^2 + sqrt(r) sin^2)^2 of its normal's angle to the warp.
TEST(VertexBending, HingesAreAsStiffAsTheFabricIsAcrossThem) {
    for (const Sample& sample : samples)
        for (const float ratio : ratios) {
            const ClothModel model = must(cook(mesh_of(sample, 12), ratio));
            const std::vector<BendingElement> found = linear_bending(model),
                                              alike = linear_bending(must(cook(mesh_of(sample, 12))));
            ASSERT_EQ(found.size(), alike.size());
            for (std::size_t e = 0; e < found.size(); ++e) {
                ASSERT_EQ(found[e].particles, alike[e].particles);
                const Vector3 edge =
                    xyz(model.positions[found[e].particles[1]]) - xyz(model.positions[found[e].particles[0]]);
                const Eigen::Vector3d along = edge.cast<double>().normalized();
                const double root =
                    along.z() * along.z() + std::sqrt(static_cast<double>(ratio)) * along.x() * along.x();
                EXPECT_NEAR(static_cast<double>(found[e].k / alike[e].k) / (root * root), 1, 1e-4);
            }
        }
}

// Relaxation divides by at least half of the largest eigenvalue, and bending pulls nothing apart for good.
TEST(VertexBending, IsBoundedByItsDiagonalAndNeverNegative) {
    std::vector<Mesh> meshes{fan(1), fan(6), fan(20), sphere(1), tube(4, 9), moebius_strip(12)};
    for (const std::uint32_t side : {2u, 3u, 4u, 9u}) meshes.push_back(loose_sheet(side, side));
    for (const Sample& sample : samples) meshes.push_back(mesh_of(sample, 9));
    for (std::size_t k = 0; k < 3 * meshes.size(); ++k) {
        SCOPED_TRACE(k);
        const ClothModel model = must(cook(meshes[k / 3], std::array{1.0f, 0.01f, 100.0f}[k % 3]));
        const auto n = static_cast<Eigen::Index>(model.particle_count);
        Eigen::MatrixXd q = Eigen::MatrixXd::Zero(n, n);
        Eigen::VectorXd scale(n);
        for (std::uint32_t i = 0; i < model.particle_count; ++i) {
            const auto row = static_cast<Eigen::Index>(i);
            for (std::uint32_t e = model.spring_offsets[i]; e < model.spring_offsets[i + 1]; ++e) {
                q(row, static_cast<Eigen::Index>(model.neighbours[e])) -=
                    static_cast<double>(model.bending[e]);
                q(row, row) += static_cast<double>(model.bending[e]);
            }
            const double own = q(row, row) + static_cast<double>(model.bending_excess[i]);
            scale[row] = own > 0 ? 1 / std::sqrt(own) : 0;
        }
        const Eigen::VectorXd values =
            Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd>(scale.asDiagonal() * q * scale.asDiagonal())
                .eigenvalues();
        EXPECT_LE(values.maxCoeff(), 2.0001);
        EXPECT_GE(values.minCoeff(), -1e-5);
    }
}

}  // namespace
}  // namespace weft::test
