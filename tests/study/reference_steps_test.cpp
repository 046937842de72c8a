// The converged step: the functional's derivatives, Newton's convergence, and the library's linearised step.

#include <gtest/gtest.h>

#include <cmath>
#include <Eigen/Dense>

#include "demo/study/reference/fine_time.h"
#include "demo/study/reference/newton.h"
#include "demo/study/reference/states.h"
#include "demo/study/run.h"
#include "demo/study/stability/study_solvers.h"
#include "tests/cloth/fixtures.h"

namespace weft::study {

namespace {

/// One step of a cloth, for a solver that is called by itself.
class OneStep {
  public:
    OneStep(Cloth& cloth, float h) : cloth_(cloth), equation_(test::equation_of(cloth, h)) {}

    [[nodiscard]] SolverStep step() {
        return {.parallel = serial_,
                .profiler = profiler_,
                .model = cloth_.model,
                .settings = cloth_.settings,
                .equation = equation_,
                .velocities = cloth_.scratch_velocities.span()};
    }
    [[nodiscard]] const StepEquation& equation() const { return equation_; }

  private:
    Cloth& cloth_;
    Parallel serial_{1};
    Profiler profiler_{stage_names};
    StepEquation equation_;
};

constexpr float h = 1.0f / 60;

/// Displaced and moving at random, with two pins, air damping and dampings of springs.
Cloth pinned_crumple(float displacement, float spring_damping) {
    Cloth cloth = test::crumpled(test::sheet(6, 5), displacement, 50.0f);
    cloth.settings.fabric.damping = spring_damping;
    cloth.settings.air_damping = 0.3f;
    cloth.pin(0);
    cloth.pin(4);
    return cloth;
}

TEST(StepFunctional, ResidualIsMinusTheGradient) {
    Cloth cloth = pinned_crumple(0.05f, 0.01f);
    OneStep step(cloth, h);
    const StepFunctional functional(cloth.model, step.equation());
    const Flat v = functional.start();
    const auto damped = functional.damped_states(v);
    const Flat residual = functional.residual(v);
    for (Eigen::Index i = 0; i < v.size(); ++i) {
        constexpr double eps = 1e-5;
        Flat above = v, below = v;
        above[i] += eps;
        below[i] -= eps;
        const double slope = (functional.value(above, damped) - functional.value(below, damped)) / (2 * eps);
        const bool is_pinned = cloth.state.positions[static_cast<std::size_t>(i / 3)].w == 0;
        EXPECT_NEAR(residual[i], is_pinned ? 0.0 : -slope, 1e-7 * residual.lpNorm<Eigen::Infinity>()) << i;
    }
}

TEST(Newton, AgreesWithItselfBySolvingDirectlyAndByIterating) {
    const StudyScene scene = hung_sheet(16, false);
    const auto solved = [&](std::uint32_t direct_up_to) {
        MethodPoint point = method_of(Reference::converged);
        struct Chosen final : Solver {
            explicit Chosen(std::uint32_t limit) : direct_up_to(limit) {}
            SolveResult solve(const SolverStep& step) override {
                const StepFunctional functional(step.model, step.equation);
                const NewtonResult result =
                    Newton(step, functional, direct_up_to).minimise(step, functional, 1e-10);
                for (std::uint32_t i = 0; i < functional.particles(); ++i) {
                    const Eigen::Index at = 3 * static_cast<Eigen::Index>(i);
                    step.velocities[i] = to_vec4(result.velocities.segment<3>(at).cast<float>(), 0);
                }
                return {};
            }
            [[nodiscard]] std::size_t bytes() const noexcept override { return 0; }
            std::uint32_t direct_up_to;
        };
        point.make_solver = [=](const ClothModel&, const ClothSettings&) {
            return std::make_unique<Chosen>(direct_up_to);
        };
        study::Run run(scene, point, 1);
        for (int frame = 0; frame < 5; ++frame) run.step();
        return positions_of(run.cloth());
    };
    EXPECT_LT(rms_distance(solved(1'000'000), solved(0)), 1e-7);
}

TEST(Cholesky, SolvesTheLibrarysSystemLikeADenseSolve) {
    Cloth cloth = pinned_crumple(0.05f, 0.01f);
    OneStep step(cloth, h);
    const auto system = test::assembled(cloth, h);
    const test::DenseSystem dense = test::dense(*system);
    const Eigen::VectorXd expected = dense.matrix.ldlt().solve(dense.right_side);

    CholeskySolver(cloth.model, cloth.settings).solve(step.step());
    EXPECT_LT((test::velocity_change(cloth) - expected).lpNorm<Eigen::Infinity>(),
              1e-6 * expected.lpNorm<Eigen::Infinity>());
}

/// With a single linearisation nothing is left of a linear problem: the functional's own quadratic model
/// agrees.
TEST(Cholesky, IsOneNewtonStepFromRest) {
    Cloth cloth = test::crumpled(test::sheet(6, 5), 0.02f, 50.0f);
    for (Vec4& v : cloth.state.velocities.span()) v = {};
    OneStep step(cloth, h);
    const StepFunctional functional(cloth.model, step.equation());
    BlockMatrix matrix(functional.particles(), pairs_of(functional.springs()));
    functional.hessian(functional.start(), Curvature::projected, matrix);
    ExactSolve exact(functional.particles());
    Eigen::VectorXd newton;
    ASSERT_TRUE(exact.solve(matrix, functional.residual(functional.start()), 1e-12, {}, newton));

    CholeskySolver(cloth.model, cloth.settings).solve(step.step());
    const Eigen::VectorXd difference = test::velocity_change(cloth) - newton;
    EXPECT_LT(difference.lpNorm<Eigen::Infinity>(), 1e-3 * newton.lpNorm<Eigen::Infinity>())
        << "the library keeps W's springs in half precision";
}

// The truth by fine steps: its order, and the motion of one particle that is known.

Positions after(const StudyScene& scene, int frames, int substeps) {
    FineTime fine(scene, 1);
    for (int frame = 0; frame < frames; ++frame) fine.step(substeps);
    return fine.positions();
}

// Without pins a flat sheet falls as one particle against air damping: v' = g - c v.
TEST(FineTime, FallsAsTheClosedFormSays) {
    StudyScene scene = hung_sheet(5, false);
    scene.pins.clear();
    scene.start_positions.clear();
    const double c = static_cast<double>(scene.cloth.air_damping), t = 0.5, g = -9.81;
    const double expected = g / c * (t - (1 - std::exp(-c * t)) / c);
    for (const Eigen::Vector3d& x : after(scene, 30, 64)) EXPECT_NEAR(x.y(), expected, 1e-6);
}

}  // namespace

}  // namespace weft::study
