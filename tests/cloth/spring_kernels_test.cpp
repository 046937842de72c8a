// The loops over springs, on every kind of vector that this machine has, against one particle at a time in
// double precision.

#include <gtest/gtest.h>

#include <algorithm>
#include <cstring>
#include <functional>
#include <random>

#include "cloth/forces/spring_system.h"
#include "cloth/forces/springs.h"
#include "cloth/implicit/symmetric3.h"
#include "fixtures.h"
#include "hwy/targets.h"
#include "meshes.h"

namespace weft::test {
namespace {

/// A moving cloth in moving air, a few particles pinned, and all that a step's equation refers to.
struct Scene {
    CookedCloth model;
    ClothSettings settings;
    AlignedBuffer<Vec4> positions, velocities, base_velocities, air;
    LinearisedAbout about = LinearisedAbout::base;

    [[nodiscard]] std::uint32_t size() const { return model.particle_count; }
    [[nodiscard]] StepEquation equation() const {
        return {.settings = settings,
                .h = 1.0f / 60,
                .gamma = 1.0f / 60,
                .positions = positions.span(),
                .velocities = velocities.span(),
                .base_positions = positions.span(),
                .base_velocities = base_velocities.span(),
                .external = {.gravity = {0, -9.81f, 0}, .air_damping = 0.5f, .air = air.span()}};
    }
    /// Where springs are looked at.
    [[nodiscard]] Vector3 place(std::uint32_t i) const {
        const float gamma = about == LinearisedAbout::base ? 0 : equation().gamma;
        return xyz(positions[i]) + gamma * xyz(velocities[i]);
    }
};

Scene make_scene(const Mesh& mesh, float stiffness, LinearisedAbout about) {
    Scene scene;
    scene.model = cook(mesh).value();
    const std::uint32_t n = scene.size();
    scene.settings.fabric = {.stretch = stiffness, .shear = 0.3f * stiffness, .bend = 1e-3f * stiffness};
    scene.settings.fabric.damping = 0.01f;
    scene.positions = random_rows(n, 0.3f * scene.model.info.mean_edge, 1);
    scene.velocities = random_rows(n, 1, 2);
    scene.base_velocities = random_rows(n, 1, 3);
    scene.air = random_rows(n, 1e-3f, 4);
    for (std::uint32_t i = 0; i < n; ++i) {
        Vec4& x = scene.positions[i];
        const Vector3 noise = xyz(x);
        const float mass = scene.settings.fabric.areal_density * scene.model.rest_area[i];
        x = to_vec4(xyz(scene.model.positions[i]) + noise, i % 13 == 4 ? 0 : 1 / mass);
        scene.air[i].w = 1e-4f * static_cast<float>(i % 3);
    }
    scene.about = about;
    return scene;
}

/// Puts every fifth particle where its first neighbour is.
void make_coincident(Scene& scene) {
    for (std::uint32_t i = 0; i < scene.size(); i += 5) {
        const std::uint32_t j = scene.model.neighbours[scene.model.spring_offsets[i]];
        set_xyz(scene.positions[i], xyz(scene.positions[j]));
        scene.velocities[i] = scene.velocities[j];
    }
}

/// spring_terms and the equation, particle by particle, summed in double precision.
struct Reference {
    explicit Reference(const Scene& scene)
        : size(scene.size()),
          diagonal(size, Eigen::Matrix3d::Zero()),
          links(size),
          row_sums(size, 0),
          b(size) {
        const StepEquation equation = scene.equation();
        const auto gamma = static_cast<double>(equation.gamma);
        const bool about_base = scene.about == LinearisedAbout::base;
        const std::array<float, 3> of_kind = stiffnesses(scene.settings.fabric);
        for (std::uint32_t i = 0; i < size; ++i) {
            b[i].setZero();
            if (scene.positions[i].w == 0) continue;
            const double mass = 1 / static_cast<double>(scene.positions[i].w);
            const Eigen::Vector3d v = velocity(scene, i);
            const auto air_damping = static_cast<double>(equation.external.air_damping);
            const auto slope = static_cast<double>(scene.air[i].w);
            row_sums[i] = mass * (1 + gamma * air_damping) + gamma * slope;
            b[i] = mass * (xyz(scene.base_velocities[i]).cast<double>() - v) +
                   gamma * mass * (equation.external.gravity.cast<double>() - air_damping * v) +
                   gamma * xyz(scene.air[i]).cast<double>();
            diagonal[i] = row_sums[i] * Eigen::Matrix3d::Identity();
            for (std::uint32_t e = scene.model.spring_offsets[i]; e < scene.model.spring_offsets[i + 1];
                 ++e) {
                const std::uint32_t j = scene.model.neighbours[e];
                const float k = of_kind[static_cast<std::size_t>(scene.model.kinds[e])];
                const SpringTerms spring =
                    spring_terms(scene.place(j) - scene.place(i), scene.model.rest_lengths[e], k, i, j);
                const Eigen::Vector3d n = spring.direction.cast<double>();
                const double viscous = gamma * 0.01 * static_cast<double>(k);
                const Eigen::Matrix3d elastic =
                    gamma * gamma *
                    (static_cast<double>(spring.isotropic) * Eigen::Matrix3d::Identity() +
                     static_cast<double>(spring.axial) * n * n.transpose());
                const Eigen::Matrix3d damping = viscous * n * n.transpose();
                links[i].push_back({j, elastic + damping});
                diagonal[i] += elastic + damping;
                b[i] += gamma * spring.force.cast<double>() +
                        (damping + (about_base ? 1 : 0) * elastic) * (velocity(scene, j) - v);
            }
        }
    }

