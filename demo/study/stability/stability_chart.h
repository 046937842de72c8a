#pragma once
// Stability maps as pictures, drawn by gnuplot.

#include <filesystem>

#include "demo/study/charts/csv.h"

namespace weft::study {

/// Whether the table is one that `weft_study stability` wrote.
[[nodiscard]] bool is_stability_table(const CsvTable& table);

/// For each start a picture, stability-<start>.svg and .png, with a map per method in the table's order, and
/// the gnuplot script that drew it. Throws std::runtime_error if gnuplot fails.
void draw_stability(const CsvTable& table, const std::filesystem::path& folder);

}  // namespace weft::study
