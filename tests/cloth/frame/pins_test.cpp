// Any set of pins, on sheets and on general meshes of any size, under every method: pins are where they were
// told to be, all else moves soundly, and the multigrid agrees with dense algebra.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <random>
#include <string>
#include <vector>

#include "cloth/methods/linear/conjugate_gradient.h"
#include "cloth/solver/levels/levels.h"
#include "cloth/solver/make_system.h"
#include "tests/cloth/fixtures.h"
#include "tests/cloth/meshes.h"
#include "tests/cloth/system/dense_algebra.h"
#include "tests/laid_out.h"

namespace weft::test {
namespace {

struct Pattern {
    std::string name;
    std::vector<std::uint32_t> pins;  ///< ascending
};

/// Those of a square of side * side vertices, row by row.
std::vector<Pattern> patterns(std::uint32_t side) {
    const std::uint32_t last = side - 1, n = side * side;
    std::vector<Pattern> result;
    const auto add = [&](const char* name, const auto& is_pinned) {
        Pattern pattern{name, {}};
        for (std::uint32_t i = 0; i < n; ++i)
            if (is_pinned(i / side, i % side)) pattern.pins.push_back(i);
        result.push_back(std::move(pattern));
    };
    add("none", [](auto, auto) { return false; });
    add("corners", [=](auto r, auto c) { return (r == 0 || r == last) && (c == 0 || c == last); });
    add("one row", [](auto r, auto) { return r == 0; });
    add("two rows", [=](auto r, auto) { return r == 0 || r == last; });
    add("border", [=](auto r, auto c) { return r == 0 || r == last || c == 0 || c == last; });
    add("column", [](auto, auto c) { return c == 1; });
    add("diagonal", [](auto r, auto c) { return r == c; });
    add("half", [=](auto r, auto) { return 2 * r < side; });
    for (const std::uint32_t percent : {1u, 10u, 50u, 90u}) {
        std::vector<std::uint32_t> order(n);
        std::iota(order.begin(), order.end(), 0u);
        std::ranges::shuffle(order, std::mt19937(percent));
        order.resize(std::max(1u, n * percent / 100));
        std::ranges::sort(order);
        result.push_back({std::to_string(percent) + " %", std::move(order)});
    }
    add("all", [](auto, auto) { return true; });
    return result;
}

Mesh square(std::uint32_t side, bool grid) {
    return grid ? sheet(side, side) : loose_sheet(side, side);
}

struct PinnedMethod {
    std::string name;
    Method method;
    float h = 1.0f / 60;
    std::uint32_t largest = 33;  ///< side of the squares
    void (*set)(ClothSettings&) = [](ClothSettings&) {};
};
void PrintTo(const PinnedMethod& method, std::ostream* out) {
    *out << method.name;
}

class PinsOf : public testing::TestWithParam<PinnedMethod> {};
INSTANTIATE_TEST_SUITE_P(
    Methods, PinsOf,
    testing::Values(
        PinnedMethod{"multilevel", Multilevel{}},
        PinnedMethod{"multilevel_elements", Multilevel{}, 1.0f / 60, 33,
                     [](ClothSettings& s) { s.finite_elements.enabled = true; }},
        PinnedMethod{"multilevel_dihedral", Multilevel{}, 1.0f / 60, 17,
                     [](ClothSettings& s) { s.finite_elements.enabled = s.finite_elements.dihedral = true; }},
        PinnedMethod{"multilevel_stiff_bending", Multilevel{}, 1.0f / 60, 17,
                     [](ClothSettings& s) { s.fabric.bending = 1e-3f; }},
        PinnedMethod{"multilevel_bdf2", Multilevel{}, 1.0f / 60, 17,
                     [](ClothSettings& s) { s.time_scheme = TimeScheme::bdf2; }},
        PinnedMethod{"jacobi", Jacobi{}}, PinnedMethod{"chebyshev", Chebyshev{}},
        PinnedMethod{"conjugate_gradient", ConjugateGradient{}}, PinnedMethod{"xpbd", Xpbd{}},
        PinnedMethod{"fibres", Fibres{}}, PinnedMethod{"symplectic_euler", SymplecticEuler{}, 2e-5f}),
    [](const auto& info) { return info.param.name; });

/// All patterns of one size side by side in a World: three steps with pins that move and one without.
void hold(const PinnedMethod& method, std::uint32_t side, bool grid) {
    const std::vector<Pattern> all = patterns(side);
    World world = World::create(vacuum({0, -9.81f, 0})).value();
    ClothSettings settings;
    settings.method = method.method;
    method.set(settings);
    const Mesh mesh = square(side, grid);
    const CookedCloth cooked = CookedCloth::create(mesh, settings).value();
    std::vector<ClothId> cloths;
    for (const Pattern& pattern : all) {
        cloths.push_back(world.add_cloth(cooked).value());
        for (const std::uint32_t pin : pattern.pins) ASSERT_TRUE(world.pin(cloths.back(), pin));
    }
    std::vector<Vec3> targets = mesh.positions;
    for (int step = 0; step < 4; ++step) {
        for (std::size_t k = 0; step < 3 && k < all.size(); ++k) {
            for (const std::uint32_t pin : all[k].pins) {
                const Vector3 moved = to_vector(mesh.positions[pin]) +
                                      method.h * static_cast<float>(step + 1) * Vector3(0.03f, 0.06f, -0.09f);
                targets[pin] = to_vec3(moved);
                ASSERT_TRUE(world.move_pin(cloths[k], pin, targets[pin]));
            }
        }
        const StepFlags flags =
            world.step(method.h).flags;  // pins that jump may leave more unsolved than usual
        EXPECT_TRUE(flags == StepFlags::none || flags == StepFlags::unsolved) << "step " << step;
    }
    for (std::size_t k = 0; k < all.size(); ++k) {
        const ClothView view = world.cloth(cloths[k]).value();
        const auto position = [&](std::size_t vertex) {
            return xyz(view.positions[view.vertex_to_particle[vertex]]);
        };
        for (const std::uint32_t pin : all[k].pins)
            EXPECT_EQ(position(pin), to_vector(targets[pin])) << all[k].name << ", pin " << pin;
        float farthest = 0;
        for (std::size_t i = 0; i < mesh.positions.size(); ++i) {
            const float moved = (position(i) - to_vector(mesh.positions[i])).norm();
            farthest = std::max(farthest, std::isfinite(moved) ? moved : 1e30f);
        }
        EXPECT_LT(farthest, 5 * method.h) << all[k].name;  // at 5 m/s
    }
}

TEST_P(PinsOf, AnyPatternAreWhereTheyWereToldToBe) {
    for (const std::uint32_t side : {3u, 4u, 5u, 8u, 16u, 17u, 33u}) {
        if (side > GetParam().largest) continue;
        for (const bool grid : {true, false}) {
            SCOPED_TRACE(std::to_string(side) + (grid ? " a side, sheet" : " a side, mesh"));
            hold(GetParam(), side, grid);
        }
    }
}

/// A square that hangs askew, its system and its levels, which get the pattern's pins one by one.
struct Pinned {
    Pinned(std::uint32_t side, bool grid, bool elements, const Pattern& pattern)
        : cloth(crumpled(square(side, grid), 0.1f / static_cast<float>(side), 400)) {
        cloth.settings.finite_elements.enabled = elements;
        system = make_system(cloth.model, cloth.settings);
        levels = make_levels(cloth.model, *system);
        for (const std::uint32_t pin : pattern.pins) {
            cloth.pin(pin);
            levels->pin(pin);
        }
        system->linearise(serial, equation_of(cloth, 1.0f / 60), cloth.state.velocities.span(),
                          LinearisedAbout::iterate);
        levels->build(serial);
    }
    [[nodiscard]] bool is_free(std::uint32_t i) const { return cloth.state.positions[i].w != 0; }

