#pragma once
// The picture of a table that `weft_study budget` wrote.

#include <filesystem>

#include "demo/study/charts/csv.h"

namespace weft::study {

[[nodiscard]] bool is_budget_table(const CsvTable& table);
void draw_budget(const CsvTable& table, const std::filesystem::path& folder);

}  // namespace weft::study
