#pragma once
// A scene run to its end, and what came of it.

#include <cstdint>

#include "demo/study/contact/contact_scenes.h"

namespace weft::study {

/// Where a scene does not have what a figure is of, this is not a number.
struct ContactResult {
    std::uint32_t particles = 0;
    std::uint64_t crossings_peak = 0, crossings_final = 0;  ///< pairs of triangles
    std::uint64_t between_final = 0;                        ///< of the latter, between cloths
    double clean_from = 0;             ///< [s] from when to the end nothing crosses; not a number: never
    double gap = 0;                    ///< the least of the whole run [m]
    double stretch_worst = 0;          ///< longest edge of the whole run, over its length at rest
    double stretch_final = 0;          ///< longest edge at the end
    double stretch_mean = 0;           ///< mean of all edges at the end
    double rest_speed = 0;             ///< rms over particles and the last second [m/s]
    double deepest = 0;                ///< in the distance kept from colliders, of the whole run [m]
    double deepest_final = 0;          ///< the same at the end [m]
    double pin_lag = 0;                ///< farthest that a moved pin was from where it should be [m]
    double momentum_drift = 0;         ///< greatest change, over ContactScene::free_momentum
    std::size_t layers = 0;            ///< below 2: order does not count
    std::size_t layers_in_order = 0;   ///< of the pairs of neighbours, one fewer
    double median_step = 0;            ///< World::step [s]
    std::uint32_t unsolved_steps = 0;  ///< of which the World said that equations were left unsolved
    std::uint32_t restored_steps = 0;  ///< at which the World had to put a state back
};

/// Looks at every `every`th frame, and at the last.
[[nodiscard]] ContactResult measure_contact(const ContactScene& scene, Rung rung, int threads, int every);

}  // namespace weft::study
