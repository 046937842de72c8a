#pragma once
// The table that `weft_study contact` writes: the figures of a run, its rows, and how it is shown.

#include <cstdint>
#include <string>
#include <vector>

#include "demo/study/charts/csv.h"
#include "demo/study/contact/contact_scenes.h"

namespace weft::study {

/// Figures of a run. Figures that do not apply to the scene are not-a-number.
struct ContactResult {
    std::uint32_t particles = 0;
    std::uint64_t crossings_peak = 0, crossings_final = 0;  ///< pairs of triangles
    std::uint64_t between_final = 0;                        ///< of crossings_final, between different cloths
    double clean_from = 0;             ///< time from which nothing crosses [s]; not-a-number: never
    double gap = 0;                    ///< least of the whole run, at most 0.1 [m]
    double stretch_worst = 0;          ///< longest edge of the whole run, over its length at rest
    double stretch_final = 0;          ///< longest edge at the end
    double stretch_mean = 0;           ///< mean of all edges at the end
    double rest_speed = 0;             ///< rms over particles and the last second [m/s]
    double deepest = 0;                ///< see deepest_in_colliders(); of the whole run [m]
    double deepest_final = 0;          ///< the same at the end [m]
    double pin_lag = 0;                ///< greatest distance of a moved pin from its target [m]
    double momentum_drift = 0;         ///< greatest change, over ContactScene::free_momentum
    std::size_t layers = 0;            ///< below 2: their order is not judged
    std::size_t layers_in_order = 0;   ///< of layers - 1 pairs of neighbours
    double median_step = 0;            ///< time of World::step [s]
    std::uint32_t unsolved_steps = 0;  ///< steps that the World reported as unsolved
    std::uint32_t restored_steps = 0;  ///< steps at which the World restored a state
};

/// Runs a scene. Crossings, gap, stretch and depth are measured at every `every`th frame and at the last.
[[nodiscard]] ContactResult measure_contact(const ContactScene& scene, SelfCollisionMethod method, int every);

[[nodiscard]] const std::vector<std::string>& contact_columns();

/// The columns that identify a row.
[[nodiscard]] const std::vector<std::string>& contact_keys();
[[nodiscard]] CsvRow contact_key(const std::string& scene, SelfCollisionMethod method,
                                 std::uint32_t particles, int every);
/// A row of the key and the figures. Lengths in mm, speeds in mm/s, steps in ms.
[[nodiscard]] CsvRow contact_row(CsvRow key, const ContactResult& result);

/// Markdown: one line for each row.
[[nodiscard]] std::string contact_markdown(const CsvTable& table);

}  // namespace weft::study
