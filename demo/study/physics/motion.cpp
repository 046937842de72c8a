// Cloth that swings and falls: periods, energy, and the influence of the step.

#include <algorithm>
#include <cmath>

#include "demo/study/physics/experiment.h"
#include "demo/study/physics/known_answers.h"
#include "demo/study/physics/physics_table.h"

namespace weft::study {

namespace {

constexpr double gravity = Experiment::gravity;

/// A strip hung by its upper edge, 1 m long and by default 0.25 m wide, turned by `angle` about this edge.
Experiment tilted(ForceModel model, std::uint32_t cells, const Fabric& fabric, double angle,
                  double width = 0.25) {
    const auto s = static_cast<float>(std::sin(angle)), c = static_cast<float>(std::cos(angle));
    Experiment cloth(strip_mesh(model, {1, width, cells},
                                [=](Vec2 p) {
                                    return Vec3{s * p.x, -c * p.x, p.y};
                                }),
                     made_of(model, fabric));
    cloth.pin([](Vec2 p) { return p.x < 1e-6f; });
    return cloth;
}

/// Period [s]: twice the mean time between zero crossings of `deflection`; 0 without two crossings.
double period(Experiment& cloth, double seconds, const std::function<double()>& deflection) {
    double before = deflection(), first = 0, last = 0, time = 0;
    int crossings = 0;
    cloth.run(seconds, Experiment::usual_step, [&] {
        const double now = deflection(), step = static_cast<double>(Experiment::usual_step);
        time += step;
        if (now * before < 0) {
            last = time - step * now / (now - before);
            if (crossings++ == 0) first = last;
        }
        before = now;
    });
    return crossings > 1 ? 2 * (last - first) / (crossings - 1) : 0;
}

Finding stiff_pendulum(ForceModel model, std::uint32_t cells) {
    constexpr double amplitude = 0.2;
    Fabric fabric;
    fabric.warp = fabric.weft = 4000;
    fabric.shear = 1500;
    fabric.bending = 0.5f;
    Experiment plate = tilted(model, cells, fabric, amplitude);
    const auto end = plate.vertices([](Vec2 p) { return p.x > 1 - 1e-6f; });
    const double measured = period(plate, 4, [&] { return static_cast<double>(plate.mean_place(end).x); });
    return finding("period", "s", measured, plate_pendulum_period(1, amplitude, gravity));
}

Finding hanging_chain(ForceModel model, std::uint32_t cells) {
    Fabric fabric;
    fabric.warp = fabric.weft = 4000;
    fabric.shear = 1000;
    fabric.bending = 0;
    const auto shape = [](float along) {
        return static_cast<float>(
            std::cyl_bessel_j(0.0, 2.404825557695773 * std::sqrt(1 - static_cast<double>(along))));
    };
    Experiment chain(strip_mesh(model, {1, 0.1, cells},
                                [&](Vec2 p) {
                                    return Vec3{0.005f * shape(p.x), -p.x, p.y};
                                }),
                     made_of(model, fabric));
    chain.pin([](Vec2 p) { return p.x < 1e-6f; });
    const auto deflection = [&] {
        double sum = 0;
        for (std::uint32_t i = 0; i < chain.mesh().pattern.size(); ++i)
            sum += static_cast<double>(chain.at(i).x * shape(chain.mesh().pattern[i].x));
        return sum;
    };
    return finding("period", "s", period(chain, 6, deflection), chain_pendulum_period(1, gravity));
}

struct SquareSwing {
    double left;   ///< share of the energy above the still hang's after 2 s
    double speed;  ///< rms over the particles and from 1.5 to 2.5 s [m/s]
};

/// A square of 1 m, turned out by 60 degrees and let go, without air. `truth`: by BDF2 in 64 substeps.
SquareSwing square_swing(ForceModel model, std::uint32_t cells, float step, bool truth) {
    Experiment cloth = tilted(model, cells, Fabric{}, 1.0472, 1);
    if (truth)
        cloth.change([](ClothSettings& settings) {
            settings.time_scheme = TimeScheme::bdf2;
            settings.substeps = 64;
        });
    const double start = cloth.energy();
    double left = 0, squares = 0;
    int count = 0;
    double time = 0;
    const double hanging = -0.5 * gravity * 0.2 * (1 - 0.5 / cells);
    cloth.run(2.5, step, [&] {
        time += static_cast<double>(step);
        if (std::abs(time - 2) < static_cast<double>(step) / 2)
            left = (cloth.energy() - hanging) / (start - hanging);
        if (time < 1.5) return;
        squares += std::pow(cloth.rms_speed(), 2);
        ++count;
    });
    return {left, std::sqrt(squares / count)};
}

std::vector<Finding> swings(ForceModel model, std::uint32_t cells) {
    const SquareSwing truth = square_swing(model, cells, 1.0f / 60, true);
    std::vector<Finding> findings;
    for (const int hz : {30, 60, 120, 240}) {
        const SquareSwing each = square_swing(model, cells, 1.0f / static_cast<float>(hz), false);
        const std::string at = " at 1/" + std::to_string(hz) + " s";
        findings.push_back(finding("energy left" + at, "", each.left, truth.left));
        findings.push_back(finding("speed" + at, "m/s", each.speed, truth.speed));
    }
    return findings;
}

Finding terminal_fall(ForceModel model, std::uint32_t cells) {
    Fabric fabric;
    fabric.bending = 1e-3f;
    WorldSettings settings = in_vacuum();
    settings.wind.air_density = 1.2f;
    settings.wind.drag = 1;
    Experiment sheet(strip_mesh(model, {0.5, 0.5, cells},
                                [](Vec2 p) {
                                    return Vec3{p.x, 0, p.y};
                                }),
                     made_of(model, fabric), settings);
    sheet.run(3);
    return finding("speed", "m/s", sheet.rms_speed(),
                   terminal_speed(static_cast<double>(fabric.areal_density), gravity, 1.2, 1));
}

}  // namespace

std::vector<PhysicsTest> motion_tests() {
    std::vector<PhysicsTest> tests;
    for (const ForceModel model : force_models) {
        for (const std::uint32_t cells : {16u, 32u}) {
            const auto add = [&](const char* name, auto measure) {
                tests.push_back({name, model, cells, cells == 16,
                                 [=] { return std::vector<Finding>{measure(model, cells)}; }});
            };
            add("stiff pendulum", stiff_pendulum);
            add("hanging chain", hanging_chain);
            add("terminal fall", terminal_fall);
            tests.push_back({"swing", model, cells, cells == 16, [=] { return swings(model, cells); }});
        }
    }
    return tests;
}

// A flag in steady wind: how far its end swings, and how often.

namespace {

struct Flutter {
    double amplitude;  ///< peak to peak, in lengths of the flag
    double frequency;  ///< [Hz]
};

/// Flutter of the middle of the free edge, from 4 to 12 s. The flag is 1 m long and 0.6 m wide.
Flutter flag(ForceModel model, std::uint32_t cells, double wind) {
    Fabric fabric;
    fabric.areal_density = 0.12f;
    WorldSettings settings;
    settings.threads = 1;
    settings.wind.velocity = {static_cast<float>(wind), 0, 0};
    Experiment cloth(strip_mesh(model, {1, 0.6, cells},
                                [](Vec2 p) {
                                    return Vec3{p.x, p.y, 0.002f * std::sin(9 * p.x)};
                                }),
                     made_of(model, fabric), settings);
    cloth.pin([](Vec2 p) { return p.x < 1e-6f; });
    cloth.run(4);
    const auto end = cloth.vertices([](Vec2 p) { return p.x > 1 - 1e-6f && std::abs(p.y - 0.3f) < 0.05f; });
    std::vector<double> aside;
    constexpr double seconds = 8;
    cloth.run(seconds, Experiment::usual_step,
              [&] { aside.push_back(static_cast<double>(cloth.mean_place(end).z)); });
    double mean = 0;
    for (const double each : aside) mean += each / static_cast<double>(aside.size());
    int upwards = 0;
    for (std::size_t k = 1; k < aside.size(); ++k) upwards += aside[k - 1] < mean && aside[k] >= mean ? 1 : 0;
    const auto [least, most] = std::ranges::minmax(aside);
    return {most - least, upwards / seconds};
}

std::vector<Finding> winds(ForceModel model, std::uint32_t cells) {
    std::vector<Finding> findings;
    double slowest = 0;
    for (const int wind : {6, 8, 10}) {
        const Flutter flutter = flag(model, cells, wind);
        const std::string at = " at " + std::to_string(wind) + " m/s";
        findings.push_back({"peak to peak" + at, "lengths", flutter.amplitude, 0.15, 0.4});
        findings.push_back({"f L / U" + at, "", flutter.frequency / wind});
        if (wind == 6) slowest = flutter.frequency;
        // In experiments the frequency grows with the wind, about in proportion.
        if (wind == 10)
            findings.push_back(
                {"frequency over that at 6 m/s", "", flutter.frequency / slowest, 1, 10.0 / 6 * 1.2});
    }
    return findings;
}

}  // namespace

std::vector<PhysicsTest> flutter_tests() {
    std::vector<PhysicsTest> tests;
    for (const ForceModel model : force_models)
        for (const std::uint32_t cells : {24u, 48u})
            tests.push_back({"flutter", model, cells, cells == 24, [=] { return winds(model, cells); }});
    return tests;
}

}  // namespace weft::study
