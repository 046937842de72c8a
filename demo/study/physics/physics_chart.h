#pragma once
// The picture of a table that `weft_study physics` wrote.

#include <filesystem>

#include "demo/study/charts/csv.h"

namespace weft::study {

/// Writes physics.gnuplot, .svg and .png into `folder`: the error of each figure by force model; finer meshes
/// have larger marks. Throws std::runtime_error if gnuplot fails.
void draw_physics(const CsvTable& table, const std::filesystem::path& folder);

}  // namespace weft::study
