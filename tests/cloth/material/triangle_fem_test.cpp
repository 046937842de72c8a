// The membrane's kernel against the source's own form (a square deformation gradient with the deformed
// normal, its singular values) and against finite differences, in double precision.

#include <gtest/gtest.h>

#include <array>
#include <random>

#include <Eigen/Geometry>
#include <Eigen/LU>

#include "hwy/highway.h"

#include "cloth/methods/finite_elements/triangle_fem-inl.h"
#include "tests/cloth/system/dense_algebra.h"

namespace weft::test {
namespace {

namespace fem = weft::HWY_NAMESPACE;
using Eigen::Matrix2d;
using Eigen::Matrix3d;
using Eigen::Vector2d;
using Eigen::Vector3d;
using Vector9d = Eigen::Matrix<double, 9, 1>;
using Matrix9d = Eigen::Matrix<double, 9, 9>;

/// A triangle of a rest shape, cut from a cloth.
struct Element {
    fem::RestTriangle<double> rest;
    fem::Elasticity<double> c;
    Eigen::Matrix<double, 3, 2> gradients;  ///< dphi/dX, by corners
};

Element element(const fem::Elasticity<double>& c) {
    const Vector2d a(0.1, -0.2), b(0.9, 0.1), apex(0.3, 0.8);
    Matrix2d sides;
    sides << b - a, apex - a;
    const Matrix2d g = sides.inverse();
    Element e{{g(0, 0), g(0, 1), g(1, 0), g(1, 1), 0.5 * sides.determinant()}, c, {}};
    e.gradients << -g.colwise().sum(), g;
    return e;
}

constexpr fem::Elasticity<double> isotropic{
    .warp = 2 * 150 + 80, .weft = 2 * 150 + 80, .coupling = 80, .shear = 150};
constexpr fem::Elasticity<double> orthotropic{.warp = 500, .weft = 200, .coupling = 60, .shear = 40};

fem::Point<double> point(const Vector3d& v) {
    return {v.x(), v.y(), v.z()};
}
Vector3d vector(const fem::Point<double>& p) {
    return {p.x, p.y, p.z};
}

fem::Polar<double> polar(const Element& e, const Vector9d& x) {
    return fem::polar(
        fem::gradient(e.rest, point(x.segment<3>(0)), point(x.segment<3>(3)), point(x.segment<3>(6))));
}

Vector9d forces(const Element& e, const Vector9d& x) {
    const auto p = polar(e, x);
    const auto f = fem::forces(e.rest, p, fem::stress(e.c, fem::strain(p)));
    Vector9d result;
    result << -vector(f.on1) - vector(f.on2), vector(f.on1), vector(f.on2);
    return result;
}

Matrix3d matrix(const fem::Block<double>& b) {
    Matrix3d m;
    m << vector(b.x).transpose(), vector(b.y).transpose(), vector(b.z).transpose();
    return m;
}

/// From the blocks off the diagonal, whose rows sum to 0.
Matrix9d hessian(const Element& e, const Vector9d& x, double elastic = 1, double viscous = 0) {
    const auto p = polar(e, x);
    const auto k = fem::stiffness(
        e.rest, p, fem::second_derivative(e.c, p, fem::stress(e.c, fem::strain(p)), elastic, viscous));
    const std::array<Matrix3d, 3> blocks{matrix(k.from0to1), matrix(k.from1to2), matrix(k.from2to0)};
    Matrix9d h = Matrix9d::Zero();
    for (int a = 0; a < 3; ++a) {
        const int b = (a + 1) % 3;
        const Matrix3d& block = blocks[static_cast<std::size_t>(a)];
        h.block<3, 3>(3 * a, 3 * b) = -block;
        h.block<3, 3>(3 * b, 3 * a) = -block.transpose();
        h.block<3, 3>(3 * a, 3 * a) += block;
        h.block<3, 3>(3 * b, 3 * b) += block.transpose();
    }
    return h;
}

/// [x0 x1 x2] dphi/dX.
Eigen::Matrix<double, 3, 2> columns(const Element& e, const Vector9d& x) {
    return x.reshaped(3, 3) * e.gradients;
}

/// By the matrix square root of F^T F.
double energy(const Element& e, const Vector9d& x) {
    const auto f = columns(e, x);
    const Matrix2d squared = f.transpose() * f;
    // sqrt(A) = (A + sqrt(det A) I) / sqrt(tr A + 2 sqrt(det A)), by Cayley and Hamilton.
    const double root = std::sqrt(squared.determinant());
    const Matrix2d s = (squared + root * Matrix2d::Identity()) / std::sqrt(squared.trace() + 2 * root);
    const double xx = s(0, 0) - 1, yy = s(1, 1) - 1;
    return e.rest.area * (0.5 * (e.c.warp * xx * xx + e.c.weft * yy * yy) + e.c.coupling * xx * yy +
                          2 * e.c.shear * s(0, 1) * s(0, 1));
}

/// The source's form. F = [x0 x1 x2 n] [dphi/dX 0; 0 0 1], 3x3, rest normal +Z.
struct SourceForm {
    Matrix3d f, u, v;
    Vector3d s, normal;
    double doubled_area;

