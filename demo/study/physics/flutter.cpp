// A flag in steady wind: how far its end swings, and how often.

#include <algorithm>
#include <cmath>

#include "demo/study/physics/experiment.h"
#include "demo/study/physics/physics_test.h"

namespace weft::study {

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
