#pragma once
// Errors of the library as exceptions, where a program builds something large and reports one failure.

#include <filesystem>
#include <stdexcept>
#include <string>
#include <type_traits>
#include <utility>

#include "weft/error.h"

namespace weft::demo {

/// An Error, thrown.
struct Refusal : std::runtime_error {
    explicit Refusal(Error why) : std::runtime_error(why.message), error(std::move(why)) {}
    Error error;
};

/// The result's value. Throws Refusal if there is none.
template <class T>
T must(Result<T> result) {
    if (!result) throw Refusal(result.error());
    return std::move(result).value();
}
inline void must(const Result<void>& result) {
    if (!result) throw Refusal(result.error());
}

/// The value of `compute()`, or the Error of a Refusal that it throws.
template <class Compute>
auto caught(const Compute& compute) -> Result<decltype(compute())> {
    try {
        if constexpr (std::is_void_v<decltype(compute())>)
            return compute(), Result<void>();
        else
            return compute();
    } catch (const Refusal& refusal) {
        return refusal.error;
    }
}

/// Throws the Refusal of a malformed file.
[[noreturn]] inline void refuse(const std::string& what) {
    throw Refusal({ErrorCode::malformed_file, what});
}

/// The value of `read()`, or the Error of a Refusal, headed by the file's name.
template <class Read>
auto caught_in(const std::filesystem::path& file, const Read& read) -> Result<decltype(read())> {
    auto value = caught(read);
    if (value) return value;
    return Error{value.error().code, file.string() + ": " + value.error().message};
}

}  // namespace weft::demo

namespace weft::study {

using demo::must;

}  // namespace weft::study
