#pragma once
// A step's report in words.

#include <string>

#include "weft/report.h"

namespace weft::demo {

/// One line for each flag that is set: what happened and the setting to change. Empty if none is.
[[nodiscard]] std::string flags_text(StepFlags flags);

}  // namespace weft::demo
