// Bending: gradients against finite differences, energies against those of bent plates, and a strip of cloth
// that hangs over an edge against the heavy elastica.

#include "cloth/mesh/rest/bending.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <functional>
#include <numbers>
#include <span>

#include "strips.h"
#include "tests/cloth/meshes.h"

namespace weft::test {
namespace {

/// x^T Q x / 2 of quadratic bending with rigidity 1, in double precision.
double quadratic_energy(const Bending& bending, const std::vector<Eigen::Vector3d>& x) {
    double energy = 0;
    for_each_quadratic_term(bending, [&](std::uint32_t i, std::uint32_t j, float k) {
        energy -= 0.25 * static_cast<double>(k) * (x[i] - x[j]).squaredNorm();
    });
    return energy;
}

/// Equilateral triangles of side 1 in the plane z = 0.
Mesh equilateral(std::uint32_t rows, std::uint32_t columns) {
    Mesh mesh = loose_sheet(rows, columns);
    for (std::uint32_t r = 0; r < rows; ++r)
        for (std::uint32_t c = 0; c < columns; ++c)
            mesh.positions[r * columns + c] = {static_cast<float>(c) + 0.5f * static_cast<float>(r % 2),
                                               static_cast<float>(r) * std::sqrt(0.75f), 0};
    mesh.triangles.clear();
    for (std::uint32_t r = 0; r + 1 < rows; ++r) {
        for (std::uint32_t c = 0; c + 1 < columns; ++c) {
            const std::uint32_t a = r * columns + c, b = a + columns;
            if (r % 2 == 0) {
                mesh.triangles.push_back({a, a + 1, b});
                mesh.triangles.push_back({a + 1, b + 1, b});
            } else {
                mesh.triangles.push_back({a, a + 1, b + 1});
                mesh.triangles.push_back({a, b + 1, b});
            }
        }
    }
    return mesh;
}

/// B/2 kappa^2 per area, away from the border, where some edges are missing: the difference of two sizes has
/// none of it.
double energy_per_area(const std::function<Mesh(std::uint32_t)>& mesh_of, double direction) {
    double energy[2], area[2];
    for (int k = 0; k < 2; ++k) {
        const std::uint32_t size = k == 0 ? 21 : 41;
        const ClothModel model = cook(mesh_of(size)).value();
        std::vector<Eigen::Vector3d> x;
        double inside = 0;
        for (std::uint32_t i = 0; i < model.particle_count; ++i) {
            const Eigen::Vector3d p = xyz(model.positions[i]).cast<double>();
            const double along = std::cos(direction) * p.x() + std::sin(direction) * p.y();
            x.emplace_back(0, 0, 0.5 * along * along);
            inside += static_cast<double>(model.rest_area[i]);
        }
        energy[k] = quadratic_energy(bending_elements(model), x);
        area[k] = inside;
    }
    // energy = density area + border length; lengths go as the square root of areas, up to a row.
    const double ratio = std::sqrt(area[1] / area[0]);
    return (energy[1] - ratio * energy[0]) / (area[1] - ratio * area[0]);
}

TEST(QuadraticBending, RegularMeshesBendToCylindersAsThePlateDoes) {
    const auto grid = [](std::uint32_t n) {
        Mesh mesh = loose_sheet(n, n);
        for (Vec3& p : mesh.positions)
            p = {p.x * static_cast<float>(n - 1), p.z * static_cast<float>(n - 1), 0};
        return mesh;
    };
    const auto triangles = [](std::uint32_t n) { return equilateral(n, n); };
    for (const double direction : {0.0, 0.3, 0.785, 1.2, 2.5})
        EXPECT_NEAR(energy_per_area(triangles, direction), 0.5, 0.01) << direction;
    // Along the threads; half as stiff again along the diagonals, whose triangles cannot tell twist from
    // bending.
    for (const double direction : {0.0, std::numbers::pi / 2})
        EXPECT_NEAR(energy_per_area(grid, direction), 0.5, 0.01) << direction;
    EXPECT_NEAR(energy_per_area(grid, std::numbers::pi / 4), 0.75, 0.01);
}

TEST(QuadraticBending, FlatClothHasNoneAndRigidMotionAddsNone) {
    const ClothModel model = cook(strip(12, 5, 0.1f, true)).value();
    const Bending bending = bending_elements(model);
    std::vector<Eigen::Vector3d> flat, bent, moved;
    const Eigen::Matrix3d turn =
        Eigen::AngleAxisd(1.2, Eigen::Vector3d(1, -2, 0.5).normalized()).toRotationMatrix();
    for (std::uint32_t i = 0; i < model.particle_count; ++i) {
        const Eigen::Vector3d p = xyz(model.positions[i]).cast<double>();
        flat.emplace_back(turn * p + Eigen::Vector3d(3, 1, -2));
        bent.emplace_back(std::sin(p.x()), p.z() * p.z(), std::cos(p.x()));
        moved.emplace_back(turn * bent.back() + Eigen::Vector3d(3, 1, -2));
    }
    EXPECT_NEAR(quadratic_energy(bending, flat), 0, 1e-4);
    const double energy = quadratic_energy(bending, bent);
    EXPECT_GT(energy, 0.01);
    EXPECT_NEAR(quadratic_energy(bending, moved), energy, 1e-5 * energy);
}

/// Two triangles about the z axis, one of them turned up by `degrees` from where both lie flat.
Mesh folded_panel(float degrees) {
    const float angle = degrees * std::numbers::pi_v<float> / 180;
    Mesh mesh;
    mesh.positions = {
        {0, 0, -0.1f}, {0, 0, 0.1f}, {-0.1f, 0, 0}, {0.1f * std::cos(angle), 0.1f * std::sin(angle), 0}};
    mesh.triangles = {{0, 1, 2}, {1, 0, 3}};
    return mesh;
}

/// Of such a panel, in [0, 360).
double fold_of(std::span<const Vec4> positions, std::span<const std::uint32_t> particles) {
    const Vec4 &edge = positions[particles[0]], &fixed = positions[particles[2]],
               &turned = positions[particles[3]];
    const double from =
        std::atan2(static_cast<double>(fixed.y - edge.y), static_cast<double>(fixed.x - edge.x));
    const double to =
        std::atan2(static_cast<double>(turned.y - edge.y), static_cast<double>(turned.x - edge.x));
    const double degrees = (to - from) * 180 / std::numbers::pi + 180;
    return degrees - 360 * std::floor(degrees / 360);
}

class FoldedPanel : public testing::TestWithParam<float> {};

// A hinge's angle jumps from 180 to -180 degrees where its panels meet: what rests near there must not feel
// it.
TEST_P(FoldedPanel, RestsWhereItWasFoldedAndComesBackFromBothSides) {
    for (const float push : {0.0f, 15.0f, -15.0f}) {
        SCOPED_TRACE(push);
        Cloth cloth(cook(folded_panel(GetParam())).value(), [] {
            ClothSettings settings;
            settings.air_damping = 2;
            settings.fabric.areal_density = 0.2f;
            settings.fabric.bending = 1e-3f;
            settings.finite_elements = {.enabled = true, .dihedral = true};
            return settings;
        }());
        const std::span<const std::uint32_t> particles = cloth.model.vertex_to_particle;
        const Vec3 pushed = folded_panel(GetParam() + push).positions[3];
        Vec4& turned = cloth.state.positions[particles[3]];
        turned = {pushed.x, pushed.y, pushed.z, turned.w};
        for (const std::uint32_t vertex : {0u, 1u, 2u}) cloth.pin(particles[vertex]);
        const auto from_rest = [&] {
            const double fold = fold_of(cloth.state.positions.span(), particles);
            return std::abs(std::remainder(fold - static_cast<double>(GetParam()), 360.0));
        };
        for (int step = 0; step < 60; ++step) {
            relax_to_rest(cloth, {0, 0, 0}, 0.05f, 1);
            ASSERT_LE(from_rest(), std::abs(push) + 0.5f) << "the long way round, in step " << step;
        }
        EXPECT_LE(from_rest(), 1);
    }
}
INSTANTIATE_TEST_SUITE_P(Degrees, FoldedPanel,
                         testing::Values(10.0f, 90.0f, 170.0f, 179.0f, 181.0f, 190.0f, 350.0f));

enum class BendingOf { springs, elements, dihedral };
struct Cantilever {
    bool irregular;
    BendingOf bending;
    float ratio;                ///< the strip runs along the weft if this is not 1
    double gamma, reach, drop;  ///< Gamma = rho g L^3 / B; over L
};
void PrintTo(const Cantilever& c, std::ostream* out) {
    *out << (c.irregular ? "irregular" : "regular")
         << (c.bending == BendingOf::dihedral   ? " dihedral "
             : c.bending == BendingOf::elements ? " quadratic "
                                                : " by vertices ")
         << c.gamma << (c.ratio == 1 ? "" : " along the weft");
}

class HeavyElastica : public testing::TestWithParam<Cantilever> {};

// Of length 1, clamped in the middle of its first cells, which is where the edges that bend there stand for;
// B = 1.
TEST_P(HeavyElastica, StripHangsAsTheElasticaDoes) {
    const Cantilever& expected = GetParam();
    constexpr std::uint32_t columns = 24, rows = 3;
    constexpr float cell = 1.0f / (columns + 0.5f), g = 9.81f;
    ClothSettings settings;
    settings.air_damping = 0;
    settings.fabric.damping = 0;
    settings.fabric.areal_density = static_cast<float>(expected.gamma) / g;
    settings.fabric.warp = settings.fabric.weft = 1e4f;
    settings.fabric.shear = 5e3f;
    settings.fabric.bending = 1 / expected.ratio;
    settings.fabric.bending_ratio = expected.ratio;
    settings.finite_elements = {.enabled = expected.bending != BendingOf::springs,
                                .dihedral = expected.bending == BendingOf::dihedral};
    Mesh mesh = strip(columns + 1, rows, cell, expected.irregular);
    if (expected.ratio != 1)
        for (Vec2& along : mesh.pattern) std::swap(along.x, along.y);
    Cloth cloth(cook(mesh).value(), settings);
    const auto at = [&](std::uint32_t row, std::uint32_t column) {
        return cloth.model.vertex_to_particle[row * (columns + 2) + column];
    };
    for (std::uint32_t r = 0; r <= rows; ++r) {
        cloth.pin(at(r, 0));
        cloth.pin(at(r, 1));
    }
    relax_to_rest(cloth, {0, -g, 0}, 0.3f, 40);
    double reach = 0, drop = 0;
    for (std::uint32_t r = 0; r <= rows; ++r) {
        const Vec4& tip = cloth.state.positions[at(r, columns + 1)];
        reach += static_cast<double>(tip.x + 0.5f * cell) / (rows + 1);
        drop -= static_cast<double>(tip.y) / (rows + 1);
    }
    // Hinges of irregular elements take some of what the strip is stiffer by across itself.
    const double of_elements = expected.ratio == 1 ? 0.03 : 0.04;
    const double tolerance = expected.bending == BendingOf::springs ? 0.02 : of_elements;
    EXPECT_NEAR(reach, expected.reach, tolerance * expected.reach);
    EXPECT_NEAR(drop, expected.drop, tolerance * expected.drop);
}

std::vector<Cantilever> cantilevers() {
    std::vector<Cantilever> all;
    for (const bool irregular : {false, true})
        for (const BendingOf bending : {BendingOf::springs, BendingOf::elements, BendingOf::dihedral})
            for (const auto& [gamma, reach, drop] :
                 {std::array{1.0, .99125, .12347}, std::array{5.0, .84666, .49591},
                  std::array{10.0, .65635, .70020}, std::array{30.0, .34276, .87309}})
                for (const float ratio : {1.0f, 0.2f, 5.0f})
                    all.push_back({irregular, bending, ratio, gamma, reach, drop});
    return all;
}
INSTANTIATE_TEST_SUITE_P(Gamma, HeavyElastica, testing::ValuesIn(cantilevers()));

// Bending grows with the fourth power of a cell's inverse side, mass shrinks with its square. Floats once
// lost the mass of such rows beside their bending, and cloth of a millimetre flew off its table at 65 m/s.
/// How far the end of an upright strip, held at its other end and pushed for a second, is sideways after ten
/// [m]. The push is of .02 m/s^2; the strip is a hundred thousand times stiffer in its own plane.
double sideways(const FiniteElements& elements, float gamma) {
    constexpr float density = 0.2f, length = 0.2f, cell = length / 16;
    Mesh mesh = strip(16, 2, cell, true);
    for (Vec3& x : mesh.positions) x = {x.x, x.z, 0};
    ClothSettings settings;
    const float free_length = length - 0.5f * cell;
    settings.fabric.areal_density = density;
    settings.fabric.warp = settings.fabric.weft = 2e4f;
    settings.fabric.shear = 8e3f;
    settings.fabric.bending = density * 9.81f * free_length * free_length * free_length / gamma;
    settings.finite_elements = elements;
    settings.air_damping = 2;
    settings.sleep_speed = 0;  // it leaves the upright slowly
    World world = World::create(vacuum({0, -9.81f, 0.02f})).value();
    const ClothId id = world.add_cloth(mesh, settings).value();
    std::vector<std::uint32_t> pins;
    for (std::uint32_t i = 0; i < mesh.positions.size(); ++i)
        if (mesh.positions[i].x < 0.5f * cell) pins.push_back(i);
    EXPECT_TRUE(world.pin(id, pins));
    for (int k = 0; k < 600; ++k) {
        if (k == 60) {
            EXPECT_TRUE(world.set_settings(vacuum({0, -9.81f, 0})));
        }
        world.step(h);
    }
    const ClothView cloth = world.cloth(id).value();
    return std::abs(static_cast<double>(cloth.positions[cloth.vertex_to_particle[16]].z));
}

// Michell (1899), "Elastic stability of long beams under transverse forces": Gamma of 18 for a narrow strip.
// Small pushes are lost where a cycle of the default method takes cloth to be stiff sideways, as well.
TEST(LateralBuckling, StripsGiveWayByTheDefaultMethodWhateverResists) {
    for (const FiniteElements& elements : {FiniteElements{}, FiniteElements{.enabled = true},
                                           FiniteElements{.enabled = true, .dihedral = true}}) {
        EXPECT_LT(sideways(elements, 15), 0.004) << elements.enabled << elements.dihedral;
        EXPECT_GT(sideways(elements, 35), 0.04) << elements.enabled << elements.dihedral;
    }
}

TEST(HeldRigidity, ClothOfAMillimetreLiesStill) {
    std::vector<ClothSettings> all(5);
    all[1].method = Jacobi{};
    all[2].method = ConjugateGradient{};
    for (const std::size_t k : {3u, 4u}) all[k].finite_elements = {.enabled = true, .dihedral = k == 4};
    for (std::size_t k = 0; k < all.size(); ++k) {
        for (const std::uint32_t cells : {8u, 16u}) {
            constexpr float side = 1e-3f;
            Mesh mesh =
                make_sheet({.rows = cells + 1, .columns = cells + 1, .u = {side, 0, 0}, .v = {0, 0, side}})
                    .value();
            mesh.rows = mesh.columns = 0;
            for (Vec3& x : mesh.positions) x.y += all[k].thickness + 5 * side;
            World world = World::create({.threads = 1}).value();
            const ClothId id = world.add_cloth(mesh, all[k]).value();
            ASSERT_TRUE(world.add_collider({.shape = Plane{}}).ok());
            float fastest = 0;
            for (int n = 0; n < 120; ++n) {
                const float now = world.step(1.0f / 60).peak_speed;
                if (n >= 60) fastest = std::max(fastest, now);
            }
            const ClothView cloth = world.cloth(id).value();
            float widest = 0;
            for (const Vec4& a : cloth.positions)
                for (const Vec4& b : cloth.positions)
                    widest = std::max(widest, std::hypot(a.x - b.x, a.y - b.y, a.z - b.z));
            EXPECT_LT(fastest, 1e-3f) << k << ", " << cells << " cells";
            EXPECT_NEAR(widest, side * std::numbers::sqrt2_v<float>, 0.02f * side)
                << k << ", " << cells << " cells";
        }
    }
}

TEST(HeldRigidity, KnowsTheMassThatAMapLeaves) {
    Cloth cloth(cook(sheet(5, 5)).value(), ClothSettings());
    const float before = cloth.bending_per_area;
    AlignedBuffer<float> lighter(cloth.model.particle_count);
    std::ranges::fill(lighter.span(), 0.01f);
    cloth.set_map(Map::mass, std::move(lighter));
    EXPECT_FLOAT_EQ(cloth.bending_per_area, 100 * before);
}

TEST(HeldRigidity, KnowsTheRatioThatSettingsChange) {
    ClothSettings settings;
    Cloth cloth(cook(sheet(5, 5)).value(), settings);
    settings.fabric.bending_ratio = 50;
    const Cloth stiff(cook(sheet(5, 5)).value(), settings);
    EXPECT_GT(stiff.bending_per_area, 10 * cloth.bending_per_area);
    cloth.apply(settings);
    EXPECT_EQ(cloth.bending_per_area, stiff.bending_per_area);
}

TEST(HeldRigidity, IsTheFabricsForCellsThatGamesHave) {
    for (const float cell : {1e-3f, 1e-2f, 1e-1f}) {
        const Mesh mesh =
            make_sheet({.rows = 11, .columns = 11, .u = {10 * cell, 0, 0}, .v = {0, 0, 10 * cell}}).value();
        const Cloth cloth(cook(mesh).value(), ClothSettings());
        Fabric leather{.areal_density = 0.8f, .bending = 2e-3f};
        EXPECT_EQ(held_rigidity(leather, 1.0f / 60, cloth.bending_per_area), leather.bending) << cell;
        leather.bending = 1e12f;
        EXPECT_LT(held_rigidity(leather, 1.0f / 60, cloth.bending_per_area), leather.bending) << cell;
    }
}

}  // namespace
}  // namespace weft::test
