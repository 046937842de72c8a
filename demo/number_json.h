#pragma once
// JSON: parsed, quoted in messages, and as numbers of settings.

#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <utility>

#include "weft/weft.h"

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

/// "a number from 0 to 10": what number_from_json() takes.
[[nodiscard]] std::string range_text(const SettingNumber& number);

/// Sets a number, or the three of a vector. Error: the value is none of its range; the message calls it
/// `key`.
[[nodiscard]] Result<void> number_from_json(const SettingNumber& number, const std::string& key,
                                            const nlohmann::ordered_json& value);

/// The number, with as few digits as read back the same.
[[nodiscard]] nlohmann::ordered_json number_to_json(const SettingNumber& number);

}  // namespace weft::demo