    /// Takes the system's blocks, which are those found here but for rounding to half precision (11 digits),
    /// to zero on some machines.
    void take_blocks(const Scene& scene, SpringSystem& system) {
        Parallel serial(1);
        const AlignedBuffer<Vec4> blocks = system.all_spring_blocks(serial);
        for (std::uint32_t i = 0; i < size; ++i) {
            std::uint32_t e = scene.model.spring_offsets[i];
            for (Link& link : links[i]) {
                const Vec4& spring = blocks[system.stencil().entries[e++]];
                const Eigen::Vector3d d = xyz(spring).cast<double>();
                const Eigen::Matrix3d block =
                    static_cast<double>(spring.w) * Eigen::Matrix3d::Identity() + d * d.transpose();
                EXPECT_LE((block - link.block).norm(), 0x1p-9 * link.block.trace()) << i << " to " << link.to;
                diagonal[i] += block - link.block;
                link.block = block;
            }
        }
    }

    static Eigen::Vector3d velocity(const Scene& scene, std::uint32_t i) {
        return xyz(scene.velocities[i]).cast<double>();
    }
    [[nodiscard]] Eigen::Vector3d product(const AlignedBuffer<Vec4>& x, std::uint32_t i) const {
        const Eigen::Vector3d x_i = xyz(x[i]).cast<double>();
        Eigen::Vector3d sum = row_sums[i] * x_i;
        for (const Link& link : links[i]) sum += link.block * (x_i - xyz(x[link.to]).cast<double>());
        return sum;
    }
    /// Of the rounding to which the sums of row i are subject.
    [[nodiscard]] double scale(std::uint32_t i) const { return diagonal[i].trace(); }

