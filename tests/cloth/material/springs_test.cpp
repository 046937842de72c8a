// Spring forces and their derivatives against energies and finite differences, and the assembled system
// against both.

#include "cloth/fabric/springs.h"
#include "cloth/fabric/membrane.h"
#include "cloth/solver/make_system.h"

#include <gtest/gtest.h>

#include <random>

#include "tests/cloth/fixtures.h"
#include "tests/cloth/meshes.h"

namespace weft::test {
namespace {

constexpr double short_step = 1e-3;

/// The force on particle i at `x`, from the energy k/2 (|d| - L)^2, in double precision.
Eigen::Vector3d exact_force(const Eigen::Vector3d& separation, double rest_length, double stiffness) {
    const double length = separation.norm();
    return stiffness * (length - rest_length) / length * separation;
}

Eigen::Matrix3d block(const SpringTerms& spring) {
    const Eigen::Vector3d n = spring.direction.cast<double>();
    return static_cast<double>(spring.isotropic) * Eigen::Matrix3d::Identity() +
           static_cast<double>(spring.axial) * n * n.transpose();
}

class SpringDirections : public testing::TestWithParam<float> {
  protected:
    /// Separations of this length in random directions.
    std::vector<Vector3> separations() const {
        std::mt19937 random(3);
        std::normal_distribution<float> component;
        std::vector<Vector3> result;
        for (int k = 0; k < 50; ++k) {
            result.push_back(GetParam() *
                             Vector3(component(random), component(random), component(random)).normalized());
        }
        return result;
    }
};

TEST_P(SpringDirections, ForceIsTheEnergysGradient) {
    for (const Vector3& separation : separations()) {
        const Eigen::Vector3d d = separation.cast<double>();
        const auto energy = [&](const Eigen::Vector3d& s) {
            return 0.5 * 30.0 * std::pow(s.norm() - 0.1, 2);
        };
        const SpringTerms spring = spring_terms(separation, 0.1f, 30.0f, 0, 1);
        for (int axis = 0; axis < 3; ++axis) {
            const Eigen::Vector3d e = 1e-6 * Eigen::Vector3d::Unit(axis);
            EXPECT_NEAR(spring.force[axis], (energy(d + e) - energy(d - e)) / 2e-6, 1e-5);
        }
    }
}

class TenseSprings : public SpringDirections {};
class SlackSprings : public SpringDirections {};

TEST_P(TenseSprings, StiffnessIsTheForcesDerivative) {
    for (const Vector3& separation : separations()) {
        const Eigen::Vector3d d = separation.cast<double>();
        const Eigen::Matrix3d stiffness = block(spring_terms(separation, 0.1f, 30.0f, 0, 1));
        for (int axis = 0; axis < 3; ++axis) {
            const Eigen::Vector3d e = 1e-6 * Eigen::Vector3d::Unit(axis);
            const Eigen::Vector3d slope = (exact_force(d + e, 0.1, 30) - exact_force(d - e, 0.1, 30)) / 2e-6;
            EXPECT_LT((stiffness.col(axis) - slope).norm(), 30 * 1e-5) << "axis " << axis;
        }
    }
}

TEST_P(SpringDirections, StiffnessIsNeverIndefinite) {
    for (const Vector3& separation : separations()) {
        const SpringTerms spring = spring_terms(separation, 0.1f, 30.0f, 0, 1);
        EXPECT_GE(spring.isotropic, 0);
        EXPECT_GE(spring.axial, 0);
    }
}

TEST_P(SlackSprings, StiffnessIsAxialOnly) {
    for (const Vector3& separation : separations()) {
        const SpringTerms spring = spring_terms(separation, 0.1f, 30.0f, 0, 1);
        EXPECT_EQ(spring.isotropic, 0);
        EXPECT_EQ(spring.axial, 30.0f);
    }
}

TEST_P(SpringDirections, BothEndsComputeOppositeFloats) {
    for (const Vector3& separation : separations()) {
        const SpringTerms at_i = spring_terms(separation, 0.1f, 30.0f, 4, 9);
        const SpringTerms at_j = spring_terms(-separation, 0.1f, 30.0f, 9, 4);
        EXPECT_EQ(at_i.force, -at_j.force);
        EXPECT_EQ(at_i.direction, -at_j.direction);
        EXPECT_EQ(at_i.isotropic, at_j.isotropic);
        EXPECT_EQ(at_i.axial, at_j.axial);
    }
}

std::string micrometres(const testing::TestParamInfo<float>& info) {
    return std::to_string(std::lround(info.param * 1e6f)) + "um";
}
INSTANTIATE_TEST_SUITE_P(Lengths, SpringDirections,
                         testing::Values(0.01f, 0.0999f, 0.1f, 0.1001f, 0.15f, 2.0f), micrometres);
INSTANTIATE_TEST_SUITE_P(Lengths, TenseSprings, testing::Values(0.1001f, 0.15f, 2.0f), micrometres);
INSTANTIATE_TEST_SUITE_P(Lengths, SlackSprings, testing::Values(0.0f, 0.01f, 0.0999f), micrometres);

TEST(Springs, CoincidentEndsArePushedApartAtFullForce) {
    const SpringTerms at_i = spring_terms(Vector3::Zero(), 0.1f, 30.0f, 4, 9);
    const SpringTerms at_j = spring_terms(Vector3::Zero(), 0.1f, 30.0f, 9, 4);
    EXPECT_NEAR(at_i.force.norm(), 3.0f, 1e-5f);
    EXPECT_EQ(at_i.force, -at_j.force);
}

std::vector<float> stiffness_of(const Cloth& cloth) {
    std::vector<float> stiffness(cloth.model.neighbours.size());
    spring_stiffness(cloth.model, cloth.settings.fabric, stiffness);
    return stiffness;
}

/// The forces of all springs and of bending on all particles, by a plain loop in double precision.
Eigen::VectorXd spring_forces(const Cloth& cloth, const Eigen::VectorXd& positions) {
    const std::vector<float> stiffness = stiffness_of(cloth);
    const double rigidity = static_cast<double>(cloth.settings.fabric.bending);
    Eigen::VectorXd forces = Eigen::VectorXd::Zero(positions.size());
    for (std::uint32_t i = 0; i < cloth.model.particle_count; ++i) {
        for (std::uint32_t e = cloth.model.spring_offsets[i]; e < cloth.model.spring_offsets[i + 1]; ++e) {
            const Eigen::Vector3d d =
                positions.segment<3>(3 * cloth.model.neighbours[e]) - positions.segment<3>(3 * i);
            forces.segment<3>(3 * i) += exact_force(d, static_cast<double>(cloth.model.rest_lengths[e]),
                                                    static_cast<double>(stiffness[e])) +
                                        rigidity * static_cast<double>(cloth.model.bending[e]) * d;
        }
    }
    return forces;
}

/// Stretches the cloth by half, so that every spring is in tension and the Jacobian is the exact one.
void stretch(Cloth& cloth) {
    for (Vec4& x : cloth.state.positions.span()) set_xyz(x, 1.5f * xyz(x));
}

TEST(Assembly, SystemIsKangsForTheExactJacobianInTension) {
    Cloth cloth = crumpled(sheet(5, 6), 0.005f, 40.0f);
    cloth.settings.fabric.damping = 0;
    stretch(cloth);
    const double h = short_step;
    const DenseSystem system = dense(*assembled(cloth, static_cast<float>(h), Vector3::Zero()));

    const Eigen::VectorXd x = flat(cloth.state.positions.span()), v = flat(cloth.state.velocities.span());
    Eigen::MatrixXd jacobian(x.size(), x.size());
    for (Eigen::Index c = 0; c < x.size(); ++c) {
        const Eigen::VectorXd e = 1e-6 * Eigen::VectorXd::Unit(x.size(), c);
        jacobian.col(c) = (spring_forces(cloth, x + e) - spring_forces(cloth, x - e)) / 2e-6;
    }
    Eigen::MatrixXd expected = -h * h * jacobian;
    for (std::uint32_t i = 0; i < cloth.model.particle_count; ++i) {
        expected.diagonal().segment<3>(3 * i).array() += static_cast<double>(cloth.mass(i));
    }
    EXPECT_LT((system.matrix - expected).norm() / expected.norm(), 1e-6);

    const Eigen::VectorXd right_side = h * (spring_forces(cloth, x) + h * jacobian * v);
    EXPECT_LT((system.right_side - right_side).norm() / right_side.norm(), 1e-4);
}

TEST(Assembly, ResidualIsTheRightSideAboutTheIterate) {
    Cloth cloth = crumpled(sheet(5, 6), 0.03f, 40.0f);
    cloth.settings.fabric.damping = 0.01f;
    cloth.pin(3);
    AlignedBuffer<Vec4> iterate(cloth.model.particle_count), residual(cloth.model.particle_count);
    for (std::uint32_t i = 0; i < iterate.size(); ++i)
        iterate[i] = to_vec4(0.5f * xyz(cloth.state.velocities[i]), 0);
    Parallel serial(1);
    const auto system = make_system(cloth.model, cloth.settings);
    const StepEquation equation = equation_of(cloth, 1.0f / 60);
    system->linearise(serial, equation, iterate.span(), LinearisedAbout::iterate);
    system->residual(serial, equation, iterate.span(), residual.span());
    const Eigen::VectorXd b = flat(system->right_side().span()), r = flat(residual.span());
    EXPECT_GT(r.norm(), 1e-3);
    EXPECT_LT((b - r).norm() / r.norm(), 1e-5);
}

// In tension and without damping nothing is left out of the matrix but what triangles' sides do to one
// another.
TEST(Assembly, CoupledProductIsTheSlopeOfTheResidualOnMeshes) {
    Cloth cloth = crumpled(loose_sheet(5, 6), 0.002f, 40.0f);
    cloth.settings.fabric.shear = 5;  // far from what springs by themselves could be
    cloth.settings.fabric.damping = 0;
    stretch(cloth);
    cloth.pin(2);
    const std::uint32_t n = cloth.model.particle_count;
    Parallel serial(1);
    const auto system = make_system(cloth.model, cloth.settings);
    const StepEquation equation = equation_of(cloth, 1.0f / 60);
    AlignedBuffer<Vec4> v = random_rows(n, 0.1f, 3), x = random_rows(n, 1, 4), product(n), w_x(n);
    v[2] = x[2] = {};
    system->linearise(serial, equation, v.span(), LinearisedAbout::iterate);
    const Products found = system->multiply_coupled(serial, {x.data()}, x.span(), product.span());
    EXPECT_NEAR(found.x_wx / flat(x.span()).dot(flat(product.span())), 1, 1e-4);
    system->multiply(serial, x.span(), w_x.span());

    constexpr float e = 2e-2f;
    AlignedBuffer<Vec4> ahead(n), behind(n), after(n), before(n);
    for (std::uint32_t i = 0; i < n; ++i) {
        ahead[i] = to_vec4(xyz(v[i]) + e * xyz(x[i]), 0);
        behind[i] = to_vec4(xyz(v[i]) - e * xyz(x[i]), 0);
    }
    system->residual(serial, equation, ahead.span(), after.span());
    system->residual(serial, equation, behind.span(), before.span());
    const Eigen::VectorXd slope = (flat(before.span()) - flat(after.span())) / (2 * static_cast<double>(e));
    const double left_out = (flat(w_x.span()) - slope).norm();
    EXPECT_LT((flat(product.span()) - slope).norm(), 0.2 * left_out);
    EXPECT_GT(left_out, 0.02 * slope.norm());
}

TEST(Assembly, DampingOpposesStretchingAndNothingElse) {
    Cloth cloth = crumpled(sheet(4, 4), 0, 40.0f);
    cloth.settings.fabric.damping = 0.01f;
    cloth.settings.fabric.bending = 0;  // which turning opposes, as its force is linear
    // A rotation about the centre: no spring changes its length.
    for (std::uint32_t i = 0; i < cloth.state.size(); ++i) {
        const Vec4& x = cloth.state.positions[i];
        cloth.state.velocities[i] = {-x.z, 0, x.x, 0};
    }
    auto system = assembled(cloth, 1e-3f, Vector3::Zero());
    for (const Vec4& b : system->right_side().span()) EXPECT_LT(xyz(b).norm(), 1e-9f);

    // A uniform growth: power of the damping force is c (dl/dt)^2, summed over springs, and negative.
    for (std::uint32_t i = 0; i < cloth.state.size(); ++i) {
        const Vec4& x = cloth.state.positions[i];
        cloth.state.velocities[i] = {x.x, x.y, x.z, 0};
    }
    system = assembled(cloth, 1e-3f, Vector3::Zero());
    double power = 0, expected = 0;
    const std::vector<float> stiffness = stiffness_of(cloth);
    for (std::uint32_t i = 0; i < cloth.state.size(); ++i) {
        power += static_cast<double>(xyz(system->right_side()[i]).dot(xyz(cloth.state.velocities[i]))) / 1e-3;
        for (std::uint32_t e = cloth.model.spring_offsets[i]; e < cloth.model.spring_offsets[i + 1]; ++e) {
            const double rate = static_cast<double>(cloth.model.rest_lengths[e]);  // growth at 1/s
            expected -= 0.5 * (0.01 + 1e-3) * static_cast<double>(stiffness[e]) * rate * rate;
        }
    }
    EXPECT_NEAR(power / expected, 1, 1e-3) << "c = (damping + h) k: the viscous term h J v acts alike";
}

}  // namespace
}  // namespace weft::test
