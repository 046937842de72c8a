#pragma once
// One row of the table that the charts of speed against accuracy are drawn from.

#include <map>
#include <string>
#include <vector>

#include "demo/study/accuracy/garment_steps.h"
#include "demo/study/charts/csv.h"
#include "demo/study/reference/states.h"

namespace weft::study {

[[nodiscard]] std::vector<std::string> accuracy_columns();
/// The columns that identify a row.
[[nodiscard]] std::vector<std::string> accuracy_keys();

/// Frames at which trajectories are compared, and at which energy is taken: 0.5 s, 1 s and 2 s at 60 frames a
/// second.
struct ComparedFrames {
    static constexpr int half_second = 30, second = 60, last = 120;
};

/// The columns that describe the run: all keys, machine, commit, label and default.
[[nodiscard]] CsvRow identity(const StudyScene& scene, const MethodPoint& point, int threads);

/// The result of measuring a point: its row, and the times for put_times().
struct Measured {
    CsvRow row;
    std::vector<double> milliseconds;  ///< of each frame
};
/// Writes the frames' number, and the median and 99th percentile of their times.
void put_times(CsvRow& row, const std::vector<double>& milliseconds);

/// Runs a sheet from its start for two seconds; the first second is timed.
[[nodiscard]] Measured measure_trajectory(const StudyScene& scene, const MethodPoint& point,
                                          const std::map<Reference, States>& references, int threads);
/// Repeats that first second for its times alone.
[[nodiscard]] std::vector<double> time_trajectory(const StudyScene& scene, const MethodPoint& point,
                                                  int threads);
/// A reference's distances from the others: the error left to a method that matches this reference exactly.
[[nodiscard]] CsvRow compare_reference(const StudyScene& scene, Reference reference,
                                       const std::map<Reference, States>& references, int threads);
/// Measures one step of a garment from each of several states.
[[nodiscard]] Measured measure_steps(const GarmentSteps& steps, const MethodPoint& point, int threads);
[[nodiscard]] std::vector<double> time_steps(const GarmentSteps& steps, const MethodPoint& point,
                                             int threads);

}  // namespace weft::study
