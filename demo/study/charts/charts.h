#pragma once
// The kinds of table that the commands write, told apart by their columns, and their pictures by gnuplot: SVG
// and PNG in `folder`, beside the scripts that drew them. Each draw_...() throws std::runtime_error if
// gnuplot fails.

#include <filesystem>

#include "demo/study/charts/csv.h"

namespace weft::study {

[[nodiscard]] bool is_accuracy_table(const CsvTable& table);
/// Error against milliseconds: accuracy-<scene>[-<n>]-<quantity>, for each scene and size.
void draw_accuracy(const CsvTable& table, const std::filesystem::path& folder);

[[nodiscard]] bool is_budget_table(const CsvTable& table);
void draw_budget(const CsvTable& table, const std::filesystem::path& folder);

[[nodiscard]] bool is_contact_table(const CsvTable& table);
/// Crossing pairs and the longest edge, peak and final: a line for each scene, a colour for each method.
void draw_contact(const CsvTable& table, const std::filesystem::path& folder);

[[nodiscard]] bool is_searches_table(const CsvTable& table);
/// Recall of the broad phases, and distance tests for a hit, over time.
void draw_searches(const CsvTable& table, const std::filesystem::path& folder);

[[nodiscard]] bool is_physics_table(const CsvTable& table);
/// The error of each figure by force model; finer meshes have larger marks.
void draw_physics(const CsvTable& table, const std::filesystem::path& folder);

[[nodiscard]] bool is_stability_table(const CsvTable& table);
/// stability-<start> for each start, with a map per method in the table's order; and stability-causes.txt.
void draw_stability(const CsvTable& table, const std::filesystem::path& folder);

}  // namespace weft::study
