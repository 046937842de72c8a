// The loops over springs against one particle at a time in double precision. tests/targets compares vector
// widths.

#include <gtest/gtest.h>

#include <algorithm>
#include <cstring>
#include <functional>

#include "cloth/fabric/spring_system.h"
#include "cloth/fabric/springs/springs.h"
#include "engine/simd/symmetric3.h"
#include "hwy/targets.h"
#include "spring_scene.h"
#include "tests/cloth/fixtures.h"
#include "tests/cloth/meshes.h"

namespace weft::test {
namespace {

struct SpringCase {
    std::string name;
    std::function<SpringScene()> scene;
};

std::vector<SpringCase> spring_cases() {
    const auto grid = [](LinearisedAbout about) { return make_scene(sheet(11, 13), 400, about); };
    const auto irregular = [] {
        return joined(sphere(2), joined(fan(20), loose_sheet(5, 7), {3, 0, 0}), {5, 0, 0});
    };
    return {{"grid", [=] { return grid(LinearisedAbout::base); }},
            {"grid about the iterate", [=] { return grid(LinearisedAbout::iterate); }},
            {"larger grid", [] { return make_scene(sheet(40, 37), 400, LinearisedAbout::iterate); }},
            // Rows a power of two apart: rings are just as long.
            {"grid of whole groups", [] { return make_scene(sheet(24, 32), 400, LinearisedAbout::iterate); }},
            {"grid of one group", [] { return make_scene(sheet(40, 16), 400, LinearisedAbout::base); }},
            {"narrow grid", [] { return make_scene(sheet(40, 2), 400, LinearisedAbout::base); }},
            {"irregular mesh", [=] { return make_scene(irregular(), 400, LinearisedAbout::iterate); }},
            {"one triangle", [] { return make_scene(fan(1), 400, LinearisedAbout::base); }},
            {"coincident particles",
             [=] {
                 SpringScene scene = make_scene(irregular(), 400, LinearisedAbout::iterate);
                 make_coincident(scene);
                 return scene;
             }},
            {"stiffening grid",
             [=] {
                 SpringScene scene = grid(LinearisedAbout::iterate);
                 scene.settings.fabric.stiffening = 30;
                 return scene;
             }},
            {"stiffening grid about the base",
             [=] {
                 SpringScene scene = grid(LinearisedAbout::base);
                 scene.settings.fabric.stiffening = 30;
                 return scene;
             }},
            {"stiffening mesh",
             [=] {
                 SpringScene scene = make_scene(irregular(), 400, LinearisedAbout::iterate);
                 scene.settings.fabric.stiffening = 30;
                 return scene;
             }},
            {"stiffening mesh about the base",
             [=] {
                 SpringScene scene = make_scene(irregular(), 400, LinearisedAbout::base);
                 scene.settings.fabric.stiffening = 1000;
                 return scene;
             }},
            {"extreme stiffness", [=] { return make_scene(irregular(), 1e12f, LinearisedAbout::base); }},
            {"no stiffness", [=] { return make_scene(sheet(9, 9), 0, LinearisedAbout::base); }}};
}

void linearise(SpringSystem& system, const SpringScene& scene, Parallel& parallel) {
    system.linearise(parallel, scene.equation(), scene.velocities.span(), scene.about);
}

/// Runs a test's body with each kind of vectors; without them again when it ends.
class SpringKernels : public testing::TestWithParam<std::int64_t> {
  protected:
    void SetUp() override { hwy::SetSupportedTargetsForTest(GetParam()); }
    void TearDown() override { hwy::SetSupportedTargetsForTest(0); }

