#pragma once
// The causes for which cells of the stability maps fail, derived from their measurements.

#include <filesystem>
#include <string>

#include "demo/study/charts/csv.h"

namespace weft::study {

/// The cause of a row that is not stable, as a sentence.
[[nodiscard]] std::string cause_of(const CsvRow& row, const CsvTable& table);

/// Writes stability-causes.txt: for each method cells by verdict, and the causes of those not stable.
void write_causes(const CsvTable& table, const std::filesystem::path& folder);

}  // namespace weft::study
