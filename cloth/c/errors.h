#pragma once
// Errors of the interface for C.

#include <cstddef>
#include <cstdint>
#include <initializer_list>
#include <utility>

#include "weft/c/values.h"
#include "weft/error.h"

namespace weft::c {

/// Stores the text for weft_error_text(), without allocating.
WeftResult fail(ErrorCode code, const char* text) noexcept;

/// Runs act(of) and stores its error.
[[nodiscard]] WeftResult run(Result<void> (*act)(const void*), const void* of) noexcept;

/// Runs `act`, which returns a Result<void>.
template <class Act>
[[nodiscard]] WeftResult guarded(const Act& act) noexcept {
    return run([](const void* of) -> Result<void> { return (*static_cast<const Act*>(of))(); }, &act);
}

// Error texts are composed out of line: in each call they would take more code than the calls do.

/// "NAME is a null pointer".
[[nodiscard]] Error null_pointer(const char* name);
/// `count` items at a null pointer.
[[nodiscard]] Error no_items(const char* name, std::size_t count);
/// A stride that is shorter than an item.
[[nodiscard]] Error too_short(const char* name, std::size_t stride, std::size_t item);
/// No room for `count` items.
[[nodiscard]] Error no_room(const char* name, std::size_t bytes, std::size_t stride, std::size_t count,
                            std::size_t item);
/// A number that is no enumerator.
[[nodiscard]] Error out_of_choices(const char* name, std::int32_t value, int count);

/// Error: one of the pointers is null. names: "world", "mesh", ...
[[nodiscard]] Result<void> are_there(std::initializer_list<std::pair<const void*, const char*>> pointers);

}  // namespace weft::c
