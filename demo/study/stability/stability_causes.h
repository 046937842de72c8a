#pragma once
// Why cells of the stability maps fail, told from what was measured in them.

#include <filesystem>
#include <string>

#include "demo/study/charts/csv.h"

namespace weft::study {

/// Of a row of the table that is not stable, in a sentence.
[[nodiscard]] std::string cause_of(const CsvRow& row, const CsvTable& table);

/// Per method: cells by verdict, and the causes of those that are not stable, as stability-causes.txt.
void write_causes(const CsvTable& table, const std::filesystem::path& folder);

}  // namespace weft::study
