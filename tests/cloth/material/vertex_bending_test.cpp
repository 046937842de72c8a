// Bending of general meshes by vertices: the plate's energy and equilibrium, whatever the triangles.

#include "cloth/mesh/rest/vertex_bending.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <numbers>
#include <random>

#include <Eigen/Dense>

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
    for (const Sample& sample : samples) {
        SCOPED_TRACE(sample.name);
        const ClothModel model = must(cook(mesh_of(sample, side)));
        const double cell = static_cast<double>(sample.aspect) / side;
        for (const Height& height : curvatures) {
            const std::vector<double> force = forces(model, height);
            for (std::uint32_t i = 0; i < model.particle_count; ++i)
                if (cells_inside(model, i, cell) > 3.5) {      // at a border moments of 1 N would have to act
                    EXPECT_LE(std::abs(force[i]), 0.06) << i;  // hinges by themselves: up to 9
                }
        }
    }
}

// A sheet that is bent along x alone would need moments at its borders of constant x: nothing gives these, so
// the half cells beside them are not bent.
TEST(VertexBending, BearsNoMomentAboutABorder) {
    constexpr std::uint32_t side = 24;
    const Height height = [](double x, double) { return x * x / 2; };
    for (const Sample& sample : samples) {
        SCOPED_TRACE(sample.name);
        const ClothModel model = must(cook(mesh_of(sample, side)));
        const std::vector<double> force = forces(model, height);
        double energy = 0;
        for (std::uint32_t i = 0; i < model.particle_count; ++i) {
            const auto x = static_cast<double>(model.positions[i].x);
            energy -= 0.5 * force[i] * height(x, 0);
        }
        EXPECT_NEAR(2 * energy, 1 - 1.0 / side, 0.3 / side);
    }
}

// Half the integral of the curvature's square: of a bump sin^4 sin^4, whose border bears nothing.
TEST(VertexBending, HasThePlatesEnergyOnAnyMesh) {
    constexpr std::uint32_t side = 48;
    constexpr double pi = std::numbers::pi;
    const auto bump = [](double s) { return s < 0 || s > 1 ? 0 : std::pow(std::sin(pi * s), 4); };
    const Height height = [&](double x, double z) { return bump(x) * bump(z); };
    // Means over (0, 1): of sin^8 35 / 128; of the slope's square pi^2 5 / 8; of the curvature's 4 pi^4.
    const double flat = 35.0 / 128, slope = 5 * pi * pi / 8, curved = 4 * std::pow(pi, 4);
    const double of_plate = 0.5 * (2 * curved * flat + 2 * slope * slope);
    for (const Sample& sample : samples) {
        SCOPED_TRACE(sample.name);
        const ClothModel model = must(cook(mesh_of(sample, side)));
        const std::vector<double> force = forces(model, height);
        double energy = 0;
        for (std::uint32_t i = 0; i < model.particle_count; ++i)
            energy -=
                0.5 * force[i] *
                height(static_cast<double>(model.positions[i].x), static_cast<double>(model.positions[i].z));
        EXPECT_NEAR(energy / of_plate, 1, sample.aspect > 1 ? 0.06 : 0.02);
    }
}

// Relaxation divides by at least half of the largest eigenvalue, and bending pulls nothing apart for good.
TEST(VertexBending, IsBoundedByItsDiagonalAndNeverNegative) {
    std::vector<Mesh> meshes{fan(1), fan(6), fan(20), sphere(1), tube(4, 9), moebius_strip(12)};
    for (const std::uint32_t side : {2u, 3u, 4u, 9u}) meshes.push_back(loose_sheet(side, side));
    for (const Sample& sample : samples) meshes.push_back(mesh_of(sample, 9));
    for (std::size_t k = 0; k < meshes.size(); ++k) {
        SCOPED_TRACE(k);
        const ClothModel model = must(cook(meshes[k]));
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
