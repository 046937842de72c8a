#pragma once
// Error against milliseconds, drawn by gnuplot.

#include <filesystem>

#include "demo/study/charts/csv.h"

namespace weft::study {

/// Whether the table is one that `weft_study accuracy` wrote.
[[nodiscard]] bool is_accuracy_table(const CsvTable& table);

/// For each scene and size the charts accuracy-<scene>[-<n>]-<what>.svg and .png, and the gnuplot scripts
/// that drew them. Throws std::runtime_error if gnuplot fails.
void draw_accuracy(const CsvTable& table, const std::filesystem::path& folder);

}  // namespace weft::study
