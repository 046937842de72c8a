// Finite elements as the linear system of a step: what W must be, what converged strips must show.

#include "cloth/methods/finite_elements/triangle_system.h"
#include "cloth/mesh/rest/bending.h"
#include "cloth/methods/finite_elements/hinge_elements.h"
#include "cloth/solver/make_system.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <functional>
#include <vector>

#include "dense_algebra.h"
#include "tests/cloth/material/strips.h"
#include "tests/cloth/meshes.h"

namespace weft::test {
namespace {

struct Model {
    bool dihedral, consistent_mass;
    float spread;  ///< how far particles are moved at random
};
void PrintTo(const Model& m, std::ostream* out) {
    *out << (m.dihedral ? "dihedral" : "quadratic") << (m.consistent_mass ? " consistent" : " lumped") << ' '
         << m.spread;
}

Cloth elements(const Mesh& mesh, const Model& model) {
    Cloth cloth = crumpled(mesh, model.spread, 0);
    ClothSettings settings = cloth.settings;
    settings.fabric.warp = 300;
    settings.fabric.weft = 200;
    settings.fabric.shear = 60;
    settings.fabric.bending = 1e-3f;
    settings.fabric.damping = 1e-3f;
    settings.finite_elements = {.enabled = true,
                                .poisson = 0.2f,
                                .dihedral = model.dihedral,
                                .consistent_mass = model.consistent_mass};
    cloth.apply(settings);
    return cloth;
}

class TriangleSystems : public testing::TestWithParam<Model> {};

TEST_P(TriangleSystems, MatrixIsSymmetricPositiveDefiniteAndRelaxationConverges) {
    Cloth cloth = elements(sheet(6, 7), GetParam());
    cloth.pin(3);
    const auto system = assembled(cloth, 0.02f);
    const Eigen::MatrixXd w = dense(*system).matrix;
    EXPECT_LT((w - w.transpose()).norm(), 1e-5 * w.norm());
    EXPECT_GT(eigenvalues(0.5 * (w + w.transpose()))[0], 0);

    // D^-1 W has no eigenvalue of 2 or more: all semi-iterations rely on it.
    const Eigen::MatrixXd inverse = dense_preconditioner(*system);
    EXPECT_EQ(inverse, inverse.transpose());
    EXPECT_LT(largest_eigenvalue_of_product(inverse, w), 2);
}

TEST_P(TriangleSystems, RightSideAboutTheIterateIsTheResidual) {
    Cloth cloth = elements(sheet(6, 7), GetParam());
    cloth.pin(0);
    Parallel serial(1);
    const auto system = make_system(cloth.model, cloth.settings);
    const StepEquation equation = equation_of(cloth, 0.02f);
    AlignedBuffer<Vec4> v(cloth.state.size()), residual(cloth.state.size());
    for (std::size_t i = 0; i < v.size(); ++i)
        if (cloth.state.positions[i].w > 0) v[i] = {0.1f, -0.2f * static_cast<float>(i % 3), 0.3f, 0};
    system->linearise(serial, equation, v.span(), LinearisedAbout::iterate);
    const Eigen::VectorXd b = flat(system->right_side().span());
    system->residual(serial, equation, v.span(), residual.span());
    EXPECT_LT((b - flat(residual.span())).norm(), 1e-5 * b.norm());
}

// gamma (f + gamma J v + C v) about the base differs from the residual at v by what is not linear.
TEST_P(TriangleSystems, LinearisationsAgreeForSmallVelocities) {
    Cloth cloth = elements(sheet(5, 5), GetParam());
    std::ranges::fill(cloth.state.velocities.span(), Vec4{});
    Parallel serial(1);
    const auto system = make_system(cloth.model, cloth.settings);
    const StepEquation equation = equation_of(cloth, 0.02f);
    AlignedBuffer<Vec4> v(cloth.state.size()), residual(cloth.state.size());
    system->linearise(serial, equation, v.span(), LinearisedAbout::base);
    const Eigen::VectorXd at_rest = flat(system->right_side().span());
    system->residual(serial, equation, v.span(), residual.span());
    EXPECT_LT((at_rest - flat(residual.span())).norm(), 1e-5 * at_rest.norm());
}

TEST_P(TriangleSystems, InternalForcesKeepMomentumAndAngularMomentum) {
    const Cloth cloth = elements(sheet(9, 8), GetParam());
    Parallel serial(1);
    const auto system = make_system(cloth.model, cloth.settings);
    const std::size_t n = cloth.state.size();
    AlignedBuffer<Vec4> rest(n), impulse(n);
    StepEquation equation = equation_of(cloth, 0.02f, Vector3::Zero());
    equation.base_velocities = rest.span();
    equation.velocities = rest.span();
    system->residual(serial, equation, rest.span(), impulse.span());
    Eigen::Vector3d sum = Eigen::Vector3d::Zero(), moment = Eigen::Vector3d::Zero();
    double scale = 0.1;  // [kg m/s], what forces of 5 N would do
    for (std::size_t i = 0; i < n; ++i) {
        const Eigen::Vector3d f = xyz(impulse[i]).cast<double>();
        sum += f;
        moment += xyz(cloth.state.positions[i]).cast<double>().cross(f);
        scale += f.norm();
    }
    EXPECT_LT(sum.norm(), 1e-6 * scale);
    EXPECT_LT(moment.norm(), 1e-6 * scale);
}

std::vector<Model> models() {
    std::vector<Model> all;
    for (const bool dihedral : {false, true})
        for (const bool consistent : {false, true})
            for (const float spread : {0.0f, 0.02f, 0.2f}) all.push_back({dihedral, consistent, spread});
    return all;
}
INSTANTIATE_TEST_SUITE_P(Models, TriangleSystems, testing::ValuesIn(models()));

/// Energies of a motion of flat cloth, less what its mass adds: of W, and of the springs that coarse levels
/// are made from.
struct TwoEnergies {
    double of_w = 0, of_springs = 0;
};
TwoEnergies energies(const Cloth& cloth,
                     const std::function<Eigen::Vector3d(const Eigen::Vector3d&)>& motion) {
    TriangleSystem system(cloth.model, cloth.settings);
    Parallel serial(1);
    const std::size_t n = cloth.state.size();
    AlignedBuffer<Vec4> still(n), x(n), product(n);
    system.linearise(serial, equation_of(cloth, 0.02f), still.span(), LinearisedAbout::iterate);
    for (std::size_t i = 0; i < n; ++i)
        x[i] = to_vec4(motion(xyz(cloth.state.positions[i]).cast<double>()).cast<float>(), 0);
    TwoEnergies sum{.of_w = system.multiply(serial, x.span(), product.span())};
    for (std::size_t i = 0; i < n; ++i)
        sum.of_w -= static_cast<double>(system.right_side()[i].w) * xyz(x[i]).cast<double>().squaredNorm();
    const AlignedBuffer<Vec4> blocks = system.all_spring_blocks(serial);
    for (std::uint32_t e = 0; e < blocks.size(); ++e) {
        const std::uint32_t j = system.stencil().neighbours[e],
                            i = system.stencil().node_of(e / Stencil::lanes, e % Stencil::lanes);
        if (i >= n || j == i) continue;
        const Eigen::Vector3d d = (xyz(x[j]) - xyz(x[i])).cast<double>();
        const double along = xyz(blocks[e]).cast<double>().dot(d);
        sum.of_springs += 0.5 * (along * along + static_cast<double>(blocks[e].w) * d.squaredNorm());
    }
    return sum;
}

class SidesAsSprings : public testing::TestWithParam<bool> {};

TEST_P(SidesAsSprings, ResistWhatTheElementsDoAndNothingElse) {
    const Cloth cloth = elements(strip(9, 8, 0.05f, true), {GetParam(), false, 0.0f});
    using V = Eigen::Vector3d;
    const auto ratio = [&](const auto& motion) {
        const TwoEnergies found = energies(cloth, motion);
        return found.of_springs / found.of_w;
    };
    const double stretch = energies(cloth, [](const V& p) { return V(p.x(), 0, 0); }).of_w;
    // Sides that are stretched together are coupled: their springs double at most.
    for (const V& strain : {V(1, 0, 0), V(0, 1, 0), V(1, 1, 0), V(0, 0, 1), V(1, -1, 0)}) {
        const double along_or_sheared = ratio([&](const V& p) {
            return V(strain[0] * p.x() + strain[2] * p.z(), 0, strain[1] * p.z() + strain[2] * p.x());
        });
        EXPECT_GT(along_or_sheared, 0.5) << strain.transpose();
        EXPECT_LT(along_or_sheared, 2.2) << strain.transpose();
    }
    EXPECT_NEAR(ratio([](const V& p) { return V(0, std::cos(9 * p.x()) * std::sin(7 * p.z()), 0); }), 1,
                1e-3);
    for (const V& turn : {V(0, 1, 0), V(1, 0, 0), V(0, 0, 1)})
        EXPECT_LT(energies(cloth, [&](const V& p) { return turn.cross(p); }).of_springs, 1e-5 * stretch);
}

TEST_P(SidesAsSprings, HoldStretchedClothAgainstTurningAsItsTensionDoes) {
    Cloth cloth = elements(strip(9, 8, 0.05f, true), {GetParam(), false, 0.0f});
    for (Vec4& p : cloth.state.positions.span()) {
        p.x *= 1.1f;
        p.z *= 1.1f;
    }
    const TwoEnergies lateral = energies(
        cloth, [](const Eigen::Vector3d& p) { return Eigen::Vector3d(0, std::sin(9 * p.x() + p.z()), 0); });
    EXPECT_NEAR(lateral.of_springs / lateral.of_w, 1, 0.05);
}
INSTANTIATE_TEST_SUITE_P(Dihedral, SidesAsSprings, testing::Bool());

TEST(HingeElements, SharedOutHessianBoundsTheEnergysFromAbove) {
    // Of pairs of hinges 2 phi_e phi_f <= phi_e^2 + phi_f^2: the difference is never negative.
    const Cloth cloth = crumpled(sheet(5, 6), 0.02f, 0);
    const Bending bending = bending_elements(cloth.model);
    HingeElements hinges(bending, cloth.model.particle_count, [](auto, auto) { return 0u; });
    Parallel serial(1);
    const float rigidity = 2e-3f;
    hinges.compute(serial, {rigidity, cloth.state.positions.span(), {}, 0});

    const auto count = static_cast<Eigen::Index>(bending.hinges.size()), size = 3 * Eigen::Index{30};
    Eigen::MatrixXd gradients = Eigen::MatrixXd::Zero(count, size),
                    weights = Eigen::MatrixXd::Zero(count, count), shared = weights;
    const auto length = [&](std::uint32_t h) { return static_cast<double>(bending.hinges[h].length); };
    for (std::uint32_t h = 0; h < bending.hinges.size(); ++h) {
        weights(h, h) = static_cast<double>(bending.hinges[h].weight) * length(h) * length(h);
        shared(h, h) = static_cast<double>(hinges.stiffness(h));
        for (std::uint32_t k = 0; k < 4; ++k)
            gradients.row(h).segment<3>(3 * static_cast<Eigen::Index>(bending.hinges[h].particles[k])) =
                hinges.gradient(h, k).cast<double>();
    }
    for (const HingePair& pair : bending.pairs) {
        const double weight = static_cast<double>(pair.weight) * length(pair.first) * length(pair.second);
        weights(pair.first, pair.second) += weight;
        weights(pair.second, pair.first) += weight;
    }
    weights *= static_cast<double>(rigidity);
    const Eigen::MatrixXd energys = gradients.transpose() * weights * gradients,
                          bound = gradients.transpose() * shared * gradients;
    EXPECT_GT(eigenvalues(bound - energys)[0], -1e-6 * bound.norm());
    // And no more than it needs: where all hinges bend alike the two agree.
    const Eigen::VectorXd alike = Eigen::VectorXd::Ones(count);
    EXPECT_NEAR(alike.dot(shared * alike), alike.dot(weights * alike), 1e-5 * alike.dot(weights * alike));
}

/// The energy that rest_elements.h states, of dihedral bending with rigidity 1, about the cloth's present
/// place.
double bending_energy(const Bending& bending, const Cloth& cloth) {
    std::vector<double> bends;
    for (const Hinge& hinge : bending.hinges) {
        std::array<Vector3, 4> x;
        for (std::size_t k = 0; k < 4; ++k) x[k] = xyz(cloth.state.positions[hinge.particles[k]]);
        bends.push_back(static_cast<double>(hinge.length * (dihedral(x, 0).angle - hinge.angle)));
    }
    double energy = 0;
    for (std::size_t h = 0; h < bends.size(); ++h)
        energy += 0.5 * static_cast<double>(bending.hinges[h].weight) * bends[h] * bends[h];
    for (const HingePair& pair : bending.pairs)
        energy += static_cast<double>(pair.weight) * bends[pair.first] * bends[pair.second];
    return energy;
}

TEST(HingeElements, ForcesAreTheEnergysDerivativeAndDampingIsAgainstTheMotion) {
    Cloth cloth = crumpled(sheet(5, 6), 0.02f, 0);
    const Bending bending = bending_elements(cloth.model);
    ASSERT_GT(bending.pairs.size(), 20u);
    HingeElements hinges(bending, cloth.model.particle_count, [](auto, auto) { return 0u; });
    Parallel serial(1);
    const auto power = [&](const AlignedBuffer<Vec4>& velocities, float viscosity) {
        hinges.compute(serial, {1, cloth.state.positions.span(),
                                viscosity > 0 ? velocities.span() : std::span<const Vec4>(), viscosity});
        double sum = 0;
        for (std::uint32_t i = 0; i < cloth.state.size(); ++i)
            for (const HingeElements::Corner& at : hinges.corners(i))
                sum += static_cast<double>(hinges.moment(at.hinge) *
                                           hinges.gradient(at.hinge, at.corner).dot(xyz(velocities[i])));
        return sum;
    };
    const AlignedBuffer<Vec4> start = cloth.state.positions;
    for (const std::uint32_t seed : {1u, 2u, 3u}) {
        const AlignedBuffer<Vec4> velocities = random_rows(cloth.model.particle_count, 1, seed);
        cloth.state.positions = start;
        const double elastic = power(velocities, 0), viscous = power(velocities, 0.01f) - elastic;
        const auto energy_after = [&](float time) {
            for (std::uint32_t i = 0; i < cloth.state.size(); ++i)
                set_xyz(cloth.state.positions[i], xyz(start[i]) + time * xyz(velocities[i]));
            return bending_energy(bending, cloth);
        };
        constexpr float step = 5e-4f;
        const double rate = (energy_after(step) - energy_after(-step)) / (2 * static_cast<double>(step));
        EXPECT_NEAR(elastic, -rate, 0.01 * std::abs(rate)) << seed;
        EXPECT_LT(viscous, -0.01 * std::abs(rate)) << "it takes energy";
    }
}

// A uniform stretch gives uniform stress on any mesh: nothing moves inside, and the borders' forces balance
// it.
TEST(TriangleSystem, PatchTest) {
    Cloth cloth = elements(strip(8, 6, 0.1f, true), {false, false, 0.0f});
    const std::size_t n = cloth.state.size();
    for (Vec4& x : cloth.state.positions.span())
        x = {1.1f * x.x + 0.05f * x.z, x.x * 0.02f, 0.97f * x.z, x.w};
    Parallel serial(1);
    const auto system = make_system(cloth.model, cloth.settings);
    AlignedBuffer<Vec4> rest(n), impulse(n);
    StepEquation equation = equation_of(cloth, 1.0f, Vector3::Zero());
    equation.base_velocities = equation.velocities = rest.span();
    system->residual(serial, equation, rest.span(), impulse.span());
    float largest_inside = 0, largest = 0;
    for (std::uint32_t r = 0; r <= 6; ++r) {
        for (std::uint32_t c = 0; c <= 8; ++c) {
            const float f = xyz(impulse[cloth.model.vertex_to_particle[r * 9 + c]]).norm();
            largest = std::max(largest, f);
            if (r > 0 && r < 6 && c > 0 && c < 8) largest_inside = std::max(largest_inside, f);
        }
    }
    EXPECT_GT(largest, 1.0f);
    EXPECT_LT(largest_inside, 1e-4f * largest);
}

// strain = force / (width Young's modulus), warp and weft apart; Poisson's ratio is nu sqrt(Y1 / Y2).
TEST(TriangleSystem, StripsStretchAndContractByTheirModuli) {
    for (const bool irregular : {false, true}) {
        for (const bool along_weft : {false, true}) {
            Mesh mesh = strip(8, 4, 0.1f, irregular);
            if (along_weft)
                for (Vec2& p : mesh.pattern) p = {p.y, -p.x};
            Cloth cloth = elements(mesh, {false, false, 0.0f});
            for (Vec4& v : cloth.state.velocities.span()) v = {};
            const std::span<const std::uint32_t> particle_of = cloth.model.vertex_to_particle;
            for (std::uint32_t r = 0; r <= 4; ++r) cloth.pin(particle_of[r * 9]);
            // The pull: gravity of a strip whose mass all but hangs from its end column, as 1 / w.
            const double own = along_weft ? 200 : 300, other = along_weft ? 300 : 200, force_per_width = 6;
            for (std::uint32_t i = 0; i < cloth.state.size(); ++i) {
                const bool end = i % 9 == 8, corner = i == 8 || i == 4 * 9 + 8;
                float& inverse_mass = cloth.state.positions[particle_of[i]].w;
                if (inverse_mass > 0)
                    inverse_mass =
                        end ? 1 / (static_cast<float>(force_per_width) * (corner ? 0.05f : 0.1f)) : 1e6f;
            }
            relax_to_rest(cloth, {1, 0, 0}, 1.0f, 8);
            // Between columns 4 and 8, away from the held end, which cannot contract.
            const auto x = [&](std::uint32_t r, std::uint32_t c) {
                return xyz(cloth.state.positions[particle_of[r * 9 + c]]);
            };
            const auto rest = [&](std::uint32_t r, std::uint32_t c) {
                return xyz(cloth.model.positions[particle_of[r * 9 + c]]);
            };
            const double strain =
                static_cast<double>((x(2, 8) - x(2, 5)).norm() / (rest(2, 8) - rest(2, 5)).norm()) - 1;
            const double across =
                static_cast<double>((x(4, 8) - x(0, 8)).norm() / (rest(4, 8) - rest(0, 8)).norm()) - 1;
            EXPECT_NEAR(strain, force_per_width / own, 0.02 * force_per_width / own)
                << irregular << along_weft;
            EXPECT_NEAR(across, -0.2 * std::sqrt(own / other) * force_per_width / own, 0.0005);
        }
    }
}

// Shear stress over twice the shear strain: a sheet sheared by s in its plane has E12 = s / 2 while s is
// small.
TEST(TriangleSystem, ShearModulusIsShearStressOverAngle) {
    Cloth cloth = elements(strip(8, 4, 0.1f, true), {false, false, 0.0f});
    constexpr float s = 1e-2f;
    for (Vec4& x : cloth.state.positions.span()) x.x += s * x.z;
    const std::size_t n = cloth.state.size();
    Parallel serial(1);
    const auto system = make_system(cloth.model, cloth.settings);
    AlignedBuffer<Vec4> rest(n), impulse(n);
    StepEquation equation = equation_of(cloth, 1.0f, Vector3::Zero());
    equation.base_velocities = equation.velocities = rest.span();
    system->residual(serial, equation, rest.span(), impulse.span());
    float along_top = 0;  // without the corners' halves, which the ends' tractions share
    for (std::uint32_t c = 1; c < 8; ++c) along_top -= impulse[cloth.model.vertex_to_particle[4 * 9 + c]].x;
    EXPECT_NEAR(along_top, 60 * s * 0.7f, 0.05f * 60 * s * 0.7f);
}

}  // namespace
}  // namespace weft::test
