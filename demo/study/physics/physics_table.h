#pragma once
// The table that `weft_study physics` writes, and how it is shown.

#include <string>

#include "demo/study/charts/csv.h"
#include "demo/study/physics/physics_test.h"

namespace weft::study {

/// Of the CSV: a row for each finding.
[[nodiscard]] const std::vector<std::string>& physics_columns();
[[nodiscard]] bool is_physics_table(const CsvTable& table);

/// What tells a test's rows from others'.
[[nodiscard]] const std::vector<std::string>& physics_keys();
/// `finding` may be null for the keys alone.
[[nodiscard]] CsvRow physics_row(const PhysicsTest& test, const Finding* finding);

/// Markdown: measured beside known, one line for each finding.
[[nodiscard]] std::string physics_markdown(const CsvTable& table);

}  // namespace weft::study
