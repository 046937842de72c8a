#pragma once
// Parses JSON text, and quotes values for messages.

#include <optional>
#include <string>
#include <utility>

namespace weft::demo {

/// Greatest depth of nesting that is accepted. nlohmann's library copies, writes and, if ordered, parses by
/// recursion: a value that is nested a hundred thousand times overflows the stack.
inline constexpr int deepest_json = 64;

/// Parses the input. None: the input is no JSON, or is nested deeper than deepest_json.
template <class Json, class Input>
[[nodiscard]] std::optional<Json> parse_json(Input&& input) {
    bool is_too_deep = false;
    const auto keep = [&](int depth, typename Json::parse_event_t, Json&) {
        is_too_deep = is_too_deep || depth > deepest_json;
        return !is_too_deep;
    };
    Json json = Json::parse(std::forward<Input>(input), keep, false);
    if (is_too_deep || json.is_discarded()) return std::nullopt;
    return json;
}

/// The value's text, at most 60 characters and three dots.
template <class Json>
[[nodiscard]] std::string quoted_json(const Json& value) {
    constexpr std::size_t longest = 60;
    std::string text = value.dump();
    if (text.size() > longest) text.replace(longest, text.npos, "...");
    return text;
}

}  // namespace weft::demo
