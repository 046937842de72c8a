#pragma once
// The machine and the commit that figures come from.

#include <string>

namespace weft::study {

/// The processor and its hardware threads: "Intel(R) Xeon(R) Platinum 8488C; 2 threads".
[[nodiscard]] std::string machine_name();
/// The commit that the program was configured from, with "+" where the tree differed; "unknown" outside a
/// repository.
[[nodiscard]] std::string commit_name();

}  // namespace weft::study
