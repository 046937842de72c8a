// Cloth against textbooks: chains, strings, hung strips, membranes.

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <numbers>
#include <utility>
#include <vector>

#include "tests/cloth/fixtures.h"
#include "tests/cloth/meshes.h"

namespace weft::test {
namespace {

constexpr double gravity = 9.81;
constexpr double pi = std::numbers::pi;
constexpr float strip_width = 0.1f;

/// Springs along the threads alone: a strip of two columns is two chains side by side, each half of its
/// width.
ClothSettings threads_only(float chain, std::uint32_t cells, TimeScheme scheme, int substeps,
                           float air_damping = 0) {
    ClothSettings settings;
    const float stiffness = 2 * chain / (strip_width * static_cast<float>(cells));
    settings.fabric = {.warp = stiffness, .weft = stiffness, .shear = 0, .bending = 0, .damping = 0};
    settings.air_damping = air_damping;
    settings.method = ConjugateGradient{.iterations = 400};
    settings.time_scheme = scheme;
    settings.substeps = substeps;
    return settings;
}

World world_in_vacuum(const Vec3& acceleration) {
    return World::create(vacuum(acceleration)).value();
}

/// `nodes` rows of two particles along `along`, 1 m at rest. `place` moves a particle, given how far along it
/// is.
template <class Place>
Mesh strip_placed(std::uint32_t nodes, const Vec3& along, const Place& place) {
    Mesh mesh =
        evenly_cut({.rows = nodes, .columns = 2, .origin = {0, 0, 0}, .u = {0, 0, strip_width}, .v = along});
    mesh.pattern = mesh.texcoords;
    for (std::uint32_t i = 0; i < 2 * nodes; ++i) {
        mesh.positions[i] =
            place(mesh.positions[i], static_cast<float>(i / 2) / static_cast<float>(nodes - 1));
    }
    return mesh;
}

TEST(HungStrip, EveryEdgeIsStretchedByWhatHangsBelow) {
    constexpr std::uint32_t nodes = 21;
    constexpr float stretch = 200;
    World world = world_in_vacuum({0, -9.81f, 0});
    const Mesh mesh = strip_placed(nodes, {0, -1, 0}, [](Vec3 x, float) { return x; });
    const ClothSettings settings = threads_only(stretch, nodes - 1, TimeScheme::backward_euler, 1, 20);
    const ClothId id = world.add_cloth(mesh, settings).value();
    (void)world.pin(id, 0);
    (void)world.pin(id, 1);
    for (int k = 0; k < 240; ++k) world.step(h);

    const ClothView cloth = world.cloth(id).value();
    ASSERT_LT(world.report().peak_speed, 1e-5f);
    std::array<double, 2> hanging{};  // mass below each column's edge [kg]
    for (std::uint32_t row = nodes - 1; row > 0; --row) {
        for (std::uint32_t column = 0; column < 2; ++column) {
            const Vec4 &below = cloth.positions[2 * row + column],
                       &above = cloth.positions[2 * row - 2 + column];
            hanging[column] += 1 / static_cast<double>(below.w);
            const double stretched = static_cast<double>(above.y - below.y) - 1.0 / (nodes - 1);
            const double expected = hanging[column] * gravity / static_cast<double>(stretch);
            EXPECT_NEAR(stretched, expected, 0.02 * expected + 1e-6) << "row " << row;
        }
    }
    // The continuum's top strain: weight over stiffness and width; two springs carry a strip one cell wide.
    const double weight = 0.2 * 1.0 * static_cast<double>(strip_width) * gravity;
    const double top = static_cast<double>(cloth.positions[0].y - cloth.positions[2].y) * (nodes - 1) - 1;
    EXPECT_NEAR(top, weight / (2.0 * static_cast<double>(stretch) / (nodes - 1)), 0.04 * top);
}

/// J_0, which only some standard libraries have.
double bessel(double x) {
    double term = 1, sum = 1;
    for (int k = 1; k < 30; ++k) sum += term *= -x * x / (4.0 * k * k);
    return sum;
}

TEST(HangingChain, SwingsAtTheZerosOfBesselsFunction) {
    constexpr std::array zeros{2.404825557695773, 5.520078110286311};
    constexpr std::uint32_t nodes = 41;
    for (const double zero : zeros) {
        const auto shape = [&](float along) {
            return static_cast<float>(bessel(zero * std::sqrt(1 - static_cast<double>(along))));
        };
        World world = world_in_vacuum({0, -9.81f, 0});
        const Mesh mesh = strip_placed(nodes, {0, -1, 0}, [&](Vec3 x, float along) {
            return Vec3{x.x + 0.005f * shape(along), x.y, x.z};
        });
        const ClothId id = world.add_cloth(mesh, threads_only(4000, 20, TimeScheme::bdf2, 6)).value();
        (void)world.pin(id, 0);
        (void)world.pin(id, 1);
        const auto deflection = [&] {
            double sum = 0;
            for (std::uint32_t i = 0; i < 2 * nodes; ++i)
                sum += static_cast<double>(world.cloth(id)->positions[i].x *
                                           shape(static_cast<float>(i / 2) / (nodes - 1)));
            return sum;
        };
        // From the first crossing of zero to the second: half a period.
        std::vector<double> crossings;
        double before = deflection();
        for (int k = 1; crossings.size() < 2 && k < 120; ++k) {
            world.step(h);
            const double now = deflection();
            if (now * before < 0) crossings.push_back((k - now / (now - before)) / 60);
            before = now;
        }
        ASSERT_EQ(crossings.size(), 2u);
        const double frequency = pi / (crossings[1] - crossings[0]);
        EXPECT_NEAR(frequency, 0.5 * zero * std::sqrt(gravity), 0.01 * frequency);
    }
}

TEST(HangingChain, HangsAsACatenary) {
    constexpr std::uint32_t nodes = 41;
    constexpr double span = 0.6;
    World world = world_in_vacuum({0, -9.81f, 0});
    // It starts as a V of the right length.
    const Mesh mesh = strip_placed(nodes, {1, 0, 0}, [&](Vec3 x, float along) {
        return Vec3{static_cast<float>(span) * (along - 0.5f), -0.8f * (0.5f - std::abs(along - 0.5f)), x.z};
    });
    const ClothId id =
        world.add_cloth(mesh, threads_only(4000, 20, TimeScheme::backward_euler, 1, 4)).value();
    for (const std::uint32_t end : {0u, 1u, 2 * nodes - 2, 2 * nodes - 1}) (void)world.pin(id, end);
    for (int k = 0; k < 400; ++k) world.step(h);

    // Of z = a cosh(x / a), whose length over the span is 1: the smaller a, the longer.
    double least = 0.05, most = 5;
    while (most - least > 1e-12) {
        const double middle = (least + most) / 2;
        (2 * middle * std::sinh(span / (2 * middle)) > 1 ? least : most) = middle;
    }
    const double a = least;
    const ClothView cloth = world.cloth(id).value();
    for (const Vec4& x : cloth.positions) {
        const double expected = a * (std::cosh(static_cast<double>(x.x) / a) - std::cosh(span / (2 * a)));
        EXPECT_NEAR(static_cast<double>(x.y), expected, 2e-3) << x.x;
    }
}

/// A string of beads between two pins, stretched by a fifth, that starts at rest in its p'th mode.
struct String {
    static constexpr std::uint32_t beads = 15;
    static constexpr float stretch = 20, strain = 0.2f, amplitude = 2e-3f;

