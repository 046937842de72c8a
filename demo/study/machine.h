#pragma once
// Where figures come from: they mean nothing without it.

#include <string>

namespace weft::study {

/// "Intel(R) Xeon(R) Platinum 8488C; 2 threads": the processor and what of it the system has.
[[nodiscard]] std::string machine_name();
/// The commit that the program was configured from, with "+" where the tree differed; "unknown" outside a
/// repository.
[[nodiscard]] std::string commit_name();

}  // namespace weft::study
