// Colliders as forces in the implicit step.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>
#include <vector>

#include "cloth/implicit/contacts.h"
#include "cloth/implicit/multigrid.h"
#include "dense_algebra.h"
#include "fixtures.h"
#include "meshes.h"

namespace weft::test {
namespace {

constexpr float h = 1.0f / 60;
constexpr double gravity = 9.80665;

ColliderMotion moving(const Collider& from, const Collider& to) {
    return {from, to};
}

/// A crumpled cloth that lies half in a floor which rises, and slides on it.
struct LyingCloth {
    explicit LyingCloth(bool elements = false)
        : cloth(crumpled(sheet(6, 7), 0.04f, 60.0f)), contacts(cloth.model.particle_count) {
        if (elements) {
            ClothSettings settings = cloth.settings;
            settings.finite_elements = {.enabled = true, .warp = 60, .weft = 40};
            cloth.apply(settings);
        }
        cloth.pin(1);
        cloth.pin(9);
        float middle = 0;
        for (const Vec4& x : cloth.state.positions.span())
            middle += x.y / static_cast<float>(cloth.model.particle_count);
        const auto floor = [&](float y) {
            return Collider{.shape = Plane{{0.1f, 1, 0}, middle + y}, .friction = 0.7f};
        };
        motions = {moving(floor(0), floor(0.002f))};
    }
    StepEquation equation() {
        StepEquation result = equation_of(cloth, h);
        result.contacts = &contacts;
        contacts.begin(motions);
        return result;
    }
    [[nodiscard]] std::uint32_t touching() const {
        return static_cast<std::uint32_t>(std::ranges::count_if(
            contacts.normals(), [](const Vec4& n) { return xyz(n).squaredNorm() > 0; }));
    }
    /// How hard particles press is known from a step before, which made them `faster` times as fast.
    void press(float faster = 1) {
        Parallel serial(1);
        const auto system = make_system(cloth.model, cloth.settings);
        const StepEquation present = equation();
        system->linearise(serial, present, cloth.state.velocities.span(), LinearisedAbout::base);
        AlignedBuffer<Vec4> changes(cloth.model.particle_count);
        for (std::uint32_t i = 0; i < changes.size(); ++i)
            set_xyz(changes[i], (faster - 1) * xyz(cloth.state.velocities[i]));
        contacts.finish(serial, present, changes.span());
    }

