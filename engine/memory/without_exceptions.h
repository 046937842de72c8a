#pragma once
// The edge of the interface, which no exception crosses, and replacements of try and catch within it: the
// library can be built without exceptions (WEFT_EXCEPTIONS=OFF). Then an error that would throw ends the
// process, above all a failed allocation.

#include <utility>

#include "weft/error.h"

namespace weft {

#ifdef __cpp_exceptions
inline constexpr bool has_exceptions = true;
#else
inline constexpr bool has_exceptions = false;
#endif

/// Thrown by functions that cannot return an Error; the edge hands it to the host.
struct Refusal {
    Error error;
};
[[noreturn]] void refuse(Error error);
/// Throws std::bad_alloc, as operator new does.
[[noreturn]] void refuse_memory();

/// Runs `act`. Memory or threads that the system refuses become an error, also where memory for an error's
/// text is refused.
template <class Act>
auto without_exceptions(const Act& act) noexcept -> decltype(act()) {
#ifdef __cpp_exceptions
    try {
        return act();
    } catch (Refusal& refusal) {
        return std::move(refusal.error);
    } catch (...) {
        return Error{ErrorCode::out_of_memory, "out of memory"};  // so short that it needs no memory
    }
#else
    return act();
#endif
}

/// Runs `act`. Returns whether it came to its end; an exception is dropped.
template <class Act>
[[nodiscard]] bool comes_through(const Act& act) noexcept {
#ifdef __cpp_exceptions
    try {
        act();
    } catch (...) {
        return false;
    }
#else
    act();
#endif
    return true;
}

/// Runs `act`. If it throws, `undo` runs, which must not throw, and the exception propagates.
template <class Act, class Undo>
void or_undo(const Act& act, [[maybe_unused]] const Undo& undo) {
#ifdef __cpp_exceptions
    try {
        act();
    } catch (...) {
        undo();
        throw;
    }
#else
    act();
#endif
}

/// Runs `act`; exceptions of this kind are dropped.
template <class Exception, class Act>
void ignoring(const Act& act) {
#ifdef __cpp_exceptions
    try {
        act();
    } catch (const Exception&) {
    }
#else
    act();
#endif
}

}  // namespace weft
