#pragma once
// Messages that name the value and the remedy, written the same way everywhere.

#include <string>
#include <string_view>

#include "weft/error.h"
#include "weft/types.h"

namespace weft {

/// An error such as "ClothSettings::fabric.warp is -3; it must be finite and >= 0 N/m".
[[nodiscard]] Error out_of_range(std::string_view name, double value, std::string_view requirement);
[[nodiscard]] Error out_of_range(std::string_view name, const Vec3& value, std::string_view requirement);

/// The shortest text that reads back as the same float: "0.1", "nan", "-inf".
[[nodiscard]] std::string number_text(double value);

[[nodiscard]] bool is_finite(const Vec3& v) noexcept;

}  // namespace weft
