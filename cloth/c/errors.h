#pragma once
// How the interface for C says what went wrong.

#include <initializer_list>
#include <utility>

#include "engine/without_exceptions.h"
#include "weft/c/values.h"
#include "weft/error.h"

namespace weft::c {

/// Keeps the text for weft_error_text(), which takes no memory.
WeftResult fail(ErrorCode code, const char* text) noexcept;

[[nodiscard]] inline WeftResult result_of(const Result<void>& done) noexcept {
    return done ? WEFT_OK : fail(done.error().code, done.error().message.c_str());
}

/// Runs `act`, which returns a Result<void>.
template <class Act>
[[nodiscard]] WeftResult guarded(const Act& act) noexcept {
    return result_of(without_exceptions([&]() -> Result<void> { return act(); }));
}

/// Error: one of the pointers is null. names: "world", "mesh", ...
[[nodiscard]] Result<void> are_there(std::initializer_list<std::pair<const void*, const char*>> pointers);

}  // namespace weft::c