    String(int mode_number, TimeScheme scheme, int substeps)
        : world(world_in_vacuum({0, 0, 0})), p(mode_number) {
        const Mesh mesh = strip_placed(beads + 2, {1, 0, 0}, [&](Vec3 x, float along) {
            return Vec3{(1 + strain) * x.x, amplitude * shape(along), x.z};
        });
        id = world.add_cloth(mesh, threads_only(stretch, beads + 1, scheme, substeps)).value();
        for (const std::uint32_t end : {0u, 1u, 2 * beads + 2, 2 * beads + 3}) (void)world.pin(id, end);
    }
    [[nodiscard]] float shape(float along) const {
        return static_cast<float>(std::sin(p * pi * static_cast<double>(along)));
    }
    /// omega_p = 2 sqrt(T / (m a)) sin(p pi / (2 (N + 1))).
    [[nodiscard]] double frequency() const {
        const double mass = 1 / static_cast<double>(world.cloth(id)->positions[2].w);
        const double rest = 1.0 / (beads + 1), a = rest * (1 + static_cast<double>(strain));
        const double tension = static_cast<double>(stretch) * (a - rest);
        return 2 * std::sqrt(tension / (mass * a)) * std::sin(p * pi / (2 * (beads + 1)));
    }
    /// The mode's amplitude, and its velocity.
    [[nodiscard]] Eigen::Vector2d mode() const {
        const ClothView cloth = world.cloth(id).value();
        Eigen::Vector2d sum(0, 0);
        for (std::uint32_t i = 0; i < 2 * beads + 4; ++i) {
            const double weight =
                static_cast<double>(shape(static_cast<float>(i / 2) / (beads + 1))) / (beads + 1);
            sum += weight * Eigen::Vector2d(static_cast<double>(cloth.positions[i].y),
                                            static_cast<double>(cloth.velocities[i].y));
        }
        return sum;
    }
    World world;
    ClothId id;
    int p;
};

TEST(PinnedString, BackwardEulerDampsEveryModeByItsClosedForm) {
    // By 1 / sqrt(1 + omega^2 h^2) a step, in the norm in which energy is measured.
    for (const int p : {1, 2, 3}) {
        String string(p, TimeScheme::backward_euler, 2);
        const double h = 1.0 / 120, omega = string.frequency();
        const auto energy = [&] {
            const Eigen::Vector2d mode = string.mode();
            return mode[1] * mode[1] + omega * omega * mode[0] * mode[0];
        };
        const double first = energy();
        for (int k = 0; k < 12; ++k) string.world.step(test::h);
        EXPECT_NEAR(energy() / first, std::pow(1 + omega * omega * h * h, -24), 0.01 * energy() / first)
            << "mode " << p;
    }
}

TEST(PinnedString, Bdf2SwingsByItsRecurrence) {
    // (3 x_n+1 - 4 x_n + x_n-1) / 2 = h v_n+1, and v likewise, from one step of backward Euler.
    for (const int p : {1, 2, 3}) {
        String string(p, TimeScheme::bdf2, 2);
        const double h = 1.0 / 120, omega = string.frequency();
        Eigen::Matrix2d rate;
        rate << 0, 1, -omega * omega, 0;
        const Eigen::Matrix2d one = Eigen::Matrix2d::Identity();
        Eigen::Vector2d before = string.mode();
        Eigen::Vector2d now = (one - h * rate).inverse() * before;
        const Eigen::Matrix2d later = (3 * one - 2 * h * rate).inverse();
        const double amplitude = before[0];
        for (int k = 0; k < 30; ++k) {
            string.world.step(test::h);
            if (k > 0) {
                const Eigen::Vector2d next = later * (4 * now - before);
                before = std::exchange(now, next);
            }
            const Eigen::Vector2d next = later * (4 * now - before);
            before = std::exchange(now, next);
            EXPECT_NEAR(string.mode()[0], now[0], 0.01 * amplitude) << "mode " << p << ", frame " << k;
        }
    }
}

TEST(PinnedString, SmallStepsSwingAtTheClosedFormsFrequency) {
    for (const int p : {1, 2, 3}) {
        String string(p, TimeScheme::bdf2, 40);
        const double amplitude = string.mode()[0], omega = string.frequency();
        for (int k = 1; k <= 20; ++k) {
            string.world.step(test::h);
            EXPECT_NEAR(string.mode()[0], amplitude * std::cos(omega * k / 60), 0.02 * amplitude)
                << "mode " << p << ", frame " << k;
        }
    }
}

/// The sag of the middle of a square membrane of side 1.2 m under a small load, n cells a side, over what a
/// membrane that cannot be refined further sags: 0.0736713 (load / tension) side^2.
double relative_sag(std::uint32_t cells) {
    constexpr double load = 0.01;  // [m/s^2]
    World world = world_in_vacuum({0, -static_cast<float>(load), 0});
    const std::uint32_t n = cells + 1;
    Mesh mesh = evenly_cut({.rows = n, .columns = n});
    mesh.pattern = mesh.texcoords;
    for (Vec3& x : mesh.positions) x = {1.2f * x.x, 0, 1.2f * x.z};
    ClothSettings settings = threads_only(50, 20, TimeScheme::backward_euler, 1);
    const ClothId id = world.add_cloth(mesh, settings).value();
    for (std::uint32_t i = 0; i < n * n; ++i) {
        if (i / n == 0 || i / n == n - 1 || i % n == 0 || i % n == n - 1) (void)world.pin(id, i);
    }
    for (int k = 0; k < 12; ++k) world.step(1);  // backward Euler in long steps goes to rest
    // Over the area of the stretched cell the load is rho g / 1.2^2, and tension is that of a spring over its
    // width.
    const double tension = 50 * (1.2 - 1) / 1.2, weight = 0.2 * load / (1.2 * 1.2);
    const double sag = -static_cast<double>(world.cloth(id)->positions[n * n / 2].y);
    return sag / (0.0736713 * weight / tension * 1.2 * 1.2);
}

TEST(Membrane, SagConvergesQuadraticallyWithTheMesh) {
    const double coarse = relative_sag(4) - 1, middle = relative_sag(8) - 1, fine = relative_sag(16) - 1;
    EXPECT_NEAR(coarse / middle, 4, 0.8);
    EXPECT_NEAR(middle / fine, 4, 0.8);
    EXPECT_LT(std::abs(fine), 5e-3);
}

}  // namespace
}  // namespace weft::test