    Parallel serial{1};
    Cloth cloth;
    std::unique_ptr<ImplicitSystem> system;
    std::unique_ptr<Multigrid> levels;
};

/// body(Pinned) for all patterns of squares up to `largest`, springs and elements.
template <class Body>
void for_each_pinned(std::uint32_t largest, const Body& body) {
    for (const std::uint32_t side : {3u, 4u, 5u, 8u, 16u}) {
        if (side > largest) continue;
        for (const bool grid : {true, false}) {
            for (const bool elements : {false, true}) {
                for (const Pattern& pattern : patterns(side)) {
                    SCOPED_TRACE(pattern.name + ", " + std::to_string(side) + (grid ? " sheet" : " mesh") +
                                 (elements ? ", elements" : ", springs"));
                    Pinned pinned(side, grid, elements, pattern);
                    body(pinned);
                }
            }
        }
    }
}

TEST(PinPatterns, CycleIsSymmetricPositiveDefiniteOnTheFreeAndZeroOnThePinned) {
    for_each_pinned(8, [](Pinned& pinned) {
        const std::uint32_t n = pinned.cloth.model.particle_count;
        Eigen::MatrixXd inverse = Eigen::MatrixXd::Identity(3 * n, 3 * n);
        AlignedBuffer<Vec4> r(n), z(n);
        for (std::uint32_t i = 0; i < n; ++i) {
            if (!pinned.is_free(i)) continue;
            for (std::uint32_t axis = 0; axis < 3; ++axis) {
                r[i] = to_vec4(Vector3::Unit(axis), 0);
                pinned.levels->cycle(pinned.serial, r.span(), z.span());
                inverse.col(3 * i + axis) = flat(z.span());
            }
            r[i] = {};
        }
        for (std::uint32_t i = 0; i < n; ++i) {
            if (!pinned.is_free(i)) {
                EXPECT_TRUE(inverse.middleRows<3>(3 * i).isApprox(
                    Eigen::MatrixXd::Identity(3 * n, 3 * n).middleRows<3>(3 * i), 0));
            }
        }
        ASSERT_LT((inverse - inverse.transpose()).norm(), 1e-4 * inverse.norm());
        EXPECT_GT(eigenvalues(inverse)[0], 0);
    });
}

TEST(PinPatterns, StepConvergesToTheDenseSolution) {
    for_each_pinned(8, [](Pinned& pinned) {
        const DenseSystem system = dense_coupled(*pinned.system);
        const Eigen::VectorXd exact = solution(system.matrix, system.right_side);
        LaidOut<CgVectors> vectors(pinned.cloth.model.particle_count);
        const auto error_after = [&](int iterations) {
            AlignedBuffer<Vec4> found(pinned.cloth.model.particle_count);
            conjugate_gradients(
                pinned.serial, *pinned.system, iterations,
                [&](auto r, auto z) { pinned.levels->cycle(pinned.serial, r, z); }, vectors, found.span());
            return (flat(found.span()) - exact).norm();
        };
        EXPECT_LE(error_after(3), 0.2 * exact.norm());
        EXPECT_LE(error_after(30), 1e-4 * exact.norm());
    });
}

/// All that a cycle gives on a vector that is different everywhere.
std::vector<Vec4> cycled(Multigrid& levels, ImplicitSystem& system) {
    Parallel serial(1);
    levels.build(serial);
    const std::uint32_t n = system.stencil().nodes;
    AlignedBuffer<Vec4> r = random_rows(n, 1, 5), z(n);
    for (std::uint32_t i = 0; i < n; ++i)
        if (system.right_side()[i].w == 0) r[i] = {};
    levels.cycle(serial, r.span(), z.span());
    return {z.data(), z.data() + n};
}

bool same(const std::vector<Vec4>& a, const std::vector<Vec4>& b) {
    return std::ranges::equal(a, b, [](const Vec4& l, const Vec4& r) {
        return l.x == r.x && l.y == r.y && l.z == r.z && l.w == r.w;
    });
}

TEST(PinPatterns, LevelsDoNotRememberTheOrderInWhichTheyCameAndWent) {
    for (const bool grid : {true, false}) {
        for (const bool elements : {false, true}) {
            const Pattern half = patterns(17)[10];
            ASSERT_EQ(half.name, "50 %");
            Pinned straight(17, grid, elements, half);
            const std::vector<Vec4> expected = cycled(*straight.levels, *straight.system);

            const auto at_once = make_levels(straight.cloth.model, *straight.system);
            at_once->set_pins(straight.cloth.state.positions.span());
            const auto wandering = make_levels(straight.cloth.model, *straight.system);
            std::mt19937 random(3);
            for (int k = 0; k < 2000; ++k) {
                const auto particle = static_cast<std::uint32_t>(random() % (17 * 17));
                random() % 2 == 0 ? wandering->pin(particle) : wandering->unpin(particle);
            }
            std::vector<std::uint32_t> order(17 * 17);
            std::iota(order.begin(), order.end(), 0u);
            std::ranges::shuffle(order, random);
            for (const std::uint32_t i : order) straight.is_free(i) ? wandering->unpin(i) : wandering->pin(i);
            straight.system->linearise(straight.serial, equation_of(straight.cloth, 1.0f / 60),
                                       straight.cloth.state.velocities.span(), LinearisedAbout::iterate);
            EXPECT_TRUE(same(cycled(*at_once, *straight.system), expected)) << grid << elements;
            EXPECT_TRUE(same(cycled(*wandering, *straight.system), expected)) << grid << elements;
        }
    }
}

}  // namespace
}  // namespace weft::test
