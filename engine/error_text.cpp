#include "engine/error_text.h"

#include <charconv>
#include <cmath>
#include <limits>

namespace weft {

namespace {

// Whole numbers up to here are written out; beyond, an exponent is easier to read than a row of digits.
constexpr double largest_plain_number = 1e9;

template <class Float>
std::string shortest_text(Float value) {
    const bool plain =
        std::abs(value) < static_cast<Float>(largest_plain_number) && value == std::trunc(value);
    char text[64];
    const auto end = plain ? std::to_chars(text, text + sizeof text, value, std::chars_format::fixed).ptr
                           : std::to_chars(text, text + sizeof text, value).ptr;
    return {text, end};
}

bool is_a_float(double value) {
    return std::abs(value) <= static_cast<double>(std::numeric_limits<float>::max()) &&
           static_cast<double>(static_cast<float>(value)) == value;
}

Error out_of_range(std::string_view name, const std::string& value, std::string_view requirement) {
    std::string message(name);
    message.append(" is ").append(value).append("; it must be ").append(requirement);
    return {ErrorCode::invalid_argument, std::move(message)};
}

}  // namespace

Error out_of_range(std::string_view name, double value, std::string_view requirement) {
    return out_of_range(name, number_text(value), requirement);
}

Error out_of_range(std::string_view name, const Vec3& value, std::string_view requirement) {
    std::string text = "(";
    text.append(number_text(static_cast<double>(value.x))).append(", ");
    text.append(number_text(static_cast<double>(value.y))).append(", ");
    text.append(number_text(static_cast<double>(value.z))).append(")");
    return out_of_range(name, text, requirement);
}

std::string number_text(double value) {
    if (std::isnan(value)) return "nan";  // whatever its sign
    return is_a_float(value) ? shortest_text(static_cast<float>(value)) : shortest_text(value);
}

bool is_finite(const Vec3& v) noexcept {
    return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z);
}

}  // namespace weft
