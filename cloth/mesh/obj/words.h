#pragma once
// Words of a line of text, as OBJ files have them.

#include <algorithm>
#include <string_view>

namespace weft {

/// Removes the next word from `text` and returns it; empty where there is none.
inline std::string_view take_word(std::string_view& text) {
    constexpr std::string_view blanks = " \t\r";
    const std::size_t begin = std::min(text.find_first_not_of(blanks), text.size());
    const std::size_t end = std::min(text.find_first_of(blanks, begin), text.size());
    const std::string_view word = text.substr(begin, end - begin);
    text.remove_prefix(end);
    return word;
}

}  // namespace weft
