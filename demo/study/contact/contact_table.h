#pragma once
// The table that `weft_study contact` writes, and how it is shown.

#include <string>
#include <vector>

#include "demo/study/charts/csv.h"
#include "demo/study/contact/contact_result.h"

namespace weft::study {

[[nodiscard]] const std::vector<std::string>& contact_columns();
[[nodiscard]] bool is_contact_table(const CsvTable& table);

/// The columns that identify a row.
[[nodiscard]] const std::vector<std::string>& contact_keys();
[[nodiscard]] CsvRow contact_key(const std::string& scene, SelfCollisionMethod method,
                                 std::uint32_t particles, int every);
/// A row of the key and the figures. Lengths in mm, speeds in mm/s, steps in ms.
[[nodiscard]] CsvRow contact_row(CsvRow key, const ContactResult& result);

/// Markdown: one line for each row.
[[nodiscard]] std::string contact_markdown(const CsvTable& table);

}  // namespace weft::study