    struct Link {
        std::uint32_t to;
        Eigen::Matrix3d block;
    };
    std::uint32_t size;
    std::vector<Eigen::Matrix3d> diagonal;
    std::vector<std::vector<Link>> links;
    std::vector<double> row_sums;
    std::vector<Eigen::Vector3d> b;
};

struct Case {
    std::string name;
    std::function<Scene()> scene;
};

std::vector<Case> cases() {
    const auto grid = [](LinearisedAbout about) { return make_scene(sheet(11, 13), 400, about); };
    const auto irregular = [] {
        return joined(sphere(2), joined(fan(20), loose_sheet(5, 7), {3, 0, 0}), {5, 0, 0});
    };
    return {{"grid", [=] { return grid(LinearisedAbout::base); }},
            {"grid about the iterate", [=] { return grid(LinearisedAbout::iterate); }},
            {"narrow grid", [] { return make_scene(sheet(40, 2), 400, LinearisedAbout::base); }},
            {"irregular mesh", [=] { return make_scene(irregular(), 400, LinearisedAbout::iterate); }},
            {"one triangle", [] { return make_scene(fan(1), 400, LinearisedAbout::base); }},
            {"coincident particles",
             [=] {
                 Scene scene = make_scene(irregular(), 400, LinearisedAbout::iterate);
                 make_coincident(scene);
                 return scene;
             }},
            {"extreme stiffness", [=] { return make_scene(irregular(), 1e12f, LinearisedAbout::base); }},
            {"no stiffness", [=] { return make_scene(sheet(9, 9), 0, LinearisedAbout::base); }}};
}

void linearise(SpringSystem& system, const Scene& scene, Parallel& parallel) {
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
    for (const Case& c : cases()) {
        SCOPED_TRACE(c.name);
        const Scene scene = c.scene();
        Reference reference(scene);
        SpringSystem system(scene.model);
        linearise(system, scene, serial);
        reference.take_blocks(scene, system);
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

TEST_P(SpringKernels, MultiplyReturnsTheEnergy) {
    for (const Case& c : cases()) {
        SCOPED_TRACE(c.name);
        const Scene scene = c.scene();
        SpringSystem system(scene.model);
        linearise(system, scene, serial);
        const AlignedBuffer<Vec4> x = random_rows(scene.size(), 1, 5);
        AlignedBuffer<Vec4> product(scene.size());
        const double energy = system.multiply(serial, x.span(), product.span());
        EXPECT_NEAR(energy / flat(x.span()).dot(flat(product.span())), 1, 1e-6);
        EXPECT_GT(energy, 0);
    }
}

TEST_P(SpringKernels, RelaxationAndPreconditioningUseTheInverseDiagonal) {
    for (const Case& c : cases()) {
        SCOPED_TRACE(c.name);
        const Scene scene = c.scene();
        Reference reference(scene);
        SpringSystem system(scene.model);
        linearise(system, scene, serial);
        reference.take_blocks(scene, system);
        const AlignedBuffer<Vec4> b = random_rows(scene.size(), 1, 6), x = random_rows(scene.size(), 1, 7);
        AlignedBuffer<Vec4> next = random_rows(scene.size(), 1, 8), preconditioned(scene.size());
        const AlignedBuffer<Vec4> before = random_rows(scene.size(), 1, 8);
        AlignedBuffer<Vec4> product(scene.size()), remainder(scene.size()), correction(scene.size());
        system.precondition(serial, b.span(), 0.75f, preconditioned.span());
        system.relax(serial, b.span(), x.span(), {.step = 0.75f, .momentum = 0.5f}, next.span());
        system.multiply(serial, x.span(), product.span());
        system.subtract_product(serial, b.span(), x.span(), remainder.span());
        for (std::uint32_t i = 0; i < scene.size(); ++i)
            EXPECT_EQ(xyz(remainder[i]), xyz(b[i]) - xyz(product[i])) << "particle " << i;
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

TEST_P(SpringKernels, PinnedParticlesHaveNoRow) {
    for (const Case& c : cases()) {
        SCOPED_TRACE(c.name);
        const Scene scene = c.scene();
        SpringSystem system(scene.model);
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
    for (const Case& c : cases()) {
        SCOPED_TRACE(c.name);
        Scene scene = c.scene();
        for (Vec4& x : scene.positions.span()) x.w = 100;  // rows of pinned particles may hold anything
        SpringSystem system(scene.model);
        linearise(system, scene, serial);
        const AlignedBuffer<Vec4> blocks = system.all_spring_blocks(serial);
        const Stencil& stencil = system.stencil();
        const CookedCloth& model = scene.model;
        const auto half_edge = [&](std::uint32_t i, std::uint32_t j) {
            const auto row = model.neighbours.span().subspan(
                model.spring_offsets[i], model.spring_offsets[i + 1] - model.spring_offsets[i]);
            const auto rank = static_cast<std::uint32_t>(std::ranges::find(row, j) - row.begin());
            return stencil.entries[model.spring_offsets[i] + rank];
        };
        for (std::uint32_t i = 0; i < scene.size(); ++i) {
            for (std::uint32_t e = model.spring_offsets[i]; e < model.spring_offsets[i + 1]; ++e) {
                const std::uint32_t here = stencil.entries[e], there = half_edge(model.neighbours[e], i);
                EXPECT_EQ(blocks[here].w, blocks[there].w);
                EXPECT_GE(blocks[here].w, 0);
                EXPECT_EQ(xyz(blocks[here]), -xyz(blocks[there]));
            }
        }
    }
}

TEST_P(SpringKernels, MatrixIsSymmetric) {
    for (const Case& c : cases()) {
        SCOPED_TRACE(c.name);
        const Scene scene = c.scene();
        SpringSystem system(scene.model);
        linearise(system, scene, serial);
        AlignedBuffer<Vec4> x = random_rows(scene.size(), 1, 5), y = random_rows(scene.size(), 1, 6);
        for (std::uint32_t i = 0; i < scene.size(); ++i) {
            if (scene.positions[i].w == 0) x[i] = y[i] = {};
        }
        AlignedBuffer<Vec4> wx(scene.size()), wy(scene.size());
        const double xx = system.multiply(serial, x.span(), wx.span());
        const double yy = system.multiply(serial, y.span(), wy.span());
        const double xy = flat(x.span()).dot(flat(wy.span())), yx = flat(y.span()).dot(flat(wx.span()));
        EXPECT_NEAR(xy, yx, 1e-6 * std::sqrt(xx * yy));
    }
}

/// All that a system computes.
struct Results {
    double energy;
    std::vector<Vec4> rows;
    bool operator==(const Results& other) const {  // to the last bit
        return std::memcmp(&energy, &other.energy, sizeof energy) == 0 && rows.size() == other.rows.size() &&
               std::memcmp(rows.data(), other.rows.data(), rows.size() * sizeof(Vec4)) == 0;
    }
};

Results everything(const Scene& scene, Parallel& parallel) {
    SpringSystem system(scene.model);
    linearise(system, scene, parallel);
    AlignedBuffer<Vec4> product(scene.size()), residual(scene.size()), relaxed(scene.size()),
        solved(scene.size());
    const auto b = system.right_side().span();
    const double energy = system.multiply(parallel, scene.velocities.span(), product.span());
    system.residual(parallel, scene.equation(), scene.velocities.span(), residual.span());
    system.relax(parallel, b, scene.velocities.span(), {.step = 0.75f, .momentum = 0.5f}, relaxed.span());
    system.precondition(parallel, b, 1, solved.span());
    Results result{energy, {}};
    for (const std::span<const Vec4> part :
         {std::span<const Vec4>(b), std::span<const Vec4>(product.span()),
          std::span<const Vec4>(residual.span()), std::span<const Vec4>(relaxed.span()),
          std::span<const Vec4>(solved.span())}) {
        result.rows.insert(result.rows.end(), part.begin(), part.end());
        // What lies behind the last particle stays 0: see AlignedBuffer.
        for (const Vec4* pad = part.data() + part.size(); pad < part.data() + (part.size() + 15) / 16 * 16;
             ++pad)
            EXPECT_TRUE(pad->x == 0 && pad->y == 0 && pad->z == 0 && pad->w == 0);
    }
    return result;
}

TEST_P(SpringKernels, SameBytesForAnyNumberOfThreads) {
    Scene scene = make_scene(loose_sheet(30, 45), 400, LinearisedAbout::iterate);
    make_coincident(scene);
    const Results expected = everything(scene, serial);
    for (const int threads : {2, 3, 8}) {
        Parallel parallel(threads);
        EXPECT_TRUE(everything(scene, parallel) == expected) << threads << " threads";
    }
}

std::vector<std::int64_t> targets() {
    return hwy::SupportedAndGeneratedTargets();
}

INSTANTIATE_TEST_SUITE_P(Targets, SpringKernels, testing::ValuesIn(targets()),
                         [](const auto& info) { return std::string(hwy::TargetName(info.param)); });

// Eight lanes or sixteen: both round a product and its sum once.
TEST(SpringKernelWidths, SameBytesOnWideAndNarrowVectors) {
    const std::int64_t usable = hwy::SupportedTargets() & HWY_TARGETS;
    if ((usable & HWY_AVX2) == 0 || (usable & HWY_AVX3) == 0) GTEST_SKIP() << "needs AVX2 and AVX-512";
    Parallel serial(1);
    for (const Case& c : cases()) {
        SCOPED_TRACE(c.name);
        const Scene scene = c.scene();
        hwy::SetSupportedTargetsForTest(HWY_AVX2);
        const Results narrow = everything(scene, serial);
        hwy::SetSupportedTargetsForTest(HWY_AVX3);
        EXPECT_TRUE(everything(scene, serial) == narrow);
        hwy::SetSupportedTargetsForTest(0);
    }
}

}  // namespace
}  // namespace weft::test
