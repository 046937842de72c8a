#pragma once
// Numbers of settings as JSON: in files of settings and of fabrics.

#include <nlohmann/json.hpp>
#include <string>

#include "weft/weft.h"

namespace weft::demo {

/// "a number from 0 to 10": what number_from_json() takes.
[[nodiscard]] std::string range_text(const SettingNumber& number);

/// Sets a number, or the three of a vector. Error: the value is none of its range; the message calls it
/// `key`.
[[nodiscard]] Result<void> number_from_json(const SettingNumber& number, const std::string& key,
                                            const nlohmann::ordered_json& value);

/// The number, with as few digits as read back the same.
[[nodiscard]] nlohmann::ordered_json number_to_json(const SettingNumber& number);

}  // namespace weft::demo
