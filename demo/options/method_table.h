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
    const char* summary;  ///< one sentence: what to expect of it
    Method method;        ///< with its default settings
};

/// All of them, in the order of Method's alternatives.
[[nodiscard]] std::span<const NamedMethod> all_methods();
/// Null if there is none of that name.
[[nodiscard]] const NamedMethod* find_method(std::string_view name);
/// The entry of the alternative that `method` holds.
[[nodiscard]] const NamedMethod& entry_of(const Method& method);

/// Empty for methods that do not iterate.
[[nodiscard]] std::optional<int> iterations_of(const Method& method);
/// Does nothing to methods that do not iterate.
void set_iterations(Method& method, int iterations);
/// Whether it takes ClothSettings::time_scheme into account.
[[nodiscard]] bool has_time_scheme(const Method& method);

}  // namespace weft::demo
