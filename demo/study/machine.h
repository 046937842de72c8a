#pragma once
// The machine and the commit that figures come from.

#include <string>

#include "demo/study/charts/csv.h"

namespace weft::study {

/// The processor and its hardware threads: "Intel(R) Xeon(R) Platinum 8488C; 2 threads".
[[nodiscard]] std::string machine_name();
/// The commit of the source tree when the program first asks, with "+" where the tree differs; "unknown"
/// outside a repository.
[[nodiscard]] std::string commit_name();

/// The line that every picture of a table has at its foot: the command, and the commits and machines of its
/// rows.
[[nodiscard]] std::string origin_of(const CsvTable& table, const std::string& command);

}  // namespace weft::study
