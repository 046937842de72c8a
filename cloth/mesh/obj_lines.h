#pragma once
// OBJ text, line by line, checked before a parser sees it.

#include <cstdint>
#include <string>
#include <string_view>

#include "weft/error.h"

namespace weft {

/// What is left of an OBJ file after check_obj. Invariant: every v line has three finite coordinates or more,
/// every vt line two, every f line three corners whose indices exist, and no line continues another.
struct CheckedObj {
    std::string text;                 ///< the v, vt and f lines, without comments
    std::uint32_t ignored_lines = 0;  ///< the others, blank lines and comments not counted
};

/// Error: a line that breaks the invariant, or has a corner without the texture coordinate that
/// `need_texcoords` asks for; or no faces. `file` is the name that errors give it.
[[nodiscard]] Result<CheckedObj> check_obj(std::string_view text, const std::string& file,
                                           bool need_texcoords);

}  // namespace weft