    SourceForm(const Element& e, const Vector9d& x) {
        const Vector3d raw =
            Vector3d(x.segment<3>(3) - x.segment<3>(0)).cross(Vector3d(x.segment<3>(6) - x.segment<3>(0)));
        doubled_area = raw.norm();
        normal = raw / doubled_area;
        f << columns(e, x), normal;
        const SingularValues svd = singular_values(f);
        u = svd.u, v = svd.v, s = svd.s;
    }
    [[nodiscard]] double energy(double area, double mu, double lambda) const {
        const double sum = s.sum() - 3;
        return area * (mu * (s.array() - 1).square().sum() + 0.5 * lambda * sum * sum);
    }
    /// area dpsi/dF : dF/dq with dpsi/dF = U diag(dpsi/ds) V^T; dn/dq = (I - n n^T) / |n~| dn~/dq.
    [[nodiscard]] Vector9d gradient(const Element& e, const Vector9d& x, double mu, double lambda) const {
        const Vector3d slope = (2 * mu * (s.array() - 1) + lambda * (s.sum() - 3)).matrix();
        const Matrix3d stress = u * slope.asDiagonal() * v.transpose();
        Vector9d g;
        for (int k = 0; k < 9; ++k) {
            Matrix3d df = Matrix3d::Zero();
            df.row(k % 3).head<2>() = e.gradients.row(k / 3);
            Vector9d dx = Vector9d::Zero();
            dx[k] = 1;
            const Vector3d side1 = x.segment<3>(3) - x.segment<3>(0),
                           side2 = x.segment<3>(6) - x.segment<3>(0);
            const Vector3d d1 = dx.segment<3>(3) - dx.segment<3>(0), d2 = dx.segment<3>(6) - dx.segment<3>(0);
            const Vector3d raw = d1.cross(side2) + side1.cross(d2);
            df.col(2) = (raw - normal.dot(raw) * normal) / doubled_area;
            g[k] = e.rest.area * stress.cwiseProduct(df).sum();
        }
        return g;
    }
};

/// x such that F has these principal stretches, turned at random in the pattern and in space.
Vector9d stretched(const Element& e, double s1, double s2, std::mt19937& random) {
    std::uniform_real_distribution<double> angle(-3, 3);
    const Matrix3d turn = (Eigen::AngleAxisd(angle(random), Vector3d::UnitX()) *
                           Eigen::AngleAxisd(angle(random), Vector3d::UnitY()) *
                           Eigen::AngleAxisd(angle(random), Vector3d::UnitZ()))
                              .toRotationMatrix();
    const Eigen::Matrix<double, 3, 2> f = turn.leftCols<2>() * Vector2d(s1, s2).asDiagonal() *
                                          Eigen::Rotation2Dd(angle(random)).toRotationMatrix();
    // Sides of the rest triangle from its gradients.
    const Matrix2d sides = e.gradients.bottomRows<2>().inverse();
    Vector9d x;
    x << Vector3d(0.3, -0.2, 0.5), Vector3d(0.3, -0.2, 0.5), Vector3d(0.3, -0.2, 0.5);
    x.segment<3>(3) += f * sides.col(0);
    x.segment<3>(6) += f * sides.col(1);
    return x;
}

struct Stretches {
    double s1, s2;
};
void PrintTo(const Stretches& s, std::ostream* out) {
    *out << s.s1 << " x " << s.s2;
}

constexpr Stretches all_stretches[] = {{1, 1},     {1.2, 1.1}, {1.1, 1.1 + 1e-9}, {1.3, 1},     {1.3, 0.9},
                                       {0.9, 0.8}, {0.9, 0.9}, {2, 1.9},          {0.5, 0.499}, {1.5, 0.02}};

class MembraneAt : public testing::TestWithParam<Stretches> {
  protected:
    template <class Check>
    void for_states(const fem::Elasticity<double>& c, const Check& check) {
        std::mt19937 random(5);
        const Element e = element(c);
        for (int k = 0; k < 20; ++k) check(e, stretched(e, GetParam().s1, GetParam().s2, random));
    }
};

TEST_P(MembraneAt, ForceIsTheGradientOfTheSourcesSquareForm) {
    const double mu = isotropic.shear, lambda = isotropic.coupling;
    for_states(isotropic, [&](const Element& e, const Vector9d& x) {
        const SourceForm source(e, x);
        EXPECT_NEAR(energy(e, x), source.energy(e.rest.area, mu, lambda), 1e-9);
        const Vector9d gradient = source.gradient(e, x, mu, lambda);
        EXPECT_LT((forces(e, x) + gradient).norm(), 1e-9 * (1 + gradient.norm()));
    });
}

TEST_P(MembraneAt, ForceIsTheEnergysGradient) {
    constexpr double step = 1e-6;
    for_states(orthotropic, [&](const Element& e, const Vector9d& x) {
        const Vector9d f = forces(e, x);
        for (int k = 0; k < 9; ++k) {
            const Vector9d dx = step * Vector9d::Unit(k);
            EXPECT_NEAR(f[k], (energy(e, x - dx) - energy(e, x + dx)) / (2 * step), 1e-5) << k;
        }
    });
}

TEST_P(MembraneAt, HessianIsNeverIndefiniteAndExactWhereTheTrueOneIsNot) {
    constexpr double step = 1e-6;
    for (const auto& c : {isotropic, orthotropic}) {
        for_states(c, [&](const Element& e, const Vector9d& x) {
            const Matrix9d h = hessian(e, x);
            EXPECT_LT((h - h.transpose()).norm(), 1e-9 * h.norm());
            EXPECT_GT(eigenvalues(h)[0], -1e-9 * h.norm());

            Matrix9d exact;
            for (int k = 0; k < 9; ++k) {
                const Vector9d dx = step * Vector9d::Unit(k);
                exact.col(k) = (forces(e, x - dx) - forces(e, x + dx)) / (2 * step);
            }
            const double least = eigenvalues(0.5 * (exact + exact.transpose()))[0];
            if (least > -1e-6 * exact.norm()) {
                EXPECT_LT((h - exact).norm(), 1e-5 * exact.norm());
            }
            // In tension it is.
            if (GetParam().s1 > 1.05 && GetParam().s2 > 1.05 && GetParam().s1 / GetParam().s2 < 1.2) {
                EXPECT_GT(least, -1e-6 * exact.norm());
            }
        });
    }
}

TEST_P(MembraneAt, InternalForcesKeepMomentumAndAngularMomentum) {
    for_states(orthotropic, [&](const Element& e, const Vector9d& x) {
        const Vector9d f = forces(e, x);
        Vector3d sum = Vector3d::Zero(), moment = Vector3d::Zero();
        for (int k = 0; k < 3; ++k) {
            sum += f.segment<3>(3 * k);
            moment += Vector3d(x.segment<3>(3 * k)).cross(Vector3d(f.segment<3>(3 * k)));
        }
        EXPECT_LT(sum.norm(), 1e-10);
        EXPECT_LT(moment.norm(), 1e-10);
    });
}

TEST_P(MembraneAt, ForcesTurnWithTheTriangle) {
    const Matrix3d turn = Eigen::AngleAxisd(1.1, Vector3d(1, 2, -1).normalized()).toRotationMatrix();
    for_states(orthotropic, [&](const Element& e, const Vector9d& x) {
        const Vector9d f = forces(e, x);
        Vector9d turned = x;
        for (int k = 0; k < 3; ++k)
            turned.segment<3>(3 * k) = turn * x.segment<3>(3 * k) + Vector3d(5, -3, 2);
        const Vector9d g = forces(e, turned);
        for (int k = 0; k < 3; ++k)
            EXPECT_LT((g.segment<3>(3 * k) - turn * f.segment<3>(3 * k)).norm(), 1e-9);
    });
}

TEST_P(MembraneAt, AreaRatioIsTheProductOfTheStretches) {
    for_states(orthotropic, [&](const Element& e, const Vector9d& x) {
        EXPECT_NEAR(polar(e, x).area_ratio, GetParam().s1 * GetParam().s2, 1e-12);
    });
}

TEST_P(MembraneAt, StrainRateIsTheDerivativeOfStrainAndZeroInRotation) {
    constexpr double step = 1e-6;
    std::mt19937 random(9);
    std::uniform_real_distribution<double> speed(-1, 1);
    for_states(orthotropic, [&](const Element& e, const Vector9d& x) {
        Vector9d v;
        for (double& component : v) component = speed(random);
        const auto rate_of = [&](const Vector9d& velocity) {
            return fem::strain_rate(
                polar(e, x), fem::gradient(e.rest, point(velocity.segment<3>(0)),
                                           point(velocity.segment<3>(3)), point(velocity.segment<3>(6))));
        };
        const auto rate = rate_of(v);
        const auto after = fem::strain(polar(e, x + step * v)), before = fem::strain(polar(e, x - step * v));
        EXPECT_NEAR(rate.xx, (after.xx - before.xx) / (2 * step), 1e-5);
        EXPECT_NEAR(rate.yy, (after.yy - before.yy) / (2 * step), 1e-5);
        EXPECT_NEAR(rate.xy, (after.xy - before.xy) / (2 * step), 1e-5);

        const Vector3d spin(0.3, -1, 0.7);
        for (int k = 0; k < 3; ++k) v.segment<3>(3 * k) = spin.cross(Vector3d(x.segment<3>(3 * k)));
        const auto turning = rate_of(v);
        EXPECT_LT(std::abs(turning.xx) + std::abs(turning.yy) + std::abs(turning.xy), 1e-12);
    });
}

TEST_P(MembraneAt, SinglePrecisionAgrees) {
    for_states(orthotropic, [&](const Element& e, const Vector9d& x) {
        const auto f32 = [](double value) { return static_cast<float>(value); };
        const auto point32 = [&](const Vector9d& of, int k) {
            return fem::Point<float>{f32(of[3 * k]), f32(of[3 * k + 1]), f32(of[3 * k + 2])};
        };
        const fem::RestTriangle<float> rest{f32(e.rest.x1), f32(e.rest.y1), f32(e.rest.x2), f32(e.rest.y2),
                                            f32(e.rest.area)};
        const fem::Elasticity<float> c{f32(e.c.warp), f32(e.c.weft), f32(e.c.coupling), f32(e.c.shear)};
        const auto p = fem::polar(fem::gradient(rest, point32(x, 0), point32(x, 1), point32(x, 2)));
        const auto f = fem::forces(rest, p, fem::stress(c, fem::strain(p)));
        const Vector9d expected = forces(e, x);
        const double allowed = 1e-4 * (e.c.warp + expected.norm());
        EXPECT_NEAR(static_cast<double>(f.on1.x), expected[3], allowed);
        EXPECT_NEAR(static_cast<double>(f.on2.z), expected[8], allowed);
    });
}

INSTANTIATE_TEST_SUITE_P(Stretches, MembraneAt, testing::ValuesIn(all_stretches));

// Viscosity resists strain alone: C's part of the Hessian.
TEST(Membrane, ViscousHessianDoesNotFeelRotation) {
    std::mt19937 random(3);
    const Element e = element(orthotropic);
    const Vector9d x = stretched(e, 1.3, 0.8, random);
    const Matrix9d viscous = hessian(e, x, 0, 1);
    Vector9d turning;
    for (int k = 0; k < 3; ++k)
        turning.segment<3>(3 * k) = Vector3d(0.3, -1, 0.7).cross(Vector3d(x.segment<3>(3 * k)));
    EXPECT_LT((viscous * turning).norm(), 1e-9 * viscous.norm());
    EXPECT_GT(viscous.norm(), 1);
}

TEST(Membrane, CollapsedTrianglesHaveFiniteForcesAndBoundedStiffness) {
    for (const auto& c : {isotropic, orthotropic}) {
        const Element e = element(c);
        std::mt19937 random(1);
        const double at_rest = hessian(e, stretched(e, 1, 1, random)).norm();
        Vector9d at_a_point = Vector9d::Zero(), on_a_line = Vector9d::Zero(), side_gone = Vector9d::Zero();
        on_a_line << 0, 0, 0, 1, 2, 3, 2, 4, 6;
        side_gone << 0, 0, 0, 0, 0, 0, 0, 1, 0;
        for (const Vector9d& x : {at_a_point, on_a_line, side_gone}) {
            EXPECT_TRUE(forces(e, x).allFinite());
            EXPECT_GT(forces(e, x).norm(), 1);  // it opens again
            const Matrix9d h = hessian(e, x);
            EXPECT_TRUE(h.allFinite());
            EXPECT_GT(eigenvalues(h)[0], -1e-9 * h.norm());
            EXPECT_LT(h.norm(), 1e3 * at_rest);
        }
    }
}

}  // namespace
}  // namespace weft::test
