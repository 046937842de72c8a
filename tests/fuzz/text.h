#pragma once
// Settings as text: for the log, and to tell whether two are the same.

#include <string>

#include "weft/weft.h"

namespace weft::fuzz {

/// Nine digits, with which floats read back the same.
[[nodiscard]] std::string text_of(float value);
[[nodiscard]] std::string text_of(const Vec3& value);
[[nodiscard]] std::string text_of(const ClothSettings& settings);
[[nodiscard]] std::string text_of(const WorldSettings& settings);
[[nodiscard]] std::string text_of(const Collider& collider);
[[nodiscard]] std::string text_of(const ClothInfo& info);

}  // namespace weft::fuzz
