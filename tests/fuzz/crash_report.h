#pragma once
// Says what was being played when the program crashes or hangs.

#include <cstddef>
#include <string>

namespace weft::fuzz {

/// From now on, a fatal signal, the sanitizers' end and `longest` seconds without another call of this print
/// `text` and the number of the present operation. Both must outlive that.
void report_crashes_with(const std::string& text, const std::size_t& operation, unsigned longest);

}  // namespace weft::fuzz
