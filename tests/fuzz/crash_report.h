#pragma once
// Says what was being played when the program crashes or hangs.

#include <string>

namespace weft::fuzz {

/// From now on, a fatal signal, the sanitizers' end and a call that takes ten minutes print `text` and the
/// present operation. `text` must outlive the play.
void report_crashes_with(const std::string& text);

}  // namespace weft::fuzz
