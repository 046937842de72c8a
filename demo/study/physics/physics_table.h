#pragma once
// The table that `weft_study physics` writes, and how it is shown.

#include <string>

#include "demo/study/charts/csv.h"
#include "demo/study/physics/physics_test.h"

namespace weft::study {

/// The columns of the CSV, which has a row for each finding.
[[nodiscard]] const std::vector<std::string>& physics_columns();
[[nodiscard]] bool is_physics_table(const CsvTable& table);

/// The columns that identify a test's rows.
[[nodiscard]] const std::vector<std::string>& physics_keys();
/// The row of a finding; without a finding (null), the keys alone.
[[nodiscard]] CsvRow physics_row(const PhysicsTest& test, const Finding* finding);

/// Markdown: measured beside known, one line for each finding.
[[nodiscard]] std::string physics_markdown(const CsvTable& table);

}  // namespace weft::study