    Parallel serial{1};
};

/// One unit of rounding, relative to what is summed.
constexpr double rounding = 6e-8;

TEST_P(SpringKernels, RowsAreThoseOfTheScalarStatement) {
    for (const SpringCase& c : spring_cases()) {
        SCOPED_TRACE(c.name);
        const SpringScene scene = c.scene();
        SpringReference reference(scene);
        SpringSystem system(scene.model, scene.settings.fabric.stiffening > 0);
        linearise(system, scene, serial);
        reference.take_blocks(system);
        const AlignedBuffer<Vec4> x = random_rows(scene.size(), 1, 5), b = random_rows(scene.size(), 1, 6);
        AlignedBuffer<Vec4> product(scene.size()), residual(scene.size());
        system.multiply(serial, x.span(), product.span());
        system.residual(serial, scene.equation(), scene.velocities.span(), residual.span());
        const bool about_iterate = scene.about == LinearisedAbout::iterate;
        for (std::uint32_t i = 0; i < scene.size(); ++i) {
            const Vec4& right = system.right_side()[i];
            const double scale = reference.scale(i);
            EXPECT_NEAR(static_cast<double>(right.w), reference.row_sums[i],
                        8 * rounding * reference.row_sums[i]);
            // b is impulses: W times speeds of some m/s, and gamma k times lengths below 10 cm.
            EXPECT_LE((xyz(right).cast<double>() - reference.b[i]).norm(), 200 * rounding * scale)
                << "particle " << i;
            if (about_iterate) {
                EXPECT_LE((xyz(residual[i]) - xyz(right)).cast<double>().norm(), 100 * rounding * scale);
            }
            EXPECT_LE((xyz(product[i]).cast<double>() - reference.product(x, i)).norm(),
                      40 * rounding * scale);
            EXPECT_EQ(product[i].w, 0);
        }
    }
}

TEST_P(SpringKernels, MultiplyReturnsTheProductsOnItsWay) {
    for (const SpringCase& c : spring_cases()) {
        SCOPED_TRACE(c.name);
        const SpringScene scene = c.scene();
        SpringSystem system(scene.model, scene.settings.fabric.stiffening > 0);
        linearise(system, scene, serial);
        const AlignedBuffer<Vec4> x = random_rows(scene.size(), 1, 5), b = random_rows(scene.size(), 1, 6);
        AlignedBuffer<Vec4> product(scene.size());
        const DottedWith with{b.data(), nullptr, x.data()};
        const Products found = system.multiply(serial, with, x.span(), product.span());
        const Eigen::VectorXd flat_x = flat(x.span()), flat_b = flat(b.span());
        EXPECT_NEAR(found.x_wx / flat_x.dot(flat(product.span())), 1, 1e-6);
        EXPECT_GT(found.x_wx, 0);
        EXPECT_NEAR(found.dots[0], flat_b.dot(flat_x), 1e-6 * flat_b.norm() * flat_x.norm());
        EXPECT_EQ(found.dots[1], 0);
        EXPECT_NEAR(found.dots[2] / flat_x.squaredNorm(), 1, 1e-6);
        const Products without = system.multiply(serial, with, x.span(), {});
        EXPECT_EQ(without.x_wx, found.x_wx) << "whether the product is kept or not";
        EXPECT_EQ(without.dots, found.dots);
    }
}

TEST_P(SpringKernels, RelaxationAndPreconditioningUseTheInverseDiagonal) {
    for (const SpringCase& c : spring_cases()) {
        SCOPED_TRACE(c.name);
        const SpringScene scene = c.scene();
        SpringReference reference(scene);
        SpringSystem system(scene.model, scene.settings.fabric.stiffening > 0);
        linearise(system, scene, serial);
        reference.take_blocks(system);
        const AlignedBuffer<Vec4> b = random_rows(scene.size(), 1, 6), x = random_rows(scene.size(), 1, 7);
        AlignedBuffer<Vec4> next = random_rows(scene.size(), 1, 8), preconditioned(scene.size());
        const AlignedBuffer<Vec4> before = random_rows(scene.size(), 1, 8);
        AlignedBuffer<Vec4> product(scene.size()), remainder(scene.size()), correction(scene.size());
        system.precondition(serial, b.span(), 0.75f, preconditioned.span());
        system.relax(serial, b.span(), x.span(), {.step = 0.75f, .momentum = 0.5f}, next.span());
        system.multiply(serial, x.span(), product.span());
        for (std::uint32_t i = 0; i < scene.size(); ++i)
            remainder[i] = to_vec4(xyz(b[i]) - xyz(product[i]), 0);
        system.precondition(serial, remainder.span(), 0.75f, correction.span());
        for (std::uint32_t i = 0; i < scene.size(); ++i) {
            Symmetric3 block;
            const Eigen::Matrix3f diagonal = reference.diagonal[i].cast<float>();
            block = {diagonal(0, 0), diagonal(1, 1), diagonal(2, 2),
                     diagonal(0, 1), diagonal(0, 2), diagonal(1, 2)};
            const bool pinned = scene.positions[i].w == 0;
            const Symmetric3 inverse_block =
                pinned ? Symmetric3{} : inverse(block, static_cast<float>(reference.row_sums[i]));
            const Vector3 expected = 0.75f * (inverse_block * xyz(b[i]));
            // A block whose softest direction single precision has all but lost has a loose inverse there.
            const double condition =
                pinned ? 1 : std::min(reference.scale(i) / reference.row_sums[i], 1 / (3 * 3e-7));
            const double size = pinned ? 0 : 1 / std::max(reference.row_sums[i], 3e-7 * reference.scale(i));
            EXPECT_LE((xyz(preconditioned[i]) - expected).cast<double>().norm(),
                      20 * rounding * condition * size)
                << "particle " << i;
            const Vector3 moved = xyz(x[i]) + 0.5f * (xyz(x[i]) - xyz(before[i])) + xyz(correction[i]);
            EXPECT_LE((xyz(next[i]) - moved).norm(), 1e-6f * (4 + xyz(correction[i]).norm()))
                << "particle " << i;
        }
    }
}

TEST_P(SpringKernels, StepsOfACycleAreThoseOneByOne) {
    for (const SpringCase& c : spring_cases()) {
        SCOPED_TRACE(c.name);
        const SpringScene scene = c.scene();
        SpringSystem system(scene.model, scene.settings.fabric.stiffening > 0);
        linearise(system, scene, serial);
        const std::uint32_t n = scene.size();
        const AlignedBuffer<Vec4> b = random_rows(n, 1, 6), e = random_rows(7, 1, 9);
        const Interpolation p = random_interpolation(scene, 7);
        const Correction correction{p, e.span()};

        AlignedBuffer<Vec4> x(n), product(n), next(n);
        system.precondition(serial, b.span(), 0.75f, x.span());
        system.multiply(serial, x.span(), product.span());
        float largest = 0;
        for (std::uint32_t i = 0; i < n; ++i) largest = std::max(largest, xyz(x[i]).norm());
        AlignedBuffer<Vec4> kept(n), remainder(n), found(n);
        system.subtract_first_step(serial, b.span(), 0.75f, kept.span(), remainder.span());
        for (std::uint32_t i = 0; i < n; ++i)
            EXPECT_EQ(xyz(remainder[i]), xyz(b[i]) - xyz(product[i])) << "particle " << i;

        prolong_from(serial, correction, x.span());
        system.relax(serial, b.span(), x.span(), {.step = 0.75f}, next.span());
        system.relax_corrected(serial, b.span(), 0.75f, kept.span(), correction, found.span());
        for (std::uint32_t i = 0; i < n; ++i)  // sums may be in another order
            EXPECT_LE((xyz(found[i]) - xyz(next[i])).norm(), 1e-5f * (4 + largest)) << "particle " << i;
    }
}

TEST_P(SpringKernels, PinnedParticlesHaveNoRow) {
    for (const SpringCase& c : spring_cases()) {
        SCOPED_TRACE(c.name);
        const SpringScene scene = c.scene();
        SpringSystem system(scene.model, scene.settings.fabric.stiffening > 0);
        linearise(system, scene, serial);
        const AlignedBuffer<Vec4> x = random_rows(scene.size(), 1, 5), b = random_rows(scene.size(), 1, 6);
        AlignedBuffer<Vec4> product(scene.size()), residual(scene.size()),
            next = random_rows(scene.size(), 1, 8);
        const AlignedBuffer<Vec4> before = random_rows(scene.size(), 1, 8);
        system.multiply(serial, x.span(), product.span());
        system.residual(serial, scene.equation(), scene.velocities.span(), residual.span());
        system.relax(serial, b.span(), x.span(), {.step = 1, .momentum = 0.5f}, next.span());
        for (std::uint32_t i = 0; i < scene.size(); ++i) {
            if (scene.positions[i].w != 0) continue;
            EXPECT_EQ(xyz(product[i]), Vector3::Zero());
            EXPECT_EQ(xyz(residual[i]), Vector3::Zero());
            EXPECT_EQ(xyz(system.right_side()[i]), Vector3::Zero());
            EXPECT_EQ(system.right_side()[i].w, 0);
            EXPECT_LE((xyz(next[i]) - (1.5f * xyz(x[i]) - 0.5f * xyz(before[i]))).norm(), 1e-6f);
        }
    }
}

TEST_P(SpringKernels, BothEndsOfASpringComputeTheSameFloats) {
    for (const SpringCase& c : spring_cases()) {
        SCOPED_TRACE(c.name);
        SpringScene scene = c.scene();
        for (Vec4& x : scene.positions.span()) x.w = 100;  // rows of pinned particles may hold anything
        SpringSystem system(scene.model, scene.settings.fabric.stiffening > 0);
        linearise(system, scene, serial);
        const AlignedBuffer<Vec4> blocks = system.all_spring_blocks(serial);
        const ClothModel& model = scene.model;
        for (std::uint32_t i = 0; i < scene.size(); ++i) {
            for (std::uint32_t e = model.spring_offsets[i]; e < model.spring_offsets[i + 1]; ++e) {
                const std::uint32_t j = model.neighbours[e];
                const std::uint32_t here = system.entry_between(i, j), there = system.entry_between(j, i);
                if (here == there) continue;  // in a grid there is but one
                EXPECT_EQ(blocks[here].w, blocks[there].w);
                EXPECT_EQ(xyz(blocks[here]), -xyz(blocks[there]));
            }
        }
    }
}

std::vector<std::int64_t> targets() {
    return hwy::SupportedAndGeneratedTargets();
}

INSTANTIATE_TEST_SUITE_P(Targets, SpringKernels, testing::ValuesIn(targets()),
                         [](const auto& info) { return std::string(hwy::TargetName(info.param)); });

}  // namespace
}  // namespace weft::test
