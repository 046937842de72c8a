#pragma once
// A step's report in words.

#include <string>

#include "weft/report.h"
#include "weft/settings.h"

namespace weft::demo {

/// One line for each flag that is set: what happened and the setting to change. Empty if none is.
/// `wind_speed` [m/s]: a strong wind is a cause, too.
[[nodiscard]] std::string flags_text(StepFlags flags, float wind_speed);

/// A message without the names of the library's types, which a player does not know: "Fabric::warp is -1"
/// becomes "warp is -1".
[[nodiscard]] std::string plain_words(const std::string& message);

/// The step's flags that somebody who looks at the cloth can see the reason of: a pin that cloth stopped less
/// than 10 mm from its place is none.
[[nodiscard]] StepFlags seen_flags(const StepReport& report);

/// The wind's greatest speed with its gusts [m/s].
[[nodiscard]] float speed_of(const Wind& wind);

}  // namespace weft::demo
