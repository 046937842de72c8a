// Cloth that stiffens as it is stretched, against the law that Fabric::stiffening states.

#include <gtest/gtest.h>

#include <cmath>
#include <numeric>
#include <string>

#include "strips.h"
#include "tests/cloth/fixtures.h"
#include "tests/cloth/meshes.h"
#include "tests/cloth/system/dense_algebra.h"

namespace weft::test {
namespace {

constexpr double last_strain = 1.0 / 6;

/// Tension per width of K e (1 + s e), along its tangent from 1/6 on; linear in compression.
double law(double stiffness, double stiffening, double strain) {
    if (strain <= 0) return stiffness * strain;
    const double c = std::min(strain, last_strain);
    return stiffness * (c * (1 + stiffening * c) + (strain - c) * (1 + 2 * stiffening * c));
}

double strain_under(double tension, double stiffness, double stiffening) {
    double least = 0, most = tension / stiffness;
    while (most - least > 1e-9) {
        const double middle = (least + most) / 2;
        (law(stiffness, stiffening, middle) > tension ? most : least) = middle;
    }
    return least;
}

struct HangingStrip {
    bool is_sheet;
    std::uint32_t cells;  ///< along it, a quarter of them across
    float density;
};

constexpr float strip_stiffness = 100, strip_stiffening = 40;

/// By how much it is longer than its 1 m.
double extension_of(const HangingStrip& strip_) {
    Mesh mesh;
    if (strip_.is_sheet) {
        mesh = must(make_sheet({.rows = strip_.cells + 1,
                                .columns = strip_.cells / 4 + 1,
                                .origin = {0, 0, 0},
                                .u = {0, 0, 0.25f},
                                .v = {0, -1, 0}}));
    } else {
        const float cell = 1 / static_cast<float>(strip_.cells);
        mesh = strip(strip_.cells, strip_.cells / 4, cell, true);
        for (Vec3& x : mesh.positions) x = {0, -(x.x + cell), x.z};
    }
    ClothSettings settings;
    settings.fabric = {.areal_density = strip_.density,
                       .warp = strip_stiffness,
                       .weft = strip_stiffness,
                       .shear = 20,
                       .bending = 0,
                       .stiffening = strip_stiffening};
    settings.air_damping = 8;
    World world = must(World::create(vacuum(downwards)));
    const ClothId id = must(world.add_cloth(mesh, settings));
    std::vector<std::uint32_t> bottom;
    for (std::uint32_t i = 0; i < mesh.positions.size(); ++i) {
        if (mesh.positions[i].y > -1e-5f) (void)world.pin(id, i);
        if (mesh.positions[i].y < -1 + 1e-5f) bottom.push_back(i);
    }
    for (int k = 0; k < 150; ++k) world.step(h);
    double sum = 0;
    const ClothView& view = *world.cloth(id);
    for (const std::uint32_t i : bottom)
        sum -= static_cast<double>(view.positions[view.vertex_to_particle[i]].y);
    return sum / static_cast<double>(bottom.size()) - 1;
}

TEST(Stiffening, HungStripIsLongerByWhatTheLawSays) {
    for (const bool is_sheet : {true, false}) {
        for (const std::uint32_t cells : {16u, 32u}) {
            for (const float density : {1.0f, 6.0f}) {  // strains up to 8 and, past the law's end, 22 %
                SCOPED_TRACE(testing::Message()
                             << (is_sheet ? "sheet " : "mesh ") << cells << " " << density);
                double expected = 0;
                constexpr int parts = 1000;
                for (int k = 0; k < parts; ++k)
                    expected += strain_under(static_cast<double>(density) * 9.81 * (k + 0.5) / parts,
                                             static_cast<double>(strip_stiffness),
                                             static_cast<double>(strip_stiffening)) /
                                parts;
                EXPECT_NEAR(extension_of({is_sheet, cells, density}), expected, 0.03 * expected);
            }
        }
    }
}

/// Stretched at random, by up to 40 %, here and there in compression.
Cloth stretched(bool is_sheet, float displacement) {
    Cloth cloth = crumpled(is_sheet ? sheet(6, 7) : loose_sheet(6, 7), displacement, 40);
    cloth.settings.fabric.bending = 0;
    cloth.settings.fabric.damping = 0;
    cloth.settings.fabric.shear = 8;
    cloth.settings.fabric.stiffening = 25;
    for (Vec4& x : cloth.state.positions.span()) {
        x.x *= 1.12f;
        x.z *= 1.2f;
    }
    return cloth;
}

/// Of the springs' parts in a cell, or of strains in a triangle [J].
double sheet_energy(const Cloth& cloth, const Eigen::VectorXd& x) {
    const ClothModel& model = cloth.model;
    const Fabric& fabric = cloth.settings.fabric;
    const auto length = [&](std::uint32_t i, std::uint32_t j) {
        return (x.segment<3>(3 * j) - x.segment<3>(3 * i)).norm();
    };
    double energy = 0;
    for (std::uint32_t row = 0; row + 1 < model.rows; ++row) {
        for (std::uint32_t column = 0; column + 1 < model.columns; ++column) {
            const std::uint32_t near = row * model.columns + column;
            const auto [a, b] = sides_of_cell(model, near);
            for_each_part_of_cell(
                model, sheet_moduli(fabric), near, [&](std::uint32_t i, std::uint32_t j, double k) {
                    const double extension = length(i, j) - rest_length_between(model, i, j);
                    energy += 0.5 * k * extension * extension;
                });
            for (const auto& [i, j, stiffness] :
                 {std::tuple(near, near + 1, fabric.warp),
                  std::tuple(near + model.columns, near + model.columns + 1, fabric.warp),
                  std::tuple(near, near + model.columns, fabric.weft),
                  std::tuple(near + 1, near + model.columns + 1, fabric.weft)}) {
                // Half of a cell's width: integral of s K e^2, the tangent's part past 1/6.
                const double rest = static_cast<double>(rest_length_between(model, i, j));
                const double e = std::max(0.0, length(i, j) / rest - 1), c = std::min(e, last_strain);
                const double integral = c * c * c / 3 + (e - c) * (c * c + c * (e - c));
                energy += static_cast<double>(fabric.stiffening * stiffness) * a * b / 2 * integral;
            }
        }
    }
    return energy;
}

double mesh_energy(const Cloth& cloth, const Eigen::VectorXd& x) {
    const Fabric& fabric = cloth.settings.fabric;
    double energy = 0;
    for (std::uint32_t t = 0; t < cloth.model.triangles.size(); ++t) {
        const TriangleMembrane membrane = triangle_membrane(cloth.model, t, fabric);
        const TriangleStiffening stiffening = triangle_stiffening(cloth.model, t, fabric);
        const Triangle& corners = cloth.model.triangles[t];
        std::array<double, 3> dl{};
        for (std::size_t k = 0; k < 3; ++k)
            dl[k] = (x.segment<3>(3 * corners[(k + 1) % 3]) - x.segment<3>(3 * corners[k])).norm() -
                    membrane.rest_lengths[k];
        for (std::size_t k = 0; k < 3; ++k) {
            energy += 0.5 * membrane.own[k] * dl[k] * dl[k];
            for (std::size_t m = 0; m < 3; ++m) energy += 0.5 * membrane.shared[k][m] * dl[k] * dl[m];
        }
        for (std::size_t axis = 0; axis < 2; ++axis) {
            const double e = std::max(
                0.0, std::inner_product(dl.begin(), dl.end(), stiffening.strains[axis].begin(), 0.0));
            const double c = std::min(e, last_strain);
            energy += stiffening.moduli[axis] * (c * c * c / 3 + (e - c) * (c * c + c * (e - c)));
        }
    }
    return energy;
}

TEST(Stiffening, ForceIsTheEnergysGradient) {
    for (const bool is_sheet : {true, false}) {
        SCOPED_TRACE(is_sheet);
        const Cloth cloth = stretched(is_sheet, 0.02f);
        const auto energy = is_sheet ? sheet_energy : mesh_energy;
        Parallel serial(1);
        const auto system = make_system(cloth.model, cloth.settings);
        constexpr float instant = 0x1p-40f;
        const StepEquation equation = equation_of(cloth, instant, Vector3::Zero());
        AlignedBuffer<Vec4> residual(cloth.state.size());
        system->residual(serial, equation, cloth.state.velocities.span(), residual.span());
        const Eigen::VectorXd force = flat(residual.span()) / static_cast<double>(instant);
        const Eigen::VectorXd x = flat(cloth.state.positions.span());
        Eigen::VectorXd expected(x.size());
        for (Eigen::Index k = 0; k < x.size(); ++k) {
            const Eigen::VectorXd e = 1e-6 * Eigen::VectorXd::Unit(x.size(), k);
            expected[k] = -(energy(cloth, x + e) - energy(cloth, x - e)) / 2e-6;
        }
        EXPECT_LT((force - expected).norm(), 1e-5 * expected.norm());
        Cloth linear = stretched(is_sheet, 0.02f);
        linear.settings.fabric.stiffening = 0;
        EXPECT_GT(energy(cloth, x), 2 * energy(linear, x)) << "else the test shows little";
    }
}

// In tension nothing is left out of the coupled matrix.
TEST(Stiffening, MatrixIsTheForcesSlopeAndPositiveDefinite) {
    for (const bool is_sheet : {true, false}) {
        SCOPED_TRACE(is_sheet);
        const Cloth cloth = stretched(is_sheet, 0.003f);
        const std::uint32_t n = cloth.model.particle_count;
        Parallel serial(1);
        const auto system = make_system(cloth.model, cloth.settings);
        const StepEquation equation = equation_of(cloth, h, Vector3::Zero());
        AlignedBuffer<Vec4> v(n), x = random_rows(n, 1, 4), product(n), ahead(n), behind(n), after(n),
                                  before(n);
        system->linearise(serial, equation, v.span(), LinearisedAbout::iterate);
        system->multiply_coupled(serial, {}, x.span(), product.span());
        constexpr float e = 4e-3f;
        for (std::uint32_t i = 0; i < n; ++i) {
            ahead[i] = to_vec4(e * xyz(x[i]), 0);
            behind[i] = to_vec4(-e * xyz(x[i]), 0);
        }
        system->residual(serial, equation, ahead.span(), after.span());
        system->residual(serial, equation, behind.span(), before.span());
        const Eigen::VectorXd slope =
            (flat(before.span()) - flat(after.span())) / (2 * static_cast<double>(e));
        EXPECT_LT((flat(product.span()) - slope).norm(), 5e-3 * slope.norm());
    }
    for (const bool is_sheet : {true, false}) {
        const Cloth cloth = stretched(is_sheet, 0.05f);
        Parallel serial(1);
        const auto system = make_system(cloth.model, cloth.settings);
        AlignedBuffer<Vec4> v(cloth.model.particle_count);
        system->linearise(serial, equation_of(cloth, 1), v.span(), LinearisedAbout::iterate);
        EXPECT_GT(eigenvalues(dense_coupled(*system).matrix)[0], 0);
    }
}

TEST(Stiffening, SettingsThatCannotHonourItAreRefused) {
    World world = must(World::create({.threads = 1}));
    const auto refusal = [&](const ClothSettings& settings) {
        const auto cloth = world.add_cloth(sheet(3, 3), settings);
        return cloth ? std::string() : cloth.error().message;
    };
    ClothSettings settings;
    settings.fabric.stiffening = 5;
    for (const Method& method : {Method(Jacobi{}), Method(Chebyshev{}), Method(ConjugateGradient{}),
                                 Method(Multilevel{}), Method(SymplecticEuler{})}) {
        settings.method = method;
        EXPECT_EQ(refusal(settings), "");
    }
    for (const Method& method : {Method(Xpbd{}), Method(Fibres{})}) {
        settings.method = method;
        EXPECT_NE(refusal(settings).find("Fabric::stiffening is more than 0"), std::string::npos);
    }
    settings.method = Multilevel{};
    settings.finite_elements.enabled = true;
    EXPECT_NE(refusal(settings).find("Fabric::stiffening is more than 0"), std::string::npos);
    settings.finite_elements.enabled = false;
    settings.fabric.weft = 1e7f;
    settings.fabric.stiffening = 500;
    EXPECT_NE(refusal(settings).find("Fabric::stiffening is 500; it must be from 0 to 297"),
              std::string::npos)
        << refusal(settings);
    settings.fabric.stiffening = 290;
    EXPECT_EQ(refusal(settings), "");
}

/// As the panel's sliders have it: everything at its end, in a gale, dragged by a pin.
TEST(Stiffening, StaysSoundAtItsGreatestInAGale) {
    for (const Method& method :
         {Method(Multilevel{}), Method(Jacobi{}), Method(Chebyshev{}), Method(ConjugateGradient{})}) {
        for (const bool is_sheet : {true, false}) {
            SCOPED_TRACE(testing::Message() << method.index() << " " << is_sheet);
            WorldSettings air{.threads = 1};
            air.wind = {.velocity = {5, 0, 40}, .gust = 1};
            World world = must(World::create(air));
            ClothSettings settings;
            settings.fabric.stiffening = 1000;
            settings.method = method;
            const ClothId id =
                must(world.add_cloth(is_sheet ? sheet(17, 17) : loose_sheet(17, 17), settings));
            const Vec4 corner = world.cloth(id)->positions[world.cloth(id)->vertex_to_particle[16]];
            ASSERT_TRUE(world.pin(id, 0).ok() && world.pin(id, 16).ok());
            for (int step = 0; step < 120; ++step) {
                const float pull = step > 60 ? 0.3f : 0.0f;
                ASSERT_TRUE(world.move_pin(id, 16, {corner.x + pull, corner.y, corner.z}).ok());
                const StepReport& report = world.step(h);
                ASSERT_FALSE(has(report.flags, StepFlags::state_restored)) << step;
                ASSERT_LT(report.peak_speed, 90);
            }
        }
    }
}

TEST(Stiffening, CanBeSwitchedBetweenStepsAndLeavesNoTrace) {
    const auto run = [](bool switched) {
        World world = must(World::create({.threads = 1}));
        ClothSettings settings;
        const ClothId id = must(world.add_cloth(sheet(9, 9), settings));
        if (switched) {
            settings.fabric.stiffening = 50;
            EXPECT_TRUE(world.set_cloth_settings(id, settings).ok());
            settings.fabric.stiffening = 20;
            EXPECT_TRUE(world.set_cloth_settings(id, settings).ok());
            settings.fabric.stiffening = 0;
            EXPECT_TRUE(world.set_cloth_settings(id, settings).ok());
        }
        EXPECT_TRUE(world.pin(id, 0).ok());
        for (int k = 0; k < 5; ++k) world.step(h);
        return std::vector<Vec4>(world.cloth(id)->positions.begin(), world.cloth(id)->positions.end());
    };
    EXPECT_TRUE(same_bytes(run(true), run(false)));
}

}  // namespace
}  // namespace weft::test
