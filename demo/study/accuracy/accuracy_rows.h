#pragma once
// One row of the table that the charts of speed against accuracy are drawn from.

#include <map>
#include <string>
#include <vector>

#include "demo/study/charts/csv.h"
#include "demo/study/reference/states.h"

namespace weft::study {

[[nodiscard]] std::vector<std::string> accuracy_columns();
/// The columns that identify a row.
[[nodiscard]] std::vector<std::string> accuracy_keys();

/// Frames at which trajectories are compared, the last one their end: 0.5 s and 1 s at 60 frames a second. A
/// garment branches wherever it buckles: after 1 s little of its motion is determined.
[[nodiscard]] std::vector<int> compared_frames(const StudyScene& scene);

/// The columns that describe the run: all keys, machine, commit, label and default.
[[nodiscard]] CsvRow identity(const StudyScene& scene, const MethodPoint& point, int threads);

/// The result of measuring a point: its row, and the times for put_times().
struct Measured {
    CsvRow row;
    std::vector<double> milliseconds;  ///< of each frame
};
/// Writes the frames' number, and the median and 99th percentile of their times.
void put_times(CsvRow& row, const std::vector<double>& milliseconds);

/// Runs a scene from its start to the last of the compared frames.
[[nodiscard]] Measured measure_trajectory(const StudyScene& scene, const MethodPoint& point,
                                          const std::map<Reference, States>& references, int threads);
/// A reference's distance from the truth: the error left to a method that matches this reference exactly.
[[nodiscard]] CsvRow compare_reference(const StudyScene& scene, Reference reference,
                                       const std::map<Reference, States>& references, int threads);

}  // namespace weft::study
