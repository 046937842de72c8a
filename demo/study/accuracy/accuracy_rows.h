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
/// What makes a row another one.
[[nodiscard]] std::vector<std::string> accuracy_keys();

/// Frames at which trajectories are compared, and at which energy is taken: 0.5 s, 1 s and 2 s at 60 frames a
/// second.
struct ComparedFrames {
    static constexpr int half_second = 30, second = 60, last = 120;
};

/// The columns that say what was run where: all keys and more.
[[nodiscard]] CsvRow identity(const StudyScene& scene, const MethodPoint& point, int threads);

/// What a run of a point gave: its row, and the times that are to be put into it.
struct Measured {
    CsvRow row;
    std::vector<double> milliseconds;  ///< of each frame
};
/// Median and 99th percentile of the frames.
void put_times(CsvRow& row, const std::vector<double>& milliseconds);

/// A sheet from its start, for two seconds, the first of which is timed.
[[nodiscard]] Measured measure_trajectory(const StudyScene& scene, const MethodPoint& point,
                                          const std::map<Reference, States>& references, int threads);
/// That first second once more, for its times alone.
[[nodiscard]] std::vector<double> time_trajectory(const StudyScene& scene, const MethodPoint& point,
                                                  int threads);
/// What a reference differs from the others by: the error that remains once its own is gone.
[[nodiscard]] CsvRow compare_reference(const StudyScene& scene, Reference reference,
                                       const std::map<Reference, States>& references, int threads);
/// One step of a garment from each of several states.
[[nodiscard]] Measured measure_steps(const GarmentSteps& steps, const MethodPoint& point, int threads);
[[nodiscard]] std::vector<double> time_steps(const GarmentSteps& steps, const MethodPoint& point,
                                             int threads);

}  // namespace weft::study
