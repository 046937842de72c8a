#pragma once
// The methods by name: for the command line, the panel and the study.

#include <optional>
#include <span>
#include <string_view>

#include "weft/methods.h"

namespace weft::demo {

struct NamedMethod {
    const char* name;     ///< on the command line and in tables: "conjugate-gradient"
    const char* title;    ///< for people
    const char* summary;  ///< one sentence on its properties
    Method method;        ///< with its default settings
};

/// All of them, in the order of Method's alternatives.
[[nodiscard]] std::span<const NamedMethod> all_methods();
/// The method of that name; null if there is none.
[[nodiscard]] const NamedMethod* find_method(std::string_view name);
/// The entry of the alternative that `method` holds.
[[nodiscard]] const NamedMethod& entry_of(const Method& method);

/// The method's iterations; empty if it does not iterate.
[[nodiscard]] std::optional<int> iterations_of(const Method& method);
/// Sets the method's iterations; does nothing if it does not iterate.
void set_iterations(Method& method, int iterations);
/// True if the method uses ClothSettings::time_scheme.
[[nodiscard]] bool has_time_scheme(const Method& method);

}  // namespace weft::demo
