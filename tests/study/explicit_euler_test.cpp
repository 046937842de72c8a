// Explicit Euler against the bounds that its characteristic equation gives.

#include "demo/study/stability/explicit_euler.h"

#include <gtest/gtest.h>

#include <cmath>

#include "cloth/simulation/simulation.h"

namespace weft::study {
namespace {

/// One particle between two pins, held by a spring along x and one along z: two modes alike, omega^2 = k / m.
/// Displaced by a tenth of a millimetre, so that it stays in the plane and all but linear.
class Oscillator {
  public:
    Oscillator(double omega, double spring_damping, double drag) : simulation_(weightless()) {
        ClothSettings settings;
        settings.method = SymplecticEuler{};
        settings.air_damping = static_cast<float>(drag);
        auto cloth =
            std::make_unique<Cloth>(cook(make_sheet({.rows = 2, .columns = 2}).value()).value(), settings);
        const float mass = cloth->mass(3);
        const float stiffness = 2 * mass * static_cast<float>(omega * omega);  // halved at a border
        settings.fabric = {.warp = stiffness,
                           .weft = stiffness,
                           .shear = 0,
                           .bending = 0,
                           .damping = static_cast<float>(spring_damping)};
        cloth->apply(settings);
        cloth->take_solver(std::make_unique<ExplicitEulerSolver>(cloth->model, settings));
        for (const std::uint32_t pinned : {0u, 1u, 2u}) cloth->pin(pinned);
        rest_ = xyz(cloth->state.positions[3]);
        set_xyz(cloth->state.positions[3], rest_ + Vector3(1e-4f, 0, 0));
        cloth_ = cloth.get();
        simulation_.prepare(*cloth);
        simulation_.add(std::move(cloth));
    }

    /// Largest displacement in the last tenth of `steps` steps, over the first.
    double growth(double h, int steps) {
        float largest = 0;
        for (int step = 0; step < steps; ++step) {
            simulation_.step(static_cast<float>(h));
            const float away = (xyz(cloth_->state.positions[3]) - rest_).norm();
            if (step >= steps - steps / 10) largest = std::max(largest, away);
        }
        return static_cast<double>(largest) / 1e-4;
    }

  private:
    static WorldSettings weightless() {
        WorldSettings settings;
        settings.gravity = {0, 0, 0};
        settings.wind.air_density = 0;
        settings.threads = 1;
        return settings;
    }

    Simulation simulation_;
    Cloth* cloth_;
    Vector3 rest_;
};

struct Damping {
    const char* what;
    double omega, of_springs, of_air;

    [[nodiscard]] double rate() const { return of_springs * omega * omega + of_air; }
    [[nodiscard]] double bound() const {
        const double c = rate(), discriminant = c * c - 4 * omega * omega;
        return discriminant < 0 ? c / (omega * omega) : 4 / (c + std::sqrt(discriminant));
    }
};

TEST(ExplicitEuler, IsStableJustInsideItsBoundAndFailsJustOutside) {
    for (const Damping& damping : {Damping{"drag alone", 100, 0, 50}, Damping{"damped springs", 100, 4e-3, 0},
                                   Damping{"both", 100, 2e-3, 30}, Damping{"creeping", 100, 0.03, 0}}) {
        Oscillator inside(damping.omega, damping.of_springs, damping.of_air);
        Oscillator outside(damping.omega, damping.of_springs, damping.of_air);
        EXPECT_LT(inside.growth(0.95 * damping.bound(), 2000), 0.5) << damping.what;
        EXPECT_GT(outside.growth(1.05 * damping.bound(), 2000), 10) << damping.what;
    }
}

TEST(ExplicitEuler, GainsEnergyAtAnyStepWithoutDamping) {
    // |mu|^2 = 1 + h^2 omega^2: at a fiftieth of symplectic Euler's bound, e-fold in 1250 steps.
    Oscillator oscillator(100, 0, 0);
    const double h = 0.04 / 100;
    const int steps = 3000;
    EXPECT_NEAR(oscillator.growth(h, steps) / std::pow(1 + 0.04 * 0.04, steps / 2.0), 1, 0.1);
}

}  // namespace
}  // namespace weft::study
