#include "demo/number_json.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <variant>

namespace weft::demo {

namespace {

using Json = nlohmann::ordered_json;

/// The shortest decimal number that reads back as the same float.
Json shortest(float value) {
    if (std::round(value) == value && std::abs(value) < 1e6f) return static_cast<long long>(value);
    std::array<char, 32> text{};
    for (int digits = 1; digits <= 9; ++digits) {
        std::snprintf(text.data(), text.size(), "%.*g", digits, static_cast<double>(value));
        if (std::strtof(text.data(), nullptr) == value) break;
    }
    return std::strtod(text.data(), nullptr);
}

}  // namespace

std::string range_text(const SettingNumber& number) {
    const char* const what = std::holds_alternative<Vec3*>(number.value) ? "three numbers from "
                             : number.or_zero                            ? "0, or a number from "
                                                                         : "a number from ";
    return what + shortest(number.least).dump() + " to " + shortest(number.greatest).dump();
}

Result<void> number_from_json(const SettingNumber& number, const std::string& key, const Json& value) {
    // The ranges are of floats: the nearest float to 0.001 is in one from 1e-3f on. None has the greatest
    // float.
    const auto fits = [&](const Json& each) {
        return each.is_number() && std::abs(each.get<double>()) < 1e38 &&
               number.has(static_cast<double>(each.get<float>()));
    };
    auto* const* const vector = std::get_if<Vec3*>(&number.value);
    const bool good =
        vector ? value.is_array() && value.size() == 3 && std::ranges::all_of(value, fits) : fits(value);
    if (!good)
        return Error{ErrorCode::malformed_file,
                     key + " is " + quoted_json(value) + "; it must be " + range_text(number)};
    if (vector)
        **vector = {value[0].get<float>(), value[1].get<float>(), value[2].get<float>()};
    else if (auto* const* const whole = std::get_if<int*>(&number.value))
        **whole = value.get<int>();
    else
        *std::get<float*>(number.value) = value.get<float>();
    return {};
}

Json number_to_json(const SettingNumber& number) {
    if (auto* const* const v = std::get_if<Vec3*>(&number.value))
        return {shortest((*v)->x), shortest((*v)->y), shortest((*v)->z)};
    if (auto* const* const whole = std::get_if<int*>(&number.value)) return **whole;
    return shortest(*std::get<float*>(number.value));
}

}  // namespace weft::demo