    Cloth cloth;
    Contacts contacts;
    std::vector<ColliderMotion> motions;
};

/// The stated law, one particle at a time, in double precision.
struct Law {
    Eigen::Matrix3d g = Eigen::Matrix3d::Zero();
    Eigen::Vector3d at_velocity = Eigen::Vector3d::Zero();  // c - G v
    bool corrected_twice = false;
};
Law law_of(const LyingCloth& lying, std::uint32_t i, double stored, double took, double gravity_fall) {
    const Plane start = std::get<Plane>(lying.motions[0].start.shape),
                end = std::get<Plane>(lying.motions[0].end.shape);
    const Eigen::Vector3d n = to_vector(end.normal).cast<double>().normalized();
    const Eigen::Vector3d x = xyz(lying.cloth.state.positions[i]).cast<double>(),
                          v = xyz(lying.cloth.state.velocities[i]).cast<double>();
    const double w = static_cast<double>(lying.cloth.state.positions[i].w), step = static_cast<double>(h);
    const double gap = n.dot(x + step * v) - static_cast<double>(end.offset) -
                       static_cast<double>(lying.cloth.settings.thickness);
    Law law;
    const bool presses = gap + gravity_fall * n.y() < 0 || (stored > 0 && gap < 4e-3);
    if (w == 0 || !presses) return law;
    const double stretch = static_cast<double>(lying.cloth.settings.fabric.stretch);
    const double spring = 50 / w + 0.005 * step * step * stretch;
    const double impulse = spring / step * (stored > 0 ? -gap : std::max(0.0, -gap));
    const double limit =
        static_cast<double>(lying.cloth.settings.friction) * 0.7 * stored * (1 + 1 / (w * spring));
    const Eigen::Vector3d surface = n * static_cast<double>(end.offset - start.offset) / step;
    const Eigen::Vector3d sliding = (Eigen::Matrix3d::Identity() - n * n.transpose()) * (v - surface);
    double damper = 10 * spring;
    if (limit < damper * sliding.norm()) {
        law.corrected_twice = took > limit;
        damper = limit / sliding.norm() * (law.corrected_twice ? std::max(limit / took, 0.25) : 1.0);
    }
    law.g = damper * Eigen::Matrix3d::Identity() + (spring - damper) * n * n.transpose();
    law.at_velocity = impulse * n - damper * sliding;
    return law;
}

TEST(Contacts, RowsAreThoseOfTheLaw) {
    for (const LinearisedAbout about : {LinearisedAbout::base, LinearisedAbout::iterate}) {
        for (const bool pressed_before : {false, true}) {
            SCOPED_TRACE(pressed_before);
            LyingCloth lying;
            if (pressed_before) {
                lying.press();
                lying.press(1.5f);  // so that the damper takes more than the limit
            }
            const AlignedBuffer<Vec4>& velocities = lying.cloth.state.velocities;
            std::vector<double> stored, took(velocities.size(), 0.0);
            for (const Vec4& normal : lying.contacts.normals())
                stored.push_back(static_cast<double>(normal.w));
            for (std::uint32_t i = 0; pressed_before && i < took.size(); ++i)
                if (stored[i] > 0) took[i] = static_cast<double>(lying.contacts.rows()->impulses[i].w);

            Parallel serial(1);
            const auto system = make_system(lying.cloth.model, lying.cloth.settings);
            system->linearise(serial, lying.equation(), velocities.span(), about);
            const ContactRows* rows = lying.contacts.rows();
            ASSERT_NE(rows, nullptr);
            int in_contact = 0, sticking = 0, corrected_twice = 0;
            for (std::uint32_t i = 0; i < lying.cloth.model.particle_count; ++i) {
                const Law law = law_of(lying, i, stored[i], took[i], -9.81 / 3600);
                const Eigen::Matrix3d g = rows->touches(i) ? rows->block(i).full() : Eigen::Matrix3d::Zero();
                Eigen::Vector3d c = Eigen::Vector3d::Zero();
                if (rows->touches(i)) c = xyz(rows->impulses[i]).cast<double>();
                const Eigen::Vector3d v = xyz(velocities[i]).cast<double>();
                const double size = law.g.norm() * v.norm() + law.at_velocity.norm() + 1e-12;
                EXPECT_LT((g - law.g).norm(), 1e-5 * law.g.norm() + 1e-12) << i;
                EXPECT_LT((c - g * v - law.at_velocity).norm(), 1e-4 * size) << i;
                in_contact += law.g.norm() > 0 ? 1 : 0;
                sticking += law.g.determinant() > 0 ? 1 : 0;
                corrected_twice += law.corrected_twice ? 1 : 0;
            }
            EXPECT_GT(in_contact, 8);
            EXPECT_EQ(sticking > 0, pressed_before);
            EXPECT_EQ(corrected_twice > 0, pressed_before);
        }
    }
}

TEST(Contacts, FarFromCollidersThereAreNone) {
    LyingCloth lying;
    lying.motions = {moving({.shape = Plane{{0, 1, 0}, -9}}, {.shape = Plane{{0, 1, 0}, -9}})};
    Parallel serial(1);
    const auto system = make_system(lying.cloth.model, lying.cloth.settings);
    system->linearise(serial, lying.equation(), lying.cloth.state.velocities.span(), LinearisedAbout::base);
    EXPECT_EQ(lying.contacts.rows(), nullptr);
    EXPECT_EQ(lying.touching(), 0u);
}

TEST(Contacts, SystemIsSymmetricAndItsDiagonalServesRelaxation) {
    for (const bool elements : {false, true}) {
        LyingCloth lying(elements);
        lying.press();
        Parallel serial(1);
        const auto system = make_system(lying.cloth.model, lying.cloth.settings);
        system->linearise(serial, lying.equation(), lying.cloth.state.velocities.span(),
                          LinearisedAbout::iterate);
        const Eigen::MatrixXd w = dense(*system).matrix;
        EXPECT_LT((w - w.transpose()).norm(), 1e-5 * w.norm());
        EXPECT_GT(eigenvalues(w)(0), 0);
        // 2 D - W is positive definite, D^-1 being what relaxation multiplies by.
        Eigen::MatrixXd inverse_diagonal = Eigen::MatrixXd::Zero(w.rows(), w.cols());
        AlignedBuffer<Vec4> unit(lying.cloth.model.particle_count), column(unit.size());
        for (Eigen::Index k = 0; k < w.rows(); ++k) {
            std::ranges::fill(unit.span(), Vec4{});
            Vector3 e = Vector3::Zero();
            e[k % 3] = 1;
            unit[static_cast<std::size_t>(k / 3)] = to_vec4(e, 0);
            system->precondition(serial, unit.span(), 1, column.span());
            inverse_diagonal.col(k) = flat(column.span());
        }
        EXPECT_LT(largest_real_part(inverse_diagonal * w), elements ? 2.01 : 2.0);
    }
}

TEST(Contacts, SolversConvergeToTheDenseSolution) {
    const Method methods[] = {Jacobi{.iterations = 6000}, Chebyshev{.iterations = 800},
                              ConjugateGradient{.iterations = 600}};
    for (const bool elements : {false, true}) {
        for (const Method& method : methods) {
            LyingCloth lying(elements);
            lying.press();
            Cloth& cloth = lying.cloth;
            Parallel serial(1);
            const auto system = make_system(cloth.model, cloth.settings);
            system->linearise(serial, lying.equation(), cloth.state.velocities.span(), LinearisedAbout::base);
            const DenseSystem expected = dense(*system);
            const Eigen::VectorXd exact = solution(expected.matrix, expected.right_side);

            ClothSettings settings = cloth.settings;
            settings.method = method;
            cloth.apply(settings);
            lying.press();  // apply() changed nothing of it; the same state as above
            Profiler profiler(stage_names);
            cloth.solver->solve({.parallel = serial,
                                 .profiler = profiler,
                                 .model = cloth.model,
                                 .settings = cloth.settings,
                                 .equation = lying.equation(),
                                 .touches_collider = true,
                                 .velocity_change = cloth.velocity_change.span()});
            EXPECT_LT((flat(cloth.velocity_change.span()) - exact).norm(), 1e-4 * exact.norm())
                << method.index() << (elements ? " elements" : " springs");
        }
    }
}

WorldSettings vacuum() {
    WorldSettings settings;
    settings.wind.air_density = 0;
    settings.threads = 1;
    settings.gravity = {0, -static_cast<float>(gravity), 0};
    return settings;
}

/// Least length b of rope beyond a rough cylinder of radius r that pulls the length a on this side over it:
/// Euler and Eytelwein's belt, with its own weight.
double slipping_length(double a, double friction, double r) {
    constexpr int parts = 20000;
    const double d_phi = std::numbers::pi / parts;
    double tension = a;  // per weight of a unit of length
    for (int k = 0; k < parts; ++k) {
        const double phi = -std::numbers::pi / 2 + (k + 0.5) * d_phi;
        tension += d_phi * (friction * (tension + r * std::cos(phi)) - r * std::sin(phi));
    }
    return tension;
}

/// A strip over a cylinder, one side longer: how far that side sinks within a second, the friction being
/// `part` of what just holds it.
double strip_sinks(double part, const ClothSettings& given) {
    constexpr float length = 1.2f, width = 0.06f, radius = 0.1f, thickness = 0.005f;
    constexpr std::uint32_t rows = 97, columns = 6;
    World world = World::create(vacuum()).value();
    ClothSettings settings = given;
    settings.thickness = thickness;
    settings.friction = 1;
    const Mesh strip = make_sheet({.rows = rows,
                                   .columns = columns,
                                   .origin = {-0.46f, radius + thickness + 1e-3f, -0.5f * width},
                                   .u = {0, 0, width},
                                   .v = {length, 0, 0}})
                           .value();
    const ClothId id = world.add_cloth(strip, settings).value();
    const Capsule cylinder{{0, 0, -1}, {0, 0, 1}, radius};
    const ColliderId collider = world.add_collider({.shape = cylinder, .friction = 1}).value();
    const auto hangs = [&](std::uint32_t row) {
        const ClothView view = world.cloth(id).value();
        return -static_cast<double>(view.positions[view.vertex_to_particle[row * columns + columns / 2]].y);
    };
    for (int step = 0; step < 480; ++step) world.step(h);
    const double a = hangs(0), b = hangs(rows - 1);
    EXPECT_GT(a, 0.25);
    EXPECT_LT(a, b);
    double low = 0, high = 1;
    for (int k = 0; k < 40; ++k) {
        const double middle = 0.5 * (low + high), r = static_cast<double>(radius + thickness);
        (slipping_length(a, middle, r) < b ? low : high) = middle;
    }
    EXPECT_TRUE(
        world.move_collider(collider, {.shape = cylinder, .friction = static_cast<float>(part * low)}));
    for (int step = 0; step < 60; ++step) world.step(h);
    return hangs(rows - 1) - b;
}

TEST(Contacts, ARopeOverACylinderHoldsAndSlipsByEulersLaw) {
    EXPECT_NEAR(strip_sinks(1.15, {}), 0, 0.015);  // the ends swing yet
    EXPECT_GT(strip_sinks(0.8, {}), 0.1);
}

/// How far a sheet slides down a slope in a second [m].
double slides(double angle, double friction, int substeps) {
    World world = World::create(vacuum()).value();
    const auto s = static_cast<float>(std::sin(angle)), c = static_cast<float>(std::cos(angle));
    const Vector3 normal(s, c, 0), down(c, -s, 0);
    ClothSettings settings;
    settings.thickness = 0.005f;
    settings.friction = 1;
    settings.air_damping = 0;
    settings.substeps = substeps;
    const Mesh mesh = make_sheet({.rows = 24,
                                  .columns = 24,
                                  .origin = to_vec3(Vector3(0.00501f * normal)),
                                  .u = to_vec3(Vector3(0.5f * down)),
                                  .v = {0, 0, 0.5f}})
                          .value();
    const ClothId id = world.add_cloth(mesh, settings).value();
    EXPECT_TRUE(
        world.add_collider({.shape = Plane{to_vec3(normal), 0}, .friction = static_cast<float>(friction)}));
    const auto mean = [&] {
        double sum = 0;
        const ClothView view = world.cloth(id).value();
        for (const Vec4& x : view.positions) sum += static_cast<double>(xyz(x).dot(down));
        return sum / static_cast<double>(view.positions.size());
    };
    const double start = mean();
    for (int step = 0; step < 60; ++step) world.step(h);
    return mean() - start;
}

TEST(Contacts, ASheetOnASlopeRestsBelowTheFrictionAngle) {
    const double angle = 0.5, least = std::tan(angle);
    EXPECT_NEAR(slides(angle, 1.05 * least, 1), 0, 5e-4);
    EXPECT_NEAR(slides(angle, 2 * least, 1), 0, 2e-4);
}

TEST(Contacts, ASheetOnASlopeSlidesByCoulombsLawAboveIt) {
    const double angle = 0.5;
    const auto expected = [&](double friction) {
        return 0.5 * gravity * (std::sin(angle) - friction * std::cos(angle));
    };
    EXPECT_NEAR(slides(angle, 0, 1), expected(0), 0.03 * expected(0));
    EXPECT_NEAR(slides(angle, 0.2, 1), expected(0.2), 0.08 * expected(0.2));
    EXPECT_NEAR(slides(angle, 0.4, 1), expected(0.4), 0.1 * expected(0.4));
    EXPECT_NEAR(slides(angle, 0.4, 4), expected(0.4), 0.08 * expected(0.4));
}

/// How long threads are over how long they rest: the longest in any frame while a 1 m sheet falls onto a
/// ball, and their mean at the end. One step a frame.
struct Threads {
    double longest = 0, mean = 0;
};
Threads threads_on_ball(const ClothSettings& settings) {
    constexpr std::uint32_t side = 64;
    World world = World::create(vacuum()).value();
    const Mesh mesh =
        make_sheet(
            {.rows = side, .columns = side, .origin = {-0.5f, 0.7f, -0.5f}, .u = {1, 0, 0}, .v = {0, 0, 1}})
            .value();
    const ClothId id = world.add_cloth(mesh, settings).value();
    EXPECT_TRUE(world.add_collider({.shape = Sphere{{0, 0.3f, 0}, 0.3f}, .friction = 0.5f}));
    EXPECT_TRUE(world.add_collider({.shape = Plane{}, .friction = 0.6f}));
    Threads threads;
    for (int step = 0; step < 50; ++step) {
        EXPECT_FALSE(has(world.step(h).flags, StepFlags::state_restored));
        const ClothView view = world.cloth(id).value();
        const auto at = [&](std::uint32_t row, std::uint32_t column) {
            return xyz(view.positions[view.vertex_to_particle[row * side + column]]);
        };
        threads.mean = 0;
        for (std::uint32_t k = 0; k < side; ++k) {
            for (std::uint32_t m = 0; m + 1 < side; ++m) {
                for (const Vector3& thread :
                     {Vector3(at(k, m + 1) - at(k, m)), Vector3(at(m + 1, k) - at(m, k))}) {
                    const double length = static_cast<double>(thread.norm()) * (side - 1);
                    threads.longest = std::max(threads.longest, length);
                    threads.mean += length / (2.0 * side * (side - 1));
                }
            }
        }
    }
    return threads;
}

// Met after the step alone, contacts let the ball through the weave: threads grow to twice their length and
// more.
TEST(Contacts, AFineSheetOnABallStaysWholeAtOneStepAFrame) {
    std::vector<ClothSettings> cases(6);
    cases[1].self_collision.enabled = true;
    cases[2].time_scheme = TimeScheme::bdf2;
    cases[3].finite_elements.enabled = true;
    cases[4].method = Multilevel{.passes = 1, .iterations = 1};
    cases[5].method = ConjugateGradient{.iterations = 48};
    for (std::size_t k = 0; k < cases.size(); ++k) {
        SCOPED_TRACE(k);
        cases[k].thickness = 0.008f;
        const Threads threads = threads_on_ball(cases[k]);
        EXPECT_LT(threads.longest, 1.5);
        EXPECT_NEAR(threads.mean, 1, 0.005);
    }
}

TEST(Contacts, DoNotDependOnTheNumberOfThreads) {
    const auto hash = [](int threads) {
        WorldSettings world_settings = vacuum();
        world_settings.threads = threads;
        World world = World::create(world_settings).value();
        ClothSettings settings;
        settings.self_collision.enabled = true;
        const Mesh mesh =
            make_sheet(
                {.rows = 33, .columns = 31, .origin = {-0.5f, 0.31f, -0.5f}, .u = {1, 0, 0}, .v = {0, 0, 1}})
                .value();
        EXPECT_TRUE(world.add_cloth(mesh, settings));
        EXPECT_TRUE(world.add_collider({.shape = Sphere{{0, 0, 0}, 0.3f}, .friction = 0.5f}));
        EXPECT_TRUE(world.add_collider({.shape = Plane{}, .friction = 0.6f}));
        std::uint32_t contacts = 0;
        for (int step = 0; step < 20; ++step) contacts += world.step(h).collider_contacts;
        EXPECT_GT(contacts, 100u);
        return world.state_hash();
    };
    const std::uint64_t expected = hash(1);
    for (const int threads : {2, 3, 8}) EXPECT_EQ(hash(threads), expected) << threads << " threads";
}

TEST(Contacts, LetGo) {
    World world = World::create(vacuum()).value();
    ClothSettings settings;
    settings.air_damping = 0;
    const Mesh mesh = make_sheet({.rows = 12,
                                  .columns = 12,
                                  .origin = {0, settings.thickness, 0},
                                  .u = {0.3f, 0, 0},
                                  .v = {0, 0, 0.3f}})
                          .value();
    const ClothId id = world.add_cloth(mesh, settings).value();
    EXPECT_TRUE(world.add_collider({.shape = Plane{}, .friction = 1}));
    for (int step = 0; step < 20; ++step) world.step(h);
    WorldSettings upwards = world.settings();
    upwards.gravity = {0, static_cast<float>(gravity), 0};
    EXPECT_TRUE(world.set_settings(upwards));
    constexpr int steps = 10;
    for (int step = 0; step < steps; ++step) world.step(h);
    const ClothView view = world.cloth(id).value();
    for (const Vec4& v : view.velocities) {
        EXPECT_LE(static_cast<double>(v.y), gravity * steps / 60 + 1e-4);
        EXPECT_GT(static_cast<double>(v.y), gravity * (steps - 1.5) / 60);  // held for no more than a step
    }
}

}  // namespace
}  // namespace weft::test
